/// Measured and computed fronts of collapsing columns that others published.
#pragma once

#include <string>
#include <vector>

#include "validation/case/parameter.hpp"
#include "validation/case/submission.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/instruments/shifted_front.hpp"

namespace seiche::validation {

struct ColumnFront {
  std::string name;      ///< "martin_moyce_tall_wide", see column_fronts
  std::string label;     ///< for legends
  std::string citation;  ///< short
  double aspect = 2;     ///< height over width of the column
  bool tall = true;      ///< T = t sqrt(2 g/a); otherwise T = t sqrt(g/a)
  bool measured = true;  ///< in a laboratory
  std::vector<double> T;
  std::vector<double> X;   ///< over a
  double uncertainty = 0;  ///< of X, standard
  [[nodiscard]] Curve curve() const { return {T, X}; }
  /// [1/s] for a column of width a.
  [[nodiscard]] double unit(double gravity, double width) const;
};

/// Names that column_front knows.
const std::vector<std::string>& column_fronts();
/// Reads the table, as values.table() does. Throws std::invalid_argument for another name.
ColumnFront column_front(const std::string& name, const Values& values);

/// Keeps what one shift of the time origin makes of a front.
void measure_shift(evidence::Exhibit& exhibit, const ShiftedFront& fit);

/// How somebody else's front is asked for: X/a from T = 0 on, at points as dense as a shift of the time origin needs.
/// What is published is joined by straight lines, from the column at rest.
/// @param farthest  X/a beyond which the far wall of the tank is felt
WantedTable wanted_front(const ColumnFront& data, double farthest);
/// Claims, measures and a figure for it: with one shift of the time origin the front is the published one, and the
/// shift is what the release explains.
void judge_front(const ColumnFront& data, double farthest, const SubmittedGroup& front, evidence::Record& record);

}  // namespace seiche::validation
