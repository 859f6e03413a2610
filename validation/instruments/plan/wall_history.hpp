/// Where the height of a Mach stem on the wall goes: its growth at the end of a run, its limit, the stem's angle.
///
/// In the Kadomtsev-Petviashvili equation the wall amplitude approaches its limit exponentially,
///
///     a_w = a_inf - C exp(-r t),   r = S^3 kappa (1 - kappa)/3 c0/h,   S = sqrt(3a/h),
///
/// ever more slowly towards kappa = 1 (there algebraically). So the limit is that of the exponential fitted to the last
/// half of the series. Its uncertainty is the largest difference from it of the exponential on the last two thirds and
/// on the last third, and of a_inf - C t^-p on the last half wherever that fits a third as well or better; at least
/// what the fit leaves, and the whole rest of the way where the series hardly bends.
///
/// All that presumes that the series has shown what it approaches. A stem next to kappa = 1 has not: at kappa = 0.98 an
/// exact one halts near t = 1/r, growing by less than 1 % in a fifth of the time, a sixth below its limit. So the
/// interval is widened by what the theory's rate r still allows: what is missing is never more than a_inf exp(-r t),
/// and
///
///     a_w(t) <= a_inf <= a_w(t)/(1 - exp(-r t)).
///
/// When not to use it: on runs shorter than several 1/r, where the interval is as wide as the number; on series that
/// oscillate as a whole; as a proof that there is a limit.
///
/// Reference: Kodama and Yeh, The KP theory and Mach reflection, J. Fluid Mech. 800 (2016) 766.
#pragma once

#include <optional>
#include <span>

#include "reports/evidence/claim.hpp"

namespace seiche::validation {

/// A series whose relative growth over its last fifth exceeds this is not steady.
inline constexpr double steady_growth = 0.01;

/// (a(end) - a(4/5 of the time))/a(end).
double growth_of_last_fifth(std::span<const double> time, std::span<const double> amplitude);

/// a_inf - C f(t) by least squares.
struct Approach {
  double limit = 0;
  double rate = 0;     ///< r of exp(-r t), or p of t^-p
  double misfit = 0;   ///< root mean square of what the fit leaves
  bool bends = false;  ///< the rate is inside the range that the series can tell from a straight line
};
Approach exponential_approach(std::span<const double> time, std::span<const double> amplitude);

struct WallLimit {
  evidence::Measurement amplitude;  ///< a_w for t -> infinity
  double growth = 0;                ///< of the last fifth
  Approach exponential;             ///< on the last half
  Approach algebraic;

  [[nodiscard]] bool steady() const { return growth <= steady_growth && growth >= -steady_growth; }
};

/// @param time       increasing, from the moment the wave met the wall; at least 20
/// @param amplitude  a_w
/// @param rate       r, the slowest rate at which a part of the way may still be made, per time; 0: not at all known,
/// nor
///                   is the limit then (no uncertainty is stated); none: the series has shown its slowest part
/// Throws std::invalid_argument.
WallLimit wall_limit(std::span<const double> time, std::span<const double> amplitude, std::optional<double> rate = {});

/// Angle chi between the wall and the path of the stem's end [rad], from the crest's places on the wall and the lengths
/// of the stem at two times or more; negative where the stem shrinks.
evidence::Measurement stem_angle(std::span<const double> wall_x, std::span<const double> stem_length);

}  // namespace seiche::validation
