/// Bad input is rejected by a std::invalid_argument that names what is wrong.
#pragma once

#include <cctype>
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

  /// Claims that `action` is rejected with a message that contains all of `words`: parameter, value, range.
  ///
  /// @param text  the bad input: "A grid without a step."
  template <class Action>
  void refused(const std::string& id, const std::string& text, const std::vector<std::string>& words, Action action) {
    const std::string message = refusal(action);
    INFO(id << ": " << message);
    bool named = true;
    std::string wanted;
    for (const std::string& word : words) {
      named = named && message.find(word) != std::string::npos;
      wanted += (wanted.empty() ? "\"" : ", \"") + word + "\"";
    }
    const std::string input = static_cast<char>(std::tolower(text.front())) + text.substr(1);
    check_.that(
        {.id = id,
         .text = "Input is rejected by name: " + input,
         .quantity = "rejected by name",
         .source = "interface of the model"},
        {.value = named ? 1.0 : 0.0},
        evidence::Qualitative{"std::invalid_argument whose message contains " + wanted,
                              "input must be rejected before anything is computed, with what is wrong, its value "
                              "and what is allowed"});
  }

 private:
  Check& check_;
};

}  // namespace seiche::verification
