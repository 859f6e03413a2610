#include <filesystem>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/exact/catalogue.hpp"
#include "seiche/io/atomic_file.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/exact_inputs.hpp"
#include "validation/command/exact_output.hpp"
#include "validation/command/exact_points.hpp"

namespace seiche::command {
namespace {

using exact::ExactSolution;

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
      add(point, std::vector<double>(outputs, std::numeric_limits<double>::quiet_NaN()));
    }
  }
  return rows;
}

InputOptions inputs_of(const ExactOptions& options) {
  InputOptions inputs{.format = options.write,
                      .folder = options.out.empty() ? "." : options.out,
                      .grid = options.grid,
                      .points = options.points,
                      .centres = options.centres,
                      .up = options.up,
                      .width = options.width};
  if (!options.origin.empty()) {
    inputs.origin_x = options.origin.at(0);
    inputs.origin_up = options.origin.at(1);
  }
  return inputs;
}

/// Returns whether every identity holds.
bool print_self_test(const exact::Evaluator& evaluator) {
  bool all = true;
  for (const exact::Identity& identity : evaluator.self_test()) {
    const bool holds = identity.defect <= identity.accuracy;  // NaN does not
    all = all && holds;
    fmt::print("{}{}: defect {:.2g}, accuracy {:.2g} ({})\n", holds ? "" : "FAILS: ", identity.name, identity.defect,
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
    for (const std::filesystem::path& file : write_inputs(solution, result.parameters, inputs_of(options))) {
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
    Point defaults;
    for (const auto& input : solution.inputs) defaults.push_back(input.default_value);
    points.push_back(defaults);
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
