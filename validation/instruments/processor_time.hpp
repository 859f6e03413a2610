/// Processor time of short computations.
#pragma once

#include <ctime>
#include <functional>

#include "seiche/samples.hpp"

namespace seiche::validation {

/// Processor time that this process has used so far [s].
inline double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Processor time of one call of `work` [s]: the shortest mean of three batches of calls that fill 20 ms each, or of as
/// many as begin within 0.3 s.
inline double shortest_time(const std::function<void()>& work) {
  constexpr double batch_seconds = 0.02;
  constexpr double all_seconds = 0.3;
  const double first = processor_seconds();
  Smallest shortest;
  for (int batch = 0; batch < 3 && processor_seconds() - first < all_seconds; ++batch) {
    int calls = 0;
    const double begin = processor_seconds();
    double spent = 0;
    do {
      work();
      ++calls;
      spent = processor_seconds() - begin;
    } while (spent < batch_seconds);
    shortest.add(spent / calls);
  }
  return shortest.value();
}

}  // namespace seiche::validation
