#include "validation/steady_flow/open_ends.hpp"

#include <cmath>

namespace seiche::validation {

evidence::Roundoff open_ends_roundoff(const ChannelReach& reach, long particles, double time) {
  const double water = reach.length * reach.depth;
  const double particle = 2 * water / static_cast<double>(particles);
  const double fastest = reach.celerity + reach.discharge / reach.depth;
  // At a tenth of the Courant number 0.4: steps shorten while a narrow particle leaves.
  const double steps = time * fastest * static_cast<double>(particles) / (0.04 * reach.length);
  const double passed = reach.discharge * time;
  return {.operations = 1,
          .scale = std::hypot(std::sqrt(2 * steps) * particle, std::sqrt(4.0) * (water + passed)),
          .reason =
              "the particles at the two ends, up to twice as large as the others, are rounded at every step; the sums "
              "of present and passed mass once each"};
}

}  // namespace seiche::validation
