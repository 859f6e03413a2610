#include "validation/breakwater/harmonic.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

namespace seiche::validation {

std::complex<double> harmonic(std::span<const double> time, std::span<const double> values, double frequency,
                              long periods) {
  if (time.size() != values.size() || time.size() < 4) {
    throw std::invalid_argument(
        fmt::format("{} times and {} values; allowed: as many, at least 4", time.size(), values.size()));
  }
  const double length = 2 * std::numbers::pi / frequency * static_cast<double>(periods);
  const double step = time[1] - time[0];
  const double begin = time.back() - length;
  if (begin < time.front() - 2.5 * step) {  // weights next to the ends are nothing
    throw std::invalid_argument(fmt::format("a history of {:g}; allowed: at least {} periods, {:g}",
                                            time.back() - time.front(), periods, length));
  }
  std::complex<double> sum = 0;
  double weights = 0;
  for (std::size_t n = 0; n < time.size(); ++n) {
    if (time[n] < begin) continue;
    const double weight = 1 - std::cos(2 * std::numbers::pi * (time[n] - begin) / length);
    sum += weight * values[n] * std::polar(1.0, frequency * time[n]);
    weights += weight;
  }
  return 2.0 * sum / weights;
}

}  // namespace seiche::validation
