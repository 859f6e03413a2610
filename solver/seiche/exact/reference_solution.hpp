/// What every exact solution offers besides its values: how well it is known, and measurements of itself.
#pragma once

#include <concepts>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace seiche::exact {

/// Relative rounding of numbers near 1, one unit in the last place.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Something that holds exactly for the solution, evaluated with the numbers that the solution returns: no outside
/// data. A measurement, not a verdict: whoever claims that it holds does so within its accuracy.
struct Identity {
  std::string name;   ///< the identity in plain text, "2 T = F (I - C)"
  double defect = 0;  ///< magnitude of what should be zero, relative to the largest term unless the name says otherwise
  double accuracy = 0;  ///< the defect that round-off or the stated resolution explains
  std::string reason;   ///< where the accuracy comes from
};

using SelfTest = std::vector<Identity>;

/// One solution with validated parameters.
template <class S>
concept ReferenceSolution = requires(const S& solution) {
  /// Bound of the numerical error of the values returned, relative to the solution's own scale (largest elevation,
  /// largest velocity, speed); for an asymptotic formula, of its evaluation, not of its derivation.
  { solution.uncertainty() } -> std::convertible_to<double>;
  { solution.self_test() } -> std::same_as<SelfTest>;
};

/// Fluid velocity at a point [m/s]: u along +x, v upwards.
struct Velocity {
  double u = 0;
  double v = 0;
};

/// A point above the surface or below the bottom was asked for.
class OutsideFluid : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace seiche::exact
