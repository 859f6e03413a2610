/// Sums over neighbours as loops over clusters of particles, one particle per SIMD lane; internal to Flow.
///
/// The particles of a cluster are consecutive and share one list of candidates. Each candidate's record, a cache line,
/// is broadcast to all lanes: no gathers, no sums across lanes, no two threads writing to one place. Terms of a pair
/// are symmetric or antisymmetric in its particles bit by bit, so forces cancel in sums over all particles.
///
/// The loops exist for AVX-512 (8 lanes), AVX2 (4) and any machine (2); pair_loops() chooses.
#pragma once

#include <cstddef>
#include <cstdint>

#include "seiche/models/wcsph/kernel.hpp"

// Sanitizers take minutes to instrument these loops: they get one version, one candidate at a time.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SEICHE_PAIR_LOOPS_PLAIN 1
#else
#define SEICHE_PAIR_LOOPS_PLAIN 0
#endif
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !SEICHE_PAIR_LOOPS_PLAIN
#define SEICHE_PAIR_LOOPS_X86 1
#else
#define SEICHE_PAIR_LOOPS_X86 0
#endif

namespace seiche::wcsph {

/// A particle as its neighbours see it.
struct alignas(64) Record {
  double x, z, u, w, density;
  double pressure;   ///< P/rho^2
  double smoothing;  ///< h
  double mass;
};

/// Stress of unresolved eddies over rho^2, and the volume m/rho.
struct Stress {
  double xx, xz, zz, volume;
};

/// Particles first, ..., first + count - 1 and what may lie within their supports.
struct Cluster {
  std::int32_t first = 0;
  std::int32_t count = 0;
  const std::int32_t* begin = nullptr;
  const std::int32_t* end = nullptr;
};

/// Gradient of the density, and the volume m/rho of fluid, 0 of walls.
struct DensityGradient {
  double x, z, volume;
};

/// What walls are told by the fluid beside them, weighted by the kernel: mean pressure, and mean of rho_f (r_w - r_f).
/// Zero where there is none.
struct WallMeans {
  double pressure, lever_x, lever_z;
};

/// Moments of right_hand_side.hpp, all over the same factor of the kernel; m0, mx, mz carry masses in place of volumes.
struct FilterMoments {
  double a00, ax, az, axx, axz, azz, m0, mx, mz;
  double neighbours;  ///< the particle itself left out
};

/// Where the loops read and write, each what it needs. Between two loops that hand on something (strain and fluid,
/// density_gradient and diffusion, surface and shift) it is to be copied to images.
struct PairWork {
  const Record* records = nullptr;
  const Cluster* clusters = nullptr;
  // Rates of change.
  double *dx = nullptr, *dz = nullptr, *du = nullptr, *dw = nullptr, *ddensity = nullptr;
  double* limit = nullptr;  ///< largest (c + sigma)/h of each cluster, which limits the step; or not asked for
  Stress* stress = nullptr;
  double gravity = 0;
  double xsph = 0;
  double inverse_density = 0;      ///< 1/rho_0
  double sound_speed = 0;          ///< c_0 times sound_scale: c = c_0 (rho/rho_0)^3
  double sound_scale = 1;          ///< -alpha/2 with artificial viscosity, 1 otherwise: saves a product per pair
  double kinematic_viscosity = 0;  ///< nu_0
  double eddy_factor = 0;          ///< (C_S Delta)^2
  double isotropic_factor = 0;     ///< (2/3) C_I Delta^2
  // Density diffusion.
  DensityGradient* gradients = nullptr;
  double diffusion = 0;  ///< delta c_0
  // Particle shifting: x, ..., density are changed.
  double* at_surface = nullptr;  ///< 1 or 0
  double *x = nullptr, *z = nullptr, *u = nullptr, *w = nullptr, *density = nullptr;
  double spacing = 0;
  double travel = 0;  ///< 4 u_max tau [m]
  // Extrapolated walls and the density filter.
  WallMeans* means = nullptr;  ///< of the walls, the first of which is particle first_wall
  std::int32_t first_wall = 0;
  FilterMoments* moments = nullptr;
};

/// Clusters first, ..., last - 1.
using PairLoop = void (*)(const PairWork& work, std::size_t first, std::size_t last);

struct IndexRange {
  std::int32_t begin, end;
};

/// What a search for candidates found.
struct Found {
  std::int32_t candidates = 0;
  std::int32_t pairs = 0;  ///< within the support, the particles themselves included
};
/// Appends to `list` those of `count` ranges that come nearer to a particle of the cluster than h_a + h_b + skin.
using CandidateSearch = Found (*)(const Record* records, double skin, const Cluster& cluster, const IndexRange* ranges,
                                  std::size_t count, std::int32_t* list);

enum class Friction { none, artificial, laminar, turbulent };

/// For one kernel.
struct PairLoops {
  std::size_t lanes;
  CandidateSearch search;
  PairLoop fluid[4];          ///< all rates of fluid clusters, by friction
  PairLoop wall;              ///< density of wall clusters
  PairLoop strain;            ///< stress of fluid clusters
  PairLoop density_gradient;  ///< these two and the next: of fluid clusters
  PairLoop diffusion;
  PairLoop surface, shift;
  PairLoop wall_pressure;  ///< of wall clusters, which list fluid only
  PairLoop filter;
};

/// Largest number of lanes of any version: arrays are padded by as many elements.
inline constexpr std::size_t most_lanes = 8;
/// Loops take this many candidates side by side, beyond Cluster::end too: there the lists must be filled up with a
/// record that is nobody's neighbour.
inline constexpr int abreast = SEICHE_PAIR_LOOPS_PLAIN ? 1 : 4;
/// Loops look this far ahead in the lists, which must be readable so far beyond the last cluster's.
inline constexpr int candidates_ahead = 12;

/// The widest that this machine runs, with at most so many lanes.
const PairLoops& pair_loops(KernelName kernel, int lanes);

/// By kernel.
namespace versions {
extern const PairLoops avx512[2];
extern const PairLoops avx2[2];
extern const PairLoops baseline[2];
}  // namespace versions

}  // namespace seiche::wcsph
