// Numbers of exact solutions that are known to many digits, and what they refuse: one program for all, by the
// catalogue.
#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/exact/catalogue.hpp"
#include "seiche/io/text_table.hpp"
#include "validation/case/data_folder.hpp"
#include "verification/digits_table.hpp"

namespace seiche::verification::digits_test {

/// "depth=1;kind=flap": choices by their places in the list.
std::map<std::string, double> numbers(const std::string& text, const std::vector<exact::Parameter>& parameters = {}) {
  std::map<std::string, double> values;
  std::istringstream items(text);
  for (std::string item; std::getline(items, item, ';');) {
    const std::string name = item.substr(0, item.find('=')), value = item.substr(item.find('=') + 1);
    const auto p = std::ranges::find(parameters, name, &exact::Parameter::name);
    const bool chosen = p != parameters.end() && !p->choices.empty();
    values[name] = chosen ? static_cast<double>(std::ranges::find(p->choices, value) - p->choices.begin())
                          : io::value_in(value).value();
  }
  return values;
}

/// The place of "x=0;t=1", other coordinates at their defaults.
std::vector<double> place(const exact::ExactSolution& solution, const std::string& at) {
  std::vector<double> coordinates;
  auto given = numbers(at);
  for (const exact::Coordinate& input : solution.inputs) {
    coordinates.push_back(given.emplace(input.name, input.default_value).first->second);
  }
  return coordinates;
}

/// The rows of a table of reference_data, its head left out.
std::vector<std::vector<std::string>> rows_of(const std::string& file) {
  const io::Text table = io::text_of(validation::data_folder("reference_data") / file);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t line = 1; line < table.lines.size(); ++line) rows.push_back(io::entries_of(table.lines[line], ','));
  return rows;
}

/// A scalar of the solution, or one of its outputs, at a place if it knows places.
double computed(const exact::ExactSolution& solution, const std::string& parameters, const std::string& at,
                const std::string& quantity) {
  const exact::Evaluator evaluator = solution.evaluator(numbers(parameters, solution.parameters));
  const auto named = [&](const std::vector<exact::Quantity>& all, const std::vector<double>& values) {
    return values.at(static_cast<std::size_t>(std::ranges::find(all, quantity, &exact::Quantity::name) - all.begin()));
  };
  const bool scalar = std::ranges::find(solution.scalars, quantity, &exact::Quantity::name) != solution.scalars.end();
  if (at.empty() && scalar) return named(solution.scalars, evaluator.scalars());
  return named(solution.outputs, evaluator.eval(place(solution, at)));
}

TEST_CASE("exact solutions have the digits that are known of them", "[exact]") {
  Check check(
      "exact_digits", "Digits of exact solutions",
      "`reference_data/exact_digits.csv` has numbers of the solutions of the catalogue that were computed in 30-digit "
      "arithmetic: plateau and bore of dam breaks (depth 1 m), a bore at a wall, steady flow in its regimes, bowls, a "
      "drop, dispersion laws, the series of a solitary wave and its Mach reflection, wavemakers with their evanescent "
      "modes, run-up, standing waves, a wave known by its length, its period and its height; the semi-axis of a "
      "stretched drop that Monaghan (1994) prints; and fourteen digits of velocities inside solitary and Stokes waves, "
      "by an earlier implementation of ours at two resolutions. Each must have all digits that are printed there.");
  std::map<std::string, std::vector<Printed>> rows;
  for (const auto& row : rows_of("exact_digits.csv")) {
    INFO(fmt::format("{}", fmt::join(row, ",")));
    REQUIRE(row.size() == 5);
    rows[row[0]].push_back({computed(exact::find_solution(row[0]), row[1], row[2], row[3]), row[4]});
  }
  for (const auto& [solution, printed] : rows) {
    check_table(check, solution, solution, printed, exact::find_solution(solution).citation);
  }
}

TEST_CASE("exact solutions reject parameters outside their theory, with the reason", "[exact]") {
  for (const auto& row : rows_of("exact_refusals.csv")) {
    INFO(fmt::format("{}", fmt::join(row, ",")));
    REQUIRE(row.size() == 4);
    const exact::ExactSolution& solution = exact::find_solution(row[0]);
    auto values = numbers(row[1], solution.parameters);
    for (const exact::Parameter& p : solution.parameters) values.emplace(p.name, p.default_value);
    // By the factory: the catalogue's own ranges are not asked.
    CHECK_THROWS_WITH(solution.factory(values).eval(place(solution, row[2])), Catch::Contains(row[3]));
  }
}

}  // namespace seiche::verification::digits_test
