#include "validation/scoring/score.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <ranges>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/evidence/record.hpp"
#include "seiche/samples.hpp"
#include "validation/case/refusal.hpp"
#include "validation/case/submission.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/instruments/each.hpp"
#include "validation/scoring/submitted.hpp"
#include "validation/scoring/units.hpp"

namespace seiche::validation {
namespace {

constexpr std::ptrdiff_t most_panels = 6;

void draw(evidence::Panel& panel, const WantedTable& wanted, const WantedQuantity& quantity,
          const SubmittedGroup& group) {
  std::vector<double> x = wanted.points(group.value);
  const bool exact = wanted.reference_role == evidence::Role::exact;
  if (exact) {  // known between the points as well
    const double from = x.front();
    const double to = x.back();
    constexpr int samples = 600;
    for (int k = 0; k <= samples; ++k) x.push_back(std::lerp(from, to, static_cast<double>(k) / samples));
    std::ranges::sort(x);
  }
  std::vector<double> known, y;
  for (const double at : x) {
    const double value = quantity.reference({group.value, at});
    if (std::isnan(value)) continue;
    known.push_back(at);
    y.push_back(value);
  }
  if (exact) {
    panel.line("reference", known, y, wanted.reference_role);
  } else {
    panel.points("reference", known, y, wanted.reference_role);
  }
  panel.points("submitted", group.abscissa, group.values.at(quantity.column.name), evidence::Role::computed);
}

/// Draws a submitted profile or series with its reference: a figure with a panel per quantity, or, where there are
/// several groups, a figure per quantity with a panel for each of the first six groups.
void draw_submitted(const WantedTable& wanted, const std::vector<SubmittedGroup>& groups, evidence::Exhibit& exhibit) {
  evidence::Figure* figure = nullptr;
  for (const WantedQuantity& q : wanted.quantities) {
    const Column& column = q.column;
    if (figure == nullptr || wanted.group) {
      figure = &exhibit.figure(
          wanted.group ? wanted.name + "-" + column.name : wanted.name,
          fmt::format("The submitted {}{}", wanted.name, wanted.group ? ": " + column.meaning : std::string()),
          "The points that were submitted, with the reference.");
    }
    for (const SubmittedGroup& group : groups | std::views::take(most_panels)) {
      auto& panel = figure->panel({.x = fmt::format("{} [{}]", wanted.abscissa->name, wanted.abscissa->unit),
                                   .y = fmt::format("{} {} [{}]", column.meaning, column.name, column.unit),
                                   .title = wanted.group ? group_in_words(wanted, group.value) : std::string()});
      draw(panel, wanted, q, group);
    }
  }
}

struct MeasureText {
  Measure measure;
  const char* id;
  const char* name;
  const char* unit;  ///< empty: the quantity's; "x": the abscissa's
};

constexpr std::array<MeasureText, 12> measure_texts{{
    {Measure::value, "value", "value", ""},
    {Measure::relative_error, "relative_error", "relative error", "1"},
    {Measure::largest_error, "largest_error", "largest error", ""},
    {Measure::relative_l1, "relative_l1", "relative L1 error", "1"},
    {Measure::relative_l2, "relative_l2", "relative L2 error", "1"},
    {Measure::relative_linf, "relative_linf", "relative Linf error", "1"},
    {Measure::amplitude_ratio, "amplitude_ratio", "amplitude ratio", "1"},
    {Measure::shift, "shift", "shift", "x"},
    {Measure::arrival_error, "arrival_error", "error of arrival", "x"},
    {Measure::peak_error, "peak_error", "error of the peak", ""},
    {Measure::peak_shift, "peak_shift", "shift of the peak", "x"},
    {Measure::skill, "skill", "Willmott's index of agreement", "1"},
}};

const MeasureText& wording_of(Measure measure) {
  return measure_texts.at(static_cast<std::size_t>(measure));
}

/// A measure and its standard uncertainty.
struct Measured {
  double value = nan;
  std::optional<double> uncertainty = {};  ///< none where the submitter stated none
};
using Measures = std::map<Measure, Measured>;

std::optional<double> times(double factor, std::optional<double> uncertainty) {
  return uncertainty ? std::optional(factor * *uncertainty) : std::nullopt;
}

evidence::Claim claim_of(const WantedTable& table, const WantedQuantity& quantity, const Requirement& requirement) {
  const MeasureText& text = wording_of(requirement.measure);
  return {quantity.column.name + "-" + text.id, requirement.text,
          fmt::format("{} of {}", text.name, quantity.column.name),
          *text.unit == '\0'  ? quantity.column.unit
          : *text.unit == 'x' ? table.abscissa->unit
                              : text.unit,
          requirement.source};
}

/// Judges one quantity in one group.
class QuantityScore {
 public:
  QuantityScore(const WantedTable& table, const WantedQuantity& quantity, const SubmittedGroup& group,
                const std::map<std::string, StatedUncertainty>& uncertainty)
      : table_(table), quantity_(quantity), group_(group), uncertainty_(uncertainty) {
    is_scalar() ? measure_scalar() : measure_curve();
  }

