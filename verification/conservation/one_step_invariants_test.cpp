// What the one-step scheme keeps to round-off.
#include <algorithm>
#include <cmath>

#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"

namespace one_step_invariants_test {

using namespace seiche::mechanics;
using namespace seiche::rigid_chain;
using namespace seiche::verification;
using seiche::Largest;
using seiche::Worst;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 1, formulas (4), (5)";

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  Worst largest;
  for (std::size_t i = 0; i < a.size(); ++i) largest.add(a[i] - b[i]);
  return largest.value();
}

TEST_CASE("energy of a spherical double pendulum over a million steps", "[conservation]") {
  Check check("one_step_double_pendulum", "Spherical double pendulum: a million steps",
              "Pinned at the origin, unit links, masses 1 and 1.3, unit gravity: the potential is linear, so the "
              "energy is exact to the residual of the solver. The links are quadratic constraints, so that $f_s(q^n) - "
              "(\\tau^2/8)\\,u^n\\cdot f_s''u^n$ is constant although $f_s$ itself is not.");
  auto pendulum = double_pendulum();
  State state = spiral_start(pendulum);
  OneStep<RigidChain> scheme(pendulum);
  InvariantsWatch watch(pendulum, state);
  const double tau = 0.01;
  std::vector<double> links(2);
  std::vector<double> bending(2);
  std::vector<double> first(2);
  Worst modified;
  const long steps = 1000000;
  for (long n = 0; n <= steps; ++n) {
    pendulum.constraint_values(state.q, links);
    pendulum.curvature(state.u, state.u, bending);
    for (std::size_t s = 0; s < 2; ++s) {
      const double value = links[s] - tau * tau / 8 * bending[s];
      if (n == 0) first[s] = value;
      modified.add(value - first[s]);
    }
    if (n == steps) break;
    scheme.step(state, tau);
    watch.record(state);
  }
  const std::string resolution = "tau = 0.01, 1e6 steps";
  check.that({.id = "energy",
              .text = "Energy is constant to round-off for a linear potential.",
              .quantity = "largest energy defect",
              .unit = "m g l",
              .source = source},
             {.value = watch.ledger().largest_defect("energy"), .resolution = resolution},
             Bound{1e-12, "a random walk of one rounding per step, 4 eps sqrt(1e6), in energies of order 1"});
  check.that({.id = "modified-links",
              .text = "Link lengths corrected by the velocities across them are constant to round-off.",
              .quantity = "largest change of f - (tau^2/8) u.f''u",
              .unit = "l^2",
              .source = "follows from the scheme for quadratic constraints"},
             {.value = modified.value(), .resolution = resolution},
             Roundoff{1e6, 1, "one rounded displacement of links of length 1 per step"});
}

TEST_CASE("a free rigid chain keeps energy and momenta", "[conservation]") {
  Check check("one_step_free_chain", "Free rigid chain of eleven masses",
              "No pin, no gravity, 1e5 steps of 0.01. The chain drifts away, so that the rounding of its angular "
              "momentum is relative to a growing distance.");
  check.source(source);
  auto chain = free_chain();
  State state = spiral_start(chain);
  OneStep<RigidChain> scheme(chain);
  InvariantsWatch watch(chain, state);
  for (int n = 0; n < 100000; ++n) {
    scheme.step(state, 0.01);
    watch.record(state);
  }
  const std::string resolution = "tau = 0.01, 1e5 steps";
  check.that({.id = "energy", .text = "Energy of the free chain is constant.", .quantity = "largest energy defect"},
             {.value = watch.ledger().largest_defect("energy"), .resolution = resolution},
             Bound{1e-12, "4 eps sqrt(1e5) times the kinetic energy, about 3.5"});
  check.that(
      {.id = "momentum", .text = "Momentum of the chain is constant to round-off.", .quantity = "largest defect"},
      {.value = watch.ledger().largest_defect("momentum"), .resolution = resolution},
      Bound{1e-12, "4 eps sqrt(1e5) times sum m|u|, a few units"});
  check.that({.id = "angular-momentum",
              .text = "Angular momentum of the free chain is constant.",
              .quantity = "largest defect"},
             {.value = watch.ledger().largest_defect("angular_momentum"), .resolution = resolution},
             Roundoff{1e5, scales_of(chain, state).angular_momentum,
                      "one rounded update per step of sum m|r||u|, which has grown to this"});
}

TEST_CASE("the one-step scheme is reversible", "[conservation]") {
  Check check("one_step_reversible", "Time reversal",
              "Steps forward, velocities reversed, as many steps: the start returns, for the free chain (no "
              "potential), the pendulum (linear) and a chain in a cubic potential.");
  Largest defect;
  for (const double cubic : {0.0, 0.3}) {
    for (const bool pinned : {false, true}) {
      RigidChain chain(
          {.masses = alternating_masses(4), .pinned = pinned, .gravity = pinned ? 1.0 : 0.0, .cubic = cubic});
      State state = spiral_start(chain);
      const State start = state;
      OneStep<RigidChain> scheme(chain);
      for (int turn = 0; turn < 2; ++turn) {
        for (int n = 0; n < 100; ++n) scheme.step(state, 0.01);
        for (double& u : state.u) u = -u;
      }
      defect.add(largest_difference(state.q, start.q));
      defect.add(largest_difference(state.u, start.u));
    }
  }
  check.that({.id = "return",
              .text = "The reversed run returns to its start.",
              .quantity = "largest difference of a coordinate or a rate",
              .source = source},
             {.value = defect.value(), .resolution = "tau = 0.01, 100 steps each way"},
             Roundoff{200 * 12, 4, "200 steps of about 12 roundings of coordinates up to 4"});
}

TEST_CASE("a quadratic potential has its own exact energy", "[conservation]") {
  Check check("one_step_quadratic_potential", "Energy law for a quadratic potential",
              "Chain on springs to the origin: $T + \\Pi - (\\tau^2/8)\\,u\\cdot\\Pi''u$ is exactly constant, so that "
              "the energy itself errs by $O(\\tau^2)$ and does not drift.");
  const double stiffness = 0.8;
  const double tau = 0.05;
  RigidChain chain({.masses = alternating_masses(4), .spring = stiffness});
  State state = spiral_start(chain);
  OneStep<RigidChain> scheme(chain);
  const auto modified = [&] {
    const double kinetic = chain.kinetic_energy(state.q, state.u);
    return kinetic * (1 - tau * tau * stiffness / 4) + chain.potential_energy(state.q);
  };
  InvariantsWatch watch(chain, state);
  const double first = modified();
  Worst defect;
  for (int n = 0; n < 10000; ++n) {
    scheme.step(state, tau);
    watch.record(state);
    defect.add(modified() - first);
  }
  check.that({.id = "modified-energy",
              .text = "T + Pi - (tau^2/8) u.Pi''u is constant to round-off.",
              .quantity = "largest defect",
              .source = "follows from the scheme"},
             {.value = defect.value(), .resolution = "tau = 0.05, 10000 steps"},
             Roundoff{1e4, first, "one rounded energy per step"});
}

}  // namespace one_step_invariants_test
