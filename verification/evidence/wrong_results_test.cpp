// Results of others that are wrong in a way that looks right: each must be told from the reference.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "validation/case/job.hpp"
#include "validation/case/registry.hpp"
#include "validation/dam_break/riemann_problem.hpp"
#include "validation/dam_break/submitted_front.hpp"
#include "validation/scoring/score.hpp"
#include "verification/check.hpp"

namespace wrong_results_test {

using namespace seiche;
using namespace seiche::validation;
using namespace seiche::verification;
using evidence::Verdict;

Verdict verdict_of(const evidence::Record& record, const std::string& id) {
  for (const evidence::JudgedClaim& claim : record.claims()) {
    if (claim.claim.id == id) return claim.judgement.verdict;
  }
  return Verdict::error;
}

void is(Check& check, const std::string& id, const std::string& text, Verdict got, Verdict expected) {
  check.that({.id = id, .text = text, .quantity = "the verdict is as stated", .source = "what scoring means"},
             {.value = got == expected ? 1.0 : 0.0, .resolution = std::string(evidence::name(got))},
             Qualitative{"verdict " + std::string(evidence::name(expected)), "it was planted"});
}

evidence::Record scored(const Case& one, const Values& values, const Submitted& submitted, const SolverFacts& facts) {
  evidence::Record record = Job{&one, values}.blank_record();
  score(one.submission.tables(values), submitted, facts.uncertainty, record);
  if (one.submission.judge) one.submission.judge(values, submitted, facts, record);
  return record;
}

using Changed = std::function<exact::Riemann::State(double x, exact::Riemann::State)>;

/// A profile of so many points, changed, as a solver with cells of this size would submit it.
evidence::Record scored_riemann(int points, double cell, const Changed& changed) {
  const Case& one = find_case("riemann");
  const Values values = one.values(Tier::quick);
  const exact::Riemann solution = riemann_solution(values);
  SubmittedGroup profile;
  for (int k = 0; k < points; ++k) {
    const double x = 50.0 * (k + 0.5) / points;
    const auto state = changed(x, solution.at(x, values.real("time")));
    profile.abscissa.push_back(x);
    profile.values["h"].push_back(state.depth);
    profile.values["u"].push_back(state.velocity);
  }
  return scored(one, values, {{"profile", {profile}}}, {.cell = cell});
}

TEST_CASE("a dam break is judged by the solver's cells, in depth and in discharge", "[evidence]") {
  Check check("riemann_scores", "Wrong dam breaks are told",
              "The exact profile passes however densely it is printed; water that never moved, or that stands still or "
              "runs backwards in the right shape, does not.");
  for (const int points : {50, 400, 4000}) {
    const auto named = [&](const char* id) { return fmt::format("{}-{}", id, points); };
    const evidence::Record right = scored_riemann(points, 1, [](double, auto state) { return state; });
    is(check, named("right"), "The exact profile has the right depth.", verdict_of(right, "depth"), Verdict::pass);
    is(check, named("right-volume"), "All its water is there.", verdict_of(right, "volume"), Verdict::pass);
    is(check, named("right-front"), "And the right front.", verdict_of(right, "front"), Verdict::pass);
    const evidence::Record still = scored_riemann(points, 1, [](double, auto state) {
      state.velocity = 0;
      return state;
    });
    is(check, named("still"), "Without velocity it fails.", verdict_of(still, "discharge"), Verdict::fail);
    const evidence::Record reversed = scored_riemann(points, 1, [](double, auto state) {
      state.velocity = -state.velocity;
      return state;
    });
    is(check, named("reversed"), "With the velocity turned it fails.", verdict_of(reversed, "discharge"),
       Verdict::fail);
    const Changed first = [](double x, auto) { return exact::Riemann::State{x < 20 ? 1.0 : 0.1, 0}; };
    is(check, named("untouched"), "The initial state fails.", verdict_of(scored_riemann(points, 1, first), "depth"),
       Verdict::fail);
    is(check, named("untouched-coarse"), "It does not pass with huge cells either.",
       verdict_of(scored_riemann(points, 12.5, first), "depth"), Verdict::inconclusive);
    const auto slow = [](double x, auto state) {
      const exact::Riemann solution = riemann_solution(find_case("riemann").values(Tier::quick));
      const double bore = 20 + 0.88 * 6 * solution.right_wave().fastest;
      return x > bore ? solution.right() : state;
    };
    is(check, named("slow"), "With a bore an eighth too slow it fails.",
       verdict_of(scored_riemann(points, 1, slow), "front"), Verdict::fail);
    is(check, named("lost"), "With 18 % of the water lost it fails.",
       verdict_of(scored_riemann(points, 1,
                                 [](double, auto state) {
                                   state.depth *= 0.82;
                                   return state;
                                 }),
                  "volume"),
       Verdict::fail);
  }
}

TEST_CASE("a standing wave of finite amplitude is not a linear one", "[evidence]") {
  Check check("standing_wave_scores", "Wrong standing waves are told",
              "The wave of theory passes, the linear one does not; a table that is left out fails.");
  const Case& one = find_case("standing_wave");
  const Values values = one.values(Tier::quick);
  const std::vector<WantedTable> wanted = one.submission.tables(values);
  const double gravity = values.real("gravity");
  const double depth = values.real("depth");
  const auto submitted = [&](const std::function<double(double)>& wall, double omega) {
    SubmittedGroup series{.value = 0, .abscissa = wanted.front().points(0), .values = {}};
    for (const double t : series.abscissa) series.values["eta"].push_back(wall(t));
    return Submitted{{"wall", {series}}, {"numbers", {{.value = 0, .abscissa = {}, .values = {{"omega", {omega}}}}}}};
  };
  const auto theory = [&](double t) { return wanted.front().quantities.front().reference({0, t}); };
  const double omega = wanted.back().quantities.front().reference({});
  const evidence::Record right = scored(one, values, submitted(theory, omega), {});
  is(check, "right", "The elevation of theory passes.", verdict_of(right, "eta-relative_l2"), Verdict::pass);
  is(check, "right-frequency", "So does its frequency.", verdict_of(right, "omega-value"), Verdict::pass);
  // The wavelength is 2 pi: k = 1.
  const double linear = std::sqrt(gravity * std::tanh(depth));
  const auto cosine = [&](double t) { return values.real("amplitude") * std::cos(linear * t); };
  is(check, "linear", "A linear wave fails.",
     verdict_of(scored(one, values, submitted(cosine, linear), {}), "eta-relative_l2"), Verdict::fail);
  const double shallow = std::sqrt(gravity * std::tanh(0.85 * depth));
  is(check, "shallow", "The frequency of a tank 15 % too shallow fails.",
     verdict_of(scored(one, values, submitted(theory, shallow), {}), "omega-value"), Verdict::fail);
  Submitted half = submitted(theory, omega);
  half.erase("wall");
  is(check, "half", "Without its elevation a frequency is no success.",
     verdict_of(scored(one, values, half, {}), "wall-coverage"), Verdict::fail);
}

TEST_CASE("the rate of a front is found beside its shift", "[evidence]") {
  Check check("front_fit", "Shift and rate of a front",
              "Points of a known front, read from a clock that is late and slow: both are found, and the stated "
              "uncertainty of the front is carried to its rate.");
  const auto front = [](double T) { return 1 + T * T / (1 + 0.55 * T); };
  std::vector<double> T, X;
  for (int k = 0; k <= 2000; ++k) {
    T.push_back(0.005 * k);
    X.push_back(front(T.back()));
  }
  ColumnFront data{.uncertainty = 0.05, .time_uncertainty = 0.05};
  constexpr double shift = 0.17;
  constexpr double rate = 1.054;
  for (int k = 2; k <= 15; ++k) {
    data.T.push_back(0.55 * k);
    data.X.push_back(front(rate * (data.T.back() - shift)));
  }
  const FrontFit fit = front_fit({T, X}, data, 100, 0.02);
  const auto close = [&](const std::string& id, double value, double expected) {
    check.that({.id = id, .text = "It is found.", .quantity = id, .source = "definition of the fit"}, {.value = value},
               Bound{1e-5,
                     "straight lines between points 0.005 apart miss a front of second derivative 2 at most by "
                     "0.005^2/4 = 6e-6",
                     expected});
  };
  close("shift", fit.shift, shift);
  close("rate", fit.rate, rate);
  // From T = 1.2 on, where X = 1.87: the first two of the points may be before that, and say nothing.
  const std::vector<double> late_T(T.begin() + 240, T.end());
  const std::vector<double> late_X(X.begin() + 240, X.end());
  const FrontFit late = front_fit({late_T, late_X}, data, 100, 0.02);
  close("late-shift", late.shift, shift);
  close("late-rate", late.rate, rate);
  const FrontFit exact = front_fit({T, X}, data, 100, 0.0);
  const FrontFit twice = front_fit({T, X}, data, 100, 0.04);
  check.that({.id = "uncertainty",
              .text = "Twice the uncertainty of the front is twice that of its rate.",
              .quantity = "ratio",
              .source = "linear propagation"},
             {.value = *twice.rate_numerical / *fit.rate_numerical}, Bound{1e-12, "round-off", 2});
  check.that({.id = "certain",
              .text = "A front that is known exactly adds none.",
              .quantity = "numerical uncertainty of the rate",
              .source = "linear propagation"},
             {.value = *exact.rate_numerical}, Bound{0, "nothing was stated to be uncertain"});
  check.that({.id = "unstated",
              .text = "Where nothing is stated nothing is known.",
              .quantity = "an uncertainty is given",
              .source = "linear propagation"},
             {.value = front_fit({T, X}, data, 100, std::nullopt).rate_numerical ? 1.0 : 0.0},
             Qualitative{"an uncertainty", "none was stated", false});
  // An X that is wrong by 0.02 with the sign of the weights moves the rate by as much as is said, to first order.
  check.that({.id = "bound",
              .text = "It bounds what the front being a constant 0.02 too far does.",
              .quantity = "change of the rate over its bound",
              .source = "triangle inequality"},
             {.value =
                  [&] {
                    std::vector<double> farther = X;
                    for (double& x : farther) x += 0.02;
                    return std::abs(front_fit({T, farther}, data, 100, 0.02).rate - fit.rate) / *fit.rate_numerical;
                  }()},
             Bound{1, "a bound of errors of every sign, to first order"});
}

}  // namespace wrong_results_test