  void measure(evidence::Exhibit& exhibit) const {
    for (const auto& [measure, measured] : measures_) {
      exhibit.measure(quantity_.column.name + "_" + wording_of(measure).id + suffix(), measured.value);
    }
    exhibit.measure(quantity_.column.name + (is_scalar() ? "_reference" : "_coverage") + suffix(),
                    is_scalar() ? reference() : coverage_);
  }

  void claim(evidence::Record& record) const {
    if (!is_scalar()) {
      record.check({table_.name + "-coverage",
                    fmt::format("The submitted points cover {:.3g} % of the reference points of the {} or more.",
                                100 * table_.least_coverage, table_.name),
                    "share of the reference points within the submitted ones", "1", "required by the case"},
                   {.value = coverage_, .resolution = resolution() + uncovered_},
                   evidence::Bound{.limit = 1 - table_.least_coverage,
                                   .reason = "N cell centres leave half a cell out at either end, 1/N of the points",
                                   .expected = 1});
    }
    for (const Requirement& requirement : quantity_.requirements) claim(requirement, record);
  }

  [[nodiscard]] std::vector<std::variant<double, std::string>> row() const {
    const std::string& name = quantity_.column.name;
    if (is_scalar()) return {name, group_.value, value(Measure::value), reference(), value(Measure::relative_error)};
    const auto points = static_cast<double>(group_.abscissa.size());
    std::vector<std::variant<double, std::string>> entries{name, group_.value, points, coverage_};
    for (const Measure m : {Measure::relative_l1, Measure::relative_l2, Measure::relative_linf, Measure::skill,
                            Measure::amplitude_ratio, Measure::shift, Measure::peak_error}) {
      entries.emplace_back(value(m));
    }
    return entries;
  }

 private:
  [[nodiscard]] bool is_scalar() const { return table_.kind == WantedTable::Kind::scalars; }
  [[nodiscard]] double value(Measure measure) const { return measures_.at(measure).value; }
  /// Of a scalar.
  [[nodiscard]] double reference() const { return quantity_.reference({group_.value, 0}); }

  [[nodiscard]] std::string suffix() const {
    return table_.group && table_.groups->size() > 1 ? fmt::format("_{}_{:g}", table_.group->name, group_.value) : "";
  }

  /// Standard uncertainty stated of a column, with what a relative one refers to.
  [[nodiscard]] std::optional<double> stated(const std::string& column, double scale) const {
    const auto found = uncertainty_.find(column);
    if (found == uncertainty_.end()) return std::nullopt;
    return found->second.of(scale);
  }

  [[nodiscard]] std::string resolution() const {
    const std::size_t points = std::max<std::size_t>(group_.abscissa.size(), 1);
    return fmt::format("{} point{}{}", points, points > 1 ? "s" : "",
                       table_.group ? ", " + group_in_words(table_, group_.value) : std::string());
  }

