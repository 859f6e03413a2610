#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace seiche::evidence {

/// What is asserted: one sentence a reader can check, and what is measured to check it.
struct Claim {
  std::string id;        ///< short, unique within a record: letters, digits, '-', '_'
  std::string text;      ///< the sentence that the report prints
  std::string quantity;  ///< what is measured, in the field's words
  std::string unit = "1";
  std::string source;  ///< where the claim comes from: citation, section, formula
};

/// What only a run can tell of the criterion that was declared: see Amount in reports/evidence/criterion.hpp.
struct Told {
  std::optional<double> expected;
  std::optional<double> limit;
  std::optional<double> operations;
  std::optional<double> scale;
  std::optional<double> data;
  std::optional<double> input;
};

/// One measured number.
struct Measurement {
  double value = std::numeric_limits<double>::quiet_NaN();
  /// Half-width (95 %) of its numerical uncertainty, same unit; 0: exact to round-off; none: not estimated.
  std::optional<double> uncertainty = {};
  std::string resolution = {};  ///< "N = 200, tau = 0.05 s"
  std::string where = {};       ///< place and time of an extreme, "t = 0.35 s"
  Told told = {};

  /// The uncertainty as a number to reckon with: NaN where it was not estimated.
  [[nodiscard]] double half_width() const { return uncertainty.value_or(std::numeric_limits<double>::quiet_NaN()); }
};

/// A convergence order with its 95 % interval, of a line through log(error), log(size) and of the next order beside it.
struct ObservedOrder {
  double order = std::numeric_limits<double>::quiet_NaN();
  double half_width = std::numeric_limits<double>::infinity();
  std::vector<double> sizes;  ///< the points that were used
  std::vector<double> errors;
  std::string note;  ///< names the points left out and why
};

/// Fits the order p; half_width: Student's, and what the next order, error = a h^p (1 + c h), changes of p.
///
/// @param sizes   mesh widths or time steps, positive, at least one
/// @param errors  error norms, same length
/// @param floor   errors at or below it are round-off, not truncation: they are left out and named
/// @returns order NaN with infinite half-width when fewer than four points remain
ObservedOrder observed_order(const std::vector<double>& sizes, const std::vector<double>& errors, double floor = 0);

}  // namespace seiche::evidence
