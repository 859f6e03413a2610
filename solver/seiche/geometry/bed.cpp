#include "seiche/geometry/bed.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace seiche {

void Bed::validate(double start, double end) const {
  if (!elevation || !primitive) throw std::invalid_argument("bed: elevation and primitive must both be given");
  constexpr int samples = 257;
  // Step of a central difference that balances truncation and round-off: eps^(1/3) of the length.
  const double step = 6e-6 * (end - start);
  const auto sample = [&](int k) { return start + (end - start) * (k + 0.5) / samples; };
  double lowest = 0;
  double highest = 0;
  for (int k = 0; k < samples; ++k) {
    lowest = std::min(lowest, elevation(sample(k)));
    highest = std::max(highest, elevation(sample(k)));
  }
  for (int k = 0; k < samples; ++k) {
    const double x = sample(k);
    const double z = elevation(x);
    const double slope = (primitive(x + step) - primitive(x - step)) / (2 * step);
    if (!std::isfinite(z) || !(std::abs(slope - z) <= 1e-6 * (highest - lowest))) {
      throw std::invalid_argument(fmt::format(
          "bed: derivative of the primitive at x = {:g} is {:.9g}, must equal the elevation {:.9g}", x, slope, z));
    }
  }
}

Bed flat_bed() {
  return {[](double) { return 0.0; }, [](double) { return 0.0; }};
}

}  // namespace seiche
