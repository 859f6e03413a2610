/// Comparison with numbers computed once in 30-digit arithmetic and printed to 9-16 digits.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "verification/check.hpp"

namespace seiche::verification {

/// Passes within half a unit of the last printed decimal or 1e-14 of the value, whichever is larger.
///
/// @param decimals  digits printed after the decimal point
inline void check_digits(Check& check, const std::string& id, const std::string& quantity, double value, double printed,
                         int decimals) {
  const double printing = 0.5 * std::pow(10.0, -decimals);
  const double limit = std::max(printing, 1e-14 * std::abs(printed));
  check.holds(id + ": The " + quantity + " has every digit of the reference.", {value},
              evidence::Bound{limit,
                              "half a unit of the last printed digit of the 30-digit reference, or 1e-14 of the value, "
                              "45 roundings, where that is larger",
                              printed});
}

}  // namespace seiche::verification
