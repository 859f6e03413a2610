#include "seiche/mechanics/scheme.hpp"

#include <algorithm>
#include <cmath>

#include "seiche/require_that.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::mechanics {

Stepping stepping_named(std::string_view name) {
  using enum Stepping;
  return value_named<Stepping>(
      "scheme", name,
      {{"one_step", one_step}, {"one_step_feedback", one_step_feedback}, {"conservative", conservative}});
}

TimeComposition composition_named(std::string_view name) {
  using enum TimeComposition;
  return value_named<TimeComposition>("composition", name,
                                      {{"none", none}, {"triple_jump", triple_jump}, {"suzuki", suzuki}});
}

namespace {

SEICHE_SIMD_CLONES
SweepChange largest_change(const double* before, const double* after, std::size_t size) {
  double change = 0;
  double rate = 0;
#pragma omp simd reduction(max : change, rate)
  for (std::size_t i = 0; i < size; ++i) {
    change = std::max(change, std::abs(after[i] - before[i]));
    rate = std::max(rate, std::abs(after[i]));
  }
  return {change, rate};
}

std::vector<double> in_pairs(const std::vector<double>& weights) {
  std::vector<double> halves;
  for (const double weight : weights) halves.insert(halves.end(), 2, weight / 2);
  return halves;
}

}  // namespace

SweepChange change_between(Input before, Input after) {
  return largest_change(before.data(), after.data(), after.size());
}

std::vector<double> triple_jump_weights() {
  const double g = 1 / (2 - std::cbrt(2.0));
  return in_pairs({g, 1 - 2 * g, g});
}

std::vector<double> suzuki_weights() {
  const double g = 1 / (4 - std::cbrt(4.0));
  return in_pairs({g, g, 1 - 4 * g, g, g});
}

}  // namespace seiche::mechanics
