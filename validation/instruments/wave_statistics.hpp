/// What irregular waves are told by: of a record with its mean taken out, of variance s^2,
///
///     standard deviation s,   skewness mean(eta^3)/s^3,   asymmetry -mean(H(eta)^3)/s^3
///
/// H the Hilbert transform, which turns cos into sin. Waves with peaked crests have positive skewness, waves that pitch
/// forward, whose front comes first and is steep, positive asymmetry.
///
/// Reference: S. Elgar, R. T. Guza, J. Fluid Mech. 161 (1985) 425.
#pragma once

#include <cmath>
#include <complex>
#include <span>
#include <vector>

#include "seiche/linear/fourier.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::validation {

struct WaveStatistics {
  double deviation = 0, skewness = 0, asymmetry = 0;
};

/// Of samples at equal instants, at least four, taken for periodic. Throws std::invalid_argument.
inline WaveStatistics wave_statistics(std::span<const double> samples) {
  require_at_least("number of samples", static_cast<long>(samples.size()), 4);
  const std::size_t n = samples.size();
  linear::Fourier fourier(n);
  std::vector<std::complex<double>> wave(samples.begin(), samples.end());
  fourier.coefficients(wave, wave);
  // The analytic signal eta + i H(eta): twice the positive frequencies.
  wave[0] = 0;
  for (std::size_t i = 1; i < n; ++i) {
    wave[i] *= fourier.is_sawtooth(i) ? 1.0 : fourier.wavenumber(i) > 0 ? 2.0 : 0.0;
  }
  fourier.samples(wave, wave);
  Mean square, cube, turned;
  for (const std::complex<double>& one : wave) {
    square.add(std::pow(one.real(), 2));
    cube.add(std::pow(one.real(), 3));
    turned.add(std::pow(one.imag(), 3));
  }
  const double deviation = std::sqrt(square.value());
  return {deviation, cube.value() / std::pow(deviation, 3), -turned.value() / std::pow(deviation, 3)};
}

}  // namespace seiche::validation
