// The alternation of the multipliers: how it starts, how it grows in very long runs, and its cures.
#include <array>
#include <cmath>

#include "seiche/mechanics/start.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"
#include "verification/conservation/differences.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::one_step_parasitic_test {

using namespace mechanics;
using namespace rigid_chain;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 1";
const std::string expansion = "expansion of the scheme's own equation for J u, see start.hpp";

enum class Begin { projected, smooth };

/// Over the first steps.
struct Alternation {
  Worst fourth;  ///< a sixteenth of the fourth difference: the alternation, what is smooth drops out to tau^4
  Worst second;  ///< a quarter of the second difference: with what is smooth to tau^2
};

Alternation alternation(Begin begin, double tau) {
  auto chain = free_chain();
  State state = spiral_start(chain);
  if (begin == Begin::smooth) {
    Start(chain).project(state);
    Start(chain).project_to_smooth(state, tau);
  }
  OneStep<RigidChain> scheme(chain);
  std::vector<std::vector<double>> history;
  Alternation result;
  for (int n = 0; n < 12; ++n) {
    scheme.step(state, tau);
    history.push_back(state.multipliers);
    if (n < 4) continue;
    const auto* h = &history[history.size() - 5];
    for (std::size_t s = 0; s < state.multipliers.size(); ++s) {
      const double middle = h[1][s] - 2 * h[2][s] + h[3][s], outer = h[0][s] - 2 * h[2][s] + h[4][s];
      result.second.add(middle / 4);
      result.fourth.add((outer - 4 * middle) / 16);
    }
  }
  return result;
}

/// Multipliers, accelerations and the part of the velocity outside the constraints at a state.
class Instant {
 public:
  explicit Instant(RigidChain& chain) : chain_(chain), form_(chain), acceleration_(chain.rates()) {}

  /// The largest |A^-1 B(u, u')|.
  double jerk(const State& state) { return largest_of(curvature(state)); }

  /// Amplitude of the alternation that the state carries: (2/tau) A^-1 (J u - w_s), w_s = (tau^2/2) B(u, u').
  double parasite(const State& state, double tau) {
    const Input bending = curvature(state);
    std::vector<double> outside(bending.size());
    chain_.constraint_rates(state.u, outside);
    for (std::size_t s = 0; s < outside.size(); ++s) outside[s] -= tau * tau / 2 * bending[s];
    return 2 / tau * largest_of(outside);
  }

 private:
  Input curvature(const State& state) {
    form_.acceleration(state.time, state.q, state.u, acceleration_);
    return form_.curvature(state.time, state.q, state.u, acceleration_);
  }
  /// Of A^-1 times a right-hand side.
  double largest_of(Input right_hand_side) {
    std::vector<double> solution(right_hand_side.size());
    chain_.solve(right_hand_side, solution);
    return worst(solution);
  }

  RigidChain& chain_;
  IndexReduced<RigidChain> form_;
  std::vector<double> acceleration_;
};

struct LongRun {
  std::vector<double> time;
  std::vector<double> parasite;  ///< every 1000 steps, before the reprojection
  std::vector<double> early;     ///< 100 steps after that
  Worst jump;                    ///< of the multipliers from step to step
  State before_jump;             ///< 50 to 100 steps before the largest
  double momentum = 0;
  Scales scales;
};

constexpr long between_copies = 50;  // of the state, in steps

/// Largest change of a multiplier in the last step.
double jump_of(const State& state) {
  return largest_difference(state.multipliers, state.earlier_multipliers);
}

/// The largest jump over the next 1.5 units of time with steps tau.
double largest_jump_from(State state, double tau) {
  auto chain = free_chain();
  Start(chain).project_to_smooth(state, tau);
  OneStep<RigidChain> scheme(chain);
  Largest jump;
  for (long n = 1; n <= std::lround(1.5 / tau); ++n) {
    scheme.step(state, tau);
    if (n > 2) jump.add(jump_of(state), state.time);
  }
  return jump.value();
}

