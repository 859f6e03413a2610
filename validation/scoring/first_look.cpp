#include "validation/scoring/first_look.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/samples.hpp"
#include "validation/case/claims.hpp"
#include "validation/scoring/submitted.hpp"
#include "validation/scoring/units.hpp"

namespace seiche::validation {
namespace {

using evidence::JudgedClaim;
using evidence::Verdict;

/// How far a claim is from what is expected, in limits.
double used(const JudgedClaim& claim) {
  const evidence::Judgement& j = claim.judgement;
  const double error = std::abs(j.measured - j.expected);
  return j.limit > 0 ? error / j.limit : error;
}

/// The claim that decides: an error, a failure, an undecided one, or the one that uses most of its limit; null without
/// any.
const JudgedClaim* deciding(const evidence::Record& record) {
  const auto found = std::ranges::max_element(
      record.claims(), {}, [](const JudgedClaim& one) { return std::pair(one.judgement.verdict, used(one)); });
  return found == record.claims().end() ? nullptr : &*found;
}

std::string verdict_line(const evidence::Record& record) {
  const std::vector<JudgedClaim>& claims = record.claims();
  const auto count = [&](Verdict verdict) {
    return std::ranges::count(claims, verdict, [](const JudgedClaim& claim) { return claim.judgement.verdict; });
  };
  std::vector<std::string> parts{fmt::format("{} of {} claims are met", count(Verdict::pass), claims.size())};
  for (const auto& [verdict, words] :
       {std::pair{Verdict::fail, "not met"}, std::pair{Verdict::inconclusive, "undecided"},
        std::pair{Verdict::error, "in error"}}) {
    if (count(verdict) > 0) parts.push_back(fmt::format("{} {}", count(verdict), words));
  }
  for (const JudgedClaim& claim : claims) {
    const bool part = claim.judgement.verdict == Verdict::fail && claim.judgement.measured > 0;
    if (claim.claim.id.ends_with("-given") || (part && claim.claim.id.ends_with("-coverage"))) {
      parts.push_back(claim.judgement.resolution);
    }
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string one_line(const JudgedClaim& claim) {
  const evidence::Judgement& j = claim.judgement;
  const std::string unit = after_number(claim.claim.unit);
  const double off = j.measured - j.expected;
  return fmt::format("{} {} ({}: {})", claim.claim.text, evidence::name(j.verdict), claim.claim.id,
                     std::isfinite(off) ? fmt::format("error {:.3g}{}, limit {:.3g}{}", off, unit, j.limit, unit)
                                        : "not found in the result");
}

/// The curve that misses its reference by most, over the reference.
struct WorstCurve {
  const WantedTable* table = nullptr;
  const WantedQuantity* quantity = nullptr;
  const SubmittedGroup* group = nullptr;
  double error = -1;
  ErrorKind kind;
};

WorstCurve worst_curve(const std::vector<WantedTable>& wanted, const Submitted& submitted) {
  WorstCurve worst;
  for (const WantedTable& table : wanted) {
    if (table.kind == WantedTable::Kind::scalars) continue;
    for (const WantedQuantity& quantity : table.quantities) {
      for (const SubmittedGroup& group : groups_in(submitted, table)) {
        const std::vector<double> x = table.points(group.value);
        const std::vector<double> r = reference_at(quantity, group, x);
        const Curve curve{group.abscissa, group.values.at(quantity.column.name)};
        const double error = agreement(curve, {x, r}).relative_l2;
        if (error > worst.error) worst = {&table, &quantity, &group, error, error_kind(curve, {x, r})};
      }
    }
  }
  return worst;
}

std::string where_line(const WorstCurve& worst) {
  const Column& axis = *worst.table->abscissa;
  const Column& column = worst.quantity->column;
  return fmt::format(
      "{}{}: largest at {} = {:.4g}{}, {:+.3g}{}; {:.0f} % of the squared error within a tenth of the range there",
      column.name, worst.table->group ? ", " + group_in_words(*worst.table, worst.group->value) : std::string(),
      axis.name, worst.kind.where, after_number(axis.unit), worst.kind.largest, after_number(column.unit),
      100 * worst.kind.near);
}

/// A ladder's quantity whose error is more than its numerical error.
const LadderQuantity* not_numerical(const std::optional<Ladder>& ladder) {
  if (!ladder) return nullptr;
  const auto found =
      std::ranges::find_if(ladder->quantities, [](const auto& q) { return q.error.back() > q.numerical; });
  return found == ladder->quantities.end() ? nullptr : &*found;
}

bool is_comparison(const JudgedClaim& claim) {
  return std::holds_alternative<evidence::Uncertainty>(claim.criterion);
}

/// Nothing is left to look at: all that the case asks was judged, and no change of the file would explain its errors.
bool all_right(const evidence::Record& record, const std::vector<Finding>& findings,
               const std::optional<Ladder>& ladder) {
  return record.as_declared() && record.left_out().empty() && findings.empty() && not_numerical(ladder) == nullptr;
}

std::string whose_line(const JudgedClaim& claim, bool all, bool exact, const std::optional<Ladder>& ladder) {
  const evidence::Judgement& j = claim.judgement;
  if (j.verdict == Verdict::error)
    return fmt::format("your result: the measured quantity is missing ({})", j.resolution);
  if (is_comparison(claim)) {
    if (j.verdict == Verdict::fail && !j.uncertainty) return "your solver's: " + j.note;
    if (j.verdict == Verdict::fail) {
      return fmt::format(
          "your solver's: an error of {:.3g}, which the uncertainties of the data and of your result ({:.3g} "
          "together) do not explain",
          j.measured - j.expected, j.limit);
    }
    if (j.verdict == Verdict::inconclusive) return "undecided: " + j.note;
    return fmt::format("none: within the uncertainties of the data and of your result, {:.3g} together", j.limit);
  }
  if (j.verdict == Verdict::pass)
    return all ? "none, all errors are within their limits" : "none within the limits of the scored claims";
  if (j.verdict == Verdict::inconclusive) return "undecided: " + j.note;
  if (!exact) return "your solver's or the data's: this limit does not include an uncertainty of the data";
  if (!ladder) return "your solver's or its set-up's, as the reference is exact: three cell sizes (--sizes) show which";
  if (const LadderQuantity* q = not_numerical(ladder)) {
    return fmt::format("your model's or set-up's: the error of {} is more than its numerical error", q->name);
  }
  return "your resolution's: the error is within the numerical error that your sizes show";
}

/// Records with fewer points than the measured ones: what lies between points cannot be scored.
std::string coarse_line(const std::vector<WantedTable>& wanted, const Submitted& submitted) {
  constexpr double enough = 0.75;  // between all measured points and every other one
  for (const WantedTable& table : wanted) {
    if (!table.abscissa || table.reference_role != evidence::Role::data) continue;
    for (const SubmittedGroup& group : groups_in(submitted, table)) {
      const std::vector<double> x = table.points(group.value);
      const auto within = [&](double at) { return at >= x.front() && at <= x.back(); };
      const long given = std::ranges::count_if(group.abscissa, within);
      if (static_cast<double>(given) >= enough * static_cast<double>(x.size())) continue;
      return fmt::format("submit {} at the points of the template: a record has {} points where {} were measured",
                         table.name, given, x.size());
    }
  }
  return "";
}

std::string next_line(const evidence::Record& record, const JudgedClaim& claim, const std::vector<Finding>& findings,
                      const std::optional<Ladder>& ladder, bool all, bool exact, const std::string& coarse) {
  const evidence::Judgement& j = claim.judgement;
  if (j.verdict == Verdict::pass && all) {
    return ladder ? "none, all claims are met"
                  : "run three or more cell sizes (--sizes) to obtain the order of accuracy and the cost of 1 % error";
  }
  for (const JudgedClaim& one : record.claims()) {
    const bool of_part = one.claim.id.ends_with("-coverage") || one.claim.id.ends_with("-given");
    if (of_part && one.judgement.verdict == Verdict::fail)
      return fmt::format("submit the rest: {} ({})", one.claim.id, one.judgement.resolution);
  }
  if (!findings.empty()) return fmt::format("check the file: {} {}", findings.front().where, findings.front().words);
  if (j.verdict != Verdict::pass && !coarse.empty()) return coarse;
  if (is_comparison(claim) && !j.uncertainty && j.verdict == Verdict::inconclusive) {
    return fmt::format(
        "state an uncertainty small enough to decide (--uncertainty, or --sizes with three or more cell sizes), for "
        "records that reach all readings: {}",
        j.resolution);
  }
  if (!ladder) return "run three or more cell sizes and pass them with --sizes";
  if (exact && not_numerical(ladder) != nullptr) {
    return "refinement will not remove this error; check initial and boundary conditions, gravity, friction and "
           "viscosity";
  }
  for (const LadderQuantity& q : ladder->quantities) {
    if (const auto reached = ladder->reach(q, ladder_target); reached && reached->size < ladder->size.back()) {
      return fmt::format("run dx = {:.2g}: 1 % of {}", reached->size, q.name);
    }
  }
  return "inspect the figure of the quantity above";
}

}  // namespace

std::string ErrorKind::words() const {
  const auto [share, name] =
      std::max({std::pair{level, "level"}, std::pair{amplitude, "amplitude"}, std::pair{phase, "phase"}});
  if (share > 0.5) return fmt::format("{}: {:.0f} % of the squared error", name, 100 * share);
  return "local shape; no level, amplitude or phase error explains more than half of it";
}

ErrorKind error_kind(Curve submitted, Curve reference) {
  const Agreement a = agreement(submitted, reference);
  const std::size_t n = a.x.size();
  double mean = 0;
  for (const double r : a.reference) mean += r / static_cast<double>(n);
  double ee = 0, e1 = 0, eq = 0, qq = 0, es = 0, ss = 0;
  Worst largest;
  for (std::size_t i = 0; i < n; ++i) {
    const double e = a.submitted[i] - a.reference[i];
    const double q = a.reference[i] - mean;
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, n - 1);
    const double slope = after > before ? (a.reference[after] - a.reference[before]) / (a.x[after] - a.x[before]) : 0.0;
    ee += e * e;
    e1 += e;
    eq += e * q;
    qq += q * q;
    es += e * slope;
    ss += slope * slope;
    largest.add(e, static_cast<double>(i));
  }
  ErrorKind kind;
  if (!(ee > 0)) return kind;
  kind.level = e1 * e1 / static_cast<double>(n) / ee;
  kind.amplitude = qq > 0 ? eq * eq / qq / ee : 0;
  kind.phase = ss > 0 ? es * es / ss / ee : 0;
  const auto at = static_cast<std::size_t>(largest.where());
  kind.where = a.x[at];
  kind.largest = a.submitted[at] - a.reference[at];
  const double reach = 0.05 * (a.x.back() - a.x.front());
  for (std::size_t i = 0; i < n; ++i) {
    if (std::abs(a.x[i] - kind.where) <= reach) kind.near += std::pow(a.submitted[i] - a.reference[i], 2) / ee;
  }
  return kind;
}

FirstLook first_look(const std::vector<WantedTable>& wanted, const Submitted& submitted, const evidence::Record& record,
                     const std::vector<Finding>& findings, const std::optional<Ladder>& ladder) {
  FirstLook look{{"result", verdict_line(record)}};
  const JudgedClaim* claim = deciding(record);
  if (claim != nullptr) look.emplace_back("closest limit", one_line(*claim));
  if (ladder) {
    for (const LadderQuantity& q : ladder->quantities) look.emplace_back("resolution", ladder->line(q));
  }
  const WorstCurve worst = worst_curve(wanted, submitted);
  if (!findings.empty()) {
    look.emplace_back("start with", fmt::format("{}: your result {}", findings.front().where, findings.front().words));
  } else if (worst.table != nullptr) {
    look.emplace_back("start with",
                      fmt::format("figure {}{}", worst.table->name,
                                  worst.table->group ? "-" + worst.quantity->column.name : std::string()));
  }
  constexpr double rounding = 1e-12;
  if (worst.table != nullptr && worst.error > rounding) {
    look.emplace_back("largest error", where_line(worst));
    look.emplace_back("type of error", worst.kind.words());
  }
  if (claim != nullptr) {
    const bool exact = std::ranges::all_of(
        wanted, [](const WantedTable& table) { return table.reference_role == evidence::Role::exact; });
    const bool all = all_right(record, findings, ladder);
    look.emplace_back("likely cause", whose_line(*claim, all, exact, ladder));
    look.emplace_back("next step",
                      next_line(record, *claim, findings, ladder, all, exact, coarse_line(wanted, submitted)));
  }
  return look;
}

void show_first_look(const FirstLook& look, evidence::Exhibit& exhibit) {
  evidence::Table& table = add_table(exhibit, "first-look", "Summary",
                                     "Result, largest error, likely cause and next step.", {"question", "answer"});
  for (const auto& [question, answer] : look) table.rows.push_back({question, answer});
}

}  // namespace seiche::validation
