#include "validation/scoring/diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/case/claims.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/scoring/misreading.hpp"
#include "validation/scoring/submitted.hpp"
#include "validation/scoring/units.hpp"

namespace seiche::validation {
namespace {

std::string where_of(const WantedTable& table, const WantedQuantity& quantity, const SubmittedGroup& group) {
  return quantity.column.name + (table.group ? ", " + group_in_words(table, group.value) : std::string());
}

struct Points {
  std::vector<double> x, y;
  [[nodiscard]] Curve curve() const { return {x, y}; }
};

Points reference_of(const WantedTable& table, const WantedQuantity& quantity, const SubmittedGroup& group) {
  const std::vector<double> x = table.points(group.value);
  return {x, reference_at(quantity, group, x)};
}

/// Of a misfit over the reference, below which there is none.
constexpr double rounding = 1e-9;

/// Root mean square of what is known.
double size_of(const Points& reference) {
  Mean squares;
  for (const double y : reference.y) {
    if (!std::isnan(y)) squares.add(y);
  }
  return squares.rms();
}

/// That the curve is the one of another group: leaves less than the third of the misfit that explains one.
std::optional<Finding> neighbour(const WantedTable& table, const WantedQuantity& quantity, const SubmittedGroup& group,
                                 Curve submitted, double before) {
  std::optional<Finding> found;
  for (const double other : *table.groups) {
    if (other == group.value) continue;
    const double left = misfit(submitted, reference_of(table, quantity, {.value = other}).curve()) / before;
    if (!(left < (found ? found->left : explained_below))) continue;
    found =
        Finding{where_of(table, quantity, group),
                fmt::format("is the reference of {}: another gauge or instant?", group_in_words(table, other)), left};
  }
  return found;
}

/// That the curve does not reach the reference's ends.
std::optional<Finding> short_of(const WantedTable& table, const WantedQuantity& quantity, const SubmittedGroup& group,
                                Curve reference) {
  const double margin = (1 - table.least_coverage) * (reference.x.back() - reference.x.front());
  const bool ends = group.abscissa.back() < reference.x.back() - margin;
  if (!ends && !(group.abscissa.front() > reference.x.front() + margin)) return std::nullopt;
  const Column& axis = *table.abscissa;
  return Finding{where_of(table, quantity, group),
                 fmt::format("{} at {} = {:.4g}{}, the reference at {:.4g}: a file cut short, or another window?",
                             ends ? "ends" : "begins", axis.name, ends ? group.abscissa.back() : group.abscissa.front(),
                             after_number(axis.unit), ends ? reference.x.back() : reference.x.front()),
                 1};
}

/// What is said of one curve, with what tells whether other groups say the same.
struct Said {
  Finding finding;
  std::optional<Misreading> misread;
};

std::vector<Said> said_of(const WantedTable& table, const WantedQuantity& quantity, const SubmittedGroup& group,
                          bool shift_fitted) {
  const Points reference = reference_of(table, quantity, group);
  const Curve submitted{group.abscissa, group.values.at(quantity.column.name)};
  std::vector<Said> all;
  if (const auto cut = short_of(table, quantity, group, reference.curve())) all.push_back({*cut, {}});
  const auto misread = misreading(submitted, reference.curve());
  const double before = misfit(submitted, reference.curve());
  const auto other = misread || before > rounding * size_of(reference)
                         ? neighbour(table, quantity, group, submitted, before)
                         : std::nullopt;
  if (other && (!misread || other->left < misread->left)) {
    all.push_back({*other, {}});
  } else if (misread && !(shift_fitted && misread->kind >= Misreading::Kind::level)) {
    all.push_back(
        {{where_of(table, quantity, group), misread->words(quantity.column.unit, table.abscissa->unit), misread->left},
         misread});
  }
  return all;
}

/// The same change, by the same number to a twentieth.
bool same(const Said& a, const Said& b) {
  return a.misread && b.misread && a.misread->kind == b.misread->kind &&
         std::abs(a.misread->amount - b.misread->amount) <= 0.05 * std::abs(a.misread->amount);
}

void add_curves(const WantedTable& table, const std::vector<SubmittedGroup>& groups, bool shift_fitted,
                std::vector<Finding>& findings) {
  for (const WantedQuantity& quantity : table.quantities) {
    std::vector<Said> all;
    for (const SubmittedGroup& group : groups) {
      for (const Said& one : said_of(table, quantity, group, shift_fitted)) all.push_back(one);
    }
    const bool everywhere = all.size() > 1 && all.size() == groups.size() &&
                            std::ranges::all_of(all, [&](const Said& one) { return same(all.front(), one); });
    if (everywhere) {
      all.front().finding.where = fmt::format("{}, every {}", quantity.column.name, table.group->name);
      all.resize(1);
    }
    for (const Said& one : all) findings.push_back(one.finding);
  }
}

void add_numbers(const WantedTable& table, const std::vector<SubmittedGroup>& groups, std::vector<Finding>& findings) {
  for (const WantedQuantity& quantity : table.quantities) {
    for (const SubmittedGroup& group : groups) {
      const double factor = group.values.at(quantity.column.name).front() / quantity.reference({group.value, 0});
      const std::string unit = unit_mistaken(factor, quantity.column.unit);
      if (unit.empty()) continue;
      findings.push_back(
          {where_of(table, quantity, group), fmt::format("is {:.4g} times the reference: {}?", factor, unit), 0});
    }
  }
}

}  // namespace

std::vector<Finding> diagnosis(const std::vector<WantedTable>& wanted, const Submitted& submitted, bool shift_fitted) {
  std::vector<Finding> findings;
  for (const WantedTable& table : wanted) {
    if (table.kind == WantedTable::Kind::scalars) {
      add_numbers(table, groups_in(submitted, table), findings);
    } else {
      add_curves(table, groups_in(submitted, table), shift_fitted, findings);
    }
  }
  return findings;
}

void show_diagnosis(const std::vector<Finding>& findings, evidence::Exhibit& exhibit) {
  if (findings.empty()) return;
  evidence::Table& table = add_table(exhibit, "diagnosis", "What the difference looks like",
                                     "A single change of the submitted values that would explain the difference from "
                                     "the reference. The submitted values are unchanged, and so are the verdicts.",
                                     {"where [1]", "submitted [1]", "left of the misfit [1]"});
  for (const Finding& one : findings) table.rows.push_back({one.where, one.words, one.left});
}

}  // namespace seiche::validation
