/// A cell of the plan model: the water of a column between the bilinear surface and the bottom.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/geometry/vector.hpp"
#include "seiche/lattice/cell_rows.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::dispersive_shallow_water_2d {

struct Column : lattice::StoredGradients {
  static constexpr std::size_t axes = 3, corners = 4, stored = 12, mobilities = 6, momenta = 2, turns = 1;

  static void run(const lattice::RowLoop<Column>& loop);
};

/// Inverse masses W of the nodes, symmetric 3 x 3.
struct InverseMasses {
  explicit InverseMasses(std::size_t nodes) {
    for (auto* w : {&xx, &yy, &zz, &xy, &xz, &yz}) w->assign(nodes, 0.0);
  }
  void put(std::size_t k, const std::array<double, 6>& w) {
    xx[k] = w[0], yy[k] = w[1], zz[k] = w[2], xy[k] = w[3], xz[k] = w[4], yz[k] = w[5];
  }
  std::vector<double> xx, yy, zz, xy, xz, yz;
};

/// Gradients of the volumes of a row over the level z = bottom, times `weight`, added to what is there if `add`.
/// Returns the smallest corner Jacobian.
double measure_row(std::size_t columns, const lattice::NodeVectors<Column>& r, double bottom, double weight, bool add,
                   linear::RowBlocks::Row gradients);

// The volume between the level z = 0 and an uneven bottom, cell by cell, as a sum over directed edges p -> q:
//
//     int b dA = sum of E_pq,   E_pq = (y_q - y_p) int_0^1 B(x(t), y(t)) dt,   B_x = b
//
// by Gauss's rule of three points, exact for bottoms of degree 4. Edges cancel between neighbours, so that inner nodes
// of raised water at rest feel no force, whatever the error of the rule.
//
// Discrete gradients over a way: what Simpson's mean lacks of E's difference is divided by the way. B counts from far
// away, and the difference of two E has the round-off of |B|, which a short way would make a force: a step's sweeps
// then never settle. So only differences of B over the way enter, which are as short as it is.

/// Makes a mean gradient over a way a discrete one, gradient times way a difference: what it lacks is added along the
/// way. Less than what is `rounded`, divided by a short way, would become a force.
template <std::size_t n>
void complete(std::array<double, n>& gradient, const std::array<double, n>& way, double difference,
              double rounded = 0) {
  double square = 0;
  for (std::size_t k = 0; k < n; ++k) {
    difference -= gradient[k] * way[k];
    square += way[k] * way[k];
  }
  if (!(std::abs(difference) > rounded)) return;
  for (std::size_t k = 0; k < n; ++k) gradient[k] += difference / square * way[k];
}

class BottomVolume {
 public:
  BottomVolume(plan_lattice::Shape shape, std::shared_ptr<const PlanBottom> bottom);

  /// Subtracts the gradients of the volumes from those of the cells, in rows: at q0 if q1 is the same, else discrete
  /// gradients over the segment: Simpson's mean, corrected along the segment so that gradient times segment is the
  /// difference of the volumes to round-off.
  void subtract_gradients(mechanics::Input q0, mechanics::Input q1, linear::RowBlocks& gradients) const;
  /// int b dA over the quadrilateral of these corners.
  [[nodiscard]] double volume(const std::array<Point, 4>& at) const;

 private:
  /// E, its derivatives with respect to x_p, y_p, x_q, y_q but for what B itself gives, and the integral of B over the
  /// edge's parameter: of the derivatives -B belongs to y_p and B to y_q.
  struct Edge {
    double value = 0;
    double xp = 0, yp = 0, xq = 0, yq = 0;
    double integral = 0;

    [[nodiscard]] Point at_p() const { return {xp, yp - integral}; }
    [[nodiscard]] Point at_q() const { return {xq, yq + integral}; }
  };

  using Ends = std::array<Point, 2>;  ///< p, q
  [[nodiscard]] Edge edge(const Ends& at) const;
  [[nodiscard]] Edge edge_between(const Ends& from, const Ends& to) const;

  plan_lattice::Shape shape_;
  std::shared_ptr<const PlanBottom> bottom_;
};

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
///     Q = (2 s_1 c_2/h_1)^2 + (2 s_2 c_1/h_2)^2,   K, G of exact/lattice_dispersion.hpp
///
/// and gamma = 1/15 is Airy's law to the fourth order of k H (Madsen and Sorensen 1992). For waves along an axis it is
/// the energy of dispersive_shallow_water_1d with s = 2.
///
/// Water at rest feels nothing of it. The discrete gradient between two configurations is exact: with S = |D|^2 and
/// Y = A^-3, S Y changes by mean(Y) times the change of S and mean(S) times that of Y.
///
/// Reference: P. A. Madsen, O. R. Sorensen, A new form of the Boussinesq equations with improved linear dispersion
/// characteristics, part 2, Coastal Eng. 18 (1992) 183.
/// Of all cells, over g. @param volumes  of the cells
double dispersion_energy(const plan_lattice::Shape& shape, double gamma, std::span<const double> volumes,
                         mechanics::Input q);
/// Adds the forces to those on the nodes along x, y, z: the discrete gradient between q0 and q1, for q0 = q1 the
/// gradient. @param weight  g gamma
void push_dispersion(const plan_lattice::Shape& shape, double weight, std::span<const double> volumes,
                     mechanics::Input q0, mechanics::Input q1, mechanics::Output forces);

/// A cell's diagonals, a from corner 0 to 2 and b from 1 to 3.
struct Diagonals {
  Vector3 a, b;

  Diagonals(mechanics::Input q, const plan_lattice::Shape& shape, std::size_t cell);
  [[nodiscard]] Point d() const { return {a.z * b.x - b.z * a.x, a.z * b.y - b.z * a.y}; }
  [[nodiscard]] double area() const { return 0.5 * (a.x * b.y - b.x * a.y); }
};

}  // namespace seiche::dispersive_shallow_water_2d
