/// What a case can tell: which wrong results its claims notice, and from what size on.
///
/// The truth is the reference at the template's points, with a stated numerical uncertainty of 0. It is changed in one
/// way at a time, and judged as any submission is. With L the length of the record, R the range of the reference over
/// all groups of the table, and both signs tried:
///
///     amplitude  y (1 +- s)              shift   y(x +- s L), ends held      smoothing  mean of y over s L about x
///     datum      y +- s R                dilation  y(x_0 + (1 +- s)(x - x_0))  gravity  the case's own
///                                                                                    reference with g (1 +- s)
///
/// The smallest s that is noticed is found among 0.05 % doubled until it is, then by bisection to a sixteenth of an
/// octave; of both signs the larger counts, the other sign being looked for from the first one's s on. Without size:
/// reversed, exchanged (the values of two groups, or of two quantities), truncated (to the first 60 %), dead (one group
/// stands still), still (everything does). The truth itself, printed at half and at double density, and with NaN where
/// it is dry, has to pass.
///
/// A part of the truth by itself (every second point, the first 60 %, one group, one quantity) has a row where it is
/// rejected or makes a claim an error: it has to be judged by what is there.
///
/// Noticed is what makes a claim anything but met, and what is rejected.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "validation/case/case.hpp"

namespace seiche::validation {

struct Resolved {
  std::string table;     ///< empty: the whole case
  std::string quantity;  ///< empty: all of the table
  std::string change;
  double smallest = std::numeric_limits<double>::quiet_NaN();  ///< s; NaN without size, or where none is noticed
  double amount = std::numeric_limits<double>::quiet_NaN();    ///< the same in `unit`
  std::string unit = {};
  std::string by = {};  ///< the claim that notices, "rejected", or "same" where nothing changes; empty: not noticed

  /// The truth in one of its forms, which has to pass.
  [[nodiscard]] bool right_result() const { return table.empty() && unit.empty(); }
};

/// @throws std::invalid_argument for parameters with which the case scores nobody
std::vector<Resolved> resolving_power(const Case& one, const Values& values);

/// What is detected of a quantity, in one line: "h detects 5 % of amplitude, 0.02 m of datum; does not detect
/// smoothing".
std::string told_by(const std::vector<Resolved>& rows, const std::string& table, const std::string& quantity);

/// The rows of every case in the table that comes with the program, reports/record/resolving_power.csv.
std::map<std::string, std::vector<Resolved>> recorded_power();

}  // namespace seiche::validation
