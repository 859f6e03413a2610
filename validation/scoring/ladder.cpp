#include "validation/scoring/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <ranges>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/evidence/order_of_few.hpp"
#include "reports/evidence/slope_guide.hpp"
#include "seiche/samples.hpp"
#include "validation/case/claims.hpp"
#include "validation/case/refusal.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/instruments/each.hpp"
#include "validation/scoring/submitted.hpp"
#include "validation/scoring/units.hpp"

namespace seiche::validation {
namespace {

constexpr double usual_order = 2;
constexpr std::size_t fewest_sizes = 3;

/// Values at a reference point, and on every rung.
struct Point {
  double reference = 0;
  std::vector<double> values;
};

void require(const std::vector<Rung>& rungs) {
  const std::vector<double> given = each(rungs, &Rung::size);
  const std::set<double> sizes(given.begin(), given.end());
  const bool positive = std::ranges::all_of(given, [](double size) { return std::isfinite(size) && size > 0; });
  if (!positive || sizes.size() != rungs.size() || sizes.size() < fewest_sizes)
    fail("sizes {}: must be three or more, all different and positive", fmt::join(given, ","));
  const auto tables = std::views::keys(rungs.front().submitted);
  for (const Rung& rung : rungs) {
    if (!std::ranges::equal(std::views::keys(rung.submitted), tables))
      fail("size {:g}: other tables than the coarsest", rung.size);
  }
}

std::vector<Point> points_of(const WantedTable& table, const WantedQuantity& quantity, const std::vector<Rung>& rungs) {
  std::vector<Point> points;
  const std::string& name = quantity.column.name;
  const std::size_t groups = rungs.front().submitted.at(table.name).size();
  for (std::size_t g = 0; g < groups; ++g) {
    const double group = rungs.front().submitted.at(table.name)[g].value;
    const bool single = table.kind == WantedTable::Kind::scalars;
    for (const double at : points_of(table, group)) {
      Point point{.reference = quantity.reference({group, at}), .values = {}};
      bool known = !std::isnan(point.reference);
      for (const Rung& rung : rungs) {
        const SubmittedGroup& submitted = rung.submitted.at(table.name)[g];
        const std::vector<double>& values = submitted.values.at(name);
        point.values.push_back(single ? values.front() : linear_at({submitted.abscissa, values}, at));
        known = known && !std::isnan(point.values.back()) && !in_gap(submitted, at);
      }
      if (known) points.push_back(std::move(point));
    }
  }
  return points;
}

LadderQuantity quantity_of(const WantedTable& table, const WantedQuantity& quantity, const std::vector<double>& sizes,
                           const std::vector<Point>& points) {
  LadderQuantity q{.table = table.name,
                   .name = quantity.column.name,
                   .unit = quantity.column.unit,
                   .exact = table.reference_role == evidence::Role::exact,
                   .order = {},
                   .tends = {}};
  const auto count = static_cast<double>(points.size());
  double scale = 0;
  double half_widths = 0;
  std::vector<double> errors(sizes.size()), distances(sizes.size());
  for (const Point& point : points) {
    const evidence::GridConvergence limit = evidence::grid_convergence(sizes, point.values, usual_order);
    scale += point.reference * point.reference;
    half_widths += limit.uncertainty * limit.uncertainty;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      errors[k] += std::pow(point.values[k] - point.reference, 2);
      distances[k] += std::pow(point.values[k] - limit.extrapolated, 2);
    }
  }
  q.relative = scale > 0;
  const double divisor = std::sqrt(q.relative ? scale : count);
  const auto norm = [&](double squares) { return std::sqrt(squares) / divisor; };
  q.error = each(errors, norm);
  q.away = each(distances, norm);
  q.numerical = std::sqrt(half_widths) / divisor;
  q.typical = std::sqrt(half_widths / count);
  q.tends = evidence::grid_convergence(sizes, q.error, usual_order);
  q.order = evidence::order_of_few(sizes, q.converging(), fewest_sizes);
  return q;
}

std::string amount(const LadderQuantity& q, double error) {
  return q.relative ? fmt::format("{:.2g} %", 100 * error) : fmt::format("{:.2g}{}", error, after_number(q.unit));
}

/// Errors that stay beyond what is left of them to converge.
bool stays(const LadderQuantity& q) {
  return q.exact && q.tends.extrapolated > q.tends.uncertainty;
}

void tabulate_results(const Ladder& ladder, evidence::Exhibit& exhibit) {
  evidence::Table& table = add_table(
      exhibit, "ladder-orders", "How fast your solver converges",
      "Order with its 95 % interval: of the error where the reference is exact, else of the distance from your "
      "own limit. Errors are relative to the reference.",
      {"quantity", "order", "from", "to", "error of the finest [1]", "numerical, 95 % [1]", "error tends to [1]",
       "size for 1 %", "at least", "at most", "time for 1 % [s]"});
  for (const LadderQuantity& q : ladder.quantities) {
    const Reach reach = ladder.reach(q, ladder_target).value_or(Reach{nan, nan, nan, {}});
    table.rows.push_back({q.name, q.order.order, q.order.order - q.order.half_width, q.order.order + q.order.half_width,
                          q.error.back(), q.numerical, q.tends.extrapolated, reach.size, reach.least, reach.most,
                          reach.seconds.value_or(nan)});
  }
}

void tabulate_errors(const Ladder& ladder, evidence::Exhibit& exhibit) {
  evidence::Table& table =
      add_table(exhibit, "ladder", "Error on every size",
                "Of each quantity, over all reference points that every size covers.", {"size [m]"});
  for (const LadderQuantity& q : ladder.quantities) table.columns.emplace_back(q.name, q.relative ? "1" : q.unit);
  if (!ladder.seconds.empty()) table.columns.emplace_back("time", "s");
  for (std::size_t k = 0; k < ladder.size.size(); ++k) {
    auto& row = table.rows.emplace_back();
    row.emplace_back(ladder.size[k]);
    for (const LadderQuantity& q : ladder.quantities) row.emplace_back(q.error[k]);
    if (!ladder.seconds.empty()) row.emplace_back(ladder.seconds[k]);
  }
}

}  // namespace

