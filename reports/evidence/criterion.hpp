/// When does a measurement support its claim? Every criterion carries the reason for its limit.
#pragma once

#include <string>
#include <variant>

namespace seiche::evidence {

/// |value - expected| <= 4 eps sqrt(operations) scale: four standard deviations of a random walk of rounding errors.
struct Roundoff {
  double operations = 1;  ///< rounded operations that contribute
  double scale = 1;       ///< magnitude of the numbers that are rounded, in the claim's unit
  std::string reason;     ///< how operations and scale were counted
  double expected = 0;
};

/// The confidence interval of the observed order lies inside [theory - tolerance, theory + tolerance].
struct Order {
  double theory = 2;
  double tolerance = 0.1;
  std::string reason;
};

/// |value - expected| <= limit; relative to |expected| if `relative`.
struct Bound {
  double limit = 0;
  std::string reason;  ///< where the limit comes from
  double expected = 0;
  bool relative = false;
};

/// |value - expected| <= coverage sqrt(u_num^2 + u_input^2 + u_data^2) (ASME V&V 20-2009). Inconclusive when that
/// uncertainty exceeds `useful`: agreement within an uncertainty that large says nothing.
struct Uncertainty {
  double expected = 0;
  double data = 0;    ///< standard uncertainty of the reference
  double input = 0;   ///< standard uncertainty from inexactly known inputs
  double useful = 0;  ///< largest expanded uncertainty that still decides
  std::string reason;
  double coverage = 2;
};

/// A named feature is present (measured value 1) or absent (0).
struct Qualitative {
  std::string detector;  ///< how presence is decided
  std::string reason;
  bool expected = true;
};

using Criterion = std::variant<Roundoff, Order, Bound, Uncertainty, Qualitative>;

}  // namespace seiche::evidence