  void measure_scalar() {
    const double submitted = group_.values.at(quantity_.column.name).front();
    const double size = std::abs(reference());
    const std::optional<double> u = stated(quantity_.column.name, size);
    measures_[Measure::value] = {submitted, u};
    Measured& relative = measures_[Measure::relative_error];
    if (size != 0) relative = {(submitted - reference()) / size, times(1 / size, u)};
  }

  void measure_curve() {
    const std::vector<double> x = table_.points(group_.value);
    const std::vector<double> y = reference_at(quantity_, group_, x);
    measure_coverage(x);
    const Curve submitted{group_.abscissa, group_.values.at(quantity_.column.name)};
    try {
      agreement_ = agreement(submitted, {x, y});
    } catch (const std::invalid_argument& uncovered) {
      fail("column {}: {}", table_.abscissa->name, uncovered.what());
    }
    const Agreement& a = agreement_;
    const auto sizes = over<Mean>(a.reference, [](double r) { return std::abs(r); });
    const double linf = worst(a.reference);
    const auto [lowest, highest] = std::ranges::minmax_element(a.reference);
    const std::optional<double> u = stated(quantity_.column.name, linf);
    const std::optional<double> u_x = stated(table_.abscissa->name, x.back() - x.front());
    const auto over_size = [&](double size) { return u == 0.0 ? u : times(1 / size, u); };
    measures_ = {
        {Measure::largest_error, {a.largest_error, u}},
        {Measure::relative_l1, {a.relative_l1, over_size(sizes.value())}},
        {Measure::relative_l2, {a.relative_l2, over_size(sizes.rms())}},
        {Measure::relative_linf, {a.relative_linf, over_size(linf)}},
        {Measure::amplitude_ratio, {a.amplitude_ratio, times(std::numbers::sqrt2, over_size(*highest - *lowest))}},
        {Measure::shift, {a.shift, u_x}},
        {Measure::peak_error, {a.peak - a.reference_peak, u}},
        {Measure::peak_shift, {a.peak_at - a.reference_peak_at, u_x}},
        {Measure::skill, {a.skill, 0}}};
    // A series that begins in the upper half of its range has nothing that arrives.
    if (table_.kind == WantedTable::Kind::series && a.reference.front() < 0.5 * (*lowest + *highest)) {
      constexpr double arrived = 0.1;  // of the reference's rise
      const double level = a.reference.front() + arrived * (*highest - a.reference.front());
      const double arrival = first_crossing(submitted, level);
      measures_[Measure::arrival_error] = {arrival - first_crossing({a.x, a.reference}, level), u_x};
    }
  }

  /// The share of what is judged that was submitted.
  void measure_coverage(const std::vector<double>& x) {
    constexpr double all = std::numeric_limits<double>::infinity();
    const auto [from, to] = table_.judged ? table_.judged(group_.value) : std::pair(-all, all);
    const double rounding = 1e-6 * (x.back() - x.front());  // of a file with fewer digits than the template
    double known = 0;
    double covered = 0;
    for (const double at : x) {
      if (std::isnan(quantity_.reference({group_.value, at})) || at < from || at > to) continue;
      ++known;
      if (in_gap(group_, at)) continue;
      if (at >= group_.abscissa.front() - rounding && at <= group_.abscissa.back() + rounding) ++covered;
    }
    coverage_ = covered / known;
    if (covered < known) uncovered_ = fmt::format(", {:g} of {:g} reference points", covered, known);
  }

  /// Of a number that was not computed before it was asked for.
  [[nodiscard]] std::optional<double> told_expected(const Requirement& requirement) const {
    const auto* bound = std::get_if<evidence::Bound>(&requirement.criterion);
    if (bound == nullptr || bound->expected.stated()) return std::nullopt;
    return reference();
  }

