/// Crests of a sampled curve and the period of a signal.
#pragma once

#include <span>
#include <vector>

namespace seiche::validation {

struct CurveCrest {
  double place = 0;
  double height = 0;
};

/// Local maxima above `threshold`, each by the parabola through a sample and its neighbours; of equal neighbouring
/// samples the first. x ascends, not necessarily in equal steps.
std::vector<CurveCrest> crests_above(double threshold, std::span<const double> x, std::span<const double> y);

/// Pearson's correlation coefficient; NaN where either is constant.
double correlation(std::span<const double> a, std::span<const double> b);

struct Period {
  double length = 0;       ///< NaN if the signal does not come back
  double correlation = 0;  ///< of the signal with itself one period later
};

/// Period of a signal sampled every `interval`: the first peak of its autocorrelation, beyond the first zero, that
/// reaches nine tenths of the highest. Lags go up to half of the signal; what overlaps is correlated.
Period period_of(std::span<const double> samples, double interval);

/// Frequency omega [1/s] by least squares of a_{n+1} + a_{n-1} = (2 - omega^2 tau^2) a_n, with amplitudes a_n after
/// steps of tau [s]: free of the time step of a symmetric scheme.
double frequency_of(std::span<const double> amplitudes, double tau);

double mean(std::span<const double> values);
/// Distances between neighbouring crests.
std::vector<double> distances(std::span<const CurveCrest> crests);
/// Largest deviation of values from their mean, relative to it; NaN for fewer than two.
double relative_spread(std::span<const double> values);

}  // namespace seiche::validation
