/// Hall and Watts' correlation of measured solitary-wave run-up on impermeable plane beaches.
///
/// With S = tan beta and lengths in depths,
///
///     R = 3.05 S^{-0.13} a^{1.15 S^{0.02}}   12 to 45 degrees,     R = 11 S^{0.67} a^{1.9 S^{0.35}}   5 to 12 degrees.
///
/// A fit to experiments with breaking and non-breaking waves, quoted here from the secondary literature.
///
/// When not to use it: slopes outside 5 to 45 degrees; to judge a solver more closely than the scatter of about 5 %.
///
/// References: Hall and Watts, Laboratory investigation of the vertical rise of solitary waves on impermeable slopes,
/// US Army Corps of Engineers, Beach Erosion Board, Tech. Memo. 33 (1953); Synolakis, J. Fluid Mech. 185 (1987) 523.
#pragma once

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class HallWatts {
 public:
  /// @param depth [m];  @param slope  tan beta, in [tan 5 deg, tan 45 deg]. Throws std::invalid_argument.
  HallWatts(double depth, double slope);

  /// Run-up [m] of a solitary wave of this amplitude [m].
  [[nodiscard]] double runup(double amplitude) const;
  /// Relative standard uncertainty of the correlation, assumed from the scatter of such experiments.
  [[nodiscard]] static constexpr double scatter() { return 0.05; }

  static Provenance provenance();
  /// Of the evaluation, not of the experiments: scatter().
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  double depth_;
  double coefficient_;
  double exponent_;
};

}  // namespace seiche::exact
