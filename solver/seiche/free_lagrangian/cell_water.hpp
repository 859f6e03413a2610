/// Water in Dirichlet cells as a mechanical system: masses at nodes, the potential energy of the polygon of water,
/// cells that keep their areas.
///
/// @f[ m_i \ddot{\mathbf{r}}_i = \sum_j \lambda_j \frac{\partial A_j}{\partial \mathbf{r}_i}
///                             - \frac{\partial \Pi}{\partial \mathbf{r}_i}, \qquad A_i = m_i/\rho @f]
///
/// Pressures keep the areas (mechanics/ring_constraints.hpp), G = dA_i/dr_k, with a stabilisation in which
///
/// @f[ L \mu = \mu_i - \text{mean of its neighbours}; @f]
///
/// on lattices symmetric about their nodes there are pressures without forces. The neighbours are those of the moment:
/// the triangulation goes along with whatever places are asked about, by flips. Pi is potential_energy's. This is what
/// mechanics::OneStep steps: q = (x of all nodes, y of all nodes), u = (velocities along x, along y). A model whose
/// masses change sets them between its steps.
///
/// The triangulation follows whatever configuration is asked about: one thread at a time, even for const functions.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "seiche/free_lagrangian/mesh.hpp"
#include "seiche/geometry/dirichlet_cells.hpp"
#include "seiche/geometry/triangulation.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/ring_constraints.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/ranges.hpp"

namespace seiche::free_lagrangian {

/// How a node answers a force: by 1/mass, along its wall alone, or not at all in a corner.
struct Mobility {
  double xx = 0;
  double xy = 0;
  double yy = 0;

  [[nodiscard]] Point operator()(Point force) const {
    return {xx * force.x + xy * force.y, xy * force.x + yy * force.y};
  }
  [[nodiscard]] Mobility over(double mass) const { return {xx / mass, xy / mass, yy / mass}; }
};

/// Projections on what the walls of a mesh leave free, one per node: mobilities for unit masses.
std::vector<Mobility> freedoms(const Mesh& mesh);

// Gravity of the polygon of water within an outline of nodes: its exact potential energy, counted from y = 0, and the
// forces on the nodes (Frank 1994, formula 7).
//
// @f[ \Pi = \rho g \sum_{ab} \frac{(x_a - x_b)(y_a^2 + y_a y_b + y_b^2)}{6}, @f]
//
// the sum over the edges ab of the outline, counter-clockwise.

/// @param weight  rho g
double potential_energy(Places at, std::span<const int> outline, double weight);

/// -dPi/dr of all nodes, in place of what is there.
void gravity_forces(Places at, std::span<const int> outline, double weight, std::vector<Point>& force);

using mechanics::Input;
using mechanics::Interval;
using mechanics::Output;
using mechanics::VelocityAt;

struct Settings {
  double gravity = 1;          ///< [m/s^2]
  double density = 1;          ///< [kg/m^3]
  double stabilisation = 0.1;  ///< epsilon

  static constexpr auto ranges() {
    return std::array{Number{"gravity", &Settings::gravity, Range::not_negative()},
                      Number{"density", &Settings::density, Range::positive()},
                      Number{"stabilisation", &Settings::stabilisation, Range::not_negative()}};
  }
};

class CellWater : public mechanics::PointMasses<CellWater> {
 public:
  /// Throws std::invalid_argument: settings out of range, bad meshes.
  explicit CellWater(const Mesh& mesh, Settings settings = {});

  static constexpr bool warm_start = true;

  // What mechanics/constrained_model.hpp asks for.
  [[nodiscard]] std::size_t constraints() const { return nodes(); }
  /// Throws mechanics::Infeasible where the mesh tangles, and without stabilisation where A is singular.
  void linearise(Interval when, Input q);
  /// The triangulation goes along: where it tangles, mechanics::Infeasible before `to` is touched.
  void advance(Input from, Input u, double h, Output to) const;
  void kick(double h, Output u) const;
  void constraint_rates(Input u, Output w) const { areas_.rates(u, w); }
  void react(Input mu, Output u) const { areas_.react(mu, u); }
  void solve(Input right_hand_side, Output mu) { areas_.solve(right_hand_side, mu); }
  /// A_i - m_i/rho.
  void constraint_values(Input q, Output f) const;

  [[nodiscard]] double potential_energy(Input q) const {
    return free_lagrangian::potential_energy(places(q), outline(), weight());
  }  ///< [J/m]

  /// Energy that the stabilisation takes in a step with these impulses of the multipliers, at the last linearisation
  /// [J/m]: 2 mu.(epsilon tr A/N) L^T L mu. Never negative.
  [[nodiscard]] double stabilisation_loss(Input impulses) const { return areas_.stabilisation_loss(impulses); }

  // The parts of linearise, for models with other mobilities.
  /// Throws mechanics::Infeasible where the mesh tangles.
  void follow(Places at) const { triangulation_.move_to(at); }
  /// Cells and gradients at these places. Throws likewise.
  void measure(Places at);
  /// A for these mobilities at the cells last measured. Throws mechanics::Infeasible where it is singular without
  /// stabilisation.
  void factor(std::span<const Mobility> mobility);

  [[nodiscard]] std::size_t nodes() const { return mass_.size(); }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] std::span<const double> masses() const { return mass_; }
  [[nodiscard]] Places given() const { return first_.places(); }
  /// As many as there are nodes, all positive. The next linearise is the first to see them.
  void set_masses(std::span<const double> masses);
  /// What the walls leave free, one per node.
  [[nodiscard]] std::span<const Mobility> freedom() const { return freedom_; }
  [[nodiscard]] std::span<const int> outline() const { return first_.outline; }
  [[nodiscard]] double weight() const { return settings_.density * settings_.gravity; }  ///< rho g
  [[nodiscard]] Places places(Input q) const { return {q.first(nodes()), q.last(nodes())}; }
  /// Of the last measure.
  [[nodiscard]] const DirichletCells& cells() const { return cells_; }
  [[nodiscard]] const linear::RingSolver& solver() const { return areas_.solver(); }
  /// A with its stabilisation, of the last factor.
  [[nodiscard]] const linear::RingMatrix& matrix() const { return areas_.matrix(); }
  /// Where the triangulation was last asked to be.
  [[nodiscard]] const MovingTriangulation& triangulation() const { return triangulation_; }

 private:
  Settings settings_;
  Mesh first_;
  mutable MovingTriangulation triangulation_;
  mutable std::vector<double> next_;
  std::vector<double> mass_;
  std::vector<Mobility> freedom_, mobility_;
  std::vector<Point> force_;   // of gravity
  long connected_flips_ = -1;  // of the triangulation, when the cells were connected
  DirichletCells cells_;
  std::vector<double> row_;  // of L, entry by entry of the rings
  mechanics::RingConstraints areas_;
};

}  // namespace seiche::free_lagrangian
