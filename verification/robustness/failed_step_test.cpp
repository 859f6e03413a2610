// A step that throws, whatever and wherever, leaves everything as it was: the strong guarantee of all steppers.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "validation/instruments/mechanics/reference_integrators.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"

namespace seiche::verification::failed_step_test {

using namespace mechanics;
using rigid_chain::RigidChain;

bool same(const State& a, const State& b) {
  return a.q == b.q && a.u == b.u && a.time == b.time && a.steps == b.steps && a.multipliers == b.multipliers &&
         a.earlier_multipliers == b.earlier_multipliers;
}

/// A chain that cannot be at its `count`-th linearisation, or does not come to the end of its `count`-th step.
struct FragileChain : RigidChain {
  enum class At { linearise, settle };
  FragileChain(At here, int count) : RigidChain(rigid_chain::double_pendulum()), where(here), left(count) {}
  void linearise(Interval when, Input q) {
    pass(At::linearise);
    RigidChain::linearise(when, q);
  }
  void linearise_between(Interval when, Input q0, Input q1, int sweep) {
    pass(At::linearise);
    RigidChain::linearise_between(when, q0, q1, sweep);
  }
  void settle(Interval, Output, Output u) const {
    pass(At::settle);
    u[0] += 1e-9;  // what walls, tips and frames do
  }
  void pass(At here) const {
    if (here == where && --left == 0) throw Infeasible("a link breaks", 0.5);
  }

