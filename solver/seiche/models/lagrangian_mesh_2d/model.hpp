/// Discrete incompressible fluid on a quadrilateral Lagrangian mesh (Frank 1994, ch. 2, formulas 6, 7).
///
/// Nodes carry a quarter of the mass of the cells around them; every cell keeps its area:
///
/// @f[ m \ddot{\mathbf{r}} = \sum_s \lambda_s \frac{\partial V_s}{\partial \mathbf{r}}
///                         - \frac{\partial \Pi}{\partial \mathbf{r}} + m \mathbf{f}, \qquad
///     V_s = \frac{(x_2 - x_0)(y_3 - y_1) - (x_3 - x_1)(y_2 - y_0)}{2} = \mathrm{const} \tag{6} @f]
/// @f[ \Pi = \rho g \sum_{ab} \frac{(x_b - x_a)(y_a^2 + y_a y_b + y_b^2)}{6} + \text{moments of contact points}
///     \tag{7} @f]
///
/// with the sum (7) over the free edges ab.
///
/// Pi is the exact energy of the polygon of water, counted from the still-water level y = 0: lambda is then the dynamic
/// pressure p + rho g y in the limit of fine meshes, and a lake at rest stays at rest bit by bit on any mesh. The
/// bottom does not enter Pi, or nodes that slide along it would feel a force that is not there.
///
/// The class is what mechanics::OneStep and ConservativeStep step: q = (x of all nodes, y of all nodes, arc lengths of
/// nodes that slide along inclined or curved walls), u = (velocities along x, along y). It is rarely used alone: see
/// flow.hpp.
///
/// Conserves mass, and momenta of a free body, to round-off with every scheme; energy to round-off with the one-step
/// scheme if there is no gravity, energy and areas to round-off always with ConservativeStep, also on curved walls: it
/// takes chords for tangents. Dispersion in closed form: exact/lattice_dispersion.hpp.
///
/// Node motions (-1)^(i+j) change no area and meet no force: long runs tangle the mesh by them. Settings::hourglass
/// adds a conservative restoring force. A corner that inverts is an Infeasible configuration, with its place.
///
/// When not to use it: waves that overturn; slopes gentler than about 1:3; surface nodes' tangential places (first
/// order only: a surface node feels the pressure half a cell below it; the surface's shape is of second order).
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapters 1 and 2.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "seiche/lattice/water.hpp"
#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/linear/constraint_solver.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/models/lagrangian_mesh_2d/mesh.hpp"
#include "seiche/models/lagrangian_mesh_2d/nodes.hpp"
#include "seiche/ranges.hpp"

namespace seiche::lagrangian_mesh_2d {

using lattice::Corner;
using mechanics::Interval;

struct Settings {
  double gravity = 1;  ///< [m/s^2]
  double density = 1;  ///< [kg/m^3]
  /// kappa_0 of the hourglass potential (kappa/2) sum |r0 - r1 + r2 - r3 - initial|^2, kappa = kappa_0 rho g
  /// sqrt(mean cell area); 0.1 to 0.6 for long runs, 0 for Frank's own model.
  double hourglass = 0;
  /// Vertical inertia of surface nodes times 1 - h2/(3H), h2/H the part of the top row in the depth: dispersion exact
  /// to one more power of k. No angular momentum then.
  bool tuned_surface_inertia = false;
  /// Stiffness of a repulsion between the sides of a corner that is about to invert (nodes.hpp); 0: none.
  double corner_barrier = 0;
  /// Shape of a corner (mesh.hpp) at which the mesh counts as inverted. Areas stay positive, and the equations
  /// solvable, beyond a tangle: minus infinity goes on as in the source.
  double lowest_corner = 0;
  linear::SolverMethod solver = linear::SolverMethod::automatic;
  double tolerance = 1e-10;  ///< relative residual of iterative solvers; 1e-13 where conservation is measured

