/// Waves out of a channel's level part by a force along the bottom, which make a given record at a place to the right.
///
/// A force per unit mass S(x) F(t), S = exp(-(x - x_s)^2/(2 w^2)), obeys in small waves over the depth h
///
/// @f[ (1 - \alpha h^2 \partial_x^2) u_t + g (1 - \gamma h^2 \partial_x^2) y_x = S F, \qquad y_t + h u_x = 0 @f]
///
/// and sends waves both ways. Those of F = exp(i omega t) are to the right of it, k the wavenumber of omega,
///
/// @f[ y = \frac{w \sqrt{2 \pi} e^{-k^2 w^2/2}}{2 (g + 2 g \gamma h^2 k^2 - \omega^2 \alpha h)} e^{i (\omega t - k x)}
/// @f]
///
/// (the residue at k), and the water's surface (water_surface.hpp) is that much higher. So F follows from the Fourier
/// coefficients of the record, which is taken for periodic; between its finer samples it is linear in time.
///
/// When not to use it: waves shorter than a few w, which would need too strong a force; high waves, whose own harmonics
/// the linear source makes once more as free ones; markers must be able to leave the waves on its left to something.
#pragma once

#include <span>
#include <vector>

#include "seiche/models/dispersive_shallow_water_1d/channel.hpp"

namespace seiche::dispersive_shallow_water_1d {

struct WaveSourcePlace {
  double depth = 1;    ///< still, constant from the source to the target [m]
  double source = 0;   ///< x_s [m]
  double width = 0.1;  ///< w [m]
  double target = 1;   ///< where the record is to be made [m]
};

class WaveSource {
 public:
  /// @param record    elevation of the water's surface at the target [m] at equal instants from t = 0, repeated for
  /// ever
  /// @param interval  between them [s]
  /// @param lowest, highest  frequencies that count [Hz], highest below half of the sampling rate
  /// Throws std::invalid_argument.
  WaveSource(const Channel& channel, const WaveSourcePlace& place, std::span<const double> record, double interval,
             double lowest, double highest);

  /// S(x) F(t) [m/s^2].
  [[nodiscard]] double force(double x, double time) const;
  /// S(x) and F(t) by themselves.
  [[nodiscard]] double shape(double x) const;
  [[nodiscard]] double strength(double time) const;

 private:
  WaveSourcePlace place_;
  double step_;  // between samples of F
  std::vector<double> strength_;
};

/// Of the water's surface over the elevation of the markers, of small waves over water of one depth, kh their
/// wavenumber times it.
double surface_of_wave(double gamma, double kh);

/// Second harmonic of the markers' y in a wave of permanent form over water of depth 1, over its amplitude's square.
/// @param power  s of the channel
double bound_second_harmonic(double alpha, double gamma, double power, double kh);

/// Wavenumber of small waves with gamma and alpha of the channel. Throws std::invalid_argument where there is none.
double small_wavenumber(const Channel& channel, double depth, double omega);

}  // namespace seiche::dispersive_shallow_water_1d
