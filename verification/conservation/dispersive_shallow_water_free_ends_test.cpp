// A patch of water with two free ends: nothing acts on it from outside.
#include <cmath>
#include <memory>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::dispersive_shallow_water_free_ends_test {

using namespace dispersive_shallow_water_1d;

constexpr double half_length = 5;
constexpr std::size_t cells = 80;
constexpr int steps = 250;
constexpr double tau = 0.02;

/// A heap of water, higher to the right, that moves to the right.
Flow patch(Stepping stepping) {
  const Channel channel{.bottom = std::make_shared<LevelBottom>(1.0), .left = End::free, .right = End::free};
  Markers markers = still_markers(channel, equal_labels(channel, -half_length, half_length, cells));
  for (std::size_t i = 0; i < markers.size(); ++i) {
    markers.y[i] = 0.3 * std::exp(-std::pow(markers.x[i] - 2, 2));
    markers.u[i] = 0.2;
  }
  return Flow(channel, markers, {.stepping = stepping});
}

TEST_CASE("a patch of water with free ends conserves momentum, and energy with the conservative stepping",
          "[conservation]") {
  Check check(
      "dispersive_free_ends", "A free patch of water: conservation without external forces",
      "Water over a length of 10 h on a level bottom, with free ends like dams just broken, moving and heaped to one "
      "side, collapses to both sides. Forces between cells are opposite, so that momentum is conserved by any scheme; "
      "the centre of mass moves uniformly; the conservative stepping conserves energy and volumes too.");
  auto& panel = check.figure("patch", "The patch collapses", "Surface by the conservative stepping, t = 0 to 5.")
                    .panel({.x = "x", .y = "elevation"});
  for (const auto& [name, stepping] : {std::pair{"one-step", Stepping::one_step},
                                       {"feedback", Stepping::one_step_feedback},
                                       {"conservative", Stepping::conservative}}) {
    const bool conservative = stepping == Stepping::conservative;
    const std::string id = name;
    Flow flow = patch(stepping);
    const double energy = flow.energy(), mass = flow.model().mass();
    const auto masses = flow.model().masses();
    const auto centre = [&] { return std::inner_product(masses.begin(), masses.end(), flow.x().begin(), 0.0) / mass; };
    const double start = centre();
    const double speed = flow.ledger().entry("momentum_x").initial / mass;
    Largest scale;  // of momentum: the root of the sum of the squares of the markers'
    Worst off_course;
    for (int k = 0; k <= steps; ++k) {
      if (k > 0) flow.advance(tau);
      flow.observe();
      double squares = 0;
      for (std::size_t i = 0; i < masses.size(); ++i) squares += std::pow(masses[i] * flow.p()[i], 2);
      scale.add(std::sqrt(squares));
      off_course.add(centre() - start - speed * flow.time());
      if (conservative && k % (steps / 5) == 0) panel.line(fmt::format("t = {:.0f}", flow.time()), flow.x(), flow.y());
    }
    const auto claim = [&](const std::string& what, const std::string& text, double value, double magnitude,
                           const std::string& reason) {
      check.holds(id + "-" + what + ": " + text, {value}, Roundoff{steps, magnitude, reason + ", once per step"});
    };
    claim("momentum", "Momentum is conserved to round-off between free ends.", flow.ledger().largest_defect("momentum"),
          scale.value(), "rounding of each node's m|u|, whose squares add up");
    claim("centre", "The centre of mass moves uniformly.", off_course.value(), 2 * half_length,
          "rounding of a position");
    if (!conservative) continue;
    claim("energy", "Energy is conserved to round-off between free ends.", flow.ledger().largest_defect("energy"),
          energy + mass, "rounding of the energy, which counts the bottom's");
    claim("volume", "The volume of every cell is conserved to round-off.", flow.ledger().largest_defect("volume_worst"),
          2 * half_length, "rounding of a position");
  }
}

}  // namespace seiche::verification::dispersive_shallow_water_free_ends_test
