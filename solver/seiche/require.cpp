#include "seiche/require.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace seiche {
namespace {

[[noreturn]] void reject(std::string_view name, double value, const std::string& range) {
  throw std::invalid_argument(fmt::format("{} = {:.17g} is out of range: must be {}", name, value, range));
}

}  // namespace

void require_finite(std::string_view name, double value) {
  if (!std::isfinite(value)) reject(name, value, "finite");
}

void require_positive(std::string_view name, double value) {
  if (!(std::isfinite(value) && value > 0)) reject(name, value, "positive and finite");
}

void require_not_negative(std::string_view name, double value) {
  if (!(std::isfinite(value) && value >= 0)) reject(name, value, "non-negative and finite");
}

void require_within(std::string_view name, double value, double lowest, double highest) {
  if (!(value >= lowest && value <= highest)) reject(name, value, fmt::format("in [{:g}, {:g}]", lowest, highest));
}

void require_at_least(std::string_view name, long value, long lowest) {
  if (value < lowest) {
    throw std::invalid_argument(fmt::format("{} = {} is out of range: must be at least {}", name, value, lowest));
  }
}

}  // namespace seiche
