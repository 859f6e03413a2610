/// Gerstner's trochoidal wave: exact, of finite amplitude, with vorticity, over infinite depth.
///
/// With k = g = 1 the particle of label (a, b), b <= b0 <= 0, moves on the circle
///
///     x = a - e^b sin(a - t),   y = b + e^b cos(a - t),   u = e^b cos(a - t),   v = e^b sin(a - t);
///
/// the wave travels to +x at speed 1, as the linear one does, whatever its height. b0 is the label of the surface: 0 is
/// the cusped wave. The area of a patch of labels is constant, J = 1 - e^{2b}; pressure p = b0 - b +
/// (e^{2b} - e^{2 b0})/2; vorticity v_x - u_y = 2 e^{2b}/(1 - e^{2b}), against the sense of the orbits.
///
/// When not to use it: irrotational waves (a wave raised from rest by pressure is not Gerstner's), finite depth.
///
/// References: Gerstner, Theorie der Wellen (1804); Rankine, Phil. Trans. 153 (1863) 127; Lamb, Hydrodynamics (1932),
/// section 251.
#pragma once

#include <cmath>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class GerstnerWave {
 public:
  /// Label of a particle [m]: the centre of its circle at t = 0 is (a, b).
  struct Label {
    double a = 0;
    double b = 0;
  };
  /// A place [m] or an acceleration [m/s^2].
  struct Vector {
    double x = 0;
    double y = 0;
  };

  /// @param wavelength [m];  @param gravity [m/s^2];  @param top  label b0 <= 0 of the surface [m]
  /// Throws std::invalid_argument.
  GerstnerWave(double wavelength, double gravity, double top = 0);

  /// Place, velocity and acceleration of a particle. Throw OutsideFluid for b > top.
  [[nodiscard]] Vector position(Label label, double t) const;
  [[nodiscard]] Velocity velocity(Label label, double t) const;
  [[nodiscard]] Vector acceleration(Label label, double t) const;
  /// Pressure over density [m^2/s^2], vorticity v_x - u_y [1/s] and area factor J of a particle: constant in time.
  [[nodiscard]] double pressure(Label label) const;
  [[nodiscard]] double vorticity(Label label) const {
    return 2 * frequency_ * std::exp(2 * wavenumber_ * label.b) / area_factor(label);
  }
  [[nodiscard]] double area_factor(Label label) const;

  /// The particle that is at (x, y) at time t. Throws OutsideFluid above the surface.
  [[nodiscard]] Label label(double x, double y, double t) const;
  /// Level of the surface [m].
  [[nodiscard]] double elevation(double x, double t) const;

  [[nodiscard]] double wavenumber() const { return wavenumber_; }
  /// Angular frequency sqrt(g k) [1/s] and phase speed sqrt(g/k) [m/s].
  [[nodiscard]] double frequency() const { return frequency_; }
  [[nodiscard]] double phase_speed() const { return frequency_ / wavenumber_; }
  /// Height of the crest above the trough [m].
  [[nodiscard]] double height() const { return 2 * radius(top_); }
  [[nodiscard]] double top() const { return top_; }

  /// Of the functions of a label. label() divides round-off by 1 - e^{k top}: at the cusp itself it keeps a
  /// third of the digits.
  [[nodiscard]] double uncertainty() const { return 10 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  void require_below_top(Label label) const;
  /// Sine and cosine of the phase of a particle, times `size`. Throws OutsideFluid.
  [[nodiscard]] Vector turned(Label label, double t, double size) const;
  /// Radius of the circle, e^{k b}/k.
  [[nodiscard]] double radius(double b) const { return std::exp(wavenumber_ * b) / wavenumber_; }
  /// Phase k a - omega t of the particle with label b that is at x.
  [[nodiscard]] double phase_at(double x, double b, double t) const;

  double wavenumber_, gravity_, top_, frequency_;
};

}  // namespace seiche::exact
