// The dispersive shallow-water model does not know the direction of time, nor the level that heights count from.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/mechanics/conservative_step.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/dispersive_defects.hpp"

namespace seiche::verification::dispersive_symmetries_test {

using namespace dispersive_shallow_water_1d;

Channel periodic_channel() {
  return {.bottom = std::make_shared<LevelBottom>(1.0), .period = 60};
}

Markers solitary(const Channel& channel) {
  return solitary_markers(channel, 0, 60, 0.25, {.amplitude = 0.3, .crest = 30});
}

Flow after(const Channel& channel, const Markers& markers, double tau, int steps, Scheme scheme = {}) {
  Flow flow(channel, markers, scheme);
  for (int n = 0; n < steps; ++n) flow.advance(tau);
  return flow;
}

/// Markers as (x, y, u, v) seen from another frame.
template <class Change>
double largest_difference(const Flow& a, const Flow& b, const Change& change) {
  const std::vector<double> ua = a.u(), va = a.v(), ub = b.u(), vb = b.v();
  const std::size_t n = a.x().size();
  if (b.x().size() != n) return std::numeric_limits<double>::infinity();
  Worst largest;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [x, y, u, v] = change(b.x()[i], b.y()[i], ub[i], vb[i]);
    largest.add(a.x()[i] - x);
    largest.add(a.y()[i] - y);
    largest.add(ua[i] - u);
    largest.add(va[i] - v);
  }
  return largest.value();
}

struct Seen {
  double x, y, u, v;
};

Roundoff limit(int steps, double length) {
  return {.operations = 2.0 * steps,
          .scale = length,
          .reason = "both runs round every place, up to the largest, once per step; waves carry it on"};
}

constexpr double tau = 0.05;

TEST_CASE("dispersive shallow water returns when its velocities are reversed", "[conservation]") {
  Check check("dispersive_reversible", "Dispersive shallow water: time reversal",
              "1000 steps of 0.05, velocities reversed, 1000 steps back. The one-step scheme is symmetric over a level "
              "bottom, where the frames do not turn, in a periodic channel and between walls. The fully conservative "
              "one is symmetric over any bottom.");
  const int steps = 1000;
  using mechanics::ConservativeStep;
  using mechanics::OneStep;
  using mechanics::State;
  const auto there_and_back = [&]<class Step>(const Channel& channel, const Markers& markers, Step*) {
    Model model(channel, markers);
    State state = model.state_of(markers);
    mechanics::Start(model).project(state);
    const State start = state;
    Step scheme(model);
    for (int turn = 0; turn < 2; ++turn) {
      for (int n = 0; n < steps; ++n) scheme.step(state, tau);
      for (double& u : state.u) u = -u;
    }
    Worst largest;
    for (std::size_t i = 0; i < state.q.size(); ++i) largest.add(state.q[i] - start.q[i]);
    for (std::size_t i = 0; i < state.u.size(); ++i) largest.add(state.u[i] - start.u[i]);
    return largest.value();
  };
  const auto returns = [&](const std::string& id, const std::string& text, double value) {
    check.holds(id + ": " + text + ").", {value}, limit(2 * steps, 60));
  };
  const Channel periodic = periodic_channel();
  const Channel walls{.bottom = std::make_shared<LevelBottom>(1.0)};
  const Channel uneven{.bottom = std::make_shared<CosineBottom>(1.0, 0.2, 2 * std::numbers::pi / 10)};
  OneStep<Model>* const one_step = nullptr;
  ConservativeStep<Model>* const conservative = nullptr;
  returns("periodic", "one-step, periodic", there_and_back(periodic, solitary(periodic), one_step));
  returns("walls", "one-step, walls", there_and_back(walls, solitary(walls), one_step));
  returns("conservative", "conservative, periodic", there_and_back(periodic, solitary(periodic), conservative));
  Markers pushed = still_markers(uneven, equal_labels(uneven, 0, 60, 240));
  for (std::size_t i = 0; i < pushed.size(); ++i) pushed.u[i] = 0.2 * std::exp(-std::pow((pushed.x[i] - 30) / 4, 2));
  returns("conservative-uneven", "conservative, walls on an uneven bottom",
          there_and_back(uneven, pushed, conservative));
}

TEST_CASE("dispersive shallow water does not know the level that heights count from", "[conservation]") {
  Check check("dispersive_datum", "Dispersive shallow water: datum",
              "A level channel with heights counted from a place a quarter of a depth above the water: multipliers are "
              "smaller by $g/4$, nothing else changes.");
  const int steps = 600;
  const auto same = [&](const std::string& id, const std::string& text, double value, int n, double length) {
    check.holds(id + ": " + text, {value}, limit(n, length));
  };
  const Channel channel = periodic_channel();
  const Flow level = after(channel, solitary(channel), tau, steps);
  Channel raised = channel;
  raised.bottom = std::make_shared<LevelBottom>(1.25);
  Markers lowered = solitary(channel);
  for (double& y : lowered.y) y -= 0.25;
  const Flow from_above = after(raised, lowered, tau, steps);
  same("datum", "The level from which heights are counted does not matter.",
       largest_difference(level, from_above,
                          [](double x, double y, double u, double v) {
                            return Seen{x, y + 0.25, u, v};
                          }),
       steps, 60);
  Worst multiplier;
  for (std::size_t j = 0; j < level.multipliers().size(); ++j) {
    multiplier.add(level.multipliers()[j] - from_above.multipliers()[j] - 0.25);
  }
  same("datum-multipliers", "A raised datum adds its height to the multipliers.", multiplier.value(), steps, 60);
}

}  // namespace seiche::verification::dispersive_symmetries_test
