#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "seiche/exact/catalogue.hpp"
#include "seiche/io/atomic_file.hpp"
#include "seiche/io/hdf5_file.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/exact_inputs.hpp"
#include "validation/command/exact_points.hpp"

namespace seiche::command {
namespace {

using exact::ExactSolution;

// What `seiche exact` computed, as CSV, JSON or HDF5.

struct ExactResult {
  const exact::ExactSolution* solution = nullptr;
  std::map<std::string, double> parameters;
  std::vector<std::vector<double>> rows;  ///< inputs, then outputs; NaN for an input that stands for the surface
  std::vector<double> scalars;            ///< empty if they were not asked for
  std::optional<double> uncertainty;      ///< relative to the solution's own scale, where scalars were asked for
};

using Json = nlohmann::ordered_json;

std::string value_of(const exact::Parameter& parameter, double value) {
  return parameter.choices.empty() ? fmt::format("{}", value) : parameter.choices.at(static_cast<std::size_t>(value));
}

struct PrintedColumn {
  std::string name, unit, meaning;
  std::vector<double> values;
};

/// Inputs and outputs; an input left to its default without a number (the surface) in every row has no column.
std::vector<PrintedColumn> columns_of(const ExactResult& result) {
  const ExactSolution& solution = *result.solution;
  std::vector<PrintedColumn> columns;
  const auto add = [&](const auto& quantity, std::size_t index) {
    PrintedColumn column{quantity.name, quantity.unit, quantity.meaning, {}};
    // Adding zero makes 0 of -0.
    for (const auto& row : result.rows) column.values.push_back(row[index] + 0.0);
    columns.push_back(std::move(column));
  };
  for (std::size_t k = 0; k < solution.inputs.size(); ++k) {
    const auto given = [k](const std::vector<double>& row) { return !std::isnan(row[k]); };
    if (std::ranges::any_of(result.rows, given)) add(solution.inputs[k], k);
  }
  for (std::size_t k = 0; k < solution.outputs.size(); ++k) add(solution.outputs[k], solution.inputs.size() + k);
  return columns;
}

std::string as_csv(const ExactResult& result) {
  const ExactSolution& solution = *result.solution;
  std::vector<std::string> scale;
  for (const auto& p : solution.parameters) {
    if (p.name == "gravity" || p.name.ends_with("depth"))
      scale.push_back(fmt::format("{} {} {}", p.name, result.parameters.at(p.name), p.unit));
  }
  std::string text = fmt::format("# {}{}{}\n# {}\n", solution.title, scale.empty() ? "" : ": ", fmt::join(scale, ", "),
                                 solution.citation);
  for (const auto& p : solution.parameters) {
    text += fmt::format("# {} = {} {}\n", p.name, value_of(p, result.parameters.at(p.name)), p.unit);
  }
  if (result.uncertainty) {
    text += fmt::format("# numerical uncertainty, relative to the solution's scale: {:.1g}\n", *result.uncertainty);
  }
  std::vector<std::string> names;
  if (result.rows.empty()) {
    // Nothing but scalars was asked for: they are the table.
    for (const auto& s : solution.scalars) names.push_back(fmt::format("{} [{}]", s.name, s.unit));
    return text + fmt::format("{}\n{}\n", fmt::join(names, ","), fmt::join(result.scalars, ","));
  }
  for (std::size_t k = 0; k < result.scalars.size(); ++k) {
    text += fmt::format("# {} [{}] = {}\n", solution.scalars[k].name, solution.scalars[k].unit, result.scalars[k]);
  }
  const std::vector<PrintedColumn> columns = columns_of(result);
  for (const auto& column : columns) names.push_back(fmt::format("{} [{}]", column.name, column.unit));
  text += fmt::format("{}\n", fmt::join(names, ","));
  std::vector<double> row(columns.size());
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k) row[k] = columns[k].values[i];
    text += fmt::format("{}\n", fmt::join(row, ","));
  }
  return text;
}

std::string as_json(const ExactResult& result) {
  const ExactSolution& solution = *result.solution;
  Json json = {{"name", solution.name}, {"title", solution.title}, {"citation", solution.citation}};
  for (const auto& p : solution.parameters) {
    const double value = result.parameters.at(p.name);
    const bool number = p.choices.empty() && std::isfinite(value);  // JSON knows no infinity
    json["parameters"][p.name] = number ? Json(value) : Json(value_of(p, value));
  }
  if (result.uncertainty) json["uncertainty"] = *result.uncertainty;
  if (!result.rows.empty()) {
    const std::vector<PrintedColumn> columns = columns_of(result);
    for (const auto& column : columns) json["columns"].push_back({{"name", column.name}, {"unit", column.unit}});
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
      Json row = Json::array();
      for (const auto& column : columns) row.push_back(column.values[i]);
      json["rows"].push_back(std::move(row));
    }
  }
  for (std::size_t k = 0; k < result.scalars.size(); ++k) {
    json["scalars"][solution.scalars[k].name] = result.scalars[k];
    json["scalar_units"][solution.scalars[k].name] = solution.scalars[k].unit;
  }
  return json.dump(1) + "\n";
}

