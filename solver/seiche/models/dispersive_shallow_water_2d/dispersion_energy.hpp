/// Improved dispersion of the plan model: an energy of the surface's slope beside the potential energy,
///
/// @f[ \Pi_\gamma = \frac{g \gamma}{2} \int H^2 |\nabla z|^2 dA = \sum_s \frac{g \gamma V_s^2}{8}
/// \frac{|\mathbf{D}|^2}{A^3},
///     \qquad \mathbf{D} = (z_2 - z_0)(\mathbf{r}_3 - \mathbf{r}_1) - (z_3 - z_1)(\mathbf{r}_2 - \mathbf{r}_0) @f]
///
/// of cells of volume V and area A with corners r_0..r_3 in plan; |D|/(2 A) is the slope of the surface between the two
/// diagonals. To be used with alpha = 1/3 + gamma: linear waves over a level bottom then obey
///
///     omega^2 = g H K^2 (G + gamma H^2 Q)/(1 + alpha H^2 K^2),   s_i, c_i = sin, cos(k_i h_i/2)
///     Q = (2 s_1 c_2/h_1)^2 + (2 s_2 c_1/h_2)^2,   K, G of exact/plan_dispersion.hpp
///
/// and gamma = 1/15 is Airy's law to the fourth order of k H (Madsen and Sorensen 1992). For waves along an axis it is
/// the energy of dispersive_shallow_water_1d with s = 2.
///
/// Water at rest feels nothing of it. The discrete gradient between two configurations is exact: with S = |D|^2 and
/// Y = A^-3, S Y changes by mean(Y) times the change of S and mean(S) times that of Y.
///
/// Reference: P. A. Madsen, O. R. Sorensen, A new form of the Boussinesq equations with improved linear dispersion
/// characteristics, part 2, Coastal Eng. 18 (1992) 183.
#pragma once

#include <cstddef>
#include <span>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::dispersive_shallow_water_2d {

class DispersionEnergy {
 public:
  /// @param gamma  0 for none. Throws std::invalid_argument for a negative one.
  DispersionEnergy(plan_lattice::Shape shape, double gamma);

  [[nodiscard]] bool active() const { return gamma_ > 0; }
  /// Of all cells, over g. @param volumes  of the cells
  [[nodiscard]] double value(std::span<const double> volumes, mechanics::Input q) const;
  /// Adds the forces to those on the nodes along x, y, z: the discrete gradient between q0 and q1, for q0 = q1 the
  /// gradient.
  void push(std::span<const double> volumes, mechanics::Input q0, mechanics::Input q1, double gravity,
            mechanics::Output forces) const;

 private:
  plan_lattice::Shape shape_;
  double gamma_;
};

}  // namespace seiche::dispersive_shallow_water_2d