std::optional<Reach> Ladder::reach(const LadderQuantity& q, double target) const {
  const double order = q.order.order;
  if (!q.relative || !(order > 0) || stays(q)) return std::nullopt;
  const double error = q.converging().back();
  const double open = target > error ? std::numeric_limits<double>::infinity() : 0.0;
  const auto with = [&](double p) { return p > 0 ? size.back() * std::pow(target / error, 1 / p) : open; };
  const auto [least, most] = std::minmax({with(order - q.order.half_width), with(order + q.order.half_width)});
  Reach reached{.size = with(order), .least = least, .most = most, .seconds = {}};
  if (seconds.empty()) return reached;
  const evidence::ObservedOrder cost = evidence::order_of_few(size, seconds, fewest_sizes);
  if (std::isfinite(cost.order)) reached.seconds = seconds.back() * std::pow(reached.size / size.back(), cost.order);
  return reached;
}

std::string Ladder::line(const LadderQuantity& q) const {
  std::string text = q.name + ": ";
  if (std::isfinite(q.order.order)) {
    text += fmt::format("your {}order is {:.2g} ({:.2g} to {:.2g})", q.exact ? "" : "own ", q.order.order,
                        q.order.order - q.order.half_width, q.order.order + q.order.half_width);
  } else {
    text += "no order, " + q.order.note;
  }
  text += fmt::format("; error on {:g} is {}", size.back(), amount(q, q.error.back()));
  if (!q.exact) text += fmt::format(", numerically {}", amount(q, q.numerical));
  if (stays(q)) {
    return text + fmt::format("; the error converges to {}, not to zero", amount(q, q.tends.extrapolated));
  }
  const std::optional<Reach> reached = reach(q, ladder_target);
  if (!reached) return q.relative ? text + "; it does not fall with the size" : text;
  text +=
      fmt::format("; {:g} %{} needs dx = {:.2g}", 100 * ladder_target, q.exact ? "" : " numerically", reached->size);
  if (reached->seconds) text += fmt::format(" and {:.2g} s", *reached->seconds);
  if (reached->least == 0 || std::isinf(reached->most))
    text += fmt::format(", but {} sizes leave the order uncertain", size.size());
  return text;
}

Ladder ladder_of(const std::vector<WantedTable>& wanted, std::vector<Rung> rungs) {
  require(rungs);
  std::ranges::sort(rungs, std::greater{}, &Rung::size);
  Ladder ladder{.size = each(rungs, &Rung::size)};
  for (const Rung& rung : rungs) {
    if (rung.seconds) ladder.seconds.push_back(*rung.seconds);
  }
  if (!ladder.seconds.empty() && ladder.seconds.size() != ladder.size.size())
    fail("{} times for {} sizes: must be as many, or none", ladder.seconds.size(), ladder.size.size());
  for (const WantedTable& table : wanted) {
    if (!rungs.front().submitted.contains(table.name)) continue;
    for (const WantedQuantity& quantity : table.quantities) {
      const std::vector<Point> points = points_of(table, quantity, rungs);
      if (!points.empty()) ladder.quantities.push_back(quantity_of(table, quantity, ladder.size, points));
    }
  }
  return ladder;
}

void show_ladder(const Ladder& ladder, evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure("ladder", "Error against size and time",
                                "Of the error where the reference is exact, else the distance from your own limit.");
  auto& sizes = figure.panel({.x = "size [m]", .y = "error", .log_x = true, .log_y = true});
  Largest coarsest;
  for (const LadderQuantity& q : ladder.quantities) {
    sizes.points(q.name, ladder.size, q.converging());
    coarsest.add(q.converging().back());
    exhibit.measure("ladder_order_" + q.name, q.order.order);
    exhibit.measure("ladder_error_" + q.name, q.error.back());
    exhibit.measure("ladder_numerical_" + q.name, q.numerical);
    if (const auto reached = ladder.reach(q, ladder_target))
      exhibit.measure("ladder_size_for_1_percent_" + q.name, reached->size);
  }
  if (coarsest.value() > 0) {
    slope_guide(sizes, 1, ladder.size, coarsest.value());
    slope_guide(sizes, 2, ladder.size, coarsest.value());
  }
  if (!ladder.seconds.empty()) {
    auto& cost = figure.panel({.x = "processor time [s]", .y = "error", .log_x = true, .log_y = true});
    for (const LadderQuantity& q : ladder.quantities) cost.points(q.name, ladder.seconds, q.converging());
  }
  tabulate_results(ladder, exhibit);
  tabulate_errors(ladder, exhibit);
}

void add_numerical(const Ladder& ladder, std::map<std::string, StatedUncertainty>& uncertainty) {
  for (const LadderQuantity& q : ladder.quantities) {
    if (!q.exact) uncertainty.try_emplace(q.name, StatedUncertainty{.value = q.typical / 2});
  }
}

}  // namespace seiche::validation
