// The implicit variant: energy of a nonlinear potential, constraints and momenta to round-off.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"
#include "verification/conservation/flat_channel.hpp"
#include "verification/timed_steps.hpp"

namespace conservative_step_test {

using namespace seiche::mechanics;
using namespace seiche::rigid_chain;
using namespace seiche::verification;
using Channel = FlatChannel<seiche::linear::PeriodicTridiagonal>;
using seiche::largest;
using seiche::worst;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 3";
const std::string digits = "regression: computed once by an earlier program for the same equations";

struct Conservation {
  double energy = 0;  ///< relative to the wave's
  double momentum = 0;
  double volume = 0;  ///< of a cell, relative to it
  double solves = 0;  ///< per step
};

/// Solitary wave of amplitude 0.3 in a periodic channel of length 60, cells of about 0.25, until t = 100.
template <class Make>
Conservation solitary(double tau, const Make& make) {
  State state = solitary_start(0.3, 60, 240, true);
  Channel channel(state.q, 60);
  Start(channel).project(state);
  auto stepper = make(channel);
  InvariantsWatch watch(channel, state);
  const double energy = channel.kinetic_energy(state.q, state.u) + channel.potential_energy(state.q);
  const long before = channel.solves();
  const long steps = std::lround(100 / tau);
  for (long n = 0; n < steps; ++n) {
    stepper.step(state, tau);
    watch.record(state);
  }
  return {watch.ledger().largest_defect("energy") / energy, watch.ledger().largest_defect("momentum"),
          watch.ledger().largest_defect("volume_worst") / 0.25,
          static_cast<double>(channel.solves() - before) / static_cast<double>(steps)};
}

void known_digits(Check& check, const std::string& id, const std::string& text, double value, double expected) {
  check.holds(id + ": " + text, {value}, Bound{0.05, "expected values have two digits", expected, true});
}

TEST_CASE("a solitary wave in a periodic channel: what each scheme conserves", "[conservation]") {
  Check check(
      "mechanics_solitary_wave", "Solitary wave in a periodic flat channel: three schemes",
      "Amplitude 0.3, length 60, cells of 0.25, $t \\le 100$. One-step: energy and volumes err by $O(\\tau^2)$. With "
      "feedback the volumes no longer accumulate their drift. Fully conservative: all to round-off.");
  check.source(source);
  const auto one_step = [](Channel& c) { return OneStep<Channel>(c); };
  const auto feedback = [](Channel& c) { return OneStep<Channel>(c, {.drift_feedback = true}); };
  const auto conservative = [](Channel& c) { return ConservativeStep<Channel>(c); };
  const auto held = [](Channel& c) { return ConservativeStep<Channel>(c, {.drift_feedback = true}); };
  seiche::evidence::Table table{
      .id = "conservation",
      .title = "Largest defects",
      .caption = "Energy relative to the wave's, volume relative to the cell's.",
      .columns = {{"scheme", ""}, {"tau", "1"}, {"energy", "1"}, {"momentum", "1"}, {"volume", "1"}, {"solves", "1"}}};
  const auto row = [&](const std::string& name, double tau, const auto& make) {
    const Conservation c = solitary(tau, make);
    table.rows.push_back({name, tau, c.energy, c.momentum, c.volume, c.solves});
    return c;
  };
  const Conservation a1 = row("one-step", 0.1, one_step);
  const Conservation a2 = row("one-step", 0.05, one_step);
  const Conservation a3 = row("one-step", 0.025, one_step);
  const Conservation b2 = row("one-step, feedback", 0.05, feedback);
  const Conservation b3 = row("one-step, feedback", 0.025, feedback);
  const Conservation c2 = row("fully conservative", 0.05, conservative);
  const Conservation h2 = row("fully conservative, feedback", 0.05, held);
  check.table(table);
  known_digits(check, "A-energy-1", "The energy error of the one-step scheme at tau = 0.1", a1.energy, 1.3e-6);
  known_digits(check, "A-energy-2", "The energy error of the one-step scheme at tau = 0.05", a2.energy, 5.2e-7);
  known_digits(check, "A-energy-3", "The energy error of the one-step scheme at tau = 0.025", a3.energy, 1.4e-7);
  known_digits(check, "A-volume-1", "The cell-volume error of the one-step scheme at tau = 0.1", a1.volume, 1.5e-5);
  known_digits(check, "A-volume-2", "The cell-volume error of the one-step scheme at tau = 0.05", a2.volume, 3.7e-6);
  known_digits(check, "A-volume-3", "The cell-volume error of the one-step scheme at tau = 0.025", a3.volume, 9.4e-7);
  known_digits(check, "B-energy-2", "The energy error with feedback at tau = 0.05", b2.energy, 1.4e-6);
  known_digits(check, "B-energy-3", "The energy error with feedback at tau = 0.025", b3.energy, 1.3e-7);
  known_digits(check, "B-volume-2", "The cell-volume error with feedback at tau = 0.05", b2.volume, 1.5e-7);
  known_digits(check, "B-volume-3", "The cell-volume error with feedback at tau = 0.025", b3.volume, 1.8e-8);
  const double steps = 2000;
  check.that({.id = "C-energy",
              .text = "Energy is conserved to round-off (conservative scheme).",
              .quantity = "largest relative energy defect"},
             {.value = c2.energy, .resolution = "tau = 0.05"}, Roundoff{steps, 1, "one rounded energy per step"});
  check.that(
      {.id = "C-volume",
       .text = "Fully conservative: every cell's volume to round-off.",
       .quantity = "largest relative volume defect"},
      {.value = c2.volume, .resolution = "tau = 0.05"},
      Roundoff{steps, 60 / 0.25, "one rounded marker position, up to the channel's length, per step and cell width"});
  check.that({.id = "C-momentum",
              .text = "Momentum is conserved to round-off with every scheme.",
              .quantity = "largest momentum defect"},
             {.value = worst(std::array{a1.momentum, a2.momentum, a3.momentum, b2.momentum, b3.momentum, c2.momentum,
                                        h2.momentum})},
             Roundoff{4000, 1.6, "one rounded update per step of the wave's momentum"});
  check.that({.id = "C-feedback-volume",
              .text = "Volumes do not accumulate rounding (conservative scheme with feedback).",
              .quantity = "largest relative volume defect",
              .source = digits + ": 4.5e-14"},
             {.value = h2.volume, .resolution = "tau = 0.05"},
             Roundoff{16, 60 / 0.25, "a few rounded marker positions, up to the channel's length, per cell width"});
}

TEST_CASE("each sweep of the implicit step gains a fixed number of digits", "[conservation]") {
  Check check("conservative_step_sweeps", "Fixed numbers of sweeps",
              "Solitary wave as before, tau = 0.1: energy and volume defects after 1 to 4 sweeps per step.");
  const double energies[] = {7.6e-4, 1.3e-6, 1.6e-8, 6.2e-11};
  const double volumes[] = {1.0e-5, 2.2e-8, 9.3e-11};
  for (int sweeps = 1; sweeps <= 4; ++sweeps) {
    const Conservation c =
        solitary(0.1, [&](Channel& channel) { return ConservativeStep<Channel>(channel, {.fixed_sweeps = sweeps}); });
    const std::string n = std::to_string(sweeps);
    known_digits(check, "energy-" + n, n + " sweeps: energy.", c.energy, energies[sweeps - 1]);
    if (sweeps < 4) {
      check.holds(
          n + " sweeps: cell volume.", {c.volume},
          Bound{0.1, "two digits, relative to cells of 0.25 that are 1 % wider here", volumes[sweeps - 1], true});
    }
  }
}

TEST_CASE("energy of a cubic potential and rigid links are exact at once", "[conservation]") {
  Check check("conservative_step_chain", "Chain in a cubic potential, fully conservative scheme",
              "Four masses, $\\Pi = \\sum m(gz + kr^2/2 + cz^3/3)$, tau = 0.02, 20000 steps, and Suzuki's fourth-order "
              "composition of it. A is factorised once per step and corrected by the sweeps.");
  const auto run = [](bool composed) {
    RigidChain chain({.masses = alternating_masses(4), .gravity = 0.3, .spring = 0.5, .cubic = 0.05});
    State state = spiral_start(chain);
    ConservativeStep<RigidChain> base(chain);
    Composition suzuki(base, suzuki_weights());
    InvariantsWatch watch(chain, state);
    const int steps = composed ? 2000 : 20000;
    try {
      for (int n = 0; n < steps; ++n) {
        if (composed) {
          suzuki.step(state, 0.2);
        } else {
          base.step(state, 0.02);
        }
        watch.record(state);
      }
    } catch (const seiche::Divergence&) {
      constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
      return std::pair{nothing, nothing};
    }
    return std::pair{watch.ledger().largest_defect("energy"), watch.ledger().largest_defect("volume_worst")};
  };
  const auto plain = run(false);
  const auto composed = run(true);
  check.that({.id = "energy",
              .text = "Energy of the chain is conserved to round-off.",
              .quantity = "largest energy defect",
              .source = "Quispel & McLaren, J. Phys. A 41 (2008) 045206"},
             {.value = largest(std::array{plain.first, composed.first})},
             Roundoff{20000, 10, "one rounded energy, of terms up to 10, per step"});
  check.that({.id = "links",
              .text = "Link lengths of the chain are conserved to round-off.",
              .quantity = "largest link defect",
              .source = "bilinear constraints at the middle"},
             {.value = largest(std::array{plain.second, composed.second})},
             Roundoff{20000, 3, "one rounded coordinate, up to 3, per step"});
}

TEST_CASE("implicit steps do not depend on when they begin nor on who counts them", "[conservation]") {
  Check check("conservative_step_clock", "Fully conservative steps and the clock",
              "The chain in a cubic potential knows no time: begun at 0, 1 or 1024, by a loop of steps or by equal "
              "steps to a time, all of 4/200, it does the same. A step starts from the velocity extrapolated from the "
              "two before; were one lost, because a time is not what it was, it would take a sweep more.");
  struct Result {
    State state;
    long sweeps;
  };
  const auto run = [](double begin, bool to_a_time, bool composed) {
    RigidChain chain({.masses = alternating_masses(4), .gravity = 0.3, .spring = 0.5, .cubic = 0.05});
    State state = spiral_start(chain);
    state.time = begin;
    ConservativeStep<RigidChain> base(chain);
    Composition suzuki(base, suzuki_weights());
    const auto step = [&](double length) { composed ? suzuki.step(state, length) : base.step(state, length); };
    if (to_a_time) {
      TimedSteps flow{state, step};
      march(flow, begin + 4, 0.02);
    } else {
      for (int n = 0; n < 200; ++n) step(4.0 / 200);
    }
    return Result{state, base.total_sweeps()};
  };
  for (const bool composed : {false, true}) {
    const Result first = run(0, false, composed);
    int different = 0;
    long most = first.sweeps;
    for (const double begin : {0.0, 1.0, 1024.0}) {
      for (const bool to_a_time : {false, true}) {
        const Result other = run(begin, to_a_time, composed);
        different += other.state.q == first.state.q && other.state.u == first.state.u ? 0 : 1;
        if (other.sweeps > most) most = other.sweeps;
      }
    }
    const std::string id = composed ? "composed-" : "plain-";
    const std::string name = composed ? "Suzuki's composition" : "plain steps";
    check.holds(
        id + "bytes: Coordinates and rates do not depend on the first time, nor on who counts steps: " + name + ".",
        {static_cast<double>(different)}, Bound{0, "equality of bytes"});
    check.holds(id + "sweeps: The number of sweeps does not either: " + name + ".",
                {static_cast<double>(most - first.sweeps)}, Bound{0, "every step but the first extrapolates"});
  }
}

}  // namespace conservative_step_test
