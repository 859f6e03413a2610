/// Sums over neighbours as loops over clusters of particles, one particle per SIMD lane; internal to Flow.
///
/// The particles of a cluster are consecutive and share one list of candidates. Each candidate's record, a cache line,
/// is broadcast to all lanes: no gathers, no sums across lanes, no two threads writing to one place. Terms of a pair
/// are symmetric or antisymmetric in its particles bit by bit, so forces cancel in sums over all particles.
///
/// The loops exist for AVX-512 (8 lanes), AVX2 (4) and any machine (2); pair_loops() chooses when first called. Those
/// of Storage::mixed have twice as many lanes.
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
  double sound;      ///< c times PairWork::sound_scale
};

/// The same in half the memory (Storage::mixed). Lengths are over h_0, densities over rho_0, and places whole numbers
/// of a unit (Units of stage.hpp): of whole numbers, differences are exact and antisymmetric, wherever the pair is.
struct alignas(32) MixedRecord {
  std::int32_t x, z;
  float u, w, density;
  float pressure;  ///< P rho_0/rho^2
  float smoothing;
  float sound;  ///< c times RateWork::sound_scale
};

template <class Record>
struct RealOf;
template <>
struct RealOf<Record> {
  using Type = double;
};
template <>
struct RealOf<MixedRecord> {
  using Type = float;
};

/// Stress of unresolved eddies over rho^2, and the volume m/rho; over rho_0 and h_0 beside mixed records.
template <class Real>
struct StressOf {
  Real xx, xz, zz, volume;
};
using Stress = StressOf<double>;

/// Particles first, ..., first + count - 1 and what may lie within their supports.
struct Cluster {
  std::int32_t first = 0;
  std::int32_t count = 0;
  const std::int32_t* begin = nullptr;
  const std::int32_t* end = nullptr;
};

enum class Friction { none, artificial, laminar, turbulent };

/// Where the loops of rates read and write.
/// @tparam SomeRecord  Record or MixedRecord
template <class SomeRecord>
struct RateWork {
  using Real = typename RealOf<SomeRecord>::Type;
  const SomeRecord* records;
  const Real* mass;  ///< beside mixed records over rho_0 h_0^2
  StressOf<Real>* stress;
  const Cluster* clusters;
  // Rates of change.
  Real *dx, *dz, *du, *dw, *ddensity;
  /// Largest (c + sigma)/h of each cluster, which limits the step.
  Real* limit;
  double gravity;
  double xsph;
  double sound_scale;          ///< -alpha/2 with artificial viscosity, 1 otherwise: saves a product per pair
  double kinematic_viscosity;  ///< nu_0
  double eddy_factor;          ///< (C_S Delta)^2
  double isotropic_factor;     ///< (2/3) C_I Delta^2
  // What mixed records are in terms of.
  double place_unit = 1;    ///< of their places, over h_0
  double per_length = 1;    ///< 1/h_0
  double density_unit = 1;  ///< rho_0
};
using PairWork = RateWork<Record>;

/// Gradient of the density, and the volume m/rho of fluid, 0 of walls.
struct DensityGradient {
  double x, z, volume;
};

/// Density diffusion: between gradients and diffusion, those of images are to be copied.
struct DiffusionWork {
  const Record* records;
  const Cluster* clusters;
  DensityGradient* gradients;
  double* ddensity;  ///< is added to
  double strength;   ///< delta c_0
};

/// Particle shifting: between surface and shift, what was found is to be copied to images.
struct ShiftWork {
  const Record* records;
  const double* mass;
  const Cluster* clusters;
  double* at_surface;               ///< 1 or 0
  double *x, *z, *u, *w, *density;  ///< are changed
  double spacing;
  double travel;  ///< 4 u_max tau [m]
};

/// What walls are told by the fluid beside them, weighted by the kernel: mean pressure, and mean of rho_f (r_w - r_f).
/// Zero where there is none.
struct WallMeans {
  double pressure, lever_x, lever_z;
};

struct WallPressureWork {
  const Record* records;
  const Cluster* clusters;
  WallMeans* means;
};

