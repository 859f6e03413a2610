/// Friction at the bottom of a channel, on the rate p along it at depth H:
///
/// @f[ \dot{p} = - C \frac{|p| \, p}{H} @f]
///
///     manning      C = g n^2/H^(1/3)    n [s/m^(1/3)]; glass 0.009 to 0.01, smooth concrete 0.011 to 0.013
///     chezy        C = g/K^2            K [m^(1/2)/s]
///     quadratic    C = c                c [1], an eighth of the f of Darcy and Weisbach
///
/// Reference: V. T. Chow, Open-Channel Hydraulics, McGraw-Hill (1959), chapter 5.
#pragma once

namespace seiche::dispersive_shallow_water_1d {

enum class FrictionLaw { manning, chezy, quadratic };

struct Friction {
  FrictionLaw law = FrictionLaw::manning;
  double coefficient = 0;  ///< n, K or c; 0 for none, also of chezy

  /// Throws std::invalid_argument for a coefficient that is negative or not finite.
  void validate() const;
  [[nodiscard]] bool active() const { return coefficient > 0; }
  /// C/H [1/m], by which |p| gives the rate of decay.
  [[nodiscard]] double per_length(double gravity, double depth) const;
};

}  // namespace seiche::dispersive_shallow_water_1d
