#include "seiche/mechanics/equal_steps.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace seiche::mechanics {

void equal_steps_to(State& state, double time, double tau, const std::function<void()>& after_step,
                    const std::function<void(double length)>& advance) {
  require_step(tau);
  if (!(time >= state.time && std::isfinite(time))) {
    throw std::invalid_argument(
        fmt::format("time = {:g}; allowed: finite, at least the present {:g}", time, state.time));
  }
  const double begin = state.time;
  const auto steps = static_cast<long>(std::ceil((time - begin) / tau - 1e-9));
  for (long k = 1; k <= steps; ++k) {
    advance((time - begin) / static_cast<double>(steps));
    if (k == steps) state.time = time;
    if (after_step) after_step();
  }
}

}  // namespace seiche::mechanics