/// Moments of density_filter.hpp, all over the same factor of the kernel; m0, mx, mz carry masses in place of volumes.
struct FilterMoments {
  double a00, ax, az, axx, axz, azz, m0, mx, mz;
  double neighbours;  ///< the particle itself left out
};

struct FilterWork {
  const Record* records;
  const double* mass;
  const Cluster* clusters;
  FilterMoments* moments;
};

/// Clusters first, ..., last - 1.
template <class SomeRecord>
using RateLoop = void (*)(const RateWork<SomeRecord>& work, std::size_t first, std::size_t last);
using DiffusionLoop = void (*)(const DiffusionWork& work, std::size_t first, std::size_t last);
using ShiftLoop = void (*)(const ShiftWork& work, std::size_t first, std::size_t last);
using WallPressureLoop = void (*)(const WallPressureWork& work, std::size_t first, std::size_t last);
using FilterLoop = void (*)(const FilterWork& work, std::size_t first, std::size_t last);

struct IndexRange {
  std::int32_t begin, end;
};

/// What a search for candidates found.
struct Found {
  std::int32_t candidates = 0;
  std::int32_t pairs = 0;  ///< within the support, the particles themselves included
};
/// Where a search for candidates looks.
template <class SomeRecord>
struct SearchWork {
  const SomeRecord* records;
  double skin;  ///< beside mixed records over h_0
  double place_unit = 1;
};
/// Appends to `list` those of `count` ranges that come nearer to a particle of the cluster than h_a + h_b + skin.
template <class SomeRecord>
using CandidateSearch = Found (*)(const SearchWork<SomeRecord>& work, const Cluster& cluster, const IndexRange* ranges,
                                  std::size_t count, std::int32_t* list);

/// What there is for both kinds of records.
template <class SomeRecord>
struct RateLoops {
  std::size_t lanes;
  /// All rates of fluid clusters; with `limited` also the limit of the step.
  RateLoop<SomeRecord> (*fluid)(KernelName kernel, Friction friction, bool limited);
  /// Density of wall clusters.
  RateLoop<SomeRecord> (*wall)(KernelName kernel, bool limited);
  /// Stress of fluid clusters.
  RateLoop<SomeRecord> (*strain)(KernelName kernel);
  CandidateSearch<SomeRecord> search;
};

struct PairLoops {
  RateLoops<Record> full;
  RateLoops<MixedRecord> mixed;
  /// See density_diffusion.hpp and particle_shifting.hpp; of fluid clusters.
  DiffusionLoop (*density_gradient)(KernelName kernel);
  DiffusionLoop (*diffusion)(KernelName kernel);
  ShiftLoop (*surface)(KernelName kernel);
  ShiftLoop (*shift)(KernelName kernel);
  /// See wall_pressure.hpp; of wall clusters, which list fluid only.
  WallPressureLoop (*wall_pressure)(KernelName kernel);
  /// See density_filter.hpp; of fluid clusters.
  FilterLoop (*filter)(KernelName kernel);
};

/// Largest number of lanes of any version: arrays are padded by as many elements.
inline constexpr std::size_t most_lanes = 16;
/// Loops take this many candidates side by side, beyond Cluster::end too: there the lists must be filled up with a
/// record that is nobody's neighbour.
inline constexpr int abreast = SEICHE_PAIR_LOOPS_PLAIN ? 1 : 4;
/// Loops look this far ahead in the lists, which must be readable so far beyond the last cluster's.
inline constexpr int candidates_ahead = 12;

/// The widest that this machine runs.
const PairLoops& pair_loops();

/// Those of one kind of records.
template <class SomeRecord>
const RateLoops<SomeRecord>& rate_loops() {
  if constexpr (sizeof(SomeRecord) == sizeof(Record)) {
    return pair_loops().full;
  } else {
    return pair_loops().mixed;
  }
}

namespace versions {
extern const PairLoops avx512;
extern const PairLoops avx2;
extern const PairLoops baseline;
}  // namespace versions

}  // namespace seiche::wcsph
