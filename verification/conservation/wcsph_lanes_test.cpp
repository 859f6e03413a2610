// The pair loops of weakly compressible SPH exist for several widths of registers: all give the rates of plain sums.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/wcsph/equation_of_state.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/wcsph_blob.hpp"
#include "verification/conservation/wcsph_direct_sums.hpp"
#include "verification/wcsph_problems.hpp"

namespace wcsph_lanes_test {

using namespace seiche::wcsph;
using namespace seiche::verification;
using seiche::Largest;
using seiche::Worst;
using seiche::evidence::Roundoff;

constexpr double spacing = Blob<Record>::spacing;

/// Rates of a free blob by one version of the loops, density diffusion too.
Rates rates_with_diffusion(const PairLoops& loops, const Particles& particles, const Settings& settings) {
  Rates rates = rates_by<Record>(loops, particles, settings);
  if (settings.density_diffusion > 0) {
    const Blob<Record> blob(particles, settings, loops.full.lanes);
    std::vector<DensityGradient> gradients(blob.records.size());
    for (std::size_t a = 0; a < blob.count; ++a) gradients[a].volume = blob.volume(a);
    const DiffusionWork diffusion{.records = blob.records.data(),
                                  .clusters = blob.clusters.data(),
                                  .gradients = gradients.data(),
                                  .ddensity = rates.ddensity.data(),
                                  .strength = settings.density_diffusion * settings.sound_speed};
    loops.density_gradient(settings.kernel)(diffusion, 0, blob.clusters.size());
    loops.diffusion(settings.kernel)(diffusion, 0, blob.clusters.size());
  }
  return rates;
}

/// A free blob after shifting over a time tau by one version of the loops.
Particles shifted_by(const PairLoops& loops, const Particles& particles, const Settings& settings, double tau) {
  const Blob<Record> blob(particles, settings, loops.full.lanes);
  Worst fastest;
  for (const Record& record : blob.records) fastest.add(std::hypot(record.u, record.w));
  Particles result = particles;
  std::vector<double> at_surface(blob.records.size());
  const ShiftWork work{.records = blob.records.data(),
                       .mass = blob.mass.data(),
                       .clusters = blob.clusters.data(),
                       .at_surface = at_surface.data(),
                       .x = result.x.data(),
                       .z = result.z.data(),
                       .u = result.u.data(),
                       .w = result.w.data(),
                       .density = result.density.data(),
                       .spacing = spacing,
                       .travel = 4 * fastest.value() * tau};
  loops.surface(settings.kernel)(work, 0, blob.clusters.size());
  loops.shift(settings.kernel)(work, 0, blob.clusters.size());
  return result;
}

/// Moments of the density filter, and what a wall in the place of each particle would be told, by one version.
struct Sums {
  std::vector<FilterMoments> moments;
  std::vector<WallMeans> means;
};
Sums sums_by(const PairLoops& loops, const Particles& particles, const Settings& settings) {
  const Blob<Record> blob(particles, settings, loops.full.lanes);
  Sums sums{std::vector<FilterMoments>(blob.count), std::vector<WallMeans>(blob.count)};
  loops.filter(settings.kernel)({.records = blob.records.data(),
                                 .mass = blob.mass.data(),
                                 .clusters = blob.clusters.data(),
                                 .moments = sums.moments.data()},
                                0, blob.clusters.size());
  loops.wall_pressure(settings.kernel)(
      {.records = blob.records.data(), .clusters = blob.clusters.data(), .means = sums.means.data()}, 0,
      blob.clusters.size());
  return sums;
}

TEST_CASE("every width of registers gives the rates of sums over all pairs", "[conservation]") {
  Check check("wcsph_lanes", "Pair loops for every width of registers",
              "The loops exist for two, four and eight particles at a time, with reciprocals and roots of each "
              "instruction set. All that this machine runs, of a free blob whose number of particles is a multiple of "
              "none of them, "
              "against sums over all pairs.");
  Particles blob = random_blob(spacing, 1000, 1);
  while (blob.size() % 8 != 5) blob.add(5 + 0.5 * static_cast<double>(blob.size() % 8), 3, 10, 1000);
  for (const Version& version : runnable()) {
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
      std::vector<Settings> models;
      for (const Viscosity& viscosity :
           std::vector<Viscosity>{Inviscid{}, ArtificialViscosity{0.3}, LaminarSps{0.01, 0.12, 0.0066}}) {
        models.push_back({.kernel = kernel, .sound_speed = 20, .viscosity = viscosity});
      }
      models.push_back({.kernel = kernel, .sound_speed = 20, .density_diffusion = 0.1});
      Largest largest;
      for (const Settings& settings : models) {
        const Rates found = rates_with_diffusion(*version.loops, blob, settings);
        const Rates direct = DirectSums(blob, spacing, settings).rates();
        largest.add(relative_difference(found.dx, direct.dx));
        largest.add(relative_difference(found.dz, direct.dz));
        largest.add(relative_difference(found.du, direct.du));
        largest.add(relative_difference(found.dw, direct.dw));
        largest.add(relative_difference(found.ddensity, direct.ddensity));
      }
      check.that(
          {.id = fmt::format("{}-{}", version.name, name_of(kernel)),
           .text =
               fmt::format("The {} loops give the rates of sums over all pairs ({}).", version.name, name_of(kernel)),
           .quantity = "largest relative difference of a rate",
           .source = "formulas (2)-(6) summed over all pairs"},
          {.value = largest.value(), .resolution = fmt::format("{} lanes", version.loops->full.lanes)},
          Roundoff{.operations = 120,
                   .scale = 1,
                   .reason =
                       "some 40 roundings of a pair, of which those of 20 pairs add up as the pairs do, and 20 of "
                       "sums, in both ways of summing; pressures are the same numbers in both"});
    }
  }
}

