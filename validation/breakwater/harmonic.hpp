/// The part of a history that oscillates with a known frequency.
///
///     A = 2 sum w v exp(i omega t)/sum w,   v = Re(A exp(-i omega t)),
///
/// over the last whole periods, weights w = 1 - cos(2 pi (t - begin)/(end - begin)): means and harmonics drop out, and
/// what has another frequency falls with the cube of its distance.
///
/// When not to use it: less than two periods; a frequency that is to be found (instruments/harmonic_fit.hpp).
#pragma once

#include <complex>
#include <span>

namespace seiche::validation {

/// @param time  in equal steps that divide the period, or many of them
/// Throws std::invalid_argument where the history is shorter than that.
std::complex<double> harmonic(std::span<const double> time, std::span<const double> values, double frequency,
                              long periods);

}  // namespace seiche::validation
