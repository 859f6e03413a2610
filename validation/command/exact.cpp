#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "seiche/exact/catalogue.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/settings.hpp"

namespace seiche::command {
namespace {

using exact::ExactSolution;
using Json = nlohmann::ordered_json;
using Point = std::array<double, 3>;  ///< x, y, t

struct Options {
  std::string name;
  std::vector<std::string> settings;
  std::vector<std::string> points;
  std::string grid;
  std::string format = "csv";
  bool integrals = false;
};

constexpr std::string_view axes = "xyt";

double number(const std::string& what, std::string_view text) {
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    throw std::invalid_argument(fmt::format("{} = {} is not a finite number", what, text));
  }
  return value;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string::npos) return parts;
    begin = end + 1;
  }
}

/// "x=0:10:101" as the numbers of a range, "x=3" as one number; names the axis.
std::pair<std::size_t, std::vector<double>> range_of(const std::string& text) {
  const auto [axis, value] = split_setting(text);
  const std::size_t index = axes.find(axis);
  if (axis.size() != 1 || index == std::string_view::npos) {
    throw std::invalid_argument(fmt::format("coordinate {} is unknown: must be x, y or t", axis));
  }
  const std::vector<std::string> parts = split(value, ':');
  if (parts.size() == 1) return {index, {number(axis, parts[0])}};
  if (parts.size() != 3) throw std::invalid_argument(fmt::format("{}: must be {}=FROM:TO:COUNT", text, axis));
  const double from = number(axis, parts[0]);
  const double to = number(axis, parts[1]);
  const double count = number(axis, parts[2]);
  if (count < 2 || count > 1e7 || count != std::floor(count)) {
    throw std::invalid_argument(fmt::format("{}: COUNT = {} must be an integer in [2, 1e7]", text, parts[2]));
  }
  std::vector<double> values(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = from + (to - from) * static_cast<double>(k) / (count - 1);
  return {index, values};
}

/// All points of --at, or the product of the ranges of --grid.
std::vector<Point> points_of(const Options& options) {
  std::vector<Point> points;
  for (const std::string& text : options.points) {
    Point point{};
    for (const std::string& part : split(text, ',')) {
      const auto [axis, values] = range_of(part);
      if (values.size() != 1) throw std::invalid_argument(fmt::format("--at {}: must be single numbers", text));
      point.at(axis) = values.front();
    }
    points.push_back(point);
  }
  if (options.grid.empty()) return points;
  std::array<std::vector<double>, 3> ranges{{{0}, {0}, {0}}};
  for (const std::string& part : split(options.grid, ',')) {
    const auto [axis, values] = range_of(part);
    ranges.at(axis) = values;
  }
  for (const double t : ranges[2]) {
    for (const double y : ranges[1]) {
      for (const double x : ranges[0]) points.push_back({x, y, t});
    }
  }
  return points;
}

std::map<std::string, double> parameters_of(const ExactSolution& solution, const std::vector<std::string>& settings) {
  std::map<std::string, double> values;
  for (const auto& p : solution.parameters) values[p.name] = p.default_value;
  for (const std::string& setting : settings) {
    const auto [name, text] = split_setting(setting);
    values[name] = number(name, text);
  }
  return values;
}

const ExactSolution& solution_named(const std::string& name) {
  const ExactSolution* found = exact::find_solution(name);
  if (found != nullptr) return *found;
  std::vector<std::string> names;
  for (const ExactSolution& s : exact::catalogue()) names.push_back(s.name);
  throw std::invalid_argument(
      fmt::format("exact solution {} is unknown: must be list or one of {}", name, fmt::join(names, ", ")));
}

void print_catalogue() {
  for (const ExactSolution& s : exact::catalogue()) {
    fmt::print("{}: {}\n  {}\n", s.name, s.title, s.citation);
    for (const auto& p : s.parameters) {
      fmt::print("    {:<16} {} [{}], default {:g}, in [{:g}, {:g}]\n", p.name, p.meaning, p.unit, p.default_value,
                 p.minimum, p.maximum);
    }
    for (const auto& o : s.outputs) fmt::print("    -> {:<13} {} [{}]\n", o.name, o.meaning, o.unit);
    for (const auto& o : s.scalars) fmt::print("    => {:<13} {} [{}]\n", o.name, o.meaning, o.unit);
  }
}

std::vector<std::pair<std::string, std::string>> columns_of(const ExactSolution& solution) {
  std::vector<std::pair<std::string, std::string>> columns;
  for (const std::string& axis : solution.inputs) columns.emplace_back(axis, axis == "t" ? "s" : "m");
  for (const auto& o : solution.outputs) columns.emplace_back(o.name, o.unit);
  return columns;
}

using Rows = std::vector<std::vector<double>>;

Rows rows_of(const ExactSolution& solution, const exact::Evaluator& evaluator, const std::vector<Point>& points) {
  Rows rows;
  for (const Point& p : points) {
    std::vector<double> row;
    for (const std::string& axis : solution.inputs) row.push_back(p.at(axes.find(axis)));
    for (const double value : evaluator.eval(p[0], p[1], p[2])) row.push_back(value);
    rows.push_back(std::move(row));
  }
  return rows;
}

void print_csv(const ExactSolution& solution, const std::map<std::string, double>& parameters, const Rows& rows,
               const std::vector<double>& scalars) {
  fmt::print("# {}\n# {}\n", solution.title, solution.citation);
  for (const auto& p : solution.parameters) fmt::print("# {} = {:.17g} {}\n", p.name, parameters.at(p.name), p.unit);
  for (std::size_t k = 0; k < scalars.size(); ++k) {
    fmt::print("# {} [{}] = {:.17g}\n", solution.scalars[k].name, solution.scalars[k].unit, scalars[k]);
  }
  if (rows.empty()) return;
  std::vector<std::string> names;
  for (const auto& [name, unit] : columns_of(solution)) names.push_back(fmt::format("{} [{}]", name, unit));
  fmt::print("{}\n", fmt::join(names, ","));
  for (const auto& row : rows) fmt::print("{:.17g}\n", fmt::join(row, ","));
}

void print_json(const ExactSolution& solution, const std::map<std::string, double>& parameters, const Rows& rows,
                const std::vector<double>& scalars) {
  Json json = {{"name", solution.name}, {"citation", solution.citation}, {"parameters", parameters}};
  for (const auto& [name, unit] : columns_of(solution)) json["columns"].push_back({{"name", name}, {"unit", unit}});
  json["rows"] = rows;
  for (std::size_t k = 0; k < scalars.size(); ++k) json["scalars"][solution.scalars[k].name] = scalars[k];
  fmt::print("{}\n", json.dump(1));
}

int exact_command(const Options& options) {
  if (options.name == "list") {
    print_catalogue();
    return 0;
  }
  const ExactSolution& solution = solution_named(options.name);
  const std::map<std::string, double> parameters = parameters_of(solution, options.settings);
  const std::vector<Point> points = points_of(options);
  const auto evaluator = solution.evaluator(parameters);
  const std::vector<double> scalars = options.integrals || points.empty() ? evaluator.scalars() : std::vector<double>{};
  const Rows rows = rows_of(solution, evaluator, points);
  if (options.format == "json") {
    print_json(solution, parameters, rows, scalars);
  } else {
    print_csv(solution, parameters, rows, scalars);
  }
  return 0;
}

}  // namespace

void add_exact(CLI::App& app, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("exact", "Print an exact solution; 'seiche exact list' shows them all");
  command->add_option("NAME", options->name, "name of the solution, or list")->required();
  command->add_option("--set", options->settings, "parameter, as name=value; may be repeated")->allow_extra_args(false);
  command->add_option("--at", options->points, "point, as x=1,t=2; may be repeated")->allow_extra_args(false);
  command->add_option("--grid", options->grid, "points, as x=-10:10:401,t=2 (FROM:TO:COUNT)");
  command->add_option("--format", options->format, "csv or json")->check(CLI::IsMember({"csv", "json"}));
  command->add_flag("--integrals", options->integrals, "also the scalar results");
  command->footer("Example: seiche exact riemann --set right_depth=0.1 --grid x=-10:10:401,t=2");
  command->callback([options, &action] { action = [options] { return exact_command(*options); }; });
}

}  // namespace seiche::command
