/// What irregular waves are told by: of a record with its mean taken out, of variance s^2,
///
///     standard deviation s,   skewness mean(eta^3)/s^3,   asymmetry -mean(H(eta)^3)/s^3
///
/// H the Hilbert transform, which turns cos into sin. Waves with peaked crests have positive skewness, waves that pitch
/// forward, whose front comes first and is steep, positive asymmetry.
///
/// Reference: S. Elgar, R. T. Guza, J. Fluid Mech. 161 (1985) 425.
#pragma once

#include <span>

namespace seiche::validation {

struct WaveStatistics {
  double deviation = 0, skewness = 0, asymmetry = 0;
};

/// Of samples at equal instants, at least four, taken for periodic. Throws std::invalid_argument.
WaveStatistics wave_statistics(std::span<const double> samples);

}  // namespace seiche::validation
