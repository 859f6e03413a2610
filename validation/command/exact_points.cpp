#include "validation/command/exact_points.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "validation/command/settings.hpp"

namespace seiche::command {
namespace {

using exact::ExactSolution;

std::size_t input_named(const ExactSolution& solution, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& input : solution.inputs) {
    if (input.name == name) return names.size();
    names.push_back(input.name);
  }
  if (names.empty()) fail("{} has no coordinates, and no {}", solution.name, name);
  fail("{} has no coordinate {}: it has {}", solution.name, name, fmt::join(names, ", "));
}

/// Of "x=0:10:101" the numbers of a range, of "x=3" one number.
std::vector<double> range_of(const std::string& axis, const std::string& value) {
  const std::vector<std::string> parts = parts_of(value, ':');
  if (parts.size() == 1) return {finite_number(axis, parts[0])};
  if (parts.size() != 3) fail("{0}={1}: must be {0}=FROM:TO:COUNT", axis, value);
  const double from = finite_number(axis, parts[0]);
  const double to = finite_number(axis, parts[1]);
  const double count = finite_number(axis, parts[2]);
  if (count < 2 || count > 1e7 || count != std::floor(count))
    fail("{}={}: COUNT = {} must be an integer in [2, 1e7]", axis, value, parts[2]);
  std::vector<double> values(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = from + (to - from) * static_cast<double>(k) / (count - 1);
  values.back() = to;
  return values;
}

/// Time alone has no default: a motion is asked for at an instant.
void require_time(const ExactSolution& solution, const std::string& text, const std::vector<std::size_t>& given) {
  const auto time = std::ranges::find(solution.inputs, "t", &exact::Coordinate::name);
  const auto number = static_cast<std::size_t>(time - solution.inputs.begin());
  if (time == solution.inputs.end() || std::ranges::find(given, number) != given.end()) return;
  fail("{}: t is missing: {} changes in time, add t=0 for its beginning", text, solution.name);
}

}  // namespace

Point default_point(const ExactSolution& solution) {
  Point point;
  for (const auto& input : solution.inputs) point.push_back(input.default_value);
  return point;
}

std::vector<Point> points_at(const ExactSolution& solution, const std::vector<std::string>& points) {
  std::vector<Point> result;
  for (const std::string& text : points) {
    Point point = default_point(solution);
    std::vector<std::size_t> given;
    for (const auto& [axis, value] : split_settings("--at", {text})) {
      const std::size_t index = input_named(solution, axis);
      const std::vector<double> values = range_of(axis, value);
      if (values.size() != 1) fail("--at {}: must be single numbers; ranges are for --grid", text);
      point[index] = values.front();
      given.push_back(index);
    }
    require_time(solution, "--at " + text, given);
    result.push_back(point);
  }
  return result;
}

std::vector<Point> points_on_grid(const ExactSolution& solution, const std::string& grid) {
  std::vector<Point> points{default_point(solution)};
  std::vector<std::vector<double>> ranges(solution.inputs.size());
  double total = 1;
  std::vector<std::size_t> given;
  for (const auto& [axis, value] : split_settings("--grid", {grid})) {
    given.push_back(input_named(solution, axis));
    ranges[given.back()] = range_of(axis, value);
    total *= static_cast<double>(ranges[given.back()].size());
  }
  require_time(solution, "--grid " + grid, given);
  if (total > 1e7) fail("--grid {}: {:g} points, must be at most 1e7", grid, total);
  // From the slowest input to the fastest, every point so far is repeated for every value.
  for (std::size_t k = ranges.size(); k-- > 0;) {
    if (ranges[k].empty()) continue;
    std::vector<Point> product;
    product.reserve(points.size() * ranges[k].size());
    for (Point point : points) {
      for (const double value : ranges[k]) {
        point[k] = value;
        product.push_back(point);
      }
    }
    points = std::move(product);
  }
  return points;
}

std::map<std::string, double> parameters_from(const ExactSolution& solution, const std::vector<std::string>& settings) {
  std::map<std::string, double> values;
  for (const auto& p : solution.parameters) values[p.name] = p.default_value;
  for (const auto& [name, text] : split_settings("--set", settings)) {
    const auto known = std::ranges::find(solution.parameters, name, &exact::Parameter::name);
    if (known == solution.parameters.end() || known->choices.empty()) {
      values[name] = number(name, text);
      continue;
    }
    const auto choice = std::ranges::find(known->choices, text);
    if (choice == known->choices.end())
      fail("{} = {} is unknown: must be one of {}", name, text, fmt::join(known->choices, ", "));
    values[name] = static_cast<double>(choice - known->choices.begin());
  }
  return values;
}

}  // namespace seiche::command
