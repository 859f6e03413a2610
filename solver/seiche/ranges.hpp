/// Ranges of the numbers in a struct of parameters, declared in it: constructors refuse by them, and tests try the
/// numbers next to them on both sides.
///
///     struct Settings {
///       double courant = 0.4;
///       static constexpr auto ranges() {
///         return std::array{Number{"courant", &Settings::courant, Range::within(0, 1)}};
///       }
///     };
///     require_ranges(settings);  // std::invalid_argument: courant = 2 is out of range: must be in [0, 1]
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace seiche {

/// From the lowest to the highest, finite; without the lowest where `open`. NaN is in no range.
struct Range {
  static constexpr double most = std::numeric_limits<double>::max();

  double lowest = -most, highest = most;
  bool open = false;

  static constexpr Range finite() { return {}; }
  static constexpr Range positive() { return {0, most, true}; }
  static constexpr Range not_negative() { return {0}; }
  static constexpr Range within(double lowest, double highest) { return {lowest, highest}; }

  [[nodiscard]] constexpr bool holds(double value) const {
    return (open ? value > lowest : value >= lowest) && value <= highest;
  }
  /// The nearest numbers outside, both infinities and NaN.
  [[nodiscard]] std::vector<double> outside() const;
  /// "in [0, 1]", "positive and finite", "finite".
  [[nodiscard]] std::string words() const;
};

/// A member of a struct of parameters.
template <class Parameters>
struct Number {
  std::string_view name;
  double Parameters::*member;
  Range range;
};

/// Throws std::invalid_argument, naming the number, its value and its range.
void require_range(std::string_view name, double value, const Range& range);
/// The same for the first of its numbers that is out of its range.
template <class Parameters>
void require_ranges(const Parameters& parameters) {
  for (const auto& number : Parameters::ranges()) require_range(number.name, parameters.*number.member, number.range);
}

}  // namespace seiche
