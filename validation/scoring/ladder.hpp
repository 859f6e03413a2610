/// The same result on several resolutions: how fast somebody else's solver converges, to what, and at what cost.
///
/// Of a quantity, over all reference points that every resolution covers, with s the submitted values, r the reference:
///
/// - error: sqrt(sum (s - r)^2 / sum r^2), not divided where r is zero;
/// - limit: at every point by evidence::grid_convergence, with 2 for the theoretical order that nobody stated;
/// - numerical error: the same norm of the half-widths (95 %) that it gives for the finest;
/// - order, by evidence::order_of_few from three sizes on: of the error where the reference is exact; where it was
///   measured, and the error ends at that of the data, of the distance from the limit;
/// - what the error tends to: evidence::grid_convergence of the errors;
/// - size for one per cent: h (0.01/e)^(1/p), with the error e on the finest size h and the order p, whose interval
/// gives
///   its range; the time for it by the power of the size that the stated times follow.
///
/// Between submitted points there are straight lines: sizes must not be confused with the points that are printed.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/evidence/grid_convergence.hpp"
#include "reports/evidence/record.hpp"
#include "validation/case/submission.hpp"

namespace seiche::validation {

/// What one resolution gave.
struct Rung {
  double size = 0;
  std::optional<double> seconds;
  Submitted submitted;
};

struct LadderQuantity {
  std::string table, name, unit;
  bool exact = true;          ///< the reference
  bool relative = true;       ///< errors are shares of the reference; else in the unit
  std::vector<double> error;  ///< from coarse to fine
  std::vector<double> away;   ///< from the limit, in the same measure
  double numerical = 0;       ///< 95 % half-width for the finest, in the same measure
  double typical = 0;         ///< the same in the unit, root mean square over the points
  evidence::ObservedOrder order;
  evidence::GridConvergence tends;  ///< the error, with the size to zero

  /// What the order is of.
  [[nodiscard]] const std::vector<double>& converging() const { return exact ? error : away; }
};

struct Reach {
  double size = 0, least = 0, most = 0;  ///< range by the order's interval; where that goes to 0, open: 0 or infinity
  std::optional<double> seconds;
};

struct Ladder {
  std::vector<double> size;     ///< from coarse to fine
  std::vector<double> seconds;  ///< as many, or none
  std::vector<LadderQuantity> quantities;

  /// The size that makes the error this share of the reference. None: it has no order, or tends to more than that.
  [[nodiscard]] std::optional<Reach> reach(const LadderQuantity& quantity, double target) const;
  /// "eta: your order is 1.1 (0.9 to 1.3); error of the finest 3.2 %; 1 % needs dx = 0.004"
  [[nodiscard]] std::string line(const LadderQuantity& quantity) const;
};

inline constexpr double ladder_target = 0.01;

/// @param rungs  three or more of different positive sizes, in any order; times for all of them or for none
/// @throws std::invalid_argument otherwise, and where the rungs do not hold the same tables
Ladder ladder_of(const std::vector<WantedTable>& wanted, std::vector<Rung> rungs);

/// A figure, two tables and measurements.
void show_ladder(const Ladder& ladder, evidence::Exhibit& exhibit);

/// Adds what the ladder says of the numerical uncertainty of quantities with a measured reference, where none is
/// stated. That of a comparison with an exact reference is the error itself.
void add_numerical(const Ladder& ladder, std::map<std::string, StatedUncertainty>& uncertainty);

}  // namespace seiche::validation
