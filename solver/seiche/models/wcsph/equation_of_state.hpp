/// Tait's equation of state of a weakly compressible fluid.
///
/// @f[ P = B \left( s^\gamma - 1 \right), \qquad s = \frac{\rho}{\rho_0}, \qquad
///     B = \frac{\rho_0 c_0^2}{\gamma}, \qquad c = c_0 \, s^{(\gamma - 1)/2} \tag{5} @f]
/// @f[ e = \frac{B}{\rho_0} \left( \frac{s^{\gamma - 1}}{\gamma - 1} + \frac{1}{s} - \frac{\gamma}{\gamma - 1} \right),
///     \qquad de = \frac{P}{\rho^2} \, d\rho @f]
///
/// Reference: Batchelor, An introduction to fluid dynamics (1967), section 1.8; Monaghan, Simulating free surface flows
/// with SPH, J. Comput. Phys. 110 (1994) 399.
#pragma once

namespace seiche::wcsph {

class TaitFluid {
 public:
  /// @param density      rho_0 [kg/m^3]
  /// @param sound_speed  c_0 [m/s] at rho_0
  /// @param exponent     gamma >= 1
  /// Throws std::invalid_argument.
  TaitFluid(double density, double sound_speed, double exponent = 7);

  [[nodiscard]] double pressure(double density) const;        ///< [Pa]
  [[nodiscard]] double density_at(double pressure) const;     ///< inverse of pressure [kg/m^3]
  [[nodiscard]] double sound_speed(double density) const;     ///< [m/s]
  [[nodiscard]] double elastic_energy(double density) const;  ///< per unit mass, 0 at rho_0 [J/kg]
  /// Density in still water, `depth` below the surface: P = rho_0 g depth. Throws std::invalid_argument where the base
  /// 1 + rho_0 g depth/B exceeds 2.
  [[nodiscard]] double hydrostatic_density(double gravity, double depth) const;

  [[nodiscard]] double reference_density() const { return density_; }
  [[nodiscard]] double reference_sound_speed() const { return sound_speed_; }
  [[nodiscard]] double exponent() const { return exponent_; }
  [[nodiscard]] double stiffness() const { return stiffness_; }  ///< B [Pa]

 private:
  double density_;
  double sound_speed_;
  double exponent_;
  double stiffness_;
};

}  // namespace seiche::wcsph
