// Weakly compressible SPH with particles in single precision and sums in double: what it costs of accuracy.
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/front.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/wcsph_blob.hpp"
#include "verification/conservation/wcsph_direct_sums.hpp"
#include "verification/wcsph_problems.hpp"

namespace wcsph_mixed_storage_test {

using namespace seiche::wcsph;
using namespace seiche::verification;
using seiche::Largest;
using seiche::worst;
using seiche::evidence::Bound;

constexpr double unit = std::numeric_limits<float>::epsilon();
constexpr double spacing = 0.1;

/// Of a rate over the largest one.
const Bound rounding{.limit = 120 * unit,
                     .reason =
                         "some 40 roundings of a pair in single precision, of which those of 20 pairs add up as "
                         "the pairs do, and places rounded by far less; pressures are rounded once, and sums "
                         "are in double precision"};

std::vector<std::pair<std::string, Viscosity>> viscosities() {
  return {{"inviscid", Inviscid{}},
          {"artificial", ArtificialViscosity{0.3}},
          {"laminar", LaminarSps{0.01, 0, 0}},
          {"sps", LaminarSps{0.01, 0.12, 0.0066}}};
}

TEST_CASE("particles in single precision have the rates of sums over all pairs, to its rounding", "[conservation]") {
  Check check("wcsph_mixed_rates", "Mixed storage: rates against sums over all pairs",
              "Particles as their neighbours see them in single precision, places in whole numbers, sums in double "
              "precision; against sums over all pairs in double precision, which know of no storage. A free blob by "
              "the loops of every width of registers, and a box that repeats itself in both directions.");
  const std::string source = "formulas (2)-(6) summed over all pairs";
  const Particles blob = random_blob(spacing, 1000, 1);
  for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
    for (const Version& version : runnable()) {
      Largest largest;
      for (const auto& [name, viscosity] : viscosities()) {
        const Settings settings{.kernel = kernel, .sound_speed = 20, .viscosity = viscosity};
        const Rates found = rates_by<MixedRecord>(*version.loops, blob, settings);
        const Rates direct = DirectSums(blob, spacing, settings).rates();
        largest.add(relative_difference(found.dx, direct.dx));
        largest.add(relative_difference(found.dz, direct.dz));
        largest.add(relative_difference(found.du, direct.du));
        largest.add(relative_difference(found.dw, direct.dw));
        largest.add(relative_difference(found.ddensity, direct.ddensity));
      }
      check.that({.id = fmt::format("{}-{}", version.name, name_of(kernel)),
                  .text = fmt::format("The {} loops give these rates ({}).", version.name, name_of(kernel)),
                  .quantity = "largest relative difference of a rate",
                  .source = source},
                 {.value = largest.value(), .resolution = fmt::format("{} lanes", version.loops->mixed.lanes)},
                 rounding);
    }
    const double side = 16 * spacing;
    for (const auto& [name, viscosity] : viscosities()) {
      Flow flow(noisy_square(16, spacing), spacing,
                {.kernel = kernel,
                 .sound_speed = 20,
                 .viscosity = viscosity,
                 .period = {side, side},
                 .storage = Storage::mixed});
      const RateDifference found = compare(flow, spacing);
      check.that({.id = fmt::format("box-{}-{}", name_of(kernel), name),
                  .text = fmt::format("A periodic box has these rates ({}, {}).", name_of(kernel), name),
                  .quantity = "largest relative difference of a rate",
                  .source = source},
                 {.value = worst(std::array{found.motion, found.acceleration, found.density})}, rounding);
    }
    Flow flow(noisy_square(16, spacing), spacing,
              {.kernel = kernel,
               .sound_speed = 20,
               .viscosity = ArtificialViscosity{0.3},
               .period = {side, side},
               .storage = Storage::mixed});
    const double expected = DirectSums(noisy_square(16, spacing), spacing, flow.settings()).largest_step();
    check.that({.id = fmt::format("step-{}", name_of(kernel)),
                .text = fmt::format("The first step has the length of the rule ({}).", name_of(kernel)),
                .quantity = "dt",
                .unit = "s",
                .source = "the rule summed over all pairs"},
               {.value = flow.advance()},
               Bound{.limit = 20 * unit,
                     .reason = "some 20 roundings of the fastest pair in single precision",
                     .expected = expected,
                     .relative = true});
  }
}

