/// The front of a collapsing column beside measured points, as computed and with one shift of the time origin.
///
/// The columns of the experiments were released by a diaphragm that melts or a wall that is pulled: they start late, by
/// a time that nobody measured. With X(T) computed and points (T_i, X_i) measured,
///
///     rms(s)^2 = mean of [X(T_i - s) - X_i]^2,
///
/// s = 0 is the comparison as it stands; the s that minimises it is the shift.
///
/// Reference: Martin and Moyce, Part IV. An experimental study of the collapse of liquid columns on a rigid horizontal
/// plane, Phil. Trans. R. Soc. Lond. A 244 (1952) 312.
#pragma once

#include <vector>

#include "validation/instruments/agreement.hpp"

namespace seiche::validation {

struct ShiftedFront {
  std::size_t points = 0;       ///< that are compared
  double raw_rms = 0;           ///< s = 0
  std::vector<double> raw_off;  ///< X(T_i)/X_i - 1 of each point
  double shift = 0;             ///< s, positive where the measured front is late
  double rms = 0;               ///< with that s
};

/// Shifts that are tried; no release is later than half a unit.
struct ShiftRange {
  double lowest = -0.2;
  double highest = 0.5;
};

/// Earliest T at which the computed front is known with every shift. One that is still at rest where it begins, X of no
/// more than 1.05, stood there before; of another nothing is known before it begins.
double known_from(Curve computed, ShiftRange range = {});

/// Points that the computed curve covers with every shift and whose X is at most `farthest` count. Throws
/// std::invalid_argument for fewer than two of them.
ShiftedFront shifted_front(Curve computed, Curve measured, double farthest, ShiftRange range = {});

/// Slope of the least-squares line through the points of a curve with from < x < to; NaN for fewer than two of them.
double slope_between(Curve curve, double from, double to);

}  // namespace seiche::validation