LongRun free_chain_run(long every, long steps, double tau) {
  auto chain = free_chain();
  State state = spiral_start(chain);
  const bool cured = every > 0;
  if (cured) {
    Start(chain).project(state);
    Start(chain).project_to_smooth(state, tau);
  }
  OneStep<RigidChain> scheme(chain);
  Instant instant(chain);
  InvariantsWatch watch(chain, state);
  LongRun run;
  State copy = state, older = state;
  for (long n = 1; n <= steps; ++n) {
    if (n % between_copies == 0) {
      older = std::move(copy);
      copy = state;
    }
    scheme.step(state, tau);
    if (n > 2) {
      const double largest_before = run.jump.value();
      run.jump.add(jump_of(state), state.time);
      if (run.jump.value() != largest_before) run.before_jump = older;
    }
    if (n % 1000 == 100) run.early.push_back(instant.parasite(state, tau));
    if (n % 1000 == 0) {
      run.time.push_back(state.time);
      run.parasite.push_back(instant.parasite(state, tau));
      run.scales.include(scales_of(chain, state));
    }
    if (cured && n % every == 0) Start(chain).project_to_smooth(state, tau);
    if (n % 1000 == 0) watch.record(state);
  }
  run.momentum = watch.ledger().largest_defect("momentum");
  return run;
}

/// Mean logarithm of `b` less that of `a` in standard errors, for samples that are far apart in time.
double growth(Input a, Input b) {
  const auto logarithms = [](Input values) {
    const auto count = static_cast<double>(values.size());
    double mean = 0, variance_of_mean = 0;
    for (const double v : values) mean += std::log(v) / count;
    for (const double v : values) variance_of_mean += std::pow(std::log(v) - mean, 2) / (count * (count - 1));
    return std::pair{mean, variance_of_mean};
  };
  const auto [mean_a, variance_a] = logarithms(a);
  const auto [mean_b, variance_b] = logarithms(b);
  return (mean_b - mean_a) / std::sqrt(variance_a + variance_b);
}

TEST_CASE("the corrected start leaves a third-order alternation", "[conservation]") {
  Check check(
      "one_step_start", "Start of the one-step scheme",
      "For quadratic constraints $w^n = J(q^n)u^n$ obeys $w^{n+1} + w^n = \\tfrac{\\tau}{2}(b^{n+1} - b^n)$, $b = "
      "B(u,u)$, exactly. Its solution without alternation is $w = "
      "\\tfrac{\\tau}{2}\\tanh(\\tfrac{\\tau}{2}\\partial_t)\\,b = \\tfrac{\\tau^2}{4}\\dot b + O(\\tau^4) = "
      "\\tfrac{\\tau^2}{2}B(u,\\dot u) + O(\\tau^4)$; any other component of $w^0$ alternates indefinitely, in the "
      "multipliers by $(2/\\tau)A^{-1}$ times it. Hence: $w^0 = 0$ leaves an alternation of $\\tau A^{-1}B(u,\\dot "
      "u)$, and $w^0 = \\tfrac{\\tau^2}{2}B(u,\\dot u)$ one of $O(\\tau^3)$. Free chain; the alternation is a "
      "sixteenth of the multipliers' fourth difference over the first steps. Second differences do not show it after a "
      "corrected start: they contain $\\tfrac{\\tau^2}{4}\\ddot\\lambda$ of the motion itself.",
      expansion);
  const auto amplitudes =
      refine(check, {"tau", falling(0.016, 5), "start", "Alternation of the multipliers"},
             {{"projected",
               "The alternation of the multipliers after a projected start is first-order in tau.",
               {1, 0.05, "w^0 = 0 instead of O(tau^2), divided by tau"}},
              {"smooth",
               "The alternation of the multipliers after a corrected start is third-order in tau.",
               {3, 0.1, "w_s has even powers of tau: the remainder is O(tau^4), divided by tau"}},
              {"second-differences",
               "Second differences after a corrected start are second-order in the step: the motion's own.",
               {2, 0.05, "tau^2/4 times the second derivative"}}},
             [](double tau) {
               const Alternation corrected = alternation(Begin::smooth, tau);
               return std::array{alternation(Begin::projected, tau).fourth.value(), corrected.fourth.value(),
                                 corrected.second.value()};
             });
  auto chain = free_chain();
  const State start = spiral_start(chain);
  constexpr double tau = 0.001;
  check.that(
      "amplitude", "The amplitude agrees with tau A^-1 B(u, u').",
      "amplitude / (tau max |A^-1 B(u, u')|) at tau = 0.001",
      {.value = amplitudes[0].back() / (tau * Instant(chain).jerk(start)), .resolution = "tau = 0.001"},
      Bound{10 * tau, "taken over the first twelve steps, in which A and B change by some tau of themselves each", 1});
}

