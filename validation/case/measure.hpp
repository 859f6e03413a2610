#pragma once

namespace seiche::validation {

/// What is measured of a submitted quantity s beside its reference r; formulas: validation/instruments/agreement.hpp.
enum class Measure {
  value,            ///< the submitted number itself; scalars only
  relative_error,   ///< (s - r)/|r|; scalars only
  largest_error,    ///< max |s - r|
  relative_l1,      ///< sum |s - r| / sum |r|
  relative_l2,      ///< sqrt(sum (s - r)^2 / sum r^2)
  relative_linf,    ///< max |s - r| / max |r|
  amplitude_ratio,  ///< range of s over range of r
  shift,            ///< how far s lies behind r along the abscissa, in its unit
  arrival_error,    ///< first arrival of s less that of r; series only
  peak_error,       ///< max s - max r
  peak_shift,       ///< where s is largest less where r is
  skill,            ///< Willmott's index of agreement: 1 is perfect
};

}  // namespace seiche::validation
