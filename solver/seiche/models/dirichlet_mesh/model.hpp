/// Discrete incompressible fluid of Dirichlet (Voronoi) cells (Frank 1994, 5.2).
///
/// Nodes carry fixed masses, and the cell of every node keeps its area:
///
/// @f[ m_i \ddot{\mathbf{r}}_i = \sum_j \lambda_j \frac{\partial A_j}{\partial \mathbf{r}_i}
///                             - \frac{\partial \Pi}{\partial \mathbf{r}_i}, \qquad A_i = m_i/\rho, \qquad
///     \Pi = \rho g \sum_{ab} \frac{(x_a - x_b)(y_a^2 + y_a y_b + y_b^2)}{6} @f]
///
/// with the sum over the edges ab of the outline, counter-clockwise. Neighbours are those of the moment: the
/// triangulation is kept Delaunay by local flips (geometry/moving_triangulation.hpp). Pi is the exact energy of the
/// polygon of water, counted from y = 0, and lambda the dynamic pressure p + rho g y: water at rest with its surface at
/// y = 0 stays so bit by bit on any mesh, with another level to round-off.
///
/// **Singular meshes.** On a lattice that is symmetric about its nodes there are pressures without forces (chequered
/// ones): A = G W G^T is singular there and nearly so beside, where a little of a velocity gets a spurious constraint.
/// Stabilisation solves
///
/// @f[ \left(A + \epsilon \frac{\mathrm{tr} A}{N} L^T L\right) \lambda = \dots, \qquad
///     L \lambda = \lambda_i - \text{mean of its neighbours} @f]
///
/// instead. Smooth pressures are touched by epsilon (kh)^2; it takes the energy stabilisation_loss() from the water, in
/// each step an amount that is known, and the areas drift. 0.1 for the pressure at one instant and for small waves,
/// 0.01 for waves that travel, 0 where energy is to be exact: the lattice must not be singular then.
///
/// Conserves, stepped by mechanics::OneStep: mass; linear and angular momentum of a free body to round-off, with any
/// stabilisation; without gravity, energy and what the stabilisation took to round-off; energy under gravity to
/// O(tau^2). Areas drift by O(tau^2) without stabilisation; with it at a rate of its own.
///
/// The class is what mechanics::OneStep steps: q = (x of all nodes, y of all nodes), u = (velocities along x, along y).
/// The triangulation follows whatever configuration is asked about: one thread at a time, even for const functions.
///
/// When not to use it: waves that are not small. The offset of a node in its cell feels no restoring force: a standing
/// wave of height 0.1 in depth 1 breaks down after a period, whatever the time step. Changes of the outline: water that
/// meets water or a wall. Those end as an Infeasible configuration that names the triangle.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapters 1 and 5.2.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "seiche/geometry/dirichlet_cells.hpp"
#include "seiche/geometry/moving_triangulation.hpp"
#include "seiche/linear/ring_solver.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/models/dirichlet_mesh/mesh.hpp"

namespace seiche::dirichlet_mesh {

using mechanics::Input;
using mechanics::Interval;
using mechanics::Output;

struct Settings {
  double gravity = 1;          ///< [m/s^2]
  double density = 1;          ///< [kg/m^3]
  double stabilisation = 0.1;  ///< epsilon
  linear::RingMethod solver = linear::RingMethod::automatic;
  double tolerance = 1e-13;  ///< relative residual of the iterative solver: a looser one breaks the balance of energy
};

/// Velocity of the water at a place; empty: at rest.
using VelocityAt = std::function<Point(Point place)>;

class Model {
 public:
  /// Throws std::invalid_argument (mesh.hpp, polygon_triangulation.hpp): settings out of range, a cell without area,
  /// the iterative solver without stabilisation, which cannot tell that a lattice is singular.
  explicit Model(const Mesh& mesh, Settings settings = {});

  static constexpr bool warm_start = true;

  /// The mesh as it was given with these velocities at its nodes; what walls forbid is taken out, the projection on
  /// constant areas is mechanics/start.hpp's.
  [[nodiscard]] mechanics::State state(const VelocityAt& velocity = {}, double time = 0) const;