TEST_CASE("every width of registers gives the sums of the density filter and of extrapolated walls", "[conservation]") {
  Check check(
      "wcsph_lanes_sums", "Sums of the density filter and of extrapolated walls for every width of registers",
      "A jittered square of 21 by 21 particles with random velocities and densities: moments of the filter, and "
      "mean pressure and lever that each place would be told as a wall's, against the same sums written out.");
  const Particles square = noisy_square(21, spacing);
  for (const Version& version : runnable()) {
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
      const Settings settings{.kernel = kernel, .sound_speed = 20};
      const Sums found = sums_by(*version.loops, square, settings);
      const Blob<Record> blob(square, settings, version.loops->full.lanes);
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
          heavy += blob.mass[b] * x * w;
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
      check.that({.id = fmt::format("{}-{}", version.name, name_of(kernel)),
                  .text = fmt::format("The {} loops give these sums ({}).", version.name, name_of(kernel)),
                  .quantity = "largest difference over the scale of the sum",
                  .source = "density_filter.hpp, wall_pressure.hpp"},
                 {.value = largest.value(), .resolution = fmt::format("{} lanes", version.loops->full.lanes)},
                 Roundoff{.operations = 120,
                          .scale = 1,
                          .reason = "some 40 roundings of a pair and 20 of sums, in both ways of summing; weights add "
                                    "up to 1"});
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
      const Settings settings{.kernel = kernel, .sound_speed = 20};
      const Particles found = shifted_by(*version.loops, square, settings, tau);
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
      check.that({.id = fmt::format("{}-{}", version.name, name_of(kernel)),
                  .text = fmt::format("The {} loops shift particles as sums over all pairs do ({}).", version.name,
                                      name_of(kernel)),
                  .quantity = "largest difference: places over dx, velocities over their size, densities over rho_0",
                  .source = "Lind et al. (2012); Sun et al. (2017)"},
                 {.value = largest.value(),
                  .resolution = fmt::format("{} lanes, {} particles moved", version.loops->full.lanes, moved)},
                 Roundoff{.operations = 2,
                          .scale = 21,
                          .reason = "the two places are rounded as numbers of up to 21 dx; the shift, 0.1 dx or less, "
                                    "and velocities and densities have errors below that"});
    }
  }
}

}  // namespace wcsph_lanes_test
