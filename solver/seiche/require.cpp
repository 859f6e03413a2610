#include "seiche/require.hpp"

#include "seiche/ranges.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace seiche {

std::vector<double> Range::outside() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> numbers{-infinity, infinity, std::numeric_limits<double>::quiet_NaN()};
  if (lowest > -most) numbers.push_back(open ? lowest : std::nextafter(lowest, -infinity));
  if (highest < most) numbers.push_back(std::nextafter(highest, infinity));
  return numbers;
}

std::string Range::words() const {
  const bool bounded = highest < most;
  if (lowest == -most && !bounded) return "finite";
  if (lowest == 0 && !bounded) return open ? "positive and finite" : "non-negative and finite";
  if (!bounded) return fmt::format("{} {:g} and finite", open ? "above" : "at least", lowest);
  return open ? fmt::format("above {:g} and at most {:g}", lowest, highest)
              : fmt::format("in [{:g}, {:g}]", lowest, highest);
}

void require_range(std::string_view name, double value, const Range& range) {
  if (!range.holds(value)) {
    throw std::invalid_argument(fmt::format("{} = {:.17g} is out of range: must be {}", name, value, range.words()));
  }
}

void require_finite(std::string_view name, double value) {
  require_range(name, value, Range::finite());
}
void require_positive(std::string_view name, double value) {
  require_range(name, value, Range::positive());
}
void require_not_negative(std::string_view name, double value) {
  require_range(name, value, Range::not_negative());
}

void require_within(std::string_view name, double value, double lowest, double highest) {
  require_range(name, value, Range::within(lowest, highest));
}

void require_at_least(std::string_view name, long value, long lowest) {
  if (value < lowest) {
    throw std::invalid_argument(fmt::format("{} = {} is out of range: must be at least {}", name, value, lowest));
  }
}

}  // namespace seiche
