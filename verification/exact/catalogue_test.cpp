#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "seiche/exact/catalogue.hpp"
#include "seiche/exact/overturning/overturning_wave.hpp"
#include "verification/check.hpp"

namespace seiche::verification::catalogue_test {

/// Three times as much as all others; exact_slope_runup, exact_wall_load and exact_overturning have their identities
/// too.
const std::set<std::string> costliest{"overturning_wave", "slope_runup", "wall_load"};

/// Steps in time or series that are cut off: worse than round-off, and better than a reader sees in a figure.
const std::set<std::string> truncated{"waves_in_tank",   "overturning_wave", "pressure_forced_wave",
                                      "released_column", "slope_runup",      "wall_load",
                                      "wall_runup"};

Check self_tests() {
  return {"exact_self_tests", "What every exact solution says of itself",
          "Each solution of the catalogue, at its default parameters, is checked against identities that hold for it "
          "exactly: conservation across jumps, integral identities, invariants of the motion. No outside data take "
          "part. `seiche exact NAME --self-test` measures the same for any parameters."};
}

/// It evaluates at its defaults, and keeps its own identities.
void evaluates(Check& check, const exact::ExactSolution& solution) {
  INFO(solution.name);
  const exact::Evaluator evaluator = solution.evaluator();
  CHECK(evaluator.scalars().size() == solution.scalars.size());
  std::vector<double> defaults;
  for (const auto& input : solution.inputs) defaults.push_back(input.default_value);
  const std::vector<double> row = evaluator.curve ? evaluator.curve(defaults).front() : evaluator.eval(defaults);
  CHECK(row.size() == solution.outputs.size());
  CHECK(std::all_of(row.begin(), row.end(), [](double value) { return std::isfinite(value); }));
  CHECK(evaluator.uncertainty() > 0);
  CHECK(evaluator.uncertainty() < (truncated.contains(solution.name) ? 1e-3 : 1e-11));
  const exact::SelfTest identities = evaluator.self_test();
  CHECK(!identities.empty());
  for (std::size_t k = 0; k < identities.size(); ++k) {
    check.holds(solution.name + ": " + identities[k].name + ".", {identities[k].defect},
                Bound{identities[k].accuracy, identities[k].reason});
  }
}

TEST_CASE("every entry of the catalogue is complete", "[exact]") {
  std::set<std::string> names;
  for (const exact::ExactSolution& solution : exact::catalogue()) {
    INFO(solution.name);
    CHECK(names.insert(solution.name).second);
    CHECK(std::all_of(solution.name.begin(), solution.name.end(),
                      [](unsigned char c) { return std::islower(c) || std::isdigit(c) || c == '_'; }));
    CHECK(!solution.title.empty());
    CHECK(!solution.citation.empty());
    CHECK(!solution.formula.empty());
    CHECK(!solution.outputs.empty());
    for (const auto& parameter : solution.parameters) {
      CHECK(parameter.minimum <= parameter.default_value);
      CHECK(parameter.default_value <= parameter.maximum);
      CHECK(!parameter.meaning.empty());
    }
    CHECK_THROWS_AS(solution.evaluator({{"no such parameter", 1.0}}), std::invalid_argument);
    if (!solution.parameters.empty()) {
      const auto& first = solution.parameters.front();
      CHECK_THROWS_AS(solution.evaluator({{first.name, std::nan("")}}), std::invalid_argument);
    }
  }
  CHECK_THROWS_AS(exact::find_solution("no_such_solution"), std::invalid_argument);
}

TEST_CASE("a surface's curve gives places, potential and velocities in the columns of these names", "[exact]") {
  const exact::ExactSolution& solution = exact::find_solution("waves_in_tank");
  std::vector<std::string> names;
  for (const auto& output : solution.outputs) names.push_back(output.name);
  CHECK(names == std::vector<std::string>{"x", "y", "phi", "u", "v"});
  const exact::Evaluator sea =
      solution.evaluator({{"seed", 3}, {"bar_height", 0.2}, {"bars", 6}, {"markers", 64}, {"last_time", 0.2}});
  const exact::WavesInTank same({.seed = 3, .bar_height = 0.2, .bars = 6, .markers = 64, .last_time = 0.2});
  const auto now = same.profile(0.1);
  const std::vector<std::vector<double>> rows = sea.curve(std::array{0.1});
  REQUIRE(rows.size() == 64);
  CHECK(rows[5] == std::vector{now.x[5], now.y[5], now.potential[5], now.u[5], now.v[5]});
}

TEST_CASE("every exact solution evaluates at its defaults and satisfies its own identities", "[exact]") {
  Check check = self_tests();
  for (const exact::ExactSolution& solution : exact::catalogue()) {
    if (!costliest.contains(solution.name)) evaluates(check, solution);
  }
}

TEST_CASE("the costliest exact solutions do so too", "[exact][full]") {
  Check check = self_tests();
  for (const std::string& name : costliest) evaluates(check, exact::find_solution(name));
}

}  // namespace seiche::verification::catalogue_test
