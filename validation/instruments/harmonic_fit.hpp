/// Frequency of an oscillation that was sampled at equal times.
///
/// Least squares of  a(t) = c + sum_m (A_m cos m Omega t + B_m sin m Omega t),  m of a given list, by Gauss and
/// Newton's method on all of them, Omega included. It starts from
///
///     2 cos(Omega tau) = sum a_n (a_{n-1} + a_{n+1})/sum a_n^2,
///
/// which is exact for a single oscillation. White noise of standard deviation s leaves Omega uncertain by
/// s sqrt(24/N)/(|a| T), N samples over the time T.
///
/// When not to use it: damped oscillations; several frequencies that are no multiples of one; less than a period;
/// m Omega tau near a multiple of pi for one of the m.
#pragma once

#include <span>
#include <vector>

namespace seiche::validation {

struct Oscillation {
  double frequency = 0;  ///< Omega [1/s]
  double amplitude = 0;  ///< sqrt(A_1^2 + B_1^2)
  double misfit = 0;     ///< root mean square of what the fit leaves, over the amplitude
};

/// @param samples    at t = 0, tau, 2 tau, ...
/// @param harmonics  the m, the first of them 1
/// Throws std::invalid_argument for fewer samples than twice the unknowns, std::runtime_error if the fit does not
/// converge.
Oscillation fit_oscillation(std::span<const double> samples, double tau, const std::vector<int>& harmonics = {1});

}  // namespace seiche::validation
