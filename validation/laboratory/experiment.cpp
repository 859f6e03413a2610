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

class Rows {
 public:
  Rows(const Series& part, const Values& values)
      : part_(part), table_(values.table(part.table)), source_(reference_source(part.table)) {
    columns_ = part.columns.empty() ? std::vector<std::string>{part.quantity.name} : part.columns;
  }

  [[nodiscard]] std::size_t size() const { return table_.rows(); }
  [[nodiscard]] bool counts(std::size_t k) const {
    if (!part_.groups.empty() && std::ranges::find(part_.groups, group(k)) == part_.groups.end()) return false;
    return std::all_of(part_.rows.begin(), part_.rows.end(),
                       [&](const auto& one) { return table_.column(one.first)[k] == one.second; }) &&
           table_.column(part_.abscissa.name)[k] <= part_.highest;
  }
  [[nodiscard]] double group(std::size_t k) const { return part_.group ? table_.column(part_.group->name)[k] : 0; }
  [[nodiscard]] Row row(std::size_t k) const {
    Mean mean;
    Largest u, highest;
    Smallest lowest;
    for (const std::string& column : columns_) {
      const double y = table_.column(column)[k];
      mean.add(y);
      highest.add(y);
      lowest.add(y);
      u.add(stated(source_, column, part_.table).of(y));
    }
    const double half = 0.5 * (highest.value() - lowest.value()) / std::numbers::sqrt3;
    return {table_.column(part_.abscissa.name)[k], mean.value(), pointwise(k).value_or(std::hypot(u.value(), half))};
  }
  [[nodiscard]] double abscissa_uncertainty() const {
    const auto found = source_.standard_uncertainty.find(part_.abscissa.name);
    return found == source_.standard_uncertainty.end() ? 0 : found->second.value;
  }

 private:
  [[nodiscard]] std::optional<double> pointwise(std::size_t k) const {
    if (!part_.spread.empty()) return table_.column(part_.spread)[k];
    if (part_.band.empty()) return std::nullopt;
    constexpr double widths = 2 * 1.96;  // standard deviations between the percentiles of a normal distribution
    return (table_.column(part_.band.at(1))[k] - table_.column(part_.band.at(0))[k]) / widths;
  }

  const Series& part_;
  io::Table table_;
  ReferenceSource source_;
  std::vector<std::string> columns_;
};

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
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] >= still.from && x[i] <= still.to) level.add(y[i]);
  }
  if (level.count() == 0) return;
  for (double& one : y) one -= level.value();
}

double Clock::lag(Curve computed, const Measured& measured) const {
  if (!by) return lag_of(computed, measured, window, range);
  return std::clamp(by->of(computed, measured) - by->expected(measured), -range, range);
}

std::vector<Measured> measured(const Series& part, const Values& values) {
  const Rows rows(part, values);
  std::map<double, std::vector<Row>> groups;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows.counts(k)) groups[rows.group(k)].push_back(rows.row(k));
  }
  std::vector<Measured> curves;
  for (auto& [group, members] : groups) {
    std::stable_sort(members.begin(), members.end(), [](const Row& a, const Row& b) { return a.x < b.x; });
    Measured curve{.group = group, .u_x = rows.abscissa_uncertainty()};
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
      return *std::find_if(curves->begin(), curves->end(), [group](const Measured& m) { return m.group == group; });
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
      table.groups = [curves] { return each(*curves, [](const Measured& curve) { return curve.group; }); };
    }
    std::vector<std::string> files{fmt::format("reference_data/{}/table.csv", part.table)};
    for (const std::string& file : experiment.files) files.push_back("reference_data/" + file);
    table.exact = files;
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace seiche::validation::laboratory
