/// Units as people write them.
#pragma once

#include <optional>
#include <string>

namespace seiche::validation {

/// What follows a number: " m"; nothing for what has no dimension, "1" or empty.
inline std::string after_number(const std::string& unit) {
  return unit == "1" || unit.empty() ? "" : " " + unit;
}

/// What a number in one unit is to be multiplied by to be in another: 0.01 from "cm" to "m"; none where they measure
/// different things, or one of them is not known. Products, quotients and powers are written as "m/s", "m s-1",
/// "m*s^-1", "m**2".
std::optional<double> conversion(const std::string& from, const std::string& to);

/// Of "seconds since 2020-01-01 00:00:00": the unit before `since`, and the instant in seconds after the start of 1970.
struct Epoch {
  std::string unit;
  double origin = 0;
};
std::optional<Epoch> epoch_of(const std::string& unit);

}  // namespace seiche::validation
