/// Rounding of frequencies that are fitted to runs of a Lagrangian model.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

#include "reports/evidence/criterion.hpp"
#include "seiche/samples.hpp"

namespace seiche::validation {

/// Of a relative deviation of the frequency. Elevations are counted from still water, so that roundings are relative to
/// the wave. Positions are not: they drift by eps L/6 a step at random (a number x is rounded by eps x/sqrt(12) in the
/// mean square, and x is L/sqrt(3)), which changes the frequency by half of k times the drift, averaged over columns.
/// @param tanks  with half_waves, linear_frequency(), tau; @param columns_of  the number of their columns
template <class Tank, class Columns>
evidence::Roundoff frequency_roundoff(const std::vector<Tank>& tanks, double periods, Columns columns_of) {
  constexpr double of_fit_and_law = 10;  // a hundred roundings
  constexpr double pi = std::numbers::pi;
  Largest scale;
  for (const Tank& tank : tanks) {
    const double steps = 2 * pi * periods / (tank.linear_frequency() * tank.tau);
    const double k_length = pi * static_cast<double>(tank.half_waves);
    const double drift = k_length / 12 * std::sqrt(steps / static_cast<double>(std::invoke(columns_of, tank)));
    scale.add(std::hypot(of_fit_and_law, drift));
  }
  return {.operations = 1,
          .scale = scale.value(),
          .reason =
              "a hundred roundings of fit, extrapolation and relation; positions, of the size of the tank's length L, "
              "drift by eps L/6 at random in every step, and the frequency by k/2 of that, averaged over columns"};
}

}  // namespace seiche::validation
