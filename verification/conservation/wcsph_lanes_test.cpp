// The pair loops of weakly compressible SPH exist for several widths of registers: all give the rates of plain sums.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/wcsph_direct_sums.hpp"
#include "verification/wcsph_problems.hpp"

namespace seiche::verification::wcsph_lanes_test {

using namespace wcsph;

constexpr double spacing = 0.1;

/// A free blob as the pair loops read it, with every particle a candidate of every cluster.
struct Blob {
  Blob(const Particles& particles, const Settings& settings, std::size_t lanes)
      : count(particles.size()),
        sound_scale(std::holds_alternative<ArtificialViscosity>(settings.viscosity)
                        ? -0.5 * std::get<ArtificialViscosity>(settings.viscosity).alpha
                        : 1),
        records(count + most_lanes,
                Record{.x = 1e30, .z = 1e30, .u = 0, .w = 0, .density = 1, .pressure = 0, .smoothing = 1, .mass = 0}) {
    const TaitFluid water(settings.density, settings.sound_speed);
    for (std::size_t a = 0; a < count; ++a) {
      const double density = particles.density[a];
      records[a] = {.x = particles.x[a],
                    .z = particles.z[a],
                    .u = particles.u[a],
                    .w = particles.w[a],
                    .density = density,
                    .pressure = water.pressure(density) / (density * density),
                    .smoothing = settings.smoothing * spacing * std::sqrt(settings.density / density),
                    .mass = particles.mass[a]};
    }
    // Filled up with a record that is nobody's neighbour.
    list.assign(count + abreast + candidates_ahead, static_cast<std::int32_t>(count));
    std::iota(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count), 0);
    for (std::size_t first = 0; first < count; first += lanes) {
      clusters.push_back({.first = static_cast<std::int32_t>(first),
                          .count = static_cast<std::int32_t>(std::min(lanes, count - first)),
                          .begin = list.data(),
                          .end = list.data() + count});
    }
  }
  [[nodiscard]] double volume(std::size_t a) const { return records[a].mass / records[a].density; }
  [[nodiscard]] PairWork work() const { return {.records = records.data(), .clusters = clusters.data()}; }

  std::size_t count;
  double sound_scale;
  std::vector<Record> records;
  std::vector<std::int32_t> list;
  std::vector<Cluster> clusters;
};

/// Rates of a free blob by one version of the loops, density diffusion too.
Rates rates_by(const PairLoops& loops, const Particles& particles, const Settings& settings) {
  const Blob blob(particles, settings, loops.lanes);
  const std::size_t padded = blob.records.size();
  const auto* const eddies = std::get_if<LaminarSps>(&settings.viscosity);
  std::vector<Stress> stress(padded);
  std::vector<DensityGradient> gradients(padded);
  for (std::size_t a = 0; a < blob.count; ++a) stress[a].volume = gradients[a].volume = blob.volume(a);
  std::vector<double> limit(padded);
  Rates rates;
  for (auto* values : {&rates.dx, &rates.dz, &rates.du, &rates.dw, &rates.ddensity}) values->resize(padded);
  PairWork work = blob.work();
  work.dx = rates.dx.data();
  work.dz = rates.dz.data();
  work.du = rates.du.data();
  work.dw = rates.dw.data();
  work.ddensity = rates.ddensity.data();
  work.limit = limit.data();
  work.stress = stress.data();
  work.gravity = settings.gravity;
  work.xsph = settings.xsph;
  work.sound_scale = blob.sound_scale;
  work.sound_speed = blob.sound_scale * settings.sound_speed;
  work.inverse_density = 1 / settings.density;
  if (eddies != nullptr) {
    work.kinematic_viscosity = eddies->kinematic_viscosity;
    work.eddy_factor = std::pow(eddies->smagorinsky * spacing, 2);
    work.isotropic_factor = 2.0 / 3 * eddies->isotropic * spacing * spacing;
  }
  work.gradients = gradients.data();
  work.diffusion = settings.density_diffusion * settings.sound_speed;
  Friction friction = Friction::none;
  if (std::holds_alternative<ArtificialViscosity>(settings.viscosity)) friction = Friction::artificial;
  if (eddies != nullptr) friction = Friction::turbulent;
  const std::size_t clusters = blob.clusters.size();
  if (friction == Friction::turbulent) loops.strain(work, 0, clusters);
  loops.fluid[static_cast<std::size_t>(friction)][1](work, 0, clusters);
  if (settings.density_diffusion > 0) {
    loops.density_gradient(work, 0, clusters);
    loops.diffusion(work, 0, clusters);
  }
  for (auto* values : {&rates.dx, &rates.dz, &rates.du, &rates.dw, &rates.ddensity}) values->resize(blob.count);
  return rates;
}