  void claim(const Requirement& requirement, evidence::Record& record) const {
    const MeasureText& text = wording_of(requirement.measure);
    const auto found = measures_.find(requirement.measure);
    if (found == measures_.end()) {
      throw std::logic_error(fmt::format("{}: {} cannot be measured here", quantity_.column.name, text.name));
    }
    const Measured& measured = found->second;
    // Standard to expanded, as the criterion takes it.
    const auto* budget = std::get_if<evidence::Uncertainty>(&requirement.criterion);
    const double coverage = budget != nullptr ? budget->coverage : 2;
    const evidence::Claim claimed = claim_of(table_, quantity_, requirement);
    const std::string stated_text =
        measured.uncertainty ? fmt::format("u_num = {:.3g}{}", *measured.uncertainty, after_number(claimed.unit))
                             : "u_num not stated";
    record.check(claimed,
                 {.value = measured.value,
                  .uncertainty = times(coverage, measured.uncertainty),
                  .resolution = resolution() + ", " + stated_text,
                  .told = {.expected = told_expected(requirement)}},
                 requirement.criterion);
  }

  const WantedTable& table_;
  const WantedQuantity& quantity_;
  const SubmittedGroup& group_;
  const std::map<std::string, StatedUncertainty>& uncertainty_;
  Agreement agreement_;
  double coverage_ = 0;
  std::string uncovered_;
  Measures measures_;
};

evidence::Table blank_table(const WantedTable& wanted) {
  const bool scalars = wanted.kind == WantedTable::Kind::scalars;
  const Column group = wanted.group.value_or(Column{"group", "1", ""});
  evidence::Table table{
      .id = wanted.name + "-measures",
      .title = fmt::format("Measures of the submitted {}", wanted.name),
      .caption = scalars ? "Submitted, reference, and their relative difference, in the units asked for."
                         : "Submitted values, interpolated linearly to the reference points, without extrapolation. "
                           "Shift and peak in the units of the template.",
      .columns = {{"quantity", "1"}, {group.name, group.unit}},
      .rows = {},
      .atlas = {}};
  const auto names = scalars
                         ? std::vector{"submitted", "reference", "relative error"}
                         : std::vector{"points", "coverage",        "relative L1", "relative L2",      "relative Linf",
                                       "skill",  "amplitude ratio", "shift",       "error of the peak"};
  for (const char* name : names) table.columns.emplace_back(name, "1");
  return table;
}

/// What nobody submitted is not met, and nothing is said of the rest of it.
void claim_absent(const WantedTable& table, evidence::Record& record) {
  std::vector<std::string> columns;
  for (const WantedQuantity& quantity : table.quantities) columns.push_back(quantity.column.name);
  record.check({table.name + "-coverage",
                fmt::format("The submission contains the table {}, {:.3g} % of its reference points or more.",
                            table.name, 100 * table.least_coverage),
                "share of the reference points within the submitted ones", "1", "required by the case"},
               {.value = 0, .resolution = fmt::format("no file has a column {}", fmt::join(columns, " or "))},
               evidence::Bound{.limit = 1 - table.least_coverage,
                               .reason = "a part of the result is scored alone only with --table",
                               .expected = 1});
  leave_out(table, "the table was not submitted", record);
}

/// What was not submitted of a table is named, and the score is not that of the whole case.
/// @param id  of the claim, after the table's name. @param all, missing  "values of t", "t = 1, 2"
void claim_given(const WantedTable& table, const std::string& id, const std::string& all, std::size_t asked,
                 std::size_t absent, const std::string& missing, evidence::Record& record) {
  record.check({table.name + id, fmt::format("All {} {} in the table {} are submitted.", asked, all, table.name),
                "share that was submitted", "1", "required by the case"},
               {.value = static_cast<double>(asked - absent) / static_cast<double>(asked),
                .resolution = fmt::format("{} of {} given, without {}", asked - absent, asked, missing)},
               evidence::Bound{.limit = 0, .reason = "a part does not stand for the whole", .expected = 1});
}

void claim_groups(const WantedTable& table, const std::vector<SubmittedGroup>& given, evidence::Record& record) {
  if (!table.group || given.size() == table.groups->size()) return;
  std::vector<double> missing;
  for (const double group : *table.groups) {
    if (std::ranges::find(given, group, &SubmittedGroup::value) == given.end()) missing.push_back(group);
  }
  const std::string& name = table.group->name;
  claim_given(table, "-given", "values of " + name, table.groups->size(), missing.size(),
              fmt::format("{} = {}", name, fmt::join(missing, ", ")), record);
}

/// The table's quantities that were submitted.
WantedTable claim_quantities(const WantedTable& table, const Submitted& submitted, evidence::Record& record) {
  const WantedTable given = given_of({table}, submitted).front();
  const auto name_of = [](const WantedQuantity& q) { return q.column.name; };
  WantedTable absent = table;
  std::erase_if(absent.quantities, [&](const WantedQuantity& q) {
    return std::ranges::find(given.quantities, q.column.name, name_of) != given.quantities.end();
  });
  if (absent.quantities.empty()) return given;
  claim_given(table, "-quantities-given", "quantities", table.quantities.size(), absent.quantities.size(),
              fmt::format("{}", fmt::join(absent.quantities | std::views::transform(name_of), ", ")), record);
  leave_out(absent, "the quantity was not submitted", record);
  return given;
}

}  // namespace

void leave_out(const WantedTable& table, const std::string& reason, evidence::Record& record) {
  for (const WantedQuantity& quantity : table.quantities) {
    for (const Requirement& requirement : quantity.requirements) {
      record.leave_out({claim_of(table, quantity, requirement), reason});
    }
  }
}

StatedUncertainty uncertainty_from(const std::string& quantity, const std::string& text) {
  StatedUncertainty stated;
  stated.relative = text.ends_with('%');
  const char* end = text.data() + text.size() - (stated.relative ? 1 : 0);
  const auto [stopped, failure] = std::from_chars(text.data(), end, stated.value);
  if (failure != std::errc() || stopped != end || !std::isfinite(stated.value) || stated.value < 0) {
    fail("uncertainty {} = {}: must be a number at least 0, or a percentage", quantity, text);
  }
  if (stated.relative) stated.value /= 100;
  return stated;
}

void score(const std::vector<WantedTable>& wanted, const Submitted& submitted,
           const std::map<std::string, StatedUncertainty>& uncertainty, evidence::Record& record) {
  for (const WantedTable& table : wanted) {
    const auto found = submitted.find(table.name);
    if (found == submitted.end()) {
      claim_absent(table, record);
      continue;
    }
    claim_groups(table, found->second, record);
    const WantedTable given = claim_quantities(table, submitted, record);
    evidence::Table summary = blank_table(given);
    for (const WantedQuantity& quantity : given.quantities) {
      for (const SubmittedGroup& group : found->second) {
        const QuantityScore one(given, quantity, group, uncertainty);
        one.measure(record);
        one.claim(record);
        summary.rows.push_back(one.row());
      }
    }
    record.table(std::move(summary));
    if (table.kind != WantedTable::Kind::scalars) draw_submitted(given, found->second, record);
  }
}

void measure_own(const std::vector<WantedTable>& wanted, const Submitted& own, evidence::Exhibit& exhibit) {
  for (const WantedTable& table : wanted) {
    const std::vector<SubmittedGroup>& groups = groups_in(own, table);
    if (groups.empty()) continue;
    for (const WantedQuantity& quantity : table.quantities) {
      for (const SubmittedGroup& group : groups) QuantityScore(table, quantity, group, {}).measure(exhibit);
    }
    const std::vector<double>& x = groups.front().abscissa;
    if (table.kind == WantedTable::Kind::profile && x.size() > 1) {
      exhibit.measure("cell_size", (x.back() - x.front()) / static_cast<double>(x.size() - 1));
    }
  }
}

}  // namespace seiche::validation
