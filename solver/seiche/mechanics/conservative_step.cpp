#include "seiche/mechanics/conservative_step.hpp"

#include <algorithm>
#include <cmath>

#include "seiche/simd_clones.hpp"

namespace seiche::mechanics {

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

}  // namespace

SweepChange change_between(Input before, Input after) {
  return largest_change(before.data(), after.data(), after.size());
}

}  // namespace seiche::mechanics
