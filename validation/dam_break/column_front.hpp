/// Measured and computed fronts of collapsing columns that others published.
#pragma once

#include <cmath>

#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/parameter.hpp"
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
  std::vector<double> X;        ///< over a
  double uncertainty = 0;       ///< of X, standard
  double time_uncertainty = 0;  ///< of T, standard
  double tank = 0;              ///< length of the tank over a; 0: no far wall
  [[nodiscard]] Curve curve() const { return {T, X}; }
  /// With the uncertainty of X.
  void draw(evidence::Panel& panel) const {
    panel.points(label, T, X, evidence::Role::data, std::vector<double>(X.size(), uncertainty));
  }
  /// [1/s] for a column of width a.
  [[nodiscard]] double unit(double gravity, double width) const { return std::sqrt((tall ? 2 : 1) * gravity / width); }
};

/// A column of the laboratories is let go late: the one rule for all models.
inline evidence::Bound release_delay() {
  return {.limit = 0.1, .reason = "0.1 to 0.3: melting time of the diaphragm stated by the source", .expected = 0.2};
}
/// With one shift a front goes through the points: the one rule for all models.
inline evidence::Bound through_points(const ColumnFront& data) {
  return {.limit = data.uncertainty, .reason = "one standard uncertainty of a point; one number was fitted"};
}

/// Names that column_front knows.
std::vector<std::string> column_fronts();
/// Reads the table, as values.table() does. Throws std::invalid_argument for another name.
ColumnFront column_front(const std::string& name, const Values& values);

/// Keeps what one shift of the time origin makes of a front.
void measure_shift(evidence::Exhibit& exhibit, const ShiftedFront& fit);

}  // namespace seiche::validation
