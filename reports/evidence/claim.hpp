#pragma once

#include <limits>
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

/// One measured number.
struct Measurement {
  double value = std::numeric_limits<double>::quiet_NaN();
  double uncertainty = 0;  ///< half-width of its numerical uncertainty, same unit; 0 where none was estimated
  std::string resolution;  ///< "N = 200, tau = 0.05 s"
};

/// A convergence order with its 95 % confidence interval, from a least-squares line through log(error), log(size).
struct ObservedOrder {
  double order = std::numeric_limits<double>::quiet_NaN();
  double half_width = std::numeric_limits<double>::infinity();
  std::vector<double> sizes;  ///< the points that were used
  std::vector<double> errors;
  std::string note;  ///< names the points left out and why
};

/// Fits the order of convergence.
///
/// @param sizes   mesh widths or time steps, positive, at least one
/// @param errors  error norms, same length
/// @param floor   errors at or below it are round-off, not truncation: they are left out and named
/// @returns order NaN with infinite half-width when fewer than four points remain
ObservedOrder observed_order(const std::vector<double>& sizes, const std::vector<double>& errors, double floor = 0);

}  // namespace seiche::evidence