TEST_CASE("particles in single precision keep their momentum to its rounding", "[conservation]") {
  Check check("wcsph_mixed_momentum", "Mixed storage: momentum",
              "A periodic box of particles with random velocities, 300 steps. Differences of places are exact, so that "
              "the forces of a pair differ by the rounding of masses and rates alone: the momentum wanders.");
  const double side = 16 * spacing;
  for (const auto& [name, viscosity] : viscosities()) {
    Flow flow(
        noisy_square(16, spacing), spacing,
        {.gravity = 0, .sound_speed = 20, .viscosity = viscosity, .period = {side, side}, .storage = Storage::mixed});
    const Totals start = flow.totals();
    for (int step = 0; step < 300; ++step) flow.advance();
    const Totals end = flow.totals();
    check.that({.id = "momentum-" + name,
                .text = fmt::format("No momentum appears ({}).", name),
                .quantity = "|sum m u| less that of the beginning, over sum m |u| of the beginning",
                .source = "antisymmetry of the pair forces"},
               {.value = std::hypot(end.momentum[0] - start.momentum[0], end.momentum[1] - start.momentum[1]) /
                         start.absolute_momentum,
                .resolution = fmt::format("N = {}, 300 steps", flow.particles().size())},
               Bound{.limit = 300.0 * 4 / 256 * unit,
                     .reason = "each of 256 particles rounds what is added to its velocity, which is less than that, "
                               "4 times per step in single precision, independently"});
  }
}

TEST_CASE("the front of a dam break does not depend on how particles are held", "[conservation]") {
  Check check("wcsph_mixed_dam_break", "Mixed storage: a dam break",
              "The column of figure 2, 32 particles across, until the water has run a column's width and a half: the "
              "front, and the energies, with particles held in single and in double precision.");
  constexpr double width = 0.057;
  const DamBreak dam{
      .width = width, .height = 2 * width, .tank_length = 4 * width, .wall_height = 3.5 * width, .spacing = width / 32};
  struct End {
    double front;
    Totals totals;
    long steps;
  };
  const auto run = [&dam](Storage storage) {
    const Settings settings{.sound_speed = 15, .viscosity = ArtificialViscosity{0.3}, .storage = storage};
    const Scene scene = dam_break(dam, settings);
    Flow flow(scene.particles, scene.spacing, settings);
    flow.advance_to(0.12);
    return End{front_position(flow.particles(), flow.smoothing_length()), flow.totals(), flow.steps()};
  };
  const End full = run(Storage::full);
  const End mixed = run(Storage::mixed);
  const std::string far_below = "a hundredth of what the method resolves: its own errors are of the spacing";
  const std::string resolution = fmt::format("{} steps", full.steps);
  check.that({.id = "front",
              .text = "The front is where it is in double precision.",
              .quantity = "difference of the fronts over dx",
              .source = "the same run in double precision"},
             {.value = (mixed.front - full.front) / dam.spacing, .resolution = resolution},
             Bound{.limit = 0.01, .reason = far_below});
  check.that({.id = "kinetic",
              .text = "So is the kinetic energy.",
              .quantity = "relative difference of the kinetic energies",
              .source = "the same run in double precision"},
             {.value = mixed.totals.kinetic / full.totals.kinetic - 1, .resolution = resolution},
             Bound{.limit = 0.01 / 32, .reason = "a hundredth of a spacing in the width of the column"});
  CHECK(full.front > 2.2 * width);
  CHECK(full.front < 3.9 * width);
}

}  // namespace wcsph_mixed_storage_test