/// A free blob after shifting over a time tau by one version of the loops.
Particles shifted_by(const PairLoops& loops, const Particles& particles, const Settings& settings, double tau) {
  const Blob blob(particles, settings, loops.lanes);
  Worst fastest;
  for (const Record& record : blob.records) fastest.add(std::hypot(record.u, record.w));
  Particles result = particles;
  std::vector<double> at_surface(blob.records.size());
  PairWork work = blob.work();
  work.at_surface = at_surface.data();
  work.x = result.x.data();
  work.z = result.z.data();
  work.u = result.u.data();
  work.w = result.w.data();
  work.density = result.density.data();
  work.spacing = spacing;
  work.travel = 4 * fastest.value() * tau;
  loops.surface(work, 0, blob.clusters.size());
  loops.shift(work, 0, blob.clusters.size());
  return result;
}

/// Moments of the density filter, and what a wall in the place of each particle would be told, by one version.
struct Sums {
  std::vector<FilterMoments> moments;
  std::vector<WallMeans> means;
};
Sums sums_by(const PairLoops& loops, const Particles& particles, const Settings& settings) {
  const Blob blob(particles, settings, loops.lanes);
  Sums sums{std::vector<FilterMoments>(blob.count), std::vector<WallMeans>(blob.count)};
  PairWork work = blob.work();
  work.moments = sums.moments.data();
  work.means = sums.means.data();
  loops.filter(work, 0, blob.clusters.size());
  loops.wall_pressure(work, 0, blob.clusters.size());
  return sums;
}

struct Version {
  std::string name;
  const PairLoops* loops;  ///< by kernel
};

/// Those that this machine can run.
std::vector<Version> runnable() {
  std::vector<Version> found{{"baseline", versions::baseline}};
#if SEICHE_PAIR_LOOPS_X86
  if (__builtin_cpu_supports("x86-64-v3")) found.push_back({"avx2", versions::avx2});
  if (__builtin_cpu_supports("x86-64-v4")) found.push_back({"avx512", versions::avx512});
#endif
  return found;
}

TEST_CASE("every width of registers gives the rates of sums over all pairs", "[conservation]") {
  Check check("wcsph_lanes", "Pair loops for every width of registers",
              "The loops exist for two, four and eight particles at a time, with reciprocals and roots of each "
              "instruction set. All that this machine runs, of a free blob whose number of particles is a multiple of "
              "none of them, against sums over all pairs.");
  Particles blob = random_blob(spacing, 1000, 1);
  while (blob.size() % 8 != 5) blob.add(5 + 0.5 * static_cast<double>(blob.size() % 8), 3, 10, 1000);
  for (const Version& version : runnable()) {
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
      const PairLoops& loops = version.loops[static_cast<std::size_t>(kernel)];
      std::vector<Settings> models;
      for (const Viscosity& viscosity :
           std::vector<Viscosity>{Inviscid{}, ArtificialViscosity{0.3}, LaminarSps{0.01, 0.12, 0.0066}}) {
        models.push_back({.kernel = kernel, .sound_speed = 20, .viscosity = viscosity});
      }
      models.push_back({.kernel = kernel, .sound_speed = 20, .density_diffusion = 0.1});
      Largest largest;
      for (const Settings& settings : models) {
        const Rates found = rates_by(loops, blob, settings);
        const Rates direct = DirectSums(blob, spacing, settings).rates();
        largest.add(relative_difference(found.dx, direct.dx));
        largest.add(relative_difference(found.dz, direct.dz));
        largest.add(relative_difference(found.du, direct.du));
        largest.add(relative_difference(found.dw, direct.dw));
        largest.add(relative_difference(found.ddensity, direct.ddensity));
      }
      check.holds(
          fmt::format("The {} loops give the rates of sums over all pairs ({}).", version.name, name_of(kernel)),
          {largest.value()},
          Roundoff{120, 1,
                   "some 40 roundings of a pair, of which those of 20 pairs add up as the pairs do, and 20 of sums, in "
                   "both ways of summing; pressures are the same numbers in both"});
    }
  }
}

