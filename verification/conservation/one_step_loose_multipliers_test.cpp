// Multipliers that are solved loosely, as iterative solvers leave them: what still holds exactly.
#include <algorithm>
#include <cmath>
#include <random>

#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"

namespace seiche::verification::one_step_loose_multipliers_test {

using namespace mechanics;
using namespace rigid_chain;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 1, formulas (4), (5)";

enum class Error { systematic, random };

/// Every multiplier is wrong by the fraction e, or by a random fraction between -e and e.
class LooseChain : public RigidChain {
 public:
  LooseChain(RigidChain chain, Error kind, double e, unsigned seed = 1)
      : RigidChain(std::move(chain)), kind_(kind), fraction_(e), random_(seed) {}

  void solve(Input right_hand_side, Output mu) {
    RigidChain::solve(right_hand_side, mu);
    for (double& impulse : mu) impulse *= 1 + fraction_ * (kind_ == Error::systematic ? 1 : uniform_(random_));
  }

 private:
  Error kind_;
  double fraction_;
  std::minstd_rand random_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

struct Defects {
  double energy = 0;      ///< of the whole run
  Worst unexplained;      ///< of a step, after the multipliers' work on the residual is booked
  Worst unexplained_sum;  ///< of the whole run, likewise
  Worst momentum, angular_momentum, vertical;
  Scales scales;
};

constexpr int steps = 1000;
constexpr double tau = 0.01;

Defects defects_of(LooseChain chain) {
  State state = spiral_start(chain);
  OneStep<LooseChain> scheme(chain);
  InvariantsWatch plain(chain, state);
  InvariantsWatch booked(chain, state);
  const auto& entries = booked.ledger().entries();
  const auto energy = static_cast<std::size_t>(
      std::find_if(entries.begin(), entries.end(), [](const auto& e) { return e.name == "energy"; }) - entries.begin());
  Defects result;
  std::vector<double> residual(chain.constraints());
  for (int n = 0; n < steps; ++n) {
    std::vector<double> mean = state.u;
    scheme.step(state, tau);
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5 * (mean[i] + state.u[i]);
    chain.constraint_rates(mean, residual);
    double work = 0;
    for (std::size_t s = 0; s < chain.constraints(); ++s) work += tau * state.multipliers[s] * residual[s];
    booked.ledger().book(energy, work);
    plain.record(state);
    booked.record(state);
    result.scales.include(scales_of(chain, state));
  }
  result.energy = plain.ledger().largest_defect("energy");
  result.unexplained.add(booked.ledger().entry("energy").largest_step_defect);
  result.unexplained_sum.add(booked.ledger().largest_defect("energy"));
  result.momentum.add(plain.ledger().largest_defect("momentum"));
  result.angular_momentum.add(plain.ledger().largest_defect("angular_momentum"));
  result.vertical.add(plain.ledger().largest_defect("angular_momentum_z"));
  return result;
}

void check_energy_law(Check& check, const std::string& system, const Defects& worst) {
  check.holds(
      system +
          "-energy-step: The energy of a step changes by the multipliers' work on the residual, and by nothing else.",
      {worst.unexplained.value()},
      Roundoff{2 * 33 * 3, worst.scales.energy,
               "difference of two energies, each a sum of up to 33 products of 3 roundings"});
  check.holds(system + "-energy-sum: So does the energy of the whole run.", {worst.unexplained_sum.value()},
              Roundoff{steps, worst.scales.energy, "one rounded energy per step"});
}

TEST_CASE("loosely solved multipliers: momenta exact, energy changed by their work on the residual", "[conservation]") {
  Check check(
      "one_step_loose_multipliers", "Loosely solved multipliers",
      "Each multiplier is wrong by a fraction e, the same for all or random. Internal forces cancel whatever they are: "
      "momentum and angular momentum stay at round-off for any e. From $u^{n+1} - u^n = 2(\\tilde u - u^n) = \\tau "
      "M^{-1}(J^T\\lambda - \\nabla\\Pi)$ and $u^{n+1} + u^n = 2\\tilde u$ the energy of a step changes by $T^{n+1} - "
      "T^n = \\tilde u^T M (u^{n+1} - u^n) = \\tau\\,\\lambda\\cdot(J\\tilde u) - (q^{n+1} - q^n)\\cdot\\nabla\\Pi$, "
      "for any $\\lambda$; the last term is $-\\Delta\\Pi$ if the potential is linear. An error of the same sign in "
      "all multipliers leaves $J\\tilde u = \\tfrac{\\tau}{2} e A\\lambda$, does work of one sign and adds up; random "
      "errors walk: in N steps they do $\\sqrt{3N}$ times less.",
      source);
  Defects worst[2];
  for (const bool pinned : {false, true}) {
    Defects& w = worst[pinned ? 1 : 0];
    for (const Error kind : {Error::systematic, Error::random}) {
      for (const double e : {0.0, 1e-14, 1e-10, 1e-6}) {
        const Defects d = defects_of({pinned ? double_pendulum() : free_chain(), kind, e});
        w.unexplained.add(d.unexplained);
        w.unexplained_sum.add(d.unexplained_sum);
        w.momentum.add(d.momentum);
        w.angular_momentum.add(d.angular_momentum);
        w.vertical.add(d.vertical);
        w.scales.include(d.scales);
      }
    }
  }
  check_energy_law(check, "free-chain", worst[0]);
  check_energy_law(check, "pendulum", worst[1]);
  const std::string resolution = "tau = 0.01, 1000 steps, e = 0 .. 1e-6";
  check.that("momentum", "Momentum of the free chain is exact for any multipliers.", "largest momentum defect",
             {.value = worst[0].momentum.value(), .resolution = resolution},
             Roundoff{steps, worst[0].scales.momentum, "one rounded update of sum m|u| per step"});
  check.that("angular-momentum", "Angular momentum of the free chain is exact for any multipliers.",
             "largest angular momentum defect", {.value = worst[0].angular_momentum.value(), .resolution = resolution},
             Roundoff{steps, worst[0].scales.angular_momentum, "one rounded update of sum m|r||u| per step"});
  check.that("vertical-angular-momentum",
             "Angular momentum of the pendulum about the vertical through the pin is, too.", "largest defect",
             {.value = worst[1].vertical.value(), .resolution = resolution},
             Roundoff{steps, worst[1].scales.angular_momentum, "one rounded update of sum m|r||u| per step"});

  // How much energy a solver's tolerance costs: errors of one sign add up, random ones walk.
  constexpr int seeds = 64;
  double mean = 0, square = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const double defect = defects_of({double_pendulum(), Error::random, 1e-6, seed}).energy;
    mean += defect / seeds;
    square += defect * defect / seeds;
  }
  const double deviation = std::sqrt(square - mean * mean);
  check.from("regression: computed once by an earlier program for the same equations, one sequence: 3.4e-9")
      .that(
          "random-walk",
          "The published energy cost of random errors lies within two standard deviations of their walk.",
          "energy defect of the pendulum at e = 1e-6, distance from the mean over 64 sequences in standard deviations",
          {.value = (3.4e-9 - mean) / deviation, .resolution = "tau = 0.01, 1000 steps"},
          Bound{2, "one outcome of a random walk, at 95 %"});
}

}  // namespace seiche::verification::one_step_loose_multipliers_test