  // What mechanics/constrained_model.hpp asks for.
  [[nodiscard]] std::size_t coordinates() const { return 2 * nodes(); }
  [[nodiscard]] std::size_t rates() const { return 2 * nodes(); }
  [[nodiscard]] std::size_t constraints() const { return nodes(); }
  /// Throws mechanics::Infeasible where the mesh tangles, and without stabilisation where A is singular.
  void linearise(Interval when, Input q);
  /// The triangulation goes along: where it tangles, mechanics::Infeasible before `to` is touched.
  void advance(Input from, Input u, double h, Output to) const;
  void kick(double h, Output u) const;
  void constraint_rates(Input u, Output w) const;
  void react(Input mu, Output u) const;
  void solve(Input right_hand_side, Output mu);
  /// A_i - m_i/rho.
  void constraint_values(Input q, Output f) const;
  [[nodiscard]] double place(std::size_t rate) const { return first_x_[rate % nodes()]; }

  [[nodiscard]] double mass() const;                                             ///< [kg/m]
  [[nodiscard]] std::array<double, 2> momentum(Input q, Input u) const;          ///< [kg/s]
  [[nodiscard]] std::array<double, 1> angular_momentum(Input q, Input u) const;  ///< about the origin [kg m/s]
  [[nodiscard]] double kinetic_energy(Input q, Input u) const;                   ///< [J/m]
  [[nodiscard]] double potential_energy(Input q) const;                          ///< [J/m]

  /// Energy that the stabilisation takes in a step with these impulses of the multipliers, at the last linearisation
  /// [J/m]: 2 mu.(epsilon tr A/N) L^T L mu. Never negative.
  [[nodiscard]] double stabilisation_loss(Input impulses) const;

  [[nodiscard]] std::size_t nodes() const { return mass_.size(); }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] std::span<const double> masses() const { return mass_; }
  [[nodiscard]] std::span<const int> outline() const { return outline_; }
  /// Cells at the last linearisation.
  [[nodiscard]] const DirichletCells& cells() const { return cells_; }
  [[nodiscard]] const linear::RingSolver& solver() const { return solver_; }
  /// A with its stabilisation, of the last linearisation.
  [[nodiscard]] const linear::RingMatrix& matrix() const { return matrix_; }
  /// Where the triangulation was last asked to be.
  [[nodiscard]] const MovingTriangulation& triangulation() const { return triangulation_; }
  [[nodiscard]] MeshQuality quality(Input q) const;

 private:
  /// Inverse mass of a node: singular along the normal of a wall, zero in a corner.
  struct Inertia {
    double xx, xy, yy;
    [[nodiscard]] Point operator()(Point force) const {
      return {xx * force.x + xy * force.y, xy * force.x + yy * force.y};
    }
  };

  [[nodiscard]] Places places(Input q) const { return {q.first(nodes()), q.last(nodes())}; }
  /// Throws mechanics::Infeasible.
  void follow(Input q) const;
  void assemble_and_factor();
  void gather_forces(Places at);
  [[noreturn]] void throw_singular(double pivots) const;

  Settings settings_;
  std::vector<double> first_x_, first_y_;
  std::vector<int> outline_;
  mutable MovingTriangulation triangulation_;
  mutable std::vector<double> next_;
  long connected_flips_ = -1;  // of the triangulation, when the cells were connected
  DirichletCells cells_;
  std::vector<double> area_;  // to keep
  std::vector<double> mass_;
  std::vector<Inertia> inertia_;
  std::vector<Point> response_;  // W dA_i/dr_k, entry by entry of the rings
  std::vector<Point> force_;     // of gravity
  double stiffness_ = 0;         // epsilon tr A/N
  linear::RingMatrix matrix_;
  linear::RingSolver solver_;
};

/// Dynamic pressure p + rho g y of water that is at rest and let go at this instant, cell by cell [Pa]. Throws
/// std::invalid_argument for a state of other lengths, mechanics::Infeasible.
std::vector<double> pressure_of_release(Model& model, const mechanics::State& rest);

}  // namespace seiche::dirichlet_mesh
