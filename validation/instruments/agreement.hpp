/// How well a submitted curve s agrees with a reference r.
///
/// Rule of interpolation: between its points the submitted curve is the piecewise linear one; it is evaluated at the
/// reference points. Nothing is extrapolated: reference points outside the submitted range, and those where the
/// reference is not known (NaN), are left out. The share that remains of the known ones is the coverage. All sums run
/// over the points that remain, each with the same weight.
///
/// | measure         | formula |
/// |-----------------|---------|
/// | largest error   | max abs(s_i - r_i) |
/// | relative L1     | sum abs(s_i - r_i) / sum abs(r_i) |
/// | relative L2     | sqrt(sum (s_i - r_i)^2 / sum r_i^2) |
/// | relative Linf   | max abs(s_i - r_i) / max abs(r_i) |
/// | amplitude ratio | (max s_i - min s_i) / (max r_i - min r_i) |
/// | skill           | d = 1 - sum (s_i - r_i)^2 / sum (abs(s_i - m) + abs(r_i - m))^2, m the mean of r_i |
/// | peak            | largest value and the abscissa where it is first reached, among the points |
///
/// A measure whose denominator is zero is NaN, and so is the place of a plateau's peak: where the reference stays
/// within a hundredth of its range of it over more than a tenth of the way.
///
/// Shift: the lag at which r(x - lag) is best correlated with s(x), positive where s is late or too far along. Both
/// curves are resampled linearly at as many equally spaced points as there are; for each lag of a whole number of
/// spacings, up to a quarter of the range, the correlation coefficient of the overlapping parts is taken; a parabola
/// through each local maximum and its neighbours refines it. Periodic curves agree at several lags: of the maxima
/// within 1 % of the largest the one of smallest lag is taken. NaN where there is none, as of constant curves.
///
/// Arrival: where a curve first rises through r_0 + fraction (max r - r_0), r_0 the first value of the reference, found
/// on the curve's own points by linear interpolation; NaN where it does not.
///
/// When not to use it: curves with several values per abscissa (overturning waves); norms of a curve with a jump, where
/// the Linf error is of the size of the jump whatever the resolution.
///
/// References: Willmott, On the validation of models, Phys. Geogr. 2 (1981) 184; Synolakis et al., Validation and
/// verification of tsunami numerical models, Pure Appl. Geophys. 165 (2008) 2197.
#pragma once

#include <span>
#include <vector>

namespace seiche::validation {

/// Points (x, y) of a curve, x strictly increasing, at least one.
struct Curve {
  std::span<const double> x;
  std::span<const double> y;
};

/// Value of the piecewise linear curve; NaN outside its range.
double linear_at(Curve curve, double x);

struct Agreement {
  double coverage = 0;  ///< share of the known reference points that the submitted curve covers
  std::vector<double> x;
  std::vector<double> submitted;  ///< interpolated to x
  std::vector<double> reference;
  double largest_error = 0;
  double relative_l1 = 0;
  double relative_l2 = 0;
  double relative_linf = 0;
  double amplitude_ratio = 0;
  double skill = 0;
  double shift = 0;
  double peak = 0;  ///< of the submitted curve, interpolated
  double peak_at = 0;
  double reference_peak = 0;
  double reference_peak_at = 0;
};

/// @throws std::invalid_argument when the curve covers none of the reference points
Agreement agreement(Curve submitted, Curve reference);

/// See Shift above. Arrays of equal length over increasing x.
double shift_between(std::span<const double> x, std::span<const double> submitted, std::span<const double> reference);

/// First abscissa at which the curve is at or above `level`; NaN if it never is.
double first_crossing(Curve curve, double level);

/// See Skill above.
double willmott_skill(std::span<const double> submitted, std::span<const double> reference);

}  // namespace seiche::validation
