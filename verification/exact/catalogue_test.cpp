#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "seiche/exact/catalogue.hpp"
#include "verification/check.hpp"

namespace catalogue_test {

using namespace seiche;

namespace {

const std::string costliest = "slope_runup";  // as much as all others; exact_slope_runup has its identities too

verification::Check self_tests() {
  return {"exact_self_tests", "What every exact solution says of itself",
          "Each solution of the catalogue, at its default parameters, is checked against identities that hold for it "
          "exactly: conservation across jumps, integral identities, invariants of the motion. No outside data take "
          "part. `seiche exact NAME --self-test` measures the same for any parameters."};
}

/// It evaluates at its defaults, and keeps its own identities.
void evaluates(verification::Check& check, const exact::ExactSolution& solution) {
  INFO(solution.name);
  const exact::Evaluator evaluator = solution.evaluator();
  CHECK(evaluator.scalars().size() == solution.scalars.size());
  std::vector<double> defaults;
  for (const auto& input : solution.inputs) defaults.push_back(input.default_value);
  const std::vector<double> row = evaluator.curve ? evaluator.curve(defaults).front() : evaluator.eval(defaults);
  CHECK(row.size() == solution.outputs.size());
  CHECK(std::all_of(row.begin(), row.end(), [](double value) { return std::isfinite(value); }));
  CHECK(evaluator.uncertainty() > 0);
  const exact::SelfTest identities = evaluator.self_test();
  CHECK(!identities.empty());
  for (std::size_t k = 0; k < identities.size(); ++k) {
    check.that({.id = solution.name + "-" + std::to_string(k + 1),
                .text = solution.name + ": " + identities[k].name + ".",
                .quantity = "relative defect",
                .source = solution.citation},
               {.value = identities[k].defect},
               evidence::Bound{.limit = identities[k].accuracy, .reason = identities[k].reason});
  }
}

}  // namespace

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

TEST_CASE("every exact solution evaluates at its defaults and keeps its own identities", "[exact]") {
  verification::Check check = self_tests();
  for (const exact::ExactSolution& solution : exact::catalogue()) {
    if (solution.name != costliest) evaluates(check, solution);
  }
}

TEST_CASE("the costliest exact solution does so too", "[exact][full]") {
  verification::Check check = self_tests();
  evaluates(check, exact::find_solution(costliest));
}

TEST_CASE("the shallow-water entries answer like their classes", "[exact]") {
  const auto value = [](const char* name, double x, double t) {
    const exact::ExactSolution& solution = exact::find_solution(name);
    const std::vector<double> at = solution.inputs.size() == 1 ? std::vector{x} : std::vector{x, t};
    const auto outputs = solution.evaluator().eval(at);
    CHECK(outputs.size() == solution.outputs.size());
    return outputs.front();
  };
  CHECK(std::abs(value("riemann", 0, 1) - 4.0 / 9.0) < 1e-15);
  CHECK(std::abs(value("bore_reflection", 9.99, 2.6) - 1.45167616) < 5e-9);
  CHECK(value("simple_wave", 6, 0) == 1.2);
  CHECK(std::abs(value("steady_bump", 0, 0) - 0.4137357305845031) < 1e-15);
  CHECK(std::abs(value("macdonald", 500, 0) - 1.112299103123052) < 1e-14);
  CHECK(value("thacker", 1.5, 0) == 0.5);
}

}  // namespace catalogue_test