  static constexpr auto ranges() {
    return std::array{Number{"gravity", &Settings::gravity, Range::not_negative()},
                      Number{"density", &Settings::density, Range::positive()},
                      Number{"hourglass", &Settings::hourglass, Range::not_negative()},
                      Number{"corner_barrier", &Settings::corner_barrier, Range::not_negative()}};
  }
};

/// What acts on the water besides gravity.
struct Forcing {
  /// Pressure on free edges [Pa] at place x and time t; empty for none.
  std::function<double(double x, double time)> surface_pressure = {};
  /// Force per unit mass on the node that was at `label` at the beginning [m/s^2]; empty for none.
  std::function<Point(Point label, double time)> body_force = {};
};

/// Velocities at the beginning, from the water's at a place or of all nodes one by one; empty: water at rest.
using VelocityAt = std::function<Point(Point place)>;
using InitialVelocity = std::variant<VelocityAt, std::vector<Point>>;

class Model : public lattice::Water<Quadrilateral, Model> {
 public:
  /// Masses and areas from the mesh. Throws std::invalid_argument (mesh.hpp, nodes.hpp, settings out of range).
  explicit Model(Mesh mesh, Settings settings = {}, Forcing forcing = {});

  static constexpr bool warm_start = true;

  /// The mesh as it was given with these velocities at its nodes; what walls forbid is taken out, the projection on
  /// constant areas is mechanics/start.hpp's.
  /// Throws std::invalid_argument for another number of velocities than nodes.
  [[nodiscard]] mechanics::State state(const InitialVelocity& velocity = {}, double time = 0) const;

  // What mechanics/constrained_model.hpp asks for, besides lattice::Water.
  [[nodiscard]] std::size_t coordinates() const { return 2 * nodes_.size() + nodes_.slides().size(); }
  void predict(Input from, Input u, double h, Output to) const { advance_along(from, u, h, to, true); }
  void advance(Input from, Input u, double h, Output to) const { advance_along(from, u, h, to, false); }
  void enter(Input q, Output u) const;
  void settle(Interval when, Output q, Output u) const;
  void curvature(Input u, Input v, Output b) const;
  [[nodiscard]] double place(std::size_t rate) const { return mesh_.x[rate % nodes_.size()]; }

  [[nodiscard]] double potential_energy(Input q) const;  ///< [J/m], zero for still water

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const Forcing& forcing() const { return forcing_; }
  [[nodiscard]] const Nodes& nodes() const { return nodes_; }

  // What lattice::Water asks for.
  void gather(Input q0, Input q1, Input middle, int sweep);
  [[nodiscard]] std::array<const double*, 2> mobility() const { return {nodes_.wx().data(), nodes_.wy().data()}; }
  [[nodiscard]] std::span<const double> node_masses() const { return nodes_.mass(); }
  [[nodiscard]] std::array<double, 2> momentum_of(std::size_t k, Input u) const {
    return {nodes_.mass()[k] * u[k], nodes_.inertia_y()[k] * u[n_ + k]};
  }
  [[nodiscard]] double cell_volume(Input q, std::size_t cell) const {
    return cell_area(mesh_, q.first(n_), q.subspan(n_, n_), cell);
  }
  [[nodiscard]] double cell_shape(Input q, std::size_t cell) const {
    return least_triangle(mesh_, q.first(n_), q.subspan(n_, n_), cell) / volume_[cell];
  }

 private:
  /// Driven nodes in their places at the middle of the interval.
  [[nodiscard]] Input with_driven(Input q);
  void measure(Input at);
  /// Directions of the slides, and what pushes their contact points.
  void turn_slides(Input q0, Input q1);
  void gather_forces(Input at, double weight);
  void advance_along(Input from, Input u, double h, Output to, bool by_tangents) const;

  Mesh mesh_;
  Settings settings_;
  Forcing forcing_;
  Nodes nodes_;
  FreeEdges edges_;
  Hourglass hourglass_;
  CornerBarrier barrier_;
  double lowest_triangle_ = 0;   // twice an area
  std::vector<double> patched_;  // q with driven nodes in place
};

/// Longest stable step of the one-step scheme on a mesh.
///
/// 2/omega of the fastest mode of the undeformed layer with the mesh's mean depth, column width and rows (the closed
/// dispersion law, exact/lattice_dispersion.hpp), with the hourglass potential's added: a bound, from the safe
/// side; infinite where there is neither.
double longest_stable_step(const Model& model);

}  // namespace seiche::lagrangian_mesh_2d
