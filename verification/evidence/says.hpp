/// Assertions that a text holds what it must say.
#pragma once

#include <string>

#include "verification/check.hpp"

namespace seiche::verification {

/// @param what    the assertion, a sentence
/// @param words   that the text must hold
/// @param reason  why it must
inline void says(Check& check, const std::string& what, const std::string& text, const std::string& words,
                 const std::string& reason = "it was made so") {
  INFO(text);
  check.holds(what, {text.find(words) != std::string::npos ? 1.0 : 0.0}, Qualitative{"\"" + words + "\"", reason});
}

}  // namespace seiche::verification
