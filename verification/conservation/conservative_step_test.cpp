// The implicit variant: energy of a nonlinear potential, constraints and momenta to round-off.
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"
#include "verification/timed_steps.hpp"

namespace seiche::verification::conservative_step_test {

using namespace mechanics;
using namespace rigid_chain;

TEST_CASE("energy of a cubic potential and rigid links are exact at once", "[conservation]") {
  Check check("conservative_step_chain", "Chain in a cubic potential, fully conservative scheme",
              "Four masses, $\\Pi = \\sum m(gz + kr^2/2 + cz^3/3)$, tau = 0.02, 20000 steps, and Suzuki's fourth-order "
              "composition of it. A is factorised once per step and corrected by the sweeps.",
              "Quispel & McLaren, J. Phys. A 41 (2008) 045206");
  const auto run = [](bool composed) {
    RigidChain chain({.masses = alternating_masses(4), .gravity = 0.3, .spring = 0.5, .cubic = 0.05});
    State state = spiral_start(chain);
    ConservativeStep<RigidChain> base(chain);
    Composition suzuki(base, suzuki_weights());
    InvariantsWatch watch(chain, state);
    try {
      for (int n = 0; n < (composed ? 2000 : 20000); ++n) {
        composed ? suzuki.step(state, 0.2) : base.step(state, 0.02);
        watch.record(state);
      }
    } catch (const Divergence&) {
      constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
      return std::pair{nothing, nothing};
    }
    return std::pair{watch.ledger().largest_defect("energy"), watch.ledger().largest_defect("volume_worst")};
  };
  const auto plain = run(false);
  const auto composed = run(true);
  check.that("energy", "Energy of the chain is conserved to round-off.", "largest energy error",
             {largest(std::array{plain.first, composed.first})},
             Roundoff{20000, 10, "one rounded energy, of terms up to 10, per step"});
  check.from("bilinear constraints at the middle")
      .that("links", "Link lengths of the chain are conserved to round-off.", "largest link error",
            {largest(std::array{plain.second, composed.second})},
            Roundoff{20000, 3, "one rounded coordinate, up to 3, per step"});
}

TEST_CASE("implicit steps do not depend on the initial time or on the time loop", "[conservation]") {
  Check check("conservative_step_clock", "Fully conservative steps and the clock",
              "The motion of the chain in a cubic potential does not depend on the initial time: runs from t = 0, 1 or "
              "1024, by a loop of steps or by equal steps to an end time, all of 4/200, agree. A step starts from the "
              "velocity extrapolated from the two before; if one of them were lost because a time had changed, the "
              "step would need one sweep more.");
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
    return std::pair{state, base.total_sweeps()};
  };
  for (const bool composed : {false, true}) {
    const auto [first, sweeps] = run(0, false, composed);
    int different = 0;
    long most = sweeps;
    for (const double begin : {0.0, 1.0, 1024.0}) {
      for (const bool to_a_time : {false, true}) {
        const auto [other, other_sweeps] = run(begin, to_a_time, composed);
        different += other.q == first.q && other.u == first.u ? 0 : 1;
        if (other_sweeps > most) most = other_sweeps;
      }
    }
    const std::string id = composed ? "composed-" : "plain-", name = composed ? "Suzuki's composition" : "plain steps";
    check.holds(
        id + "bytes: Coordinates and rates do not depend on the first time, nor on who counts steps: " + name + ".",
        {static_cast<double>(different)}, Bound{0, "equality of bytes"});
    check.holds(id + "sweeps: The number of sweeps does not either: " + name + ".",
                {static_cast<double>(most - sweeps)}, Bound{0, "every step but the first extrapolates"});
  }
}

}  // namespace seiche::verification::conservative_step_test
