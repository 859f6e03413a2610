// The dispersive shallow-water model makes whole steps in two passes over memory, with an elimination from both ends.
// They must do what the separate calls of the integrators do.
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/models/dispersive_shallow_water_1d/model.hpp"
#include "validation/instruments/cosine_bottom.hpp"
#include "verification/conservation/mechanical_problem.hpp"

namespace seiche::verification::dispersive_fused_step_test {

using namespace dispersive_shallow_water_1d;
using namespace mechanics;

constexpr double cotangent = 10;

struct Basin {
  std::string text;
  Channel channel;
};

/// Water of `cells` cells of 0.25 up to x = 0; the beach ends there.
std::vector<Basin> basins() {
  const auto level = std::make_shared<LevelBottom>(1.0);
  const auto beach = std::make_shared<PiecewiseLinearBottom>(std::vector{-1000.0, -cotangent, 10 * cotangent},
                                                             std::vector{-1.0, -1.0, 10.0});
  const auto waves = std::make_shared<CosineBottom>(1.0, 0.2, 0.3);
  return {{"level, walls", {.bottom = level}},
          {"wall and shore", {.bottom = beach, .right = End::tip}},
          {"wall and shore, Green-Naghdi", {.bottom = beach, .right = End::tip, .kinetics = Kinetics::green_naghdi}},
          {"uneven, walls", {.bottom = waves}}};
}

Markers pushed_water(const Channel& channel, std::size_t cells) {
  const double begin = -0.25 * static_cast<double>(cells);
  Markers markers = still_markers(channel, equal_labels(channel, begin, 0, cells));
  const double middle = begin / 2;
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const double s = (markers.x[i] - middle) / 4;
    markers.u[i] = 0.1 * std::exp(-s * s);
  }
  return markers;
}

template <class Step>
State run(Model& model, const Markers& markers, typename Step::Settings settings, double tau, int steps) {
  State state = model.state_of(markers);
  mechanics::Start(model).project(state);
  Step scheme(model, settings);
  for (int n = 0; n < steps; ++n) scheme.step(state, tau);
  return state;
}

/// No force, but one that only the separate calls can take.
Forcing nothing() {
  return {.body_force = [](double, std::span<double>, std::span<double>) {}};
}

constexpr double tau = 0.05;

/// Rounding at the places, up to `length`, is carried along by waves that neither grow nor decay.
Roundoff limit(int steps, double length) {
  return {.operations = 2.0 * steps * 64 + length * length,
          .scale = 1,
          .reason =
              "both variants add the same to a position, except for roundings of rates and multipliers of order 1, "
              "some 64 in a step; by these a position, up to the channel's length, may round the other way for once"};
}

/// The scheme reflects what feedback puts into the rates and never damps it.
Roundoff fed_back(double scale) {
  return {.operations = 2.0 * 1000,
          .scale = scale,
          .reason =
              "feedback divides the rounding of positions, up to 75, by tau in every step; impulses become multipliers "
              "by 2/tau"};
}

/// What fused and separate calls of a scheme lead to.
template <class Step>
std::pair<State, State> both(const Basin& basin, std::size_t cells, typename Step::Settings settings, int steps) {
  const Markers markers = pushed_water(basin.channel, cells);
  Model fused(basin.channel, markers), separate(basin.channel, markers, nothing());
  REQUIRE(fused.fuses_step());
  REQUIRE(!separate.fuses_step());
  return {run<Step>(fused, markers, settings, tau, steps), run<Step>(separate, markers, settings, tau, steps)};
}

/// What they come apart by: coordinates, rates and multipliers.
template <class Step>
double apart(const Basin& basin, std::size_t cells, typename Step::Settings settings, int steps) {
  const auto [a, b] = both<Step>(basin, cells, settings, steps);
  return worst(std::array{largest_difference(a, b), largest_difference(a.multipliers, b.multipliers)});
}

/// Around the blocks of 256 markers, in which the passes go.
const std::vector<std::size_t> sizes{60, 255, 256, 257, 511, 512, 700, 1024, 1300};

TEST_CASE("fused one-step steps agree with separate calls", "[robustness]") {
  Check check("dispersive_fused_step", "Dispersive shallow water: fused and separate passes, one-step scheme",
              "A pulse of velocity 0.1 in the middle of the water splits in two, 1000 steps of 0.05. Once with the "
              "fused step, once with the separate calls.");
  const int steps = 1000;
  for (const Basin& basin : basins()) {
    check.holds(fmt::format("Fused and separate steps agree ({}).", basin.text),
                {apart<OneStep<Model>>(basin, 300, {}, steps)}, limit(steps, 75));
    const auto [c, d] = both<OneStep<Model>>(basin, 300, {.drift_feedback = true}, steps);
    check.holds(fmt::format("Fused and separate steps with feedback agree ({}).", basin.text),
                {largest_difference(c, d)}, fed_back(75 / tau));
    check.holds(fmt::format("Multipliers of fused and separate steps agree ({}).", basin.text),
                {largest_difference(c.multipliers, d.multipliers)}, fed_back(75 / tau * 2 / tau));
  }
}

TEST_CASE("fused sweeps of the conservative step agree with separate calls", "[robustness]") {
  Check check("dispersive_fused_sweep", "Dispersive shallow water: fused and separate passes, conservative scheme",
              "As before with the fully conservative scheme, four sweeps per step, 1000 steps.");
  const int steps = 1000;
  for (const Basin& basin : basins()) {
    check.holds(fmt::format("Fused and separate sweeps agree: {}.", basin.text),
                {apart<ConservativeStep<Model>>(basin, 300, {.fixed_sweeps = 4}, steps)}, limit(steps, 75));
  }
}

TEST_CASE("fused steps agree with separate calls for any number of cells", "[robustness]") {
  Check check("dispersive_fused_sizes", "Dispersive shallow water: fused passes at the borders of blocks",
              "As before for numbers of cells around multiples of the block size, 256 nodes; 50 steps. One, two, "
              "several blocks, blocks of a single node.");
  const int steps = 50;
  for (const Basin& basin : basins()) {
    Largest worst;
    for (const std::size_t cells : sizes) {
      worst.add(apart<OneStep<Model>>(basin, cells, {}, steps));
      worst.add(apart<ConservativeStep<Model>>(basin, cells, {}, steps));
    }
    check.holds(fmt::format("Fused and separate steps agree for 60 to 1300 cells: {}.", basin.text), {worst.value()},
                limit(steps, 325));
  }
}

TEST_CASE("fused steps agree with separate calls in long channels", "[robustness]") {
  Check check("dispersive_fused_long", "Dispersive shallow water: fused passes of a long channel",
              "As before for 66000 cells in blocks of 2048 nodes; 20 steps.");
  const int steps = 20;
  constexpr std::size_t cells = 66000;
  for (const Basin& basin : basins()) {
    if (basin.channel.right == End::tip) continue;  // their bottom is shorter
    check.holds(fmt::format("Fused and separate steps agree for 66000 cells: {}.", basin.text),
                {worst(std::array{apart<OneStep<Model>>(basin, cells, {}, steps),
                                  apart<ConservativeStep<Model>>(basin, cells, {}, steps)})},
                limit(steps, 0.25 * static_cast<double>(cells)));
  }
}

}  // namespace seiche::verification::dispersive_fused_step_test
