/// How somebody else's result is judged by a case.
///
/// A case says which tables it takes: their columns with units, the points at which the reference is known, the
/// reference itself, and what is required of it. Template, reading, measures, figures and claims follow from that:
///
///     std::vector<WantedTable> wanted(const Values& values) {
///       const exact::Thacker bowl = bowl_of(values);
///       return {{.name = "shorelines",
///                .kind = WantedTable::Kind::series,
///                .abscissa = {"t", "s", "time"},
///                .quantities = {{.column = {"left", "m", "left shoreline"},
///                                .reference = [bowl](Place p) { return bowl.left_shoreline(p.abscissa); },
///                                .requirements = {...}}},
///                .points = [](double) { return times; }}};
///     }
///     c.submission = {.tables = wanted};
#pragma once

#include <cmath>
#include <concepts>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/parameter.hpp"

namespace seiche::validation {

/// A value, or what computes it when it is first asked for; copies share it. Not for several threads at a time.
template <class T>
class Lazy {
 public:
  Lazy(T known = {}) : kept_(std::make_shared<Kept>(Kept{std::move(known), {}})) {}
  template <class Element>
  Lazy(std::initializer_list<Element> known) : Lazy(T(known.begin(), known.end())) {}
  template <std::invocable Compute>
  Lazy(Compute compute) : kept_(std::make_shared<Kept>(Kept{{}, std::move(compute)})) {}

  const T& operator*() const {
    if (!kept_->value) kept_->value.emplace(kept_->compute());
    return *kept_->value;
  }
  const T* operator->() const { return &**this; }

 private:
  struct Kept {
    std::optional<T> value;
    std::function<T()> compute;
  };
  std::shared_ptr<Kept> kept_;
};

/// What is measured of a submitted quantity s beside its reference r; formulas: validation/instruments/agreement.hpp.
enum class Measure {
  value,            ///< the submitted number itself; scalars only
  relative_error,   ///< (s - r)/|r|; scalars only
  largest_error,    ///< max |s - r|
  relative_l1,      ///< sum |s - r| / sum |r|
  relative_l2,      ///< sqrt(sum (s - r)^2 / sum r^2)
  relative_linf,    ///< max |s - r| / max |r|
  amplitude_ratio,  ///< range of s over range of r
  shift,            ///< how far s lies behind r along the abscissa, in its unit
  arrival_error,    ///< first arrival of s less that of r; series only
  peak_error,       ///< max s - max r
  peak_shift,       ///< where s is largest less where r is
  skill,            ///< Willmott's index of agreement: 1 is perfect
};

struct Column {
  std::string name;
  std::string unit;
  std::string meaning;
};

/// Where a value belongs: the group (time of a profile, position of a gauge; 0 without groups) and the abscissa within
/// it (position in a profile, time in a series; 0 of a scalar).
struct Place {
  double group = 0;
  double abscissa = 0;
};

/// What is required of one measure of a quantity, in every group.
struct Requirement {
  Measure measure = Measure::value;
  evidence::Criterion criterion;
  std::string text;    ///< the sentence that the report prints
  std::string source;  ///< citation
};

/// A quantity that is asked for, with what it should be.
struct WantedQuantity {
  Column column;
  std::function<double(Place)> reference;  ///< NaN where nothing is known: such points are left out
  std::vector<Requirement> requirements = {};
};

/// A table that is asked for.
struct WantedTable {
  /// Values along x at given times, values along t at given gauges, or one row of single numbers.
  enum class Kind { profile, series, scalars };

  std::string name;
  Kind kind = Kind::scalars;
  std::optional<Column> group = {};     ///< the column that tells several profiles or gauges apart
  std::optional<Column> abscissa = {};  ///< not for scalars
  std::vector<WantedQuantity> quantities;
  Lazy<std::vector<double>> groups = {};  ///< those that are required, where there is a group column
  /// The reference points of a group, strictly increasing: where the measures are taken and a template asks for values.
  std::function<std::vector<double>(double group)> points = {};
  /// Smallest share of the reference points that must lie within the submitted ones. A result at the centres of N cells
  /// leaves half a cell out at either end: 1/N of the points.
  double least_coverage = 0.9;
  /// What of a group's points is judged, where that is not all: the coverage is counted there.
  std::function<std::pair<double, double>(double group)> judged = {};
  /// Where the numbered groups are, x and y [m]: a file may say that instead of the number.
  Lazy<std::map<double, std::pair<double, double>>> places = {};
  Lazy<std::vector<std::string>> exact = {};              ///< commands that print the reference; a template shows them
  evidence::Role reference_role = evidence::Role::exact;  ///< Role::data where it was measured
};

/// One group of a submitted table, by the wanted names.
struct SubmittedGroup {
  double value = 0;                   ///< of the group column
  std::vector<double> abscissa = {};  ///< strictly increasing; empty for scalars
  std::map<std::string, std::vector<double>> values = {};
  std::vector<std::pair<double, double>> gaps = {};  ///< of the abscissa, between whose ends no value was given
};

/// Submitted tables by name, in the wanted order of groups; those groups that were submitted.
using Submitted = std::map<std::string, std::vector<SubmittedGroup>>;

/// A standard uncertainty that the submitter states of a quantity, or of an abscissa.
struct StatedUncertainty {
  double value = 0;
  /// Of the largest absolute value of the reference (for an abscissa: of the range of the reference points), instead of
  /// in the wanted unit.
  bool relative = false;
  double scatter = 0;  ///< of the mean of several runs, beside the value; in the wanted unit whatever that is in

  /// In the wanted unit. @param size  what a relative one refers to
  [[nodiscard]] double of(double size) const { return std::hypot(relative ? value * size : value, scatter); }
};

/// What the submitter says of the solver.
struct SolverFacts {
  std::optional<double> cell;                            ///< size of its cells or spacing of its particles [m]
  std::optional<double> seconds;                         ///< processor time of the run
  std::map<std::string, StatedUncertainty> uncertainty;  ///< by the wanted name of a column
};

struct Submission {
  /// What is asked for with given parameters. A file may hold one of several tables.
  std::function<std::vector<WantedTable>(const Values&)> tables;
  /// Adds claims, measures and figures that the tables alone cannot state; optional.
  std::function<void(const Values&, const Submitted&, const SolverFacts&, evidence::Record&)> judge = {};

  explicit operator bool() const { return static_cast<bool>(tables); }
};

}  // namespace seiche::validation
