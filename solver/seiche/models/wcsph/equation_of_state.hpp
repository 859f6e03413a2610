/// Tait's equation of state of a weakly compressible fluid.
///
///     P = B [(rho/rho_0)^gamma - 1],   B = rho_0 c_0^2/gamma,   c = c_0 (rho/rho_0)^((gamma-1)/2)           (5)
///     e = (B/rho_0) [s^(gamma-1)/(gamma-1) + 1/s - gamma/(gamma-1)],   s = rho/rho_0,   de = P/rho^2 d rho
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
