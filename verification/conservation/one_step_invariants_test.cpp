// What the one-step scheme keeps to round-off.

#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"

namespace seiche::verification::one_step_invariants_test {

using namespace mechanics;
using namespace rigid_chain;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 1, formulas (4), (5)";

TEST_CASE("energy of a spherical double pendulum over a million steps", "[conservation]") {
  Check check("one_step_double_pendulum", "Spherical double pendulum: a million steps",
              "Pinned at the origin, unit links, masses 1 and 1.3, unit gravity: the potential is linear, so the "
              "energy is exact to the residual of the solver. The links are quadratic constraints, so that $f_s(q^n) - "
              "(\\tau^2/8)\\,u^n\\cdot f_s''u^n$ is constant although $f_s$ itself is not.",
              source);
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
  check.that("energy", "Energy is constant for a linear potential within a random walk of 1e6 roundings.",
             "largest energy defect [m g l]",
             {.value = watch.ledger().largest_defect("energy"), .resolution = resolution},
             Bound{1e-12, "a random walk of one rounding per step, 4 eps sqrt(1e6), in energies of order 1"});
  check.from("follows from the scheme for quadratic constraints")
      .that("modified-links", "Link lengths corrected by the velocities across them are constant to round-off.",
            "largest change of f - (tau^2/8) u.f''u [l^2]", {.value = modified.value(), .resolution = resolution},
            Roundoff{1e6, 1, "one rounded displacement of links of length 1 per step"});
}

TEST_CASE("a free rigid chain keeps energy and momenta", "[conservation]") {
  Check check("one_step_free_chain", "Free rigid chain of eleven masses",
              "No pin, no gravity, 1e5 steps of 0.01. The chain drifts away, so that the rounding of its angular "
              "momentum is relative to a growing distance.",
              source);
  auto chain = free_chain();
  State state = spiral_start(chain);
  OneStep<RigidChain> scheme(chain);
  InvariantsWatch watch(chain, state);
  for (int n = 0; n < 100000; ++n) {
    scheme.step(state, 0.01);
    watch.record(state);
  }
  check.at("tau = 0.01, 1e5 steps");
  check.that("energy", "Energy of the free chain is constant within a random walk of 1e5 roundings.",
             "largest energy defect", {watch.ledger().largest_defect("energy")},
             Bound{1e-12, "4 eps sqrt(1e5) times the kinetic energy, about 3.5"});
  check.that("momentum", "Momentum of the chain is constant within a random walk of 1e5 roundings.", "largest defect",
             {watch.ledger().largest_defect("momentum")}, Bound{1e-12, "4 eps sqrt(1e5) times sum m|u|, a few units"});
  check.that("angular-momentum", "Angular momentum of the free chain is constant.", "largest defect",
             {watch.ledger().largest_defect("angular_momentum")},
             Roundoff{1e5, scales_of(chain, state).angular_momentum,
                      "one rounded update per step of sum m|r||u|, which has grown to this"});
}

TEST_CASE("a quadratic potential has its own exact energy", "[conservation]") {
  Check check("one_step_quadratic_potential", "Energy law for a quadratic potential",
              "Chain on springs to the origin: $T + \\Pi - (\\tau^2/8)\\,u\\cdot\\Pi''u$ is exactly constant, so that "
              "the energy itself errs by $O(\\tau^2)$ and does not drift.",
              "follows from the scheme");
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
  check.that("modified-energy", "T + Pi - (tau^2/8) u.Pi''u is constant to round-off.", "largest defect",
             {.value = defect.value(), .resolution = "tau = 0.05, 10000 steps"},
             Roundoff{1e4, first, "one rounded energy per step"});
}

}  // namespace seiche::verification::one_step_invariants_test