  At where;
  mutable int left;
};

struct Failures {
  int all = 0, changed = 0, unnamed = 0;
};

/// Steps until the chain breaks; counts a changed state, and an exception that does not say when.
void break_chain(FragileChain::At where, int count, const std::function<StepFunction(FragileChain&)>& make,
                 Failures& failures) {
  FragileChain chain(where, count);
  const StepFunction step = make(chain);
  RigidChain sound = rigid_chain::double_pendulum();
  State state = rigid_chain::spiral_start(sound);
  State before = state;
  try {
    for (int n = 0; n < 40; ++n) {
      before = state;
      step(state, 0.02);
    }
    return;  // an integrator that does not ask for it
  } catch (const Divergence& failure) {
    // The stages of the triple jump go from -0.352 to 1.352 of a step.
    if (std::abs(failure.time() - before.time) > 1.352 * 0.02 || failure.step() != before.steps) ++failures.unnamed;
  } catch (const Infeasible&) {
    ++failures.unnamed;
  }
  ++failures.all;
  if (!same(state, before)) ++failures.changed;
}

/// Advances until a step throws; whether it left the flow's state as it was.
template <class Flow>
bool keeps_state(Flow& flow, double tau) {
  for (int n = 0; n < 400; ++n) {
    const State before = flow.state();
    try {
      flow.advance(tau);
    } catch (const std::exception&) {
      return same(flow.state(), before);
    }
  }
  FAIL("no step failed");
  return false;
}

TEST_CASE("a step that fails leaves the state as it was, with every integrator", "[robustness]") {
  Check check("failed_steps", "Steps that fail: integrators",
              "A chain breaks at one of its first linearisations, in stages and sweeps of the third or a later step, "
              "or at the end of a step or stage. Coordinates, rates, multipliers, time and number of steps are then "
              "unchanged, and the exception is a Divergence with the time of the stage and the step.");
  Failures failures;
  for (const auto where : {FragileChain::At::linearise, FragileChain::At::settle}) {
    for (const int count : {3, 8, 17, 30}) {
      for (const Integrator integrator : all_integrators) {
        const auto make = [&](FragileChain& chain) { return make_integrator(integrator, chain); };
        break_chain(where, count, make, failures);
      }
      const auto projected = [](FragileChain& chain) {
        const auto step = std::make_shared<ProjectedStep<FragileChain>>(chain);
        return [step](State& state, double tau) { step->step(state, tau); };
      };
      break_chain(where, count, projected, failures);
    }
  }
  REQUIRE(failures.all > 50);
  check.holds("A step that fails leaves the state as it was (nine integrators).",
              {static_cast<double>(failures.changed)},
              Bound{0, "equality of bytes: a caller may go on with a shorter step"});
  check.holds("The failure is reported with the time of the stage and the step (nine integrators).",
              {static_cast<double>(failures.unnamed)}, Bound{0, "seiche::Divergence, whichever stage failed"});
}

TEST_CASE("a step that fails leaves a flow as it was", "[robustness]") {
  Check check("failed_flow_steps", "Steps that fail: flows",
              "Water that reaches the end of the curve it slides along, within or at the end of a step; pressure, "
              "absorption or a wall's motion whose function throws at a later time. The state is the one before the "
              "step, also for the first step with its smooth start.");
  int changed = 0;
  const auto count = [&](auto flow, double tau) { changed += keeps_state(flow, tau) ? 0 : 1; };
  const auto give_up_after = [](double last) {
    return [last](double, double time) -> double {
      if (time > last) throw std::runtime_error("no pressure is known");
      return 1e-3 * std::sin(time);
    };
  };
  namespace mesh = lagrangian_mesh_2d;
  using mesh::Stepping;
  const mesh::Layer layer{.end = 4, .columns = 16, .rows = 4};
  const auto stretched = [](Point r) { return Point{0.3 * r.x / 4, 0}; };
  const auto sloshing = [](Point r) { return Point{0.1 * std::sin(r.x), 0}; };
  for (const Stepping stepping : {Stepping::one_step, Stepping::one_step_feedback, Stepping::conservative}) {
    for (const double tau : {0.05, 0.06, 0.07, 0.08, 0.09}) {
      count(mesh::Flow(water_at_short_wall(), stretched, {.stepping = stepping}), tau);
    }
    for (const double last : {0.0, 0.5}) {
      for (const auto composition : {TimeComposition::none, TimeComposition::suzuki}) {
        count(mesh::Flow(mesh::layer_mesh(layer), sloshing, {.stepping = stepping, .composition = composition}, {},
                         {.surface_pressure = give_up_after(last)}),
              0.05);
      }
    }
  }
  namespace cells = lagrangian_mesh_3d;
  const auto wave = [](double x, double) { return 0.05 * std::cos(x); };
  for (const double last : {0.0, 0.5}) {
    const auto force = [last](const auto&, double time) {
      if (time > last) throw std::runtime_error("no force is known");
      return cells::Vector{};
    };
    count(cells::Flow(cells::layer_mesh({.end = 4, .north = 4, .columns = 8, .rows = 8, .elevation = wave}), {}, {}, {},
                      {}, true, {.body_force = force}),
          0.05);
  }
  check.holds("A step that fails leaves the state of the flow as it was.", {static_cast<double>(changed)},
              Bound{0, "equality of bytes: a caller may go on with a shorter step"});
}

TEST_CASE("a failed step leaves the losses by friction and breaking unchanged", "[robustness]") {
  namespace water = dispersive_shallow_water_1d;
  Check check("failed_step_losses", "Steps that fail: friction and breaking",
              "A bore runs up a beach with friction; then a step of 1000 s is tried, which fails. State, energy lost "
              "and breaking fronts are as before, and 20 more steps equal the steps of a flow without a failure.");
  const auto flow_of = [] {
    const auto beach =
        std::make_shared<PiecewiseLinearBottom>(std::vector{-100.0, 0.0, 100.0}, std::vector{-1.0, -1.0, 9.0});
    const water::Channel channel{.bottom = beach,
                                 .right = water::End::tip,
                                 .friction = {.coefficient = 0.02},
                                 .breaking = water::Breaking{.onset_slope = 0.05}};
    water::Markers markers = water::still_markers(channel, water::equal_labels(channel, -30, 10, 200));
    const auto push = [](double x) { return 0.9 * std::exp(-std::pow((x + 15) / 4, 2)); };
    std::ranges::transform(markers.x, markers.u.begin(), push);
    return water::Flow(channel, markers);
  };
  water::Flow plain = flow_of(), tried = flow_of();
  for (water::Flow* flow : {&plain, &tried}) {
    for (int n = 0; n < 60; ++n) flow->advance(0.02);
  }
  REQUIRE(plain.lost().breaking > 0);
  REQUIRE(plain.lost().friction > 0);
  CHECK_THROWS_AS(tried.advance(1000), Divergence);
  for (water::Flow* flow : {&plain, &tried}) {
    for (int n = 0; n < 20; ++n) flow->advance(0.02);
  }
  const water::Losses a = plain.lost(), b = tried.lost();
  check.holds("The continuation after a failed step equals a run without that step.",
              {(same(plain.state(), tried.state()) ? 0.0 : 1.0) + (a.friction == b.friction ? 0 : 1) +
               (a.breaking == b.breaking ? 0 : 1)},
              Bound{0, "equality of bytes"});
}

}  // namespace seiche::verification::failed_step_test
