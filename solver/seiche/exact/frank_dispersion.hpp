/// Dispersion of the discrete dispersive shallow-water model: markers at spacing s on still water of depth H.
///
/// With h = s/H, kappa = k H, theta = k s/2, nu = omega^2 H/g:
///
///     nu = (1 - beta (1 - cos k s) + 4 gamma sin^2 theta/h^2) 4 tan^2 theta/(4 alpha tan^2 theta + h^2),  k s < pi.
///
/// alpha multiplies the vertical kinetic energy; 1 - 2 beta, the potential energy of a cell's slope; gamma is an added
/// potential energy of slopes. alpha = beta = 1/3, gamma = 0 is formula (13) of the source,
/// nu = (2 + cos k s)/3 * 4 t^2/(h^2 + 4 alpha t^2), t = tan theta. As s -> 0 it is kappa^2 (1 + gamma kappa^2)/
/// (1 + alpha kappa^2), with relative error O(s^2) (for beta = 1/3 the leading one is -alpha kappa^4 h^2/12 in omega).
///
/// A time step tau changes the frequency omega of the semi-discrete model into Omega:
/// one-step scheme sin(Omega tau/2) = omega tau/2, conservative scheme tan(Omega tau/2) = omega tau/2.
///
/// When not to use it: unequal spacing, an uneven bottom, waves of finite amplitude.
///
/// References: Frank, Discrete models of incompressible fluids (1994), ch. 3, formula (13); Madsen and Sorensen,
/// Coastal Eng. 18 (1992) 183 (the idea of tuning to Airy); Hairer, Lubich and Wanner, Geometric numerical integration
/// (2006), I.5 (frequency of the time schemes).
#pragma once

#include "seiche/exact/dispersion.hpp"

namespace seiche::exact {

class FrankDispersion {
 public:
  struct Parameters {
    double alpha = 1.0 / 3;
    double beta = 1.0 / 3;
    double gamma = 0;
  };

  /// @param gravity [m/s^2];  @param depth H [m];  @param spacing s [m]
  /// Throws std::invalid_argument; also for parameters with which the shortest wave would grow.
  FrankDispersion(double gravity, double depth, double spacing, Parameters parameters);
  FrankDispersion(double gravity, double depth, double spacing)
      : FrankDispersion(gravity, depth, spacing, Parameters{}) {}

  /// alpha and gamma that follow Airy's law through kappa^4 (relative) for this spacing and time step of the one-step
  /// scheme, beta = 1/3.
  /// @param time_step tau [s], 0 for the semi-discrete model
  static FrankDispersion tuned(double gravity, double depth, double spacing, double time_step);

  /// Angular frequency [1/s], phase and group speed [m/s] of wavenumber k, 0 < k s < pi.
  [[nodiscard]] double frequency(double k) const;
  [[nodiscard]] double phase_speed(double k) const;
  [[nodiscard]] double group_speed(double k) const;
  /// The law without markers, s -> 0.
  [[nodiscard]] RationalDispersion limit() const;

  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  [[nodiscard]] double spacing() const { return spacing_; }

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  void require_resolved(double k) const;

  double gravity_;
  double depth_;
  double spacing_;
  Parameters parameters_;
};

enum class TimeScheme { one_step, conservative };

/// Frequency Omega [1/s] that a scheme of time step tau gives to a mode of frequency omega. Throws
/// std::invalid_argument for the one-step scheme with omega tau > 2: the mode grows.
double discrete_frequency(double omega, double time_step, TimeScheme scheme);

}  // namespace seiche::exact
