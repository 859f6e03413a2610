/// Discrete incompressible fluid on a hexahedral Lagrangian mesh (Frank 1994, ch. 4.1; scheme of ch. 1).
///
/// Nodes carry an eighth of the mass of the cells around them; every cell keeps its volume, that of the trilinear
/// hexahedron of its corners, which is the mean of the two ways to cut each face into triangles:
///
/// @f[ m \ddot{\mathbf{r}} = \sum_s \lambda_s \frac{\partial V_s}{\partial \mathbf{r}}
///                         - \frac{\partial \Pi}{\partial \mathbf{r}} + m \mathbf{f}, \qquad V_s = \mathrm{const} @f]
/// @f[ \Pi = \frac{\rho g}{2} \sum \int z^2 \, dA @f]
///
/// with the last sum over the bilinear patches of the free surface.
///
/// Pi counts from the still-water level z = 0: lambda is then the dynamic pressure p + rho g z in the limit of fine
/// meshes, and a lake at rest stays at rest bit by bit.
///
/// The class is what mechanics::OneStep and ConservativeStep step: q = (x, y, z of all nodes), u = (their velocities).
/// It is rarely used alone: see flow.hpp.
///
/// Conserves, to round-off and for any multipliers however loosely solved: mass, and with the one-step scheme linear
/// momentum along x, y and angular momentum about z where no side holds the fluid, energy if there is no gravity.
/// ConservativeStep conserves energy, volumes and linear momentum, for V_s is cubic and Pi quartic along a step, so
/// that their mean gradients are known exactly; not angular momentum.
///
/// Over an uneven bottom the nodes of level 0 slide on it (nodes.hpp); the bottom does not enter Pi, or they would
/// feel a force that is not there. The smooth start of the one-step scheme does not know how the bottom is curved.
///
/// When not to use it: waves that overturn; shorelines; waves shorter than about seven depths with one layer
/// (dispersion error 6 per cent at 7 depths, 2 per cent with two layers); more than some ten layers (surface nodes'
/// tangential places are of first order). A corner that inverts is an Infeasible configuration, with its place.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapters 1 and 4.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "seiche/lattice/surface_patches.hpp"
#include "seiche/lattice/water.hpp"
#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/linear/constraint_solver.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/models/lagrangian_mesh_3d/mesh.hpp"
#include "seiche/models/lagrangian_mesh_3d/nodes.hpp"
#include "seiche/ranges.hpp"

namespace seiche::lagrangian_mesh_3d {

using lattice::Corner;
using mechanics::Input;
using mechanics::Interval;
using mechanics::Output;

struct Settings {
  double gravity = 1;        ///< [m/s^2]
  double density = 1;        ///< [kg/m^3]
  double tolerance = 1e-10;  ///< relative residual of the iteration; 1e-13 where conservation is measured

  static constexpr auto ranges() {
    return std::array{Number{"gravity", &Settings::gravity, Range::not_negative()},
                      Number{"density", &Settings::density, Range::positive()}};
  }
};

/// What acts on the water besides gravity.
struct Forcing {
  /// Force per unit mass on the node that was at `label` at the beginning [m/s^2]; empty for none.
  std::function<Vector(Place label, double time)> body_force = {};
};

/// Velocities at the beginning [m/s], from the water's at a place or of all nodes one by one; empty: water at rest.
using VelocityAt = std::function<Vector(Place place)>;
using Velocity = std::variant<VelocityAt, std::vector<Vector>>;

class Model : public lattice::Water<Hexahedron, Model> {
 public:
  /// Masses and volumes from the mesh. Throws std::invalid_argument (mesh.hpp, sides.hpp, settings out of range).
  explicit Model(Mesh mesh, Settings settings = {}, Forcing forcing = {});

  /// No guesses from earlier multipliers: A hardly sees checkerboards in plan, so that the solver leaves their errors,
  /// and extrapolation makes them grow from step to step until they cost more iterations than a guess can save.
  static constexpr bool warm_start = false;

