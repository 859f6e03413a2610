/// Units in sentences.
#pragma once

#include <string>

namespace seiche::validation {

/// What follows a number: " m"; nothing for what has no dimension, "1" or empty.
inline std::string after_number(const std::string& unit) {
  return unit == "1" || unit.empty() ? "" : " " + unit;
}

}  // namespace seiche::validation
