/// How somebody else's front of a collapsing column is asked for and judged.
///
/// Nobody knows when the columns of the laboratories began to move, so a computed front is late or early by a time that
/// cannot be judged; how fast it runs can. With X(T) computed and points (T_i, X_i) measured, the shift s and the rate
/// r minimise
///
///     sum w_i [X(r (T_i - s)) - X_i]^2,   1/w_i = u_X^2 + (X' u_T)^2,
///
/// and their covariance is the inverse of the normal matrix. A right front has r = 1: water that falls by a gravity a
/// tenth too small needs r = 1.054, a front a tenth too slow 1.11, one a twentieth too fast 0.952.
///
/// What it cannot tell: what the artificial viscosity of a particle method does at the start looks like the delay of
/// the diaphragm.
#pragma once

#include "validation/case/submission.hpp"
#include "validation/dam_break/column_front.hpp"

namespace seiche::validation {

struct FrontFit {
  std::size_t points = 0;
  double shift = 0;              ///< s
  double rate = 1;               ///< r
  double shift_uncertainty = 0;  ///< standard, of the data
  double rate_uncertainty = 0;   ///< standard, of the data
  /// By how much r moves at most when the computed front is wrong by its stated uncertainty, of whatever sign at every
  /// point; none without a statement.
  std::optional<double> rate_numerical = {};
  double rms = 0;       ///< of X(T_i - s) - X_i with r = 1 and the s that suits that: see ShiftedFront
  double expected = 0;  ///< of that, from the uncertainties of the points
};

/// @param farthest  points with a larger X do not count
/// @param stated    standard uncertainty of the computed X; none where nothing was stated
/// @throws std::invalid_argument for fewer than three points that count
FrontFit front_fit(Curve computed, const ColumnFront& data, double farthest, std::optional<double> stated);

/// X/a from T = 0 on, at points as dense as a shift of the time origin needs. What is published is joined by straight
/// lines, from the column at rest.
WantedTable wanted_front(const ColumnFront& data, double farthest);

/// Claims, measures and a figure.
/// @param cell  over the width of the column
void judge_front(const ColumnFront& data, double farthest, double cell, const SubmittedGroup& front,
                 const SolverFacts& facts, evidence::Record& record);

}  // namespace seiche::validation
