/// Bad input is refused by a std::invalid_argument that names what is wrong.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/ranges.hpp"
#include "verification/check.hpp"

namespace seiche::verification {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Rows of a table of what is refused: words of the message, and what is bad.
///
///     const auto channel = refusals.of(level_channel(), [](const Channel& c) { Flow flow(c, water()); });
///     channel({"gravity", "= 0", "positive"}, [](Channel& c) { c.gravity = 0; });
class Refusals {
 public:
  explicit Refusals(Check& check) : check_(check) {}

  /// `action` is refused with a message that contains all of `words`: parameter, value, range. @param of  what it is of
  template <class Action>
  void refused(const std::vector<std::string>& words, Action action, const std::string& of = "") {
    std::string message;
    try {
      action();
    } catch (const std::invalid_argument& error) {
      message = error.what();
    } catch (const std::exception& other) {
      UNSCOPED_INFO("not a std::invalid_argument: " << other.what());
    }
    INFO(message);
    const auto named = [&](const std::string& word) { return message.find(word) != std::string::npos; };
    check_.holds(
        fmt::format("{}Invalid input is rejected with a message that names {}.", of, fmt::join(words, ", ")),
        {std::ranges::all_of(words, named) ? 1.0 : 0.0},
        evidence::Qualitative{
            "std::invalid_argument whose message contains all of it",
            "input must be rejected before any computation, with the parameter, its value and the allowed range"});
  }

  /// Rows that change something good before it is used.
  template <class Good, class Use>
  auto of(Good good, Use use) {
    return [=, this](const std::vector<std::string>& words, auto change) {
      refused(words, [&] {
        Good bad = good;
        change(bad);
        use(std::move(bad));
      });
    };
  }
  /// A struct of parameters has these ranges ("theta in [1, 2]; gravity positive and finite"); the numbers next to
  /// their ends outside, infinities and NaN are refused by name, value and range; the ends inside are none of them, and
  /// the good ones are not refused. @param of  the name of the struct
  template <class Parameters, class Use>
  void outside_ranges(const std::string& of, const std::string& ranges, const Parameters& good, Use use) {
    CHECK_NOTHROW(use(good));
    std::string declared;
    for (const auto& [name, member, range] : Parameters::ranges()) {
      declared += fmt::format("{}{} {}", declared.empty() ? "" : "; ", name, range.words());
      CHECK(range.holds(range.open ? std::nextafter(range.lowest, infinity) : range.lowest));
      CHECK(range.holds(range.highest));
      for (const double value : range.outside()) {
        Parameters bad = good;
        bad.*member = value;
        refused(
            {fmt::format("{} = {:.17g}", name, value), range.words()}, [&] { use(bad); }, of + ": ");
      }
    }
    CHECK(declared == ranges);
  }
  /// Rows that give what is used.
  template <class Bad, class Use>
  auto with(Use use) {
    return [=, this](const std::vector<std::string>& words, const Bad& bad) { refused(words, [&] { use(bad); }); };
  }

 private:
  Check& check_;
};

}  // namespace seiche::verification