  /// The mesh as it was given with these velocities at its nodes; what walls forbid is taken out, the projection on
  /// constant volumes is mechanics/start.hpp's.
  /// Throws std::invalid_argument for another number of velocities than nodes.
  [[nodiscard]] mechanics::State state(const Velocity& velocity = {}, double time = 0) const;

  // What mechanics/constrained_model.hpp asks for, besides lattice::Water.
  void kick(double h, Output u) const;
  void enter(Input, Output u) const { drive(when_.middle(), driven_from_, u); }
  void settle(Interval when, Output q, Output u) const { drive(when.end(), q, u); }
  [[nodiscard]] double place(std::size_t rate) const { return mesh_.x[rate % n_]; }

  /// [J], zero for still water. @param counted  marks the columns of cells whose water counts; empty: all
  [[nodiscard]] double potential_energy(Input q, std::span<const char> counted = {}) const {
    return settings_.density * settings_.gravity * surface_.moment(q, counted);
  }

  /// Over a level bottom: drops the west column and puts a column at rest, as wide as the last one was at the
  /// beginning, before the east side. The nodes that become the west side, which must be a wall or held, are put
  /// straight above each other. State and model change together.
  void shift_east(mechanics::State& state);
  /// Of a model of a part of a mesh, after shift_east of the models of all parts and with the places that their owners
  /// have: brings what the shift changed beside the state, first places, volumes and masses, to that of the whole.
  /// @param nodes  gives numbers of nodes that other parts own (x, y, z one after the other) their owners' values
  /// @param cells  likewise, one number per cell
  void join_shift(const std::function<void(Output)>& nodes, const std::function<void(Output)>& cells) {
    join_columns(mesh_.x, mesh_.y, nodes, cells);
    nodes_.weigh(mesh_, volume_, settings_.density);
  }
  /// Of the columns that shift_east appends.
  [[nodiscard]] double east_width() const { return east_width_; }

  /// As given at the beginning, or at the last shift of a moving window.
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const Nodes& nodes() const { return nodes_; }
  /// Of the first cell's cube at the beginning [m].
  [[nodiscard]] double cell_size() const { return std::cbrt(volume_.front()); }

  // What lattice::Water asks for.
  void gather(Input q0, Input q1, Input at, int sweep);
  [[nodiscard]] std::array<const double*, 3> mobility() const {
    return {nodes_.w(0).data(), nodes_.w(1).data(), nodes_.w(2).data()};
  }
  [[nodiscard]] std::span<const double> node_masses() const { return nodes_.mass(); }
  [[nodiscard]] std::array<double, 3> momentum_of(std::size_t k, Input u) const {
    const double m = nodes_.mass()[k];
    return {m * u[k], m * u[n_ + k], m * u[2 * n_ + k]};
  }
  [[nodiscard]] double cell_volume(Input q, std::size_t cell) const { return hexahedron_volume(corners(q, cell)); }
  [[nodiscard]] double cell_shape(Input q, std::size_t cell) const {
    return std::ranges::min(corner_volumes(corners(q, cell))) / volume_[cell];
  }

 private:
  [[nodiscard]] CellCorners corners(Input q, std::size_t cell) const {
    return corners_of(mesh_, q.first(n_), q.subspan(n_, n_), q.subspan(2 * n_, n_), cell);
  }
  void measure(Input q);
  /// What each node is held to moves by, besides the axes.
  void hold();
  /// Velocities of driven nodes where they are at q.
  void drive(double time, Input q, Output u) const;

  Mesh mesh_;
  Settings settings_;
  double east_width_;
  Nodes nodes_;
  lattice::SurfacePatches surface_;
  Forcing forcing_;
  std::vector<double> delta_;
  std::vector<double> driven_from_;  // the linearised configuration, if nodes are driven
};

/// Longest step of the one-step scheme that is surely stable on a mesh.
///
/// 2/omega with omega^2 = 2 g/h: waves on layers of height h have omega^2 = (2 g/h) G R with G, R < 1, whatever their
/// length. h is the smallest height of a cell at the surface of the first mesh; infinite without gravity.
double surely_stable_step(const Model& model);

}  // namespace seiche::lagrangian_mesh_3d
