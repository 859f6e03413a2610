// Symmetries of the dispersive shallow-water model: time, moving frames, mirrors, units, the place of the origin.
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

namespace dispersive_symmetries_test {

using namespace seiche::dispersive_shallow_water_1d;
using namespace seiche::verification;
using seiche::LevelBottom;
using seiche::PiecewiseLinearBottom;
using seiche::Worst;
using seiche::evidence::Roundoff;

const std::string source = "invariance of the equations of motion";

Channel periodic_channel() {
  return {.bottom = std::make_shared<LevelBottom>(1.0), .period = 60};
}

Markers solitary(const Channel& channel, int direction = 1) {
  return solitary_markers(channel, 0, 60, 0.25, {.amplitude = 0.3, .crest = 30, .direction = direction});
}

/// Slope 1:3.732 to the right of x = place - 3.732, wall on the left; a solitary wave of a tenth of the depth.
struct Beach {
  Channel channel;
  Markers markers;
};

Beach beach(double place = 0, Kinetics kinetics = Kinetics::frank) {
  constexpr double cotangent = 3.732;
  Beach result;
  result.channel = {
      .bottom = std::make_shared<PiecewiseLinearBottom>(
          std::vector{place - 40, place - cotangent, place + 4 * cotangent}, std::vector{-1.0, -1.0, 4.0}),
      .left = End::wall,
      .right = End::tip,
      .kinetics = kinetics};
  result.markers = solitary_markers(result.channel, place - 30, place, 0.25, {.amplitude = 0.1, .crest = place - 15});
  return result;
}

Flow after(const Channel& channel, const Markers& markers, double tau, int steps, Scheme scheme = {}) {
  Flow flow(channel, markers, scheme);
  for (int n = 0; n < steps; ++n) flow.advance(tau);
  return flow;
}

/// Markers as (x, y, u, v) seen from another frame.
template <class Change>
double largest_difference(const Flow& a, const Flow& b, bool reversed, const Change& change) {
  const std::vector<double> ua = a.u(), va = a.v(), ub = b.u(), vb = b.v();
  const std::size_t n = a.x().size();
  if (b.x().size() != n) return std::numeric_limits<double>::infinity();
  Worst largest;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = reversed ? n - 1 - i : i;
    const auto [x, y, u, v] = change(b.x()[k], b.y()[k], ub[k], vb[k]);
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
  using seiche::mechanics::ConservativeStep;
  using seiche::mechanics::OneStep;
  using seiche::mechanics::State;
  const auto there_and_back = [&]<class Step>(const Channel& channel, const Markers& markers, Step*) {
    Model model(channel, markers);
    State state = model.state_of(markers);
    seiche::mechanics::Start(model).project(state);
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
    check.that({.id = id,
                .text = text + ": the start returns.",
                .quantity = "largest difference of a coordinate or rate",
                .source = source},
               {.value = value, .resolution = "tau = 0.05, 1000 steps each way"}, limit(2 * steps, 60));
  };
  const Channel periodic = periodic_channel();
  const Channel walls{.bottom = std::make_shared<LevelBottom>(1.0)};
  const Channel uneven{.bottom = std::make_shared<seiche::CosineBottom>(1.0, 0.2, 2 * std::numbers::pi / 10)};
  OneStep<Model>* const one_step = nullptr;
  ConservativeStep<Model>* const conservative = nullptr;
  returns("periodic", "One-step, periodic", there_and_back(periodic, solitary(periodic), one_step));
  returns("walls", "One-step, walls", there_and_back(walls, solitary(walls), one_step));
  returns("conservative", "Fully conservative, periodic", there_and_back(periodic, solitary(periodic), conservative));
  Markers pushed = still_markers(uneven, equal_labels(uneven, 0, 60, 240));
  for (std::size_t i = 0; i < pushed.size(); ++i) pushed.u[i] = 0.2 * std::exp(-std::pow((pushed.x[i] - 30) / 4, 2));
  returns("conservative-uneven", "Fully conservative, walls on an uneven bottom",
          there_and_back(uneven, pushed, conservative));
  check.measure("one-step on an uneven bottom, of second order in the step", there_and_back(uneven, pushed, one_step));
}

TEST_CASE("dispersive shallow water is the same from a moving frame", "[conservation]") {
  Check check(
      "dispersive_galilean", "Dispersive shallow water: Galilean invariance",
      "Solitary wave in a periodic level channel, once at rest and once with 0.3 added to all velocities: after "
      "1000 steps of 0.05 the markers differ by the path of the frame, 15.");
  const int steps = 1000;
  const double drift = 0.3;
  const Channel channel = periodic_channel();
  const Markers at_rest = solitary(channel);
  Markers moving = at_rest;
  for (double& u : moving.u) u += drift;
  for (const auto& [id, stepping] :
       {std::pair{"one-step", Stepping::one_step}, std::pair{"conservative", Stepping::conservative}}) {
    const Flow a = after(channel, at_rest, tau, steps, {.stepping = stepping});
    const Flow b = after(channel, moving, tau, steps, {.stepping = stepping});
    const double path = drift * a.time();
    check.that({.id = id,
                .text = fmt::format("{}: the same flow from a moving frame.", id),
                .quantity = "largest difference of a place or velocity",
                .source = source},
               {.value = largest_difference(a, b, false,
                                            [&](double x, double y, double u, double v) {
                                              return Seen{x - path, y, u - drift, v};
                                            }),
                .resolution = "1000 steps"},
               limit(steps, 75));
  }
}

TEST_CASE("dispersive shallow water is the same in a mirror", "[conservation]") {
  Check check("dispersive_mirror", "Dispersive shallow water: mirror images",
              "A solitary wave that runs to the left is the mirror image of one that runs to the right, in a periodic "
              "channel and on a beach, for either kinetic energy.");
  const auto mirrored = [](const Markers& markers, double axis) {
    Markers image;
    image.x.assign(markers.x.rbegin(), markers.x.rend());
    image.y.assign(markers.y.rbegin(), markers.y.rend());
    image.u.assign(markers.u.rbegin(), markers.u.rend());
    image.v.assign(markers.v.rbegin(), markers.v.rend());
    for (double& x : image.x) x = 2 * axis - x;
    for (double& u : image.u) u = -u;
    return image;
  };
  const auto compare = [&](const std::string& id, const std::string& text, const Flow& a, const Flow& b, double axis,
                           double length) {
    check.that({.id = id,
                .text = text + ": the mirror image.",
                .quantity = "largest difference of a place or velocity",
                .source = source},
               {.value = largest_difference(a, b, true,
                                            [&](double x, double y, double u, double v) {
                                              return Seen{2 * axis - x, y, -u, v};
                                            }),
                .resolution = fmt::format("{} steps", a.steps())},
               limit(static_cast<int>(a.steps()), length));
  };
  const Channel channel = periodic_channel();
  const Markers right = solitary(channel);
  compare("periodic", "Periodic", after(channel, right, tau, 1000), after(channel, mirrored(right, 30), tau, 1000), 30,
          120);
  const Channel walls{.bottom = std::make_shared<LevelBottom>(1.0)};
  compare("walls", "Walls, waves started to the left and to the right", after(walls, solitary(walls), tau, 1000),
          after(walls, solitary(walls, -1), tau, 1000), 30, 60);
  for (const Kinetics kinetics : {Kinetics::frank, Kinetics::green_naghdi}) {
    const Beach original = beach(0, kinetics);
    Channel image = original.channel;
    image.bottom =
        std::make_shared<PiecewiseLinearBottom>(std::vector{-4 * 3.732, 3.732, 40.0}, std::vector{4.0, -1.0, -1.0});
    std::swap(image.left, image.right);
    compare(kinetics == Kinetics::frank ? "beach" : "beach-gn",
            kinetics == Kinetics::frank ? "Beach" : "Beach, Green-Naghdi",
            after(original.channel, original.markers, tau, 600), after(image, mirrored(original.markers, 0), tau, 600),
            0, 30);
  }
}

TEST_CASE("dispersive shallow water does not know units or the origin", "[conservation]") {
  Check check("dispersive_units", "Dispersive shallow water: units and origin",
              "Run-up on a slope 1:3.732 in units of the depth and of $\\sqrt{\\text{depth}/g}$, and in metres and "
              "seconds with a depth of 10 m, $g = 9.81$ m/s$^2$ and water of 1000 kg/m$^3$. The same beach 50 depths "
              "further to the right. A level channel with heights counted from a place a quarter of a depth above the "
              "water: multipliers are smaller by $g/4$, nothing else changes.");
  const int steps = 600;
  const Beach plain = beach();
  const Flow reference = after(plain.channel, plain.markers, tau, steps);
  const auto same = [&](const std::string& id, const std::string& text, double value, int n, double length) {
    check.that({.id = id, .text = text, .quantity = "largest difference of a place or velocity", .source = source},
               {.value = value, .resolution = fmt::format("{} steps", n)}, limit(n, length));
  };
  const double depth = 10;
  const double gravity = 9.81;
  const double speed = std::sqrt(gravity * depth);
  Channel metres = plain.channel;
  metres.bottom =
      std::make_shared<PiecewiseLinearBottom>(std::vector{-400.0, -37.32, 4 * 37.32}, std::vector{-10.0, -10.0, 40.0});
  metres.gravity = gravity;
  metres.density = 1000;
  Markers scaled = plain.markers;
  for (auto* lengths : {&scaled.x, &scaled.y}) {
    for (double& value : *lengths) value *= depth;
  }
  for (auto* speeds : {&scaled.u, &scaled.v}) {
    for (double& value : *speeds) value *= speed;
  }
  const Flow in_metres = after(metres, scaled, tau * depth / speed, steps);
  same("metres", "Metres and seconds give the same flow.",
       largest_difference(reference, in_metres, false,
                          [&](double x, double y, double u, double v) {
                            return Seen{x / depth, y / depth, u / speed, v / speed};
                          }),
       steps, 30);
  Worst pressure;
  for (std::size_t j = 0; j < reference.multipliers().size(); ++j) {
    const double scale = metres.density * gravity * depth;
    pressure.add(reference.multipliers()[j] - in_metres.multipliers()[j] / scale);
  }
  same("pressure", "So do the multipliers, in units of the pressure at the bottom.", pressure.value(), steps, 30);
  same(
      "place", "The place of the origin does not matter.",
      [&] {
        const Beach moved = beach(50);
        return largest_difference(reference, after(moved.channel, moved.markers, tau, steps), false,
                                  [](double x, double y, double u, double v) {
                                    return Seen{x - 50, y, u, v};
                                  });
      }(),
      steps, 50);
  const Channel channel = periodic_channel();
  const Flow level = after(channel, solitary(channel), tau, steps);
  Channel raised = channel;
  raised.bottom = std::make_shared<LevelBottom>(1.25);
  Markers lowered = solitary(channel);
  for (double& y : lowered.y) y -= 0.25;
  const Flow from_above = after(raised, lowered, tau, steps);
  same("datum", "The level from which heights are counted does not matter.",
       largest_difference(level, from_above, false,
                          [](double x, double y, double u, double v) {
                            return Seen{x, y + 0.25, u, v};
                          }),
       steps, 60);
  Worst multiplier;
  for (std::size_t j = 0; j < level.multipliers().size(); ++j) {
    multiplier.add(level.multipliers()[j] - from_above.multipliers()[j] - 0.25);
  }
  same("datum-multipliers", "It adds its height to the multipliers.", multiplier.value(), steps, 60);
}

}  // namespace dispersive_symmetries_test
