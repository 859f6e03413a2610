/// What dispersion does to long waves.
#pragma once

#include <cmath>

namespace seiche::verification {

/// (1 - c^2)/k^2 as k -> 0, of the phase speed c(k) in units of depth and gravity: 1/3 in water. Extrapolated in k^2
/// from three wavenumbers.
template <class PhaseSpeed>
double long_wave_coefficient(const PhaseSpeed& speed) {
  const auto at = [&](double k) { return (1 - std::pow(speed(k), 2)) / (k * k); };
  return (64 * at(0.05) - 20 * at(0.1) + at(0.2)) / 45;
}

}  // namespace seiche::verification
