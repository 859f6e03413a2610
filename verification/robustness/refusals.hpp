/// Bad input is refused by a std::invalid_argument that names what is wrong.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "verification/check.hpp"

namespace seiche::verification {

/// The message of the std::invalid_argument that `action` must throw; empty when it throws nothing or something else.
template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  } catch (const std::exception& other) {
    UNSCOPED_INFO("not a std::invalid_argument: " << other.what());
  }
  return {};
}

class Refusals {
 public:
  explicit Refusals(Check& check) : check_(check) {}

  /// `action` is refused with a message that contains all of `words`: parameter, value, range.
  template <class Action>
  void refused(const std::string& what, const std::vector<std::string>& words, Action action) {
    const std::string message = refusal(action);
    INFO(message);
    bool named = true;
    std::string wanted;
    for (const std::string& word : words) {
      named = named && message.find(word) != std::string::npos;
      wanted += (wanted.empty() ? "\"" : ", \"") + word + "\"";
    }
    check_.holds(
        what, {named ? 1.0 : 0.0},
        evidence::Qualitative{
            "std::invalid_argument whose message contains " + wanted,
            "input must be rejected before anything is computed, with what is wrong, its value and what is allowed"});
  }

 private:
  Check& check_;
};

}  // namespace seiche::verification
