// Errors of the integrators name what was wrong, and leave the state as it was.
#include <cmath>
#include <limits>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "validation/instruments/mechanics/reference_integrators.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"

namespace seiche::verification::mechanics_input_test {

using namespace mechanics;
using namespace rigid_chain;
using Catch::Matchers::Contains;

template <class Stepper>
void refuses_bad_steps(Stepper&& stepper, State state) {
  const State before = state;
  for (const double tau : {0.0, -0.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_WITH(stepper.step(state, tau), Contains("tau"));
    CHECK(state.q == before.q);
    CHECK(state.steps == 0);
  }
}

TEST_CASE("integrators reject bad steps", "[robustness]") {
  auto chain = double_pendulum();
  const State state = spiral_start(chain);
  OneStep<RigidChain> base(chain);
  refuses_bad_steps(base, state);
  refuses_bad_steps(ConservativeStep<RigidChain>(chain), state);
  refuses_bad_steps(Composition(base, suzuki_weights()), state);
  refuses_bad_steps(RungeKutta2<RigidChain>(chain), state);
  refuses_bad_steps(Rattle<RigidChain>(chain), state);
}

TEST_CASE("an invalid state or invalid masses are named", "[robustness]") {
  auto chain = double_pendulum();
  State state = spiral_start(chain);
  state.u[4] = std::nan("");
  CHECK_THROWS_WITH(Start(chain).project(state), Contains("u[4]"));
  state.u.pop_back();
  CHECK_THROWS_WITH(Start(chain).project(state), Contains("u has 5 entries; the model needs 6"));
  CHECK_THROWS_WITH(RigidChain({.masses = {1, 0}}), Contains("mass"));
}

TEST_CASE("a rate that is not finite stops the run with time, step and position, and leaves the state unchanged",
          "[robustness]") {
  auto chain = double_pendulum();
  State state = spiral_start(chain);
  OneStep<RigidChain> scheme(chain);
  for (int n = 0; n < 3; ++n) scheme.step(state, 0.01);
  state.u[2] = 1e308;
  state.u[5] = -1e308;
  const State before = state;
  try {
    scheme.step(state, 1);
    FAIL("went on");
  } catch (const Divergence& error) {
    CHECK(error.step() == 3);
    CHECK(error.time() == before.time);
  } catch (const linear::NotPositiveDefinite&) {  // that it stopped, and left the state alone, is what matters
  }
  CHECK(state.q == before.q);
  CHECK(state.u == before.u);
}

TEST_CASE("an implicit step that does not converge reports it and leaves the state unchanged", "[robustness]") {
  auto chain = double_pendulum();
  State state = spiral_start(chain);
  const State before = state;
  CHECK_THROWS_AS(ConservativeStep<RigidChain>(chain).step(state, 5), Divergence);
  CHECK(state.q == before.q);
  CHECK(state.u == before.u);
}

TEST_CASE("the ledger adds up its entries and rejects wrong numbers of values", "[robustness]") {
  InvariantsLedger ledger;
  const std::size_t mass = ledger.watch("mass", 2);
  CHECK(std::isnan(ledger.entry("mass").largest_defect));
  ledger.book(mass, 0.25);
  ledger.record(std::vector{2.25});
  CHECK(ledger.entry("mass").defect == 0);
  ledger.record(std::vector{2.5});
  CHECK(ledger.entry("mass").step_defect == 0.25);
  ledger.record(std::vector{2.75});
  CHECK(ledger.entry("mass").defect == 0.5);
  CHECK(ledger.entry("mass").step_defect == 0.25);
  CHECK_THROWS_WITH(ledger.record(std::vector{1.0, 2.0}), Contains("values"));
  CHECK_THROWS_WITH(ledger.entry("energy"), Contains("mass"));
  ledger.record(std::vector{std::nan("")});
  ledger.record(std::vector{2.25});
  CHECK(std::isnan(ledger.entry("mass").largest_defect));
  CHECK(std::isnan(ledger.largest_defect("mass")));
}

}  // namespace seiche::verification::mechanics_input_test
