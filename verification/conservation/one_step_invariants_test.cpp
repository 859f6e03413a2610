// What the one-step scheme keeps to round-off, and what still holds where multipliers are solved loosely, as iterative
// solvers leave them.
#include <algorithm>
#include <cmath>
#include <random>

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
  constexpr double tau = 0.01;
  std::vector<double> links(2), bending(2), first(2);
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
             "largest energy error [m g l]",
             {.value = watch.ledger().largest_defect("energy"), .resolution = resolution},
             Bound{1e-12, "a random walk of one rounding per step, 4 eps sqrt(1e6), in energies of order 1"});
  check.from("follows from the scheme for quadratic constraints")
      .that("modified-links", "Link lengths corrected by the velocities across them are constant to round-off.",
            "largest change of f - (tau^2/8) u.f''u [l^2]", {.value = modified.value(), .resolution = resolution},
            Roundoff{1e6, 1, "one rounded displacement of links of length 1 per step"});
}

TEST_CASE("a free rigid chain conserves energy and momenta", "[conservation]") {
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
  const InvariantsLedger& ledger = watch.ledger();
  check.at("tau = 0.01, 1e5 steps");
  check.that("energy", "Energy of the free chain is constant within a random walk of 1e5 roundings.",
             "largest energy error", {ledger.largest_defect("energy")},
             Bound{1e-12, "4 eps sqrt(1e5) times the kinetic energy, about 3.5"});
  check.that("momentum", "Momentum of the chain is constant within a random walk of 1e5 roundings.", "largest defect",
             {ledger.largest_defect("momentum")}, Bound{1e-12, "4 eps sqrt(1e5) times sum m|u|, a few units"});
  check.that("angular-momentum", "Angular momentum of the free chain is constant.", "largest defect",
             {ledger.largest_defect("angular_momentum")},
             Roundoff{1e5, scales_of(chain, state).angular_momentum,
                      "one rounded update per step of sum m|r||u|, which has grown to this"});
}

TEST_CASE("a quadratic potential has its own exact energy", "[conservation]") {
  Check check("one_step_quadratic_potential", "Energy law for a quadratic potential",
              "Chain on springs to the origin: $T + \\Pi - (\\tau^2/8)\\,u\\cdot\\Pi''u$ is exactly constant, so that "
              "the energy itself errs by $O(\\tau^2)$ and does not drift.",
              "follows from the scheme");
  constexpr double stiffness = 0.8, tau = 0.05;
  RigidChain chain({.masses = alternating_masses(4), .spring = stiffness});
  State state = spiral_start(chain);
  OneStep<RigidChain> scheme(chain);
  const auto modified = [&] {
    const double kinetic = chain.kinetic_energy(state.q, state.u);
    return kinetic * (1 - tau * tau * stiffness / 4) + chain.potential_energy(state.q);
  };
  const double first = modified();
  Worst defect;
  for (int n = 0; n < 10000; ++n) {
    scheme.step(state, tau);
    defect.add(modified() - first);
  }
  check.that("modified-energy", "T + Pi - (tau^2/8) u.Pi''u is constant to round-off.", "largest defect",
             {.value = defect.value(), .resolution = "tau = 0.05, 10000 steps"},
             Roundoff{1e4, first, "one rounded energy per step"});
}

enum class Error { systematic, random };

/// Every multiplier is wrong by the fraction e, or by a random fraction between -e and e.
class LooseChain : public RigidChain {
 public:
  LooseChain(RigidChain chain, Error kind, double e) : RigidChain(std::move(chain)), kind_(kind), fraction_(e) {}

  void solve(Input right_hand_side, Output mu) {
    RigidChain::solve(right_hand_side, mu);
    for (double& impulse : mu) impulse *= 1 + fraction_ * (kind_ == Error::systematic ? 1 : uniform_(random_));
  }

