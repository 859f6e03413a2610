#include "validation/scoring/repeats.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/instruments/agreement.hpp"

namespace seiche::validation {
namespace {

/// The points of the first run that lie within those of all others; one nameless point for scalars.
std::vector<double> common_points(const std::vector<const SubmittedGroup*>& groups, const std::string& table) {
  const std::vector<double>& first = groups.front()->abscissa;
  if (first.empty()) return {};
  Largest least;
  Smallest most;
  for (const SubmittedGroup* group : groups) {
    least.add(group->abscissa.front());
    most.add(group->abscissa.back());
  }
  std::vector<double> points;
  std::copy_if(first.begin(), first.end(), std::back_inserter(points),
               [&](double x) { return x >= least.value() && x <= most.value(); });
  if (points.size() < 2) {
    throw std::invalid_argument(
        fmt::format("--repeats: the runs have {} points of table {} in common, needed: 2", points.size(), table));
  }
  return points;
}

/// Sums over all points of a quantity.
struct Spread {
  double squares = 0;
  double points = 0;
};

SubmittedGroup mean_of(const std::vector<const SubmittedGroup*>& groups, const std::string& table,
                       std::map<std::string, Spread>& spreads) {
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
      double sum = 0;
      for (const SubmittedGroup* group : groups) sum += at(*group);
      const double middle = sum / runs;
      double squares = 0;
      for (const SubmittedGroup* group : groups) squares += std::pow(at(*group) - middle, 2);
      mean.values[quantity].push_back(middle);
      spreads[quantity].squares += squares / (runs - 1);
      spreads[quantity].points += 1;
    }
  }
  return mean;
}

[[noreturn]] void refuse_different(const std::string& table, const std::string& what) {
  throw std::invalid_argument(fmt::format("--repeats: the runs differ in the {} of table {}", what, table));
}

/// The same group of every run.
std::vector<const SubmittedGroup*> group_of(const std::vector<Submitted>& runs, const std::string& table,
                                            std::size_t number) {
  std::vector<const SubmittedGroup*> groups;
  for (const Submitted& run : runs) {
    const auto found = run.find(table);
    if (found == run.end() || found->second.size() != runs.front().at(table).size()) refuse_different(table, "groups");
    const SubmittedGroup& group = found->second[number];
    const SubmittedGroup& first = runs.front().at(table)[number];
    if (group.value != first.value) refuse_different(table, "groups");
    const bool same = std::equal(group.values.begin(), group.values.end(), first.values.begin(), first.values.end(),
                                 [](const auto& a, const auto& b) { return a.first == b.first; });
    if (!same) refuse_different(table, "quantities");
    groups.push_back(&group);
  }
  return groups;
}

}  // namespace

Repeats repeats_of(const std::vector<Submitted>& runs) {
  if (runs.size() < 2) throw std::invalid_argument(fmt::format("--repeats {}: must be at least 2", runs.size()));
  Repeats repeats{.runs = runs.size()};
  std::map<std::string, Spread> spreads;
  for (const Submitted& run : runs) {
    if (run.size() != runs.front().size()) throw std::invalid_argument("--repeats: the runs hold different tables");
  }
  for (const auto& [table, groups] : runs.front()) {
    for (std::size_t k = 0; k < groups.size(); ++k) {
      repeats.mean[table].push_back(mean_of(group_of(runs, table, k), table, spreads));
    }
  }
  for (const auto& [quantity, spread] : spreads) {
    repeats.scatter[quantity] = std::sqrt(spread.squares / spread.points);
  }
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