TEST_CASE("every width of registers gives the sums of the density filter and of extrapolated walls", "[conservation]") {
  Check check(
      "wcsph_lanes_sums", "Sums of the density filter and of extrapolated walls for every width of registers",
      "A jittered square of 21 by 21 particles with random velocities and densities: moments of the filter, and mean "
      "pressure and lever that each place would be told as a wall's, against the same sums written out.");
  const Particles square = noisy_square(21, spacing);
  for (const Version& version : runnable()) {
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
      const PairLoops& loops = version.loops[static_cast<std::size_t>(kernel)];
      const Settings settings{.kernel = kernel, .sound_speed = 20};
      const Sums found = sums_by(loops, square, settings);
      const Blob blob(square, settings, loops.lanes);
      Largest largest;
      for (std::size_t a = 0; a < blob.count; ++a) {
        const Record& one = blob.records[a];
        double weights = 0, pressure = 0, lever = 0, volumes = 0, cross = 0, heavy = 0;
        double neighbours = -1;
        for (std::size_t b = 0; b < blob.count; ++b) {
          const Record& other = blob.records[b];
          const double x = one.x - other.x;
          const double z = one.z - other.z;
          const double h = 0.5 * (one.smoothing + other.smoothing);
          const double r = std::hypot(x, z);
          if (r >= support * h) continue;
          const double w = kernel == KernelName::cubic_spline ? weight<CubicSpline>(r, h) : weight<WendlandC2>(r, h);
          weights += w;
          pressure += other.pressure * other.density * other.density * w;
          lever += other.density * z * w;
          volumes += blob.volume(b) * w;
          cross += blob.volume(b) * x * z * w;
          heavy += blob.records[b].mass * x * w;
          neighbours += 1;
        }
        const FilterMoments& moments = found.moments[a];
        const WallMeans& means = found.means[a];
        const double factor = volumes / moments.a00;
        const double scale = 1000 * 20 * 20;
        largest.add(std::abs(means.pressure - pressure / weights) / scale);
        largest.add(std::abs(means.lever_z - lever / weights) / (1000 * spacing));
        largest.add(std::abs(factor * moments.axz - cross) / (spacing * spacing));
        largest.add(std::abs(factor * moments.mx - heavy) / (1000 * spacing));
        CHECK(moments.neighbours == neighbours);
      }
      check.holds(
          fmt::format("The {} loops give these sums ({}).", version.name, name_of(kernel)), {largest.value()},
          Roundoff{120, 1, "some 40 roundings of a pair and 20 of sums, in both ways of summing; weights add up to 1"});
    }
  }
}

TEST_CASE("every width of registers shifts particles as sums over all pairs do", "[conservation]") {
  Check check("wcsph_lanes_shifting", "Particle shifting for every width of registers",
              "A jittered square of 21 by 21 particles with random velocities and densities, shifted over a time in "
              "which the longest shift is cut off: places, velocities and densities against sums over all pairs. "
              "Particles at its edge and their neighbours stay.");
  constexpr double tau = 0.02;
  const Particles square = noisy_square(21, spacing);
  for (const Version& version : runnable()) {
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
      const PairLoops& loops = version.loops[static_cast<std::size_t>(kernel)];
      const Settings settings{.kernel = kernel, .sound_speed = 20};
      const Particles found = shifted_by(loops, square, settings, tau);
      const Particles direct = DirectSums(square, spacing, settings).shifted(tau);
      long moved = 0;
      Largest largest;
      for (std::size_t a = 0; a < square.size(); ++a) {
        const bool moves = direct.x[a] != square.x[a];
        REQUIRE((found.x[a] != square.x[a]) == moves);
        moved += moves ? 1 : 0;
        largest.add(std::abs(found.x[a] - direct.x[a]) / spacing);
        largest.add(std::abs(found.z[a] - direct.z[a]) / spacing);
        largest.add(std::abs(found.u[a] - direct.u[a]));
        largest.add(std::abs(found.w[a] - direct.w[a]));
        largest.add(std::abs(found.density[a] - direct.density[a]) / 1000);
      }
      REQUIRE(moved > 100);
      REQUIRE(moved < 400);
      check.holds(
          fmt::format("The {} loops shift particles as sums over all pairs do ({}).", version.name, name_of(kernel)),
          {largest.value()},
          Roundoff{2, 21,
                   "the two places are rounded as numbers of up to 21 dx; the shift, 0.1 dx or less, and velocities "
                   "and densities have errors below that"});
    }
  }
}

}  // namespace seiche::verification::wcsph_lanes_test