 private:
  Error kind_;
  double fraction_;
  std::minstd_rand random_{1};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

/// Largest over runs.
struct Defects {
  Worst unexplained;      ///< of a step, after the multipliers' work on the residual is booked
  Worst unexplained_sum;  ///< of the whole run, likewise
  Worst momentum, angular_momentum, vertical;
  Scales scales;
};

constexpr int loose_steps = 1000;
constexpr double tau = 0.01;

void run(LooseChain chain, Defects& largest) {
  State state = spiral_start(chain);
  OneStep<LooseChain> scheme(chain);
  InvariantsWatch booked(chain, state);
  std::vector<double> residual(chain.constraints());
  for (int n = 0; n < loose_steps; ++n) {
    std::vector<double> mean = state.u;
    scheme.step(state, tau);
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5 * (mean[i] + state.u[i]);
    chain.constraint_rates(mean, residual);
    double work = 0;
    for (std::size_t s = 0; s < chain.constraints(); ++s) work += tau * state.multipliers[s] * residual[s];
    booked.ledger().book("energy", work);
    booked.record(state);
    largest.scales.include(scales_of(chain, state));
  }
  const InvariantsLedger& ledger = booked.ledger();
  largest.unexplained.add(ledger.entry("energy").largest_step_defect);
  largest.unexplained_sum.add(ledger.largest_defect("energy"));
  largest.momentum.add(ledger.largest_defect("momentum"));
  largest.angular_momentum.add(ledger.largest_defect("angular_momentum"));
  largest.vertical.add(ledger.largest_defect("angular_momentum_z"));
}

void check_energy_law(Check& check, const std::string& system, const Defects& worst) {
  check.holds(
      system + "-energy-step: The energy change of a step equals the multipliers' work on the residual to round-off.",
      {worst.unexplained.value()},
      Roundoff{2 * 33 * 3, worst.scales.energy,
               "difference of two energies, each a sum of up to 33 products of 3 roundings"});
  check.holds(
      system +
          "-energy-sum: The energy change of the whole run equals the multipliers' work on the residual to round-off.",
      {worst.unexplained_sum.value()}, Roundoff{loose_steps, worst.scales.energy, "one rounded energy per step"});
}

TEST_CASE("loosely solved multipliers: momenta exact, energy changed by their work on the residual", "[conservation]") {
  Check check(
      "one_step_loose_multipliers", "Loosely solved multipliers",
      "Each multiplier is wrong by a fraction e, the same for all or random. Internal forces cancel whatever they are: "
      "momentum and angular momentum stay at round-off for any e. From $u^{n+1} - u^n = 2(\\tilde u - u^n) = \\tau "
      "M^{-1}(J^T\\lambda - \\nabla\\Pi)$ and $u^{n+1} + u^n = 2\\tilde u$ the energy of a step changes by $T^{n+1} - "
      "T^n = \\tilde u^T M (u^{n+1} - u^n) = \\tau\\,\\lambda\\cdot(J\\tilde u) - (q^{n+1} - q^n)\\cdot\\nabla\\Pi$, "
      "for any $\\lambda$; the last term is $-\\Delta\\Pi$ if the potential is linear. An error of the same sign in "
      "all multipliers leaves $J\\tilde u = \\tfrac{\\tau}{2} e A\\lambda$ and adds up; random errors walk.",
      source);
  Defects free, pinned;
  for (const Error kind : {Error::systematic, Error::random}) {
    for (const double e : {0.0, 1e-14, 1e-10, 1e-6}) {
      run({free_chain(), kind, e}, free);
      run({double_pendulum(), kind, e}, pinned);
    }
  }
  check_energy_law(check, "free-chain", free);
  check_energy_law(check, "pendulum", pinned);
  check.at("tau = 0.01, 1000 steps, e = 0 .. 1e-6");
  check.that("momentum", "Momentum of the free chain is exact for any multipliers.", "largest momentum error",
             {free.momentum.value()},
             Roundoff{loose_steps, free.scales.momentum, "one rounded update of sum m|u| per step"});
  check.that("angular-momentum", "Angular momentum of the free chain is exact for any multipliers.",
             "largest angular momentum error", {free.angular_momentum.value()},
             Roundoff{loose_steps, free.scales.angular_momentum, "one rounded update of sum m|r||u| per step"});
  check.that("vertical-angular-momentum",
             "Angular momentum of the pendulum about the vertical through the pin is conserved to round-off.",
             "largest defect", {pinned.vertical.value()},
             Roundoff{loose_steps, pinned.scales.angular_momentum, "one rounded update of sum m|r||u| per step"});
}

}  // namespace seiche::verification::one_step_invariants_test