TEST_CASE("reprojection cures the parasitic mode of very long runs", "[conservation]") {
  Check check(
      "one_step_parasitic_mode", "Parasitic mode of a free chain over 1e6 steps",
      "Free chain of 11 masses, tau = 0.01. Without reprojection the alternation of the multipliers grows by orders of "
      "magnitude while energy and momenta stay exact; restoring $J u = w_s$ every 1000 steps stops it. What a state "
      "carries of it is $(2/\\tau)\\,|A^{-1}(Ju - w_s)|$, measured before each reprojection. The multipliers still "
      "change from step to step, by 0.013 in the median and by up to 0.27 when the chain whips, by more than 0.05 in "
      "one step of 23: that is the motion, $\\tau\\dot\\lambda$. With a sixteenth of the step the largest is a "
      "sixteenth.",
      source);
  constexpr double tau = 0.01;
  constexpr long steps = 1000000;
  const LongRun wild = free_chain_run(0, steps, tau);
  const LongRun cured = free_chain_run(1000, steps, tau);
  check.at("tau = 0.01, 1e6 steps");
  check.that("growth", "The alternation of the multipliers without reprojection exceeds 10 after 1e6 steps.",
             "alternation exceeds 10", {wild.parasite.back() > 10 ? 1.0 : 0.0},
             Qualitative{"amplitude of the alternation > 10", "the multipliers are of order 1"});
  refine(check, {"tau", falling(tau, 5), "jump", "Largest jump of a multiplier"},
         {{"jump",
           "The largest jump of the cured run, repeated with shorter steps, falls at first order in the step.",
           {1, 0.05, "tau times the rate of the multiplier"}}},
         [&](double step) { return largest_jump_from(cured.before_jump, step); });
  const Input parasite = cured.parasite;
  const std::size_t quarter = parasite.size() / 4;
  const std::string quantity = "mean logarithm of the alternation, difference in standard errors: ";
  check.that("no-growth", "The alternation in the cured run grows by less than 3 standard errors.",
             quantity + "last quarter less first", {growth(parasite.first(quarter), parasite.last(quarter))},
             Bound{3, "no growth at three standard errors; samples are 1000 steps apart"});
  check.that("no-regrowth", "The alternation does not grow between two reprojections.",
             quantity + "1000 steps after a reprojection less 100 steps after", {growth(cured.early, parasite)},
             Bound{3, "no growth at three standard errors; samples are 1000 steps apart"});
  check.that("cured-momentum", "Momentum is conserved to round-off by the reprojections.",
             "largest momentum error over 1e6 steps", {cured.momentum},
             Roundoff{1e6, cured.scales.momentum, "one rounded update of sum m|u| per step"});
  auto& figure = check.figure("parasitic", "Alternation of the multipliers", "Every 1000 steps, before reprojection.");
  auto& panel = figure.panel({.x = "time", .y = "amplitude of the alternation", .log_y = true});
  panel.line("without reprojection", wild.time, wild.parasite, Role::peer);
  panel.line("reprojection every 1000 steps", cured.time, cured.parasite, Role::computed);
}

}  // namespace seiche::verification::one_step_parasitic_test
