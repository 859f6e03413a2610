/// A free blob as the pair loops of weakly compressible SPH read it, in either storage, and its rates by one version of
/// the loops.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "seiche/models/wcsph/equation_of_state.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/particles.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "seiche/samples.hpp"

namespace seiche::verification {

/// With every particle a candidate of every cluster.
template <class SomeRecord>
struct Blob {
  static constexpr double spacing = 0.1;
  static constexpr bool mixed = std::is_same_v<SomeRecord, wcsph::MixedRecord>;
  using Real = typename wcsph::RealOf<SomeRecord>::Type;

  Blob(const wcsph::Particles& particles, const wcsph::Settings& settings, std::size_t lanes)
      : count(particles.size()),
        sound_scale(std::holds_alternative<wcsph::ArtificialViscosity>(settings.viscosity)
                        ? -0.5 * std::get<wcsph::ArtificialViscosity>(settings.viscosity).alpha
                        : 1),
        length(mixed ? settings.smoothing * spacing : 1),
        density_unit(mixed ? settings.density : 1) {
    const wcsph::TaitFluid water(settings.density, settings.sound_speed, settings.exponent);
    const std::size_t padded = count + wcsph::most_lanes;
    Worst extent;
    for (std::size_t a = 0; a < count; ++a) {
      extent.add(particles.x[a]);
      extent.add(particles.z[a]);
    }
    if (mixed) place = 1.5 * extent.value() / (1 << 30);
    SomeRecord nobody{.x = {}, .z = {}, .u = 0, .w = 0, .density = 1, .pressure = 0, .smoothing = 1, .sound = 0};
    if constexpr (mixed) {
      nobody.x = nobody.z = std::numeric_limits<std::int32_t>::min();
    } else {
      nobody.x = nobody.z = 1e30;
    }
    records.assign(padded, nobody);
    mass.resize(padded);
    for (std::size_t a = 0; a < count; ++a) {
      const double density = particles.density[a];
      const double smoothing = settings.smoothing * spacing * std::sqrt(settings.density / density);
      mass[a] = static_cast<Real>(particles.mass[a] / (density_unit * length * length));
      records[a] = {.x = place_of(particles.x[a]),
                    .z = place_of(particles.z[a]),
                    .u = static_cast<Real>(particles.u[a]),
                    .w = static_cast<Real>(particles.w[a]),
                    .density = static_cast<Real>(density / density_unit),
                    .pressure = static_cast<Real>(density_unit * (water.pressure(density) / (density * density))),
                    .smoothing = static_cast<Real>(smoothing / length),
                    .sound = static_cast<Real>(sound_scale * water.sound_speed(density))};
    }
    // Filled up with a record that is nobody's neighbour.
    list.assign(count + wcsph::abreast + wcsph::candidates_ahead, static_cast<std::int32_t>(count));
    std::iota(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count), 0);
    for (std::size_t first = 0; first < count; first += lanes) {
      clusters.push_back({.first = static_cast<std::int32_t>(first),
                          .count = static_cast<std::int32_t>(std::min(lanes, count - first)),
                          .begin = list.data(),
                          .end = list.data() + count});
    }
  }
  [[nodiscard]] auto place_of(double x) const {
    if constexpr (mixed) {
      return static_cast<std::int32_t>(std::lround(x / place));
    } else {
      return x;
    }
  }
  [[nodiscard]] Real volume(std::size_t a) const { return mass[a] / records[a].density; }

  std::size_t count;
  double sound_scale;
  double length;  ///< that lengths are over [m]
  double density_unit;
  double place = 1;  ///< unit of places [m]
  std::vector<Real> mass;
  std::vector<SomeRecord> records;
  std::vector<std::int32_t> list;
  std::vector<wcsph::Cluster> clusters;
};

/// Rates of a free blob by one version of the loops.
template <class SomeRecord>
wcsph::Rates rates_by(const wcsph::PairLoops& all_loops, const wcsph::Particles& particles,
                      const wcsph::Settings& settings) {
  using namespace wcsph;
  using Real = typename RealOf<SomeRecord>::Type;
  constexpr double spacing = Blob<SomeRecord>::spacing;
  const RateLoops<SomeRecord>& loops = [&]() -> const RateLoops<SomeRecord>& {
    if constexpr (std::is_same_v<SomeRecord, Record>) {
      return all_loops.full;
    } else {
      return all_loops.mixed;
    }
  }();
  const Blob<SomeRecord> blob(particles, settings, loops.lanes);
  const std::size_t padded = blob.records.size();
  const auto* const eddies = std::get_if<LaminarSps>(&settings.viscosity);
  std::vector<StressOf<Real>> stress(padded);
  for (std::size_t a = 0; a < blob.count; ++a) stress[a].volume = blob.volume(a);
  std::vector<Real> dx(padded), dz(padded), du(padded), dw(padded), ddensity(padded), limit(padded);
  const RateWork<SomeRecord> work{
      .records = blob.records.data(),
      .mass = blob.mass.data(),
      .stress = stress.data(),
      .clusters = blob.clusters.data(),
      .dx = dx.data(),
      .dz = dz.data(),
      .du = du.data(),
      .dw = dw.data(),
      .ddensity = ddensity.data(),
      .limit = limit.data(),
      .gravity = settings.gravity,
      .xsph = settings.xsph,
      .sound_scale = blob.sound_scale,
      .kinematic_viscosity = eddies != nullptr ? eddies->kinematic_viscosity : 0,
      .eddy_factor = eddies != nullptr ? std::pow(eddies->smagorinsky * spacing, 2) : 0,
      .isotropic_factor = eddies != nullptr ? 2.0 / 3 * eddies->isotropic * spacing * spacing : 0,
      .place_unit = blob.place / blob.length,
      .per_length = 1 / blob.length,
      .density_unit = blob.density_unit};
  Friction friction = Friction::none;
  if (std::holds_alternative<ArtificialViscosity>(settings.viscosity)) friction = Friction::artificial;
  if (eddies != nullptr) friction = Friction::turbulent;
  const std::size_t clusters = blob.clusters.size();
  if (friction == Friction::turbulent) loops.strain(settings.kernel)(work, 0, clusters);
  loops.fluid(settings.kernel, friction, true)(work, 0, clusters);
  const auto of_particles = [&blob](const std::vector<Real>& values) {
    return std::vector<double>(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(blob.count));
  };
  return {.dx = of_particles(dx),
          .dz = of_particles(dz),
          .du = of_particles(du),
          .dw = of_particles(dw),
          .ddensity = of_particles(ddensity)};
}

struct Version {
  std::string name;
  const wcsph::PairLoops* loops;
};

/// Those that this machine can run.
inline std::vector<Version> runnable() {
  std::vector<Version> found{{"baseline", &wcsph::versions::baseline}};
#if SEICHE_PAIR_LOOPS_X86
  if (__builtin_cpu_supports("x86-64-v3")) found.push_back({"avx2", &wcsph::versions::avx2});
  if (__builtin_cpu_supports("x86-64-v4")) found.push_back({"avx512", &wcsph::versions::avx512});
#endif
  return found;
}

}  // namespace seiche::verification
