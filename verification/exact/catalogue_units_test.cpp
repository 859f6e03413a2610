// Exact solutions do not know units: every entry of the catalogue, with its declared units, under a change of them.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/catalogue.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::catalogue_units_test {

using namespace exact;

/// What one metre, second and kilogram are in the other units.
struct Units {
  double length, time, mass;
};

/// Of "kg/m^3", "s/m^(1/3)", "1": a numerator and a denominator of one unit each, with an exponent.
double factor_of(std::string_view unit, const Units& units) {
  const auto of_one = [&](std::string_view one) {
    const auto caret = one.find('^');
    const std::string_view name = one.substr(0, caret);
    double exponent = 1;
    if (caret != std::string_view::npos)
      exponent = one[caret + 1] == '(' ? 1.0 / 3 : std::stod(std::string(one.substr(caret + 1)));
    const std::map<std::string_view, double> known{{"1", 1},
                                                   {"rad", 1},
                                                   {"deg", 1},
                                                   {"degrees", 1},
                                                   {"m", units.length},
                                                   {"s", units.time},
                                                   {"kg", units.mass},
                                                   {"Pa", units.mass / (units.length * units.time * units.time)}};
    return std::pow(known.at(name), exponent);
  };
  const auto slash = unit.find('/');
  return slash == std::string_view::npos ? of_one(unit)
                                         : of_one(unit.substr(0, slash)) / of_one(unit.substr(slash + 1));
}

bool integrates_motion(const ExactSolution& solution) {
  return std::any_of(solution.parameters.begin(), solution.parameters.end(),
                     [](const exact::Parameter& p) { return p.name == "markers"; });
}

/// What integrates a motion does so coarsely, for a low wave, and not for long.
double usual(const ExactSolution& solution, const exact::Parameter& p) {
  if (p.name == "markers") return p.minimum;
  if (p.name == "last_time") return 0.5;
  return integrates_motion(solution) && p.name == "amplitude" ? 0.1 : p.default_value;
}

/// The k-th place, time or number; where a default stands for something else, now and then that.
double sample(const exact::Coordinate& c, std::size_t k) {
  static const std::map<std::string_view, std::vector<double>> samples{{"m", {0.3, 1.1, -0.7, 2.6, 0}},
                                                                       {"s", {0, 0.37, 0.2, 1.6, 0.45}},
                                                                       {"1/m", {1.3, 0.2, 5, 0.7, 2}},
                                                                       {"1", {1, 2, 0, 3, 0.5}}};
  return std::isnan(c.default_value) && k % 2 == 0 ? c.default_value
                                                   : (c.name == "y" ? -0.2 : samples.at(c.unit).at(k));
}

/// All numbers of a solution in the first units, by their place in the table; none where it refuses.
using Numbers = std::vector<std::optional<std::vector<double>>>;
Numbers numbers(const ExactSolution& solution, const Units& units) {
  std::map<std::string, double> values;
  for (const auto& p : solution.parameters) values[p.name] = usual(solution, p) * factor_of(p.unit, units);
  std::optional<Evaluator> made;
  try {
    made = solution.evaluator(values);
  } catch (const std::invalid_argument&) {
    return {};
  }
  const Evaluator& evaluator = *made;
  const auto back = [&](Evaluator::Row row, const std::vector<exact::Quantity>& quantities) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] /= factor_of(quantities[i].unit, units);
    return row;
  };
  Numbers all{back(evaluator.scalars(), solution.scalars)};
  for (std::size_t k = 0; k < 5; ++k) {
    std::vector<double> at;
    for (const auto& input : solution.inputs) at.push_back(sample(input, k) * factor_of(input.unit, units));
    try {
      if (!evaluator.curve) {
        all.emplace_back(back(evaluator.eval(at), solution.outputs));
      } else {
        for (const auto& row : evaluator.curve(at)) all.emplace_back(back(row, solution.outputs));
      }
    } catch (const std::exception&) {
      all.emplace_back(std::nullopt);
    }
  }
  return all;
}

/// Over the largest number of the same quantity.
double largest_difference(const ExactSolution& solution, const Numbers& one, const Numbers& other) {
  Worst worst;
  if (one.size() != other.size()) return INFINITY;
  std::vector<double> scale(std::max(solution.outputs.size(), solution.scalars.size()), 0.0);
  for (std::size_t r = 1; r < one.size(); ++r) {
    for (std::size_t i = 0; one[r] && i < one[r]->size(); ++i) {
      if (const double size = std::abs((*one[r])[i]); std::isfinite(size) && size > scale[i]) scale[i] = size;
    }
  }
  for (std::size_t r = 0; r < one.size(); ++r) {
    if (one[r].has_value() != other[r].has_value()) return INFINITY;
    for (std::size_t i = 0; one[r] && i < one[r]->size(); ++i) {
      const double a = (*one[r])[i], b = (*other[r])[i];
      if (a == b || (std::isnan(a) && std::isnan(b))) {
        worst.add(0);
      } else {
        worst.add((a - b) / (r == 0 ? std::abs(a) : scale[i]));
      }
    }
  }
  return worst.value();
}

void claim_units(bool motions) {
  Check check(
      "exact_units", "Exact solutions in other units",
      "Every solution of the catalogue at its defaults, and with all lengths, times and masses multiplied according to "
      "the units that it declares: lengths by 2 alone; lengths by 4 and times by 2, which leaves gravity as it is; "
      "lengths by 1/64, times by 1/8. What comes out is multiplied accordingly. A dimensional constant in a formula, "
      "an iteration that ends at a number of metres and a wrong unit in the catalogue do not survive it.");
  for (const ExactSolution& solution : exact::catalogue()) {
    if (integrates_motion(solution) != motions) continue;
    Worst worst;
    const Numbers plain = numbers(solution, {1, 1, 1});
    for (const Units& units : {Units{2, 1, 8}, Units{4, 2, 1}, Units{1.0 / 64, 1.0 / 8, 0.25}}) {
      if (integrates_motion(solution) && worst.count() > 0) break;  // one change of units is dear enough
      const double d = largest_difference(solution, plain, numbers(solution, units));
      worst.add(d);
    }
    check.holds(
        fmt::format("The numbers of the exact solution {} are the same in other units.", solution.name),
        {worst.value()},
        Roundoff{
            .operations = 1000,
            .reason = "some hundreds of roundings, relative; the remainder of an iteration or a series is the same"});
  }
}

TEST_CASE("exact solutions do not know units", "[exact]") {
  claim_units(false);
}

TEST_CASE("nor do those that integrate a motion", "[exact][full]") {
  claim_units(true);
}

}  // namespace seiche::verification::catalogue_units_test
