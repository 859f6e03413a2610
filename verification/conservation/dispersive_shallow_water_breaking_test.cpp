// The breaking term of the dispersive shallow-water model: keeps momentum and volumes, takes energy.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace {

using namespace seiche;
using namespace seiche::dispersive_shallow_water_1d;
using seiche::evidence::Bound;
using seiche::evidence::Role;
using seiche::evidence::Roundoff;
using seiche::verification::Check;

const std::string source = "opposite forces on the two markers of a cell, against their approach";
constexpr double length = 40;
constexpr double tau = 0.05;

/// Waves that run against each other, so that cells are compressed strongly.
Flow colliding_waves(Stepping stepping, double breaking) {
  const Channel channel{.bottom = std::make_shared<LevelBottom>(1.0), .period = length, .breaking = breaking};
  Markers markers = still_markers(channel, equal_labels(channel, 0, length, 160));
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const double phase = 2 * std::numbers::pi * markers.x[i] / length;
    markers.u[i] = 0.05 + 0.3 * std::sin(phase) + 0.1 * std::sin(3 * phase);
  }
  return Flow(channel, markers, {.stepping = stepping});
}

struct Course {
  std::vector<double> time, energy;
  Largest steepest_rise;  ///< of the energy in a step
  double momentum = 0;    ///< largest defect
  Largest momentum_scale;
  double volume = 0;
};

Course run(Stepping stepping, double breaking, int steps) {
  Flow flow = colliding_waves(stepping, breaking);
  Course course;
  for (int k = 0; k <= steps; ++k) {
    if (k > 0) flow.advance(tau);
    flow.observe();
    course.time.push_back(flow.time());
    course.energy.push_back(flow.energy());
    double squares = 0;
    for (std::size_t i = 0; i < flow.p().size(); ++i) squares += std::pow(flow.model().masses()[i] * flow.p()[i], 2);
    course.momentum_scale.add(std::sqrt(squares));
    if (k > 0) course.steepest_rise.add(course.energy.back() - course.energy[course.energy.size() - 2]);
  }
  course.momentum = flow.ledger().largest_defect("momentum");
  course.volume = flow.ledger().largest_defect("volume_worst");
  return course;
}

}  // namespace

TEST_CASE("breaking keeps momentum and volumes to round-off and never gives energy", "[conservation]") {
  Check check(
      "dispersive_breaking", "Breaking takes energy and nothing else",
      "Waves run against each other in a periodic channel and steepen. Where the two markers of a cell approach, "
      "they resist with $\\pm c\\,V|\\delta u|/\\delta x\\,(\\delta u, \\delta v)$: opposite forces, which keep "
      "momentum and do negative work. With the conservative stepping, which keeps the energy to round-off by "
      "itself, it must fall in every step; with the one-step scheme it falls where breaking takes more than "
      "the scheme's own $O(\\tau^2)$.");
  constexpr int steps = 800;
  auto& panel = check
                    .figure("energy", "Energy while waves collide",
                            "By the conservative stepping; c is the coefficient "
                            "of breaking.")
                    .panel({.x = "t", .y = "energy / initial energy"});
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    const bool conservative = stepping == Stepping::conservative;
    const std::string scheme = conservative ? "conservative" : "one-step";
    double less = std::numeric_limits<double>::infinity();  // energy left with the weaker breaking
    for (const double breaking : {0.0, 0.5, 2.0}) {
      const Course course = run(stepping, breaking, steps);
      const std::string id = scheme + "-" + (breaking == 0 ? "none" : breaking < 1 ? "weak" : "strong");
      const std::string resolution = fmt::format("c = {:g}, h = 0.25, tau = {:g}, {} steps", breaking, tau, steps);
      check.that({.id = id + "-momentum", .text = "Momentum is kept.", .quantity = "largest defect", .source = source},
                 {.value = course.momentum, .resolution = resolution},
                 Roundoff{.operations = steps,
                          .scale = course.momentum_scale.value(),
                          .reason = "once per step, rounding of each marker's m|u|; squares add up"});
      if (breaking > 0) {
        check.that(
            {.id = id + "-energy", .text = "Energy falls.", .quantity = "steepest rise in a step", .source = source},
            {.value = std::max(course.steepest_rise.value(), 0.0), .resolution = resolution},
            Roundoff{.operations = 160,
                     .scale = course.energy.front(),
                     .reason = "difference of two sums over 160 markers; there is nothing else that may rise"});
        check.that({.id = id + "-stronger",
                    .text = "Stronger breaking leaves less energy.",
                    .quantity = "energy left / energy left with weaker breaking",
                    .source = source},
                   {.value = course.energy.back() / less, .resolution = resolution},
                   Bound{.limit = 1, .reason = "less than with the weaker one"});
      }
      less = course.energy.back();
      if (!conservative) continue;
      check.that(
          {.id = id + "-volume", .text = "Volumes are kept.", .quantity = "largest defect of a cell", .source = source},
          {.value = course.volume, .resolution = resolution},
          Roundoff{.operations = 4 * steps,
                   .scale = length,
                   .reason = "once per step, rounding of two places and two heights; depths are about 1"});
      std::vector<double> relative;
      for (const double energy : course.energy) relative.push_back(energy / course.energy.front());
      panel.line(fmt::format("c = {:g}", breaking), course.time, relative, Role::computed);
    }
  }
}