/// One dataset per column, scalars and parameters as attributes of the root. Written atomically.
void write_hdf5(const ExactResult& result, const std::filesystem::path& file) {
  const ExactSolution& solution = *result.solution;
  io::AtomicFile target(file);
  io::Hdf5File out(target.path());
  out.attribute("/", "solution", solution.name);
  out.attribute("/", "citation", solution.citation);
  if (result.uncertainty) out.attribute("/", "uncertainty", *result.uncertainty);
  for (const auto& p : solution.parameters) {
    const double value = result.parameters.at(p.name);
    if (p.choices.empty()) {
      out.attribute("/", p.name, value);
    } else {
      out.attribute("/", p.name, value_of(p, value));
    }
  }
  if (!result.rows.empty()) {
    for (const auto& column : columns_of(result)) {
      out.array("/" + column.name, column.values, column.name, column.unit, column.meaning);
    }
  }
  if (!result.scalars.empty()) out.group("/scalars");
  for (std::size_t k = 0; k < result.scalars.size(); ++k) {
    const exact::Quantity& scalar = solution.scalars[k];
    out.array("/scalars/" + scalar.name, std::span(&result.scalars[k], 1), scalar.name, scalar.unit, scalar.meaning);
  }
  out.close();
  target.commit();
}

void print_catalogue() {
  for (const ExactSolution& s : exact::catalogue()) {
    fmt::print("{}: {}\n  {}\n  {}\n", s.name, s.title, s.citation, s.formula);
    for (const auto& p : s.parameters) {
      if (p.choices.empty()) {
        fmt::print("    --set {:<18} {} [{}], default {:.10g}, in [{:g}, {:g}]\n", p.name, p.meaning, p.unit,
                   p.default_value, p.minimum, p.maximum);
      } else {
        fmt::print("    --set {:<18} {}, default {}, one of {}\n", p.name, p.meaning,
                   p.choices.at(static_cast<std::size_t>(p.default_value)), fmt::join(p.choices, ", "));
      }
    }
    for (const auto& i : s.inputs) fmt::print("    --at  {:<18} {} [{}]\n", i.name, i.meaning, i.unit);
    for (const auto& o : s.outputs) fmt::print("    ->    {:<18} {} [{}]\n", o.name, o.meaning, o.unit);
    for (const auto& o : s.scalars) fmt::print("    =>    {:<18} {} [{}]\n", o.name, o.meaning, o.unit);
    fmt::print("\n");
  }
  fmt::print("--set parameters, --at or --grid coordinates; -> outputs at each point, => scalars of --integrals\n");
}

/// Rows of inputs and outputs. Grid points outside the fluid hold NaN, since a rectangle never fits a wave; the first
/// points, asked for one by one, must lie in the fluid.
std::vector<std::vector<double>> rows_of(const exact::Evaluator& evaluator, const std::vector<Point>& points,
                                         std::size_t outputs, std::size_t one_by_one) {
  std::vector<std::vector<double>> rows;
  const auto add = [&](const Point& point, const std::vector<double>& values) {
    rows.push_back(point);
    rows.back().insert(rows.back().end(), values.begin(), values.end());
  };
  for (const Point& point : points) {
    if (evaluator.curve) {
      for (const auto& values : evaluator.curve(point)) add(point, values);
      continue;
    }
    try {
      add(point, evaluator.eval(point));
    } catch (const exact::OutsideFluid&) {
      if (rows.size() < one_by_one) throw;
      add(point, std::vector<double>(outputs, validation::nan));
    }
  }
  return rows;
}

/// Returns whether every identity holds.
bool print_self_test(const exact::Evaluator& evaluator) {
  bool all = true;
  for (const exact::Identity& identity : evaluator.self_test()) {
    const bool holds = identity.defect <= identity.accuracy;  // NaN does not
    all = all && holds;
    fmt::print("{}{}: residual {:.2g}, accuracy {:.2g} ({})\n", holds ? "" : "FAILS: ", identity.name, identity.defect,
               identity.accuracy, identity.reason);
  }
  return all;
}

}  // namespace

int exact_command(const ExactOptions& options) {
  if (options.name == "list") {
    print_catalogue();
    return 0;
  }
  const ExactSolution& solution = exact::find_solution(options.name);
  ExactResult result{.solution = &solution, .parameters = parameters_from(solution, options.settings)};
  if (!options.write.empty() && options.write != "csv") {
    for (const std::filesystem::path& file : write_inputs(solution, result.parameters, options)) {
      fmt::print("{}\n", file.string());
    }
    return 0;
  }
  std::vector<Point> points = points_at(solution, options.points);
  const std::size_t one_by_one = options.grid.empty() ? std::numeric_limits<std::size_t>::max() : points.size();
  if (!options.grid.empty()) {
    const std::vector<Point> grid = points_on_grid(solution, options.grid);
    points.insert(points.end(), grid.begin(), grid.end());
  }
  const exact::Evaluator evaluator = solution.evaluator(result.parameters);
  if (options.self_test) {
    return print_self_test(evaluator) ? 0 : 1;
  }
  // Without points the scalars are what is left to print; a solution without scalars is evaluated at the defaults.
  if (points.empty() && (solution.inputs.empty() || solution.scalars.empty())) {
    points.push_back(default_point(solution));
  }
  if (options.integrals || points.empty()) {
    result.scalars = evaluator.scalars();
    result.uncertainty = evaluator.uncertainty();
  }
  result.rows = rows_of(evaluator, points, solution.outputs.size(), one_by_one);

  if (options.format == "hdf5") {
    const std::string file = options.out.empty() ? options.name + ".h5" : options.out;
    write_hdf5(result, file);
    fmt::print("{}\n", file);
    return 0;
  }
  if (options.write == "csv") {
    const std::filesystem::path file = std::filesystem::path(options.out) / (options.name + ".csv");
    if (!options.out.empty()) std::filesystem::create_directories(options.out);
    io::write_file(file, as_csv(result));
    fmt::print("{}\n", file.string());
    return 0;
  }
  const std::string text = options.format == "json" ? as_json(result) : as_csv(result);
  if (options.out.empty()) {
    fmt::print("{}", text);
  } else {
    io::write_file(options.out, text);
  }
  return 0;
}

}  // namespace seiche::command
