#include "validation/laboratory/experiment.hpp"
#include "validation/instruments/each.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/io/text_table.hpp"
#include "seiche/samples.hpp"
#include "validation/case/data_folder.hpp"
#include "validation/case/reference_source.hpp"

namespace seiche::validation::laboratory {
namespace {

struct Row {
  double x = 0, y = 0, u = 0;
};

const ColumnUncertainty& stated(const ReferenceSource& source, const std::string& column, const std::string& table) {
  const auto found = source.standard_uncertainty.find(column);
  if (found == source.standard_uncertainty.end()) {
    throw std::logic_error(fmt::format("{}: column {} has no standard uncertainty", table, column));
  }
  return found->second;
}

/// Of the rows of a table that count, by group.
std::map<double, std::vector<Row>> rows_of(const Series& part, const io::Table& table, const ReferenceSource& source) {
  const std::vector<std::string> columns =
      part.columns.empty() ? std::vector<std::string>{part.quantity.name} : part.columns;
  std::map<double, std::vector<Row>> groups;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const auto entry = [&](const std::string& column) { return table.column(column)[k]; };
    const double group = part.group ? entry(part.group->name) : 0;
    const bool asked = part.groups.empty() || std::ranges::find(part.groups, group) != part.groups.end();
    const double x = entry(part.abscissa.name);
    const auto as_said = [&](const auto& one) { return entry(one.first) == one.second; };
    if (!asked || !std::ranges::all_of(part.rows, as_said) || !(x <= part.highest)) continue;
    const std::vector<double> y = each(columns, entry);
    double u = std::hypot(
        largest(each(columns, [&](const std::string& one) { return stated(source, one, part.table).of(entry(one)); })),
        0.5 * (largest(y) - smallest(y)) / std::numbers::sqrt3);
    if (!part.spread.empty()) {
      u = entry(part.spread);
    } else if (!part.band.empty()) {
      constexpr double widths = 2 * 1.96;  // standard deviations between the percentiles of a normal distribution
      u = (entry(part.band.at(1)) - entry(part.band.at(0))) / widths;
    }
    groups[group].push_back({x, over<Mean>(y, std::identity{}).value(), u});
  }
  return groups;
}

/// Rows of the same abscissa become their mean, with the standard deviation of the repeats.
void add_rows(const std::vector<Row>& rows, Measured& curve) {
  for (std::size_t k = 0; k < rows.size();) {
    std::size_t end = k + 1;
    while (end < rows.size() && rows[end].x == rows[k].x) ++end;
    const auto n = static_cast<double>(end - k);
    double mean = 0;
    for (std::size_t i = k; i < end; ++i) mean += rows[i].y / n;
    double square = 0;
    for (std::size_t i = k; i < end; ++i) square += std::pow(rows[i].y - mean, 2);
    curve.x.push_back(rows[k].x);
    curve.y.push_back(mean);
    curve.u.push_back(end - k > 1 ? std::sqrt(square / (n - 1)) : rows[k].u);
    k = end;
  }
}

}  // namespace

void set_zero(const std::vector<double>& x, std::vector<double>& y, Window still) {
  Mean level;
  for (const std::size_t i : inside(x, still)) level.add(y[i]);
  if (level.count() == 0) return;
  for (double& one : y) one -= level.value();
}

double Clock::lag(Curve computed, const Measured& measured) const {
  if (!by) return lag_of(computed, measured, window, range);
  return std::clamp(by->of(computed, measured) - by->expected(measured), -range, range);
}

std::vector<Measured> measured(const Series& part, const Values& values) {
  const ReferenceSource source = reference_source(part.table);
  const auto of_abscissa = source.standard_uncertainty.find(part.abscissa.name);
  const double u_x = of_abscissa == source.standard_uncertainty.end() ? 0 : of_abscissa->second.value;
  std::vector<Measured> curves;
  for (auto& [group, members] : rows_of(part, values.table(part.table), source)) {
    std::ranges::stable_sort(members, {}, &Row::x);
    Measured curve{.group = group, .u_x = u_x};
    add_rows(members, curve);
    if (part.still) set_zero(curve.x, curve.y, *part.still);
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<WantedTable> wanted(const Experiment& experiment, const Values& values) {
  std::vector<WantedTable> tables;
  for (const Series& part : experiment.parts) {
    const Lazy<std::vector<Measured>> curves([part, values] { return measured(part, values); });
    const auto find = [curves](double group) -> const Measured& {
      return *std::ranges::find(*curves, group, &Measured::group);
    };
    const bool scalar = part.kind == WantedTable::Kind::scalars;
    WantedTable table{.name = part.name,
                      .kind = part.kind,
                      .group = part.group,
                      .abscissa = scalar ? std::nullopt : std::optional(part.abscissa),
                      .quantities = {{.column = part.quantity,
                                      .reference =
                                          [find, scalar](Place p) {
                                            const Measured& curve = find(p.group);
                                            return scalar ? curve.y.front() : linear_at(curve.curve(), p.abscissa);
                                          }}},
                      .reference_role = Role::data};
    if (!scalar) table.points = [find](double group) { return find(group).x; };
    table.judged = [part](double group) {
      constexpr double all = std::numeric_limits<double>::infinity();
      std::pair<double, double> window{all, -all};
      for (const Reading& reading : part.readings) {
        if (part.group && reading.group != group) continue;
        window = {std::min(window.first, reading.window.from), std::max(window.second, reading.window.to)};
      }
      return window.first > window.second ? std::pair(-all, all) : window;
    };
    table.places = [folder = data_folder("reference_data") / part.table] {
      std::map<double, std::pair<double, double>> places;
      if (!std::filesystem::is_regular_file(folder / "gauges.csv")) return places;
      const io::Table gauges = io::read_csv(folder / "gauges.csv");
      for (std::size_t k = 0; k < gauges.rows(); ++k) {
        const double y = gauges.has("y") ? gauges.column("y")[k] : nan;
        places[gauges.column("gauge")[k]] = {gauges.column("x")[k], y};
      }
      return places;
    };
    if (part.group) {
      table.groups = [curves] { return each(*curves, &Measured::group); };
    }
    std::vector<std::string> files{fmt::format("reference_data/{}/table.csv", part.table)};
    for (const std::string& file : experiment.files) files.push_back("reference_data/" + file);
    table.exact = files;
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace seiche::validation::laboratory
