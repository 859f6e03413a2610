#include "seiche/mechanics/state.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::mechanics {

std::vector<double> State::nodal_multipliers() const {
  std::vector<double> mean = multipliers;
  if (earlier_multipliers.size() != mean.size()) return mean;
  std::transform(mean.begin(), mean.end(), earlier_multipliers.begin(), mean.begin(),
                 [](double a, double b) { return 0.5 * (a + b); });
  return mean;
}

std::vector<double>& State::next_multipliers() {
  earlier_multipliers.swap(earliest_multipliers);
  multipliers.swap(earlier_multipliers);
  return multipliers;
}

namespace {

void require_array(const char* name, const std::vector<double>& values, std::size_t size) {
  require_that(values.size() == size, "{} has {} entries; the model needs {}", name, values.size(), size);
  const std::size_t bad = first_not_finite(values);
  if (bad < size)
    throw std::invalid_argument(fmt::format("{}[{}] = {}; allowed: finite numbers", name, bad, values[bad]));
}

}  // namespace

void require_state(const State& state, std::size_t coordinates, std::size_t rates) {
  require_array("q", state.q, coordinates);
  require_array("u", state.u, rates);
  require_finite("time", state.time);
}

void require_step(double tau) {
  require_positive("tau", tau);
}

void throw_not_finite(const State& state, Input rates, double place) {
  throw Divergence(fmt::format("rate {} is not finite", first_not_finite(rates)), state.time, state.steps, place);
}

std::size_t first_not_finite(Input values) {
  double nothing = 0;  // x * 0 is 0 for every finite x and NaN otherwise
#pragma omp simd reduction(+ : nothing)
  for (std::size_t i = 0; i < values.size(); ++i) nothing += values[i] * 0.0;
  if (nothing == 0) return values.size();
  const auto bad = std::find_if_not(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
  return static_cast<std::size_t>(bad - values.begin());
}

}  // namespace seiche::mechanics
