#include "validation/instruments/processor_time.hpp"

#include <ctime>

#include "seiche/samples.hpp"

namespace seiche::validation {

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double shortest_time(const std::function<void()>& work) {
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
