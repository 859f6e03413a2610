#include "validation/command/exact_output.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "seiche/io/atomic_file.hpp"
#include "seiche/io/hdf5_file.hpp"

namespace seiche::command {
namespace {

using exact::ExactSolution;
using Json = nlohmann::ordered_json;

std::string value_of(const exact::Parameter& parameter, double value) {
  return parameter.choices.empty() ? fmt::format("{}", value) : parameter.choices.at(static_cast<std::size_t>(value));
}

struct PrintedColumn {
  std::string name;
  std::string unit;
  std::string meaning;
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
    if (std::any_of(result.rows.begin(), result.rows.end(), given)) add(solution.inputs[k], k);
  }
  for (std::size_t k = 0; k < solution.outputs.size(); ++k) add(solution.outputs[k], solution.inputs.size() + k);
  return columns;
}

}  // namespace

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
    // JSON knows no infinity.
    if (p.choices.empty() && std::isfinite(value)) {
      json["parameters"][p.name] = value;
    } else {
      json["parameters"][p.name] = value_of(p, value);
    }
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

}  // namespace seiche::command
