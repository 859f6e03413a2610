/// Run-up of a solitary wave on a plane beach: Synolakis' solution of the nonlinear shallow-water equations.
///
/// A wave a sech^2(gamma t) arrives at the toe of a beach of slope 1 : cot beta, whose toe lies X0 = d cot beta from
/// the shoreline; gamma = sqrt(3 a/4). In units of d and sqrt(d/g) the linear theory gives at the initial shoreline
///
///     R(tau) = int Phi(k) 2 e^{-ik tau}/(J0(2 k X0) - i J1(2 k X0)) dk,   Phi = (2/3) k csch(pi k/(2 gamma)),
///
/// and the Carrier-Greenspan transformation makes of it the moving shoreline of the nonlinear theory,
///
///     U = X0 R'(tau),   t = tau - X0 U,   elevation = R(tau) - U^2/2,
///
/// with the same extremes. The wave breaks at the shoreline when X0^2 R'' reaches 1: the solution ends there.
/// R is summed by the trapezoidal rule with the aliasing period longer than the motion lasts: round-off accuracy.
///
/// When not to use it: breaking waves (nonbreaking(), shoreline_steepness()); steep beaches, where the incident wave on
/// the beach is not long; waves so high that a sech^2(gamma t) with speed sqrt(g d) is not the solitary wave.
///
/// References: Carrier and Greenspan, Water waves of finite amplitude on a sloping beach, J. Fluid Mech. 4 (1958) 97;
/// Synolakis, The runup of solitary waves, J. Fluid Mech. 185 (1987) 523.
///
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

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class SolitaryRunup {
 public:
  /// @param amplitude  crest height a of the incident wave [m];  @param cotangent  cot beta of the beach
  /// @param refinement  of the rule of the integral: a second value tells its error. Throws std::invalid_argument.
  SolitaryRunup(double gravity, double depth, double amplitude, double cotangent, double refinement = 1);

  /// Elevation of the linear theory at the initial shoreline [m]; t = 0 when the crest is at the toe.
  [[nodiscard]] double linear_elevation(double t) const;

  /// Shoreline of the nonlinear theory: elevation [m], and velocity along the horizontal, positive up the beach [m/s].
  /// Throws std::invalid_argument from breaking_time() on.
  struct Shoreline {
    double elevation, velocity;
  };
  [[nodiscard]] Shoreline shoreline(double t) const;

  /// Highest and lowest shoreline of linear and nonlinear theory alike [m], and when [s]. On a beach much shorter than
  /// the wave the water does not fall below its still level.
  struct Extreme {
    double elevation, time;
  };
  [[nodiscard]] Extreme highest() const { return highest_; }
  [[nodiscard]] std::optional<Extreme> lowest() const { return lowest_; }

  /// Largest X0^2 R'' in units of g, on the way up (before the maximum) and over all time: below 1, the shoreline does
  /// not break. Run-down is steeper.
  struct Steepness {
    double run_up, overall;
  };
  [[nodiscard]] Steepness shoreline_steepness() const { return steepness_; }
  /// When the shoreline first breaks [s]; infinite if it never does.
  [[nodiscard]] double breaking_time() const { return breaking_time_; }

  /// Run-up law R = 2.831 sqrt(cot beta) (a/d)^{5/4} d, the leading term of the maximum for long beaches [m].
  [[nodiscard]] double law() const { return 2.831 * std::sqrt(toe_) * std::pow(amplitude_, 1.25) * depth_; }
  /// Synolakis' estimates of where the law holds: a < 0.8183 (cot beta)^{-10/9} d (does not break during run-up) and
  /// a >> (0.288 tan beta)^2 d [m].
  [[nodiscard]] double breaking_amplitude() const { return 0.8183 * std::pow(toe_, -10.0 / 9) * depth_; }
  [[nodiscard]] double short_beach_amplitude() const { return std::pow(0.288 / toe_, 2) * depth_; }
  [[nodiscard]] bool nonbreaking() const { return amplitude_ * depth_ < breaking_amplitude(); }

  [[nodiscard]] double uncertainty() const { return 1e-13; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  /// R and its first two derivatives, scaled.
  struct Jet {
    double value, slope, curvature;
  };
  [[nodiscard]] Jet jet(double tau) const;
  [[nodiscard]] std::optional<Extreme> extreme(double from, double to, double sign) const;

  double depth_;
  double time_unit_;  ///< sqrt(d/g)
  double amplitude_;  ///< a/d
  double toe_;        ///< X0/d = cot beta
  double gamma_;
  double arrival_;  ///< before it, and after the end, |R| < 1e-17
  double end_, wavenumber_step_;
  std::vector<double> real_;  ///< weighted transform 2 h F(j h), conjugate-even
  std::vector<double> imaginary_;
  Extreme highest_{};
  std::optional<Extreme> lowest_;
  Steepness steepness_{};
  double breaking_time_ = std::numeric_limits<double>::infinity();
  double excursion_ = 0;  ///< largest |X0 U|
};

class HallWatts {
 public:
  /// @param depth [m];  @param slope  tan beta, in [tan 5 deg, tan 45 deg]. Throws std::invalid_argument.
  HallWatts(double depth, double slope);

  /// Run-up [m] of a solitary wave of this amplitude [m].
  [[nodiscard]] double runup(double amplitude) const;
  /// Relative standard uncertainty of the correlation, assumed from the scatter of such experiments.
  [[nodiscard]] static constexpr double scatter() { return 0.05; }

  /// Of the evaluation, not of the experiments: scatter().
  [[nodiscard]] double uncertainty() const { return 1e-15; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  double depth_, coefficient_, exponent_;
};

}  // namespace seiche::exact
