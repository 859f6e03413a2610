#include "validation/scoring/repeats.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/case/refusal.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {
namespace {

/// The points of the first run that lie within those of all others; one nameless point for scalars.
std::vector<double> common_points(const std::vector<const SubmittedGroup*>& groups, const std::string& table) {
  const std::vector<double>& first = groups.front()->abscissa;
  if (first.empty()) return {};
  const double least = over<Largest>(groups, [](const auto* group) { return group->abscissa.front(); }).value();
  const double most = over<Smallest>(groups, [](const auto* group) { return group->abscissa.back(); }).value();
  std::vector<double> points = first;
  std::erase_if(points, [&](double x) { return x < least || x > most; });
  if (points.size() < 2)
    fail("--repeats: the runs have {} points of table {} in common, needed: 2", points.size(), table);
  return points;
}

SubmittedGroup mean_of(const std::vector<const SubmittedGroup*>& groups, const std::string& table,
                       std::map<std::string, Mean>& variances) {
  const auto runs = static_cast<double>(groups.size());
  const SubmittedGroup& first = *groups.front();
  SubmittedGroup mean{.value = first.value, .abscissa = common_points(groups, table), .values = {}};
  for (const auto& [quantity, values] : first.values) {
    const std::size_t points = mean.abscissa.empty() ? values.size() : mean.abscissa.size();
    for (std::size_t i = 0; i < points; ++i) {
      const auto at = [&, quantity = quantity](const SubmittedGroup& group) {
        const std::vector<double>& v = group.values.at(quantity);
        return mean.abscissa.empty() ? v.at(i) : linear_at({group.abscissa, v}, mean.abscissa[i]);
      };
      const double middle = over<Mean>(groups, [&](const auto* group) { return at(*group); }).value();
      const auto squares = over<Mean>(groups, [&](const auto* group) { return std::pow(at(*group) - middle, 2); });
      mean.values[quantity].push_back(middle);
      variances[quantity].add(squares.sum() / (runs - 1));
    }
  }
  return mean;
}

/// The same group of every run.
std::vector<const SubmittedGroup*> group_of(const std::vector<Submitted>& runs, const std::string& table,
                                            std::size_t number) {
  std::vector<const SubmittedGroup*> groups;
  for (const Submitted& run : runs) {
    const std::vector<SubmittedGroup>& all = runs.front().at(table);
    const auto found = run.find(table);
    if (found == run.end() || found->second.size() != all.size() || found->second[number].value != all[number].value)
      fail("--repeats: the runs differ in the groups of table {}", table);
    groups.push_back(&found->second[number]);
    if (!std::ranges::equal(std::views::keys(groups.back()->values), std::views::keys(all[number].values)))
      fail("--repeats: the runs differ in the quantities of table {}", table);
  }
  return groups;
}

}  // namespace

Repeats repeats_of(const std::vector<Submitted>& runs) {
  if (runs.size() < 2) fail("--repeats {}: must be at least 2", runs.size());
  Repeats repeats{.runs = runs.size()};
  std::map<std::string, Mean> variances;
  for (const Submitted& run : runs) {
    if (run.size() != runs.front().size()) fail("--repeats: the runs hold different tables");
  }
  for (const auto& [table, groups] : runs.front()) {
    for (std::size_t k = 0; k < groups.size(); ++k) {
      repeats.mean[table].push_back(mean_of(group_of(runs, table, k), table, variances));
    }
  }
  for (const auto& [quantity, variance] : variances) repeats.scatter[quantity] = std::sqrt(variance.value());
  return repeats;
}

void add_scatter(const Repeats& repeats, std::map<std::string, StatedUncertainty>& uncertainty) {
  for (const auto& [quantity, scatter] : repeats.scatter) {
    const auto stated = uncertainty.find(quantity);
    if (stated == uncertainty.end()) continue;
    stated->second.scatter = scatter / std::sqrt(static_cast<double>(repeats.runs));
  }
}

void show_repeats(const Repeats& repeats, evidence::Exhibit& exhibit) {
  exhibit.measure("repeats", static_cast<double>(repeats.runs));
  for (const auto& [quantity, scatter] : repeats.scatter) exhibit.measure("repeats_scatter_" + quantity, scatter);
}

}  // namespace seiche::validation
