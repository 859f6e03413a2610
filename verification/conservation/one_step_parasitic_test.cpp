// The alternation of the multipliers: how it starts, how it grows in very long runs, and its cures.
#include <algorithm>
#include <cmath>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/start.hpp"
#include "verification/check.hpp"
#include "verification/conservation/rigid_chain.hpp"

namespace {

using namespace seiche::mechanics;
using namespace seiche::verification;
using seiche::evidence::Bound;
using seiche::evidence::Order;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 1";

enum class Begin { projected, smooth };

double largest_jump(const State& state) {
  double jump = 0;
  for (std::size_t s = 0; s < state.multipliers.size(); ++s) {
    jump = std::max(jump, std::abs(state.multipliers[s] - state.earlier_multipliers[s]));
  }
  return jump;
}

/// Amplitude of the alternation, by a fourth difference over the first steps: smooth multipliers drop out.
double alternation(Begin begin, double tau) {
  auto chain = free_chain();
  State state = spiral_start(chain);
  if (begin == Begin::smooth) Start(chain).project_smooth(state, tau);
  OneStep<RigidChain> scheme(chain);
  std::vector<std::vector<double>> history;
  double amplitude = 0;
  for (int n = 0; n < 12; ++n) {
    scheme.step(state, tau);
    history.push_back(state.multipliers);
    if (n < 4) continue;
    const auto* h = &history[history.size() - 5];
    for (std::size_t s = 0; s < state.multipliers.size(); ++s) {
      const double difference = h[0][s] - 4 * h[1][s] + 6 * h[2][s] - 4 * h[3][s] + h[4][s];
      amplitude = std::max(amplitude, std::abs(difference) / 16);
    }
  }
  return amplitude;
}

}  // namespace

TEST_CASE("the corrected start leaves an alternation of third order", "[conservation]") {
  Check check(
      "one_step_start", "Start of the one-step scheme",
      "Free chain: amplitude of the multipliers' alternation (a sixteenth of their fourth difference over the first "
      "steps) after a projected start, $J u^0 = 0$, and a corrected one, $J u^0 = (\\tau^2/2) B(u, \\dot u)$.");
  const std::vector<double> steps = {0.008, 0.004, 0.002, 0.001};
  std::vector<double> projected;
  std::vector<double> smooth;
  for (const double tau : steps) {
    projected.push_back(alternation(Begin::projected, tau));
    smooth.push_back(alternation(Begin::smooth, tau));
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    check.measure("amplitude, projected, tau / 0.001 = " + std::to_string(8 >> i), projected[i]);
    check.measure("amplitude, corrected, tau / 0.001 = " + std::to_string(8 >> i), smooth[i]);
  }
  check.that({.id = "projected",
              .text = "After a projected start the multipliers alternate by O(tau).",
              .quantity = "order of the amplitude",
              .source = source},
             seiche::evidence::observed_order(steps, projected),
             Order{1, 0.15, "w = 0 instead of w_s = O(tau^2), divided by tau"});
  check.that(
      {.id = "smooth",
       .text = "After a corrected start they alternate by O(tau^3).",
       .quantity = "order of the amplitude",
       .source = source},
      seiche::evidence::observed_order(steps, smooth),
      Order{3, 0.3, "the scheme is symmetric, so w_s has even powers of tau: the next is tau^4, divided by tau"});
  auto& figure = check.figure("start", "Alternation of the multipliers", "Amplitude against the step.");
  auto& panel = figure.panel({.x = "tau", .y = "amplitude", .log_x = true, .log_y = true});
  panel.points("projected start", steps, projected, Role::peer);
  panel.points("corrected start", steps, smooth, Role::computed);
}

TEST_CASE("reprojection cures the parasitic mode of very long runs", "[conservation]") {
  Check check("one_step_parasitic_mode", "Parasitic mode of a free chain over 1e6 steps",
              "Free chain of 11 masses, tau = 0.01. Without reprojection the jump of the multipliers from step to step "
              "grows by orders of magnitude while energy and momenta stay exact; restoring $J u = w_s$ every 1000 "
              "steps stops it. The jump is averaged over 1000 steps, so that single whips of the chain do not decide.");
  const double tau = 0.01;
  const long steps = 1000000;
  std::vector<double> times;
  std::vector<double> jumps[2];
  double energy[2] = {};
  double momentum[2] = {};
  for (const int cured : {0, 1}) {
    auto chain = free_chain();
    State state = spiral_start(chain);
    if (cured == 1) Start(chain).project_smooth(state, tau);
    OneStep<RigidChain> scheme(chain);
    Reprojection<RigidChain> reprojection(chain, 1000);
    InvariantsWatch watch(chain, state);
    double sum = 0;
    for (long n = 1; n <= steps; ++n) {
      scheme.step(state, tau);
      if (n > 1) sum += largest_jump(state);
      if (cured == 1) reprojection.after_step(state, tau);
      if (n % 1000 != 0) continue;
      watch.record(state);
      if (cured == 0) times.push_back(state.time);
      jumps[cured].push_back(sum / 1000);
      sum = 0;
    }
    energy[cured] = watch.ledger().largest_defect("energy");
    momentum[cured] = watch.ledger().largest_defect("momentum");
  }
  check.that(
      {.id = "growth",
       .text = "Without cure the multipliers alternate by more than 10 after 1e6 steps.",
       .quantity = "mean jump over the last 1000 steps exceeds 10",
       .source = "computed once by an independent implementation: 5e-3 at the start, 1e2 after 1e6 steps"},
      {.value = jumps[0].back() > 10 ? 1.0 : 0.0},
      seiche::evidence::Qualitative{"mean jump of the largest multiplier > 10", "the multipliers are of order 1"});
  check.that({.id = "cure",
              .text = "With reprojection every 1000 steps the jump stays small.",
              .quantity = "largest mean jump over 1000 steps",
              .source = "computed once by an independent implementation"},
             {.value = *std::max_element(jumps[1].begin(), jumps[1].end())},
             Bound{0.05, "jump found for reprojection every 1 to 1000 steps"});
  check.that({.id = "cured-energy",
              .text = "Reprojection costs next to no energy.",
              .quantity = "largest energy defect over 1e6 steps",
              .source = "computed once by an independent implementation: 4.4e-10"},
             {.value = energy[1]}, Bound{1e-9, "same order as 4.4e-10"});
  check.that({.id = "cured-momentum",
              .text = "Reprojection keeps the momentum.",
              .quantity = "largest momentum defect over 1e6 steps",
              .source = source},
             {.value = momentum[1]}, Bound{1e-11, "4 eps sqrt(1e6) times sum m|u|, about 10"});
  check.measure("energy defect without cure", energy[0]);
  check.measure("momentum defect without cure", momentum[0]);
  check.measure("mean jump, first 1000 steps", jumps[0].front());
  check.measure("mean jump, last 1000 steps, without cure", jumps[0].back());
  check.measure("mean jump, last 1000 steps, with cure", jumps[1].back());
  auto& figure = check.figure("parasitic", "Jump of the multipliers", "Mean over 1000 steps of the largest jump.");
  auto& panel = figure.panel({.x = "time", .y = "jump of lambda", .log_y = true});
  panel.line("without reprojection", times, jumps[0], Role::peer);
  panel.line("reprojection every 1000 steps", times, jumps[1], Role::computed);
}
