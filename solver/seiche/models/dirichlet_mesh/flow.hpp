/// A flow of the Dirichlet mesh: water in cells, stepped by Frank's one-step scheme.
///
///     Flow flow(free_lagrangian::layer_mesh({.begin = 0, .end = 3, .columns = 24, .rows = 8}),
///               [](Point r) { return Point{0.01 * std::sin(r.x), 0}; });
///     while (flow.time() < 20) flow.advance(0.05);
///
/// The first velocities are projected on constant areas. What the stabilisation and the feedback of the drift do to the
/// energy is booked: energy() + stabilisation_loss() - drift_work() is kept to round-off without gravity, and to
/// O(tau^2) with it. Throws std::invalid_argument for bad input, a singular mesh without stabilisation among it, and
/// Divergence, with time, step and place, when the mesh tangles or a value is not finite.
#pragma once

#include <memory>

#include "seiche/free_lagrangian/cell_water.hpp"
#include "seiche/mechanics/plane_flow.hpp"

namespace seiche::dirichlet_mesh {

// Discrete incompressible fluid of Dirichlet (Voronoi) cells (Frank 1994, 5.2).
//
// Nodes carry fixed masses, and the cell of every node keeps its area:
//
// @f[ m_i \ddot{\mathbf{r}}_i = \sum_j \lambda_j \frac{\partial A_j}{\partial \mathbf{r}_i}
//                             - \frac{\partial \Pi}{\partial \mathbf{r}_i}, \qquad A_i = m_i/\rho, \qquad
//     \Pi = \rho g \sum_{ab} \frac{(x_a - x_b)(y_a^2 + y_a y_b + y_b^2)}{6} @f]
//
// with the sum over the edges ab of the outline, counter-clockwise. Neighbours are those of the moment: the
// triangulation is kept Delaunay by local flips (geometry/triangulation.hpp). Pi is the exact energy of the
// polygon of water, counted from y = 0, and lambda the dynamic pressure p + rho g y: water at rest with its surface at
// y = 0 stays so bit by bit on any mesh, with another level to round-off.
//
// **Singular meshes.** On a lattice that is symmetric about its nodes there are pressures without forces (chequered
// ones): A = G W G^T is singular there and nearly so beside, where a little of a velocity gets a spurious constraint.
// Stabilisation solves
//
// @f[ \left(A + \epsilon \frac{\mathrm{tr} A}{N} L^T L\right) \lambda = \dots, \qquad
//     L \lambda = \lambda_i - \text{mean of its neighbours} @f]
//
// instead. Smooth pressures are touched by epsilon (kh)^2; it takes the energy stabilisation_loss() from the water, in
// each step an amount that is known, and the areas drift. 0.1 for the pressure at one instant and for small waves,
// 0.01 for waves that travel, 0 where energy is to be exact: the lattice must not be singular then.
//
// Conserves, stepped by mechanics::OneStep: mass; linear and angular momentum of a free body to round-off, with any
// stabilisation; without gravity, energy and what the stabilisation took to round-off; energy under gravity to
// O(tau^2). Areas drift by O(tau^2) without stabilisation; with it at a rate of its own.
//
// When not to use it: waves that are not small. The offset of a node in its cell feels no restoring force: a standing
// wave of height 0.1 in depth 1 breaks down after a period, whatever the time step. Changes of the outline: water that
// meets water or a wall. Those end as an Infeasible configuration that names the triangle.
//
// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapters 1 and 5.2.

using free_lagrangian::Mesh;
using free_lagrangian::Settings;
using free_lagrangian::VelocityAt;
using Model = free_lagrangian::CellWater;

class Flow : public mechanics::OneStepFlow<Model> {
 public:
  /// @param drift_feedback  share of the drift of the areas that a step takes back, in [0, 1]; 0.2 is enough
  explicit Flow(const Mesh& mesh, const VelocityAt& velocity = {}, Settings settings = {}, double drift_feedback = 0)
      : OneStepFlow(std::make_unique<Model>(mesh, settings), velocity, drift_feedback) {}

  [[nodiscard]] long flips() const { return model_->triangulation().flips(); }
};

}  // namespace seiche::dirichlet_mesh
