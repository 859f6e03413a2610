/// Largest magnitudes of numbered samples, in which one that is not a number is not lost.
#pragma once

#include <cstddef>
#include <ranges>

#include "seiche/samples.hpp"

namespace seiche::verification {

/// The largest |sample(k)|, k = 0 to count - 1.
template <class Sample>
double worst_of(std::size_t count, const Sample& sample) {
  Worst worst;
  for (std::size_t k = 0; k < count; ++k) worst.add(sample(k));
  return worst.value();
}

/// Of two arrays of the length of the first.
template <std::ranges::random_access_range A, std::ranges::random_access_range B>
double largest_difference(const A& a, const B& b) {
  return worst_of(std::size(a), [&](std::size_t k) { return a[k] - b[k]; });
}

}  // namespace seiche::verification
