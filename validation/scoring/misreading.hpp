/// What a submitted curve may have been misread as: the one change of it that would bring it onto the reference.
///
/// Solvers are right more often than the files that are written of them: a clock that starts at another instant, a
/// datum, an axis or a unit. With s the submitted curve, joined by straight lines, and r the reference at its points,
/// each change replaces s(x) by
///
///     unit       s(x)/f, f = 1000, 100, 10, 3.28084 (feet), 9.81 or one over them       levels    s(x) - c
///     inverted   -s(x)                                                                   shift     s(x + d)
///     backwards  s(x_first + x_last - x)                                                 slow      s(x_first + f (x -
///     x_first)) abscissa   s(f x), f = 1000, 100, 60 or one over them                              scaled    s(x)/f
///                                                                                        dying     m + (s(x) - m)
///                                                                                        exp(b z)
///                                                                                        smeared    s(x) + r - r_w
///
/// with m the mean of r, z from 0 to 1 along it, and r_w the mean of r over w of the range about x. The numbers on the
/// right are fitted: |d| up to a quarter of the range, f of `slow` within a quarter of 1, w up to a quarter, |b| up
/// to 3. What counts is the misfit, the root of the mean of (s_i - r_i)^2 over the reference's points that s covers. A
/// change explains it when
///
/// - the misfit is more than a hundredth of the reference's range: less is what solvers differ by;
/// - ten points or more are compared, of which the change leaves three quarters covered;
/// - it leaves less than a third of the misfit, a ninth of its square. One number fitted to noise leaves all but one
///   part in ten of it.
///
/// Of several that do, the one that leaves least; a fitted number must leave a fifth less than a given one.
///
/// When not to use it: to correct a result. It says what to look at; nothing is applied.
#pragma once

#include <optional>
#include <string>

#include "validation/instruments/agreement.hpp"

namespace seiche::validation {

struct Misreading {
  enum class Kind { unit, inverted, backwards, abscissa, level, shift, slow, scaled, dying, smeared };
  Kind kind = Kind::level;
  double amount = 0;  ///< f, c, d or b above; 0 where there is none
  double left = 0;    ///< of the misfit, when it is undone

  /// One sentence about "your curve". @param unit, abscissa_unit  for the numbers in it
  [[nodiscard]] std::string words(const std::string& unit, const std::string& abscissa_unit) const;
};

/// Points of the reference that are NaN are left out. None: no single change explains what the curves differ by, or
/// they do not differ.
std::optional<Misreading> misreading(Curve submitted, Curve reference);

/// The unit that makes a single number `factor` times too large, to five per cent: "centimetres for metres"; empty for
/// none.
std::string unit_mistaken(double factor, const std::string& unit);

/// See misfit above; NaN where nothing is covered.
double misfit(Curve submitted, Curve reference);

/// What part of the misfit a change must not leave to explain it.
inline constexpr double explained_below = 1.0 / 3;

}  // namespace seiche::validation
