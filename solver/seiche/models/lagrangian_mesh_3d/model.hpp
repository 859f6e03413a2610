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
/// Over an uneven bottom the nodes of level 0 slide on it (bottom.hpp); the bottom does not enter Pi, or they would
/// feel a force that is not there. The smooth start of the one-step scheme does not know how the bottom is curved.
///
/// When not to use it: waves that overturn; shorelines; waves shorter than about seven depths with one layer
/// (dispersion error 6 per cent at 7 depths, 2 per cent with two layers); more than some ten layers (surface nodes'
/// tangential places are of first order). A corner that folds is an Infeasible configuration, with its place.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapters 1 and 4.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "seiche/linear/constraint_solver.hpp"
#include "seiche/linear/lattice_matrix.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/models/lagrangian_mesh_3d/bottom.hpp"
#include "seiche/models/lagrangian_mesh_3d/mesh.hpp"
#include "seiche/models/lagrangian_mesh_3d/nodes.hpp"
#include "seiche/models/lagrangian_mesh_3d/rows.hpp"
#include "seiche/models/lagrangian_mesh_3d/surface.hpp"

namespace seiche::lagrangian_mesh_3d {

using mechanics::Input;
using mechanics::Interval;
using mechanics::Output;

struct Settings {
  double gravity = 1;        ///< [m/s^2]
  double density = 1;        ///< [kg/m^3]
  double tolerance = 1e-10;  ///< relative residual of the iteration; 1e-13 where conservation is measured
};

/// What acts on the water besides gravity.
struct Forcing {
  /// Force per unit mass on the node that was at `label` at the beginning [m/s^2]; empty for none.
  std::function<Vector(Place label, double time)> body_force = {};
};

/// Velocities at the beginning [m/s], from the water's at a place or of all nodes one by one; empty: water at rest.
using VelocityAt = std::function<Vector(Place place)>;
using Velocity = std::variant<VelocityAt, std::vector<Vector>>;

class Model {
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

  // What mechanics/constrained_model.hpp asks for.
  [[nodiscard]] std::size_t coordinates() const { return 3 * nodes_.size(); }
  [[nodiscard]] std::size_t rates() const { return 3 * nodes_.size(); }
  [[nodiscard]] std::size_t constraints() const { return mesh_.cells(); }
  /// Throws mechanics::Infeasible where a cell's corner folds.
  void linearise(Interval when, Input q);
  /// Factorised in sweep 0 only.
  void linearise_between(Interval when, Input q0, Input q1, int sweep);
  void advance(Input from, Input u, double h, Output to) const;
  void kick(double h, Output u) const;
  void enter(Input q, Output u) const;
  void settle(Interval when, Output q, Output u) const;
  void constraint_rates(Input u, Output w) const;
  void react(Input mu, Output u) const;
  void solve(Input right_hand_side, Output mu);
  /// Relative accuracy of solve: conservative steps go no further.
  [[nodiscard]] double solver_accuracy() const { return settings_.tolerance; }
  void constraint_values(Input q, Output f) const;
  [[nodiscard]] double place(std::size_t rate) const { return mesh_.x[rate % nodes_.size()]; }

  [[nodiscard]] double mass() const;                                             ///< [kg]
  [[nodiscard]] std::array<double, 3> momentum(Input q, Input u) const;          ///< [kg m/s]
  [[nodiscard]] std::array<double, 3> angular_momentum(Input q, Input u) const;  ///< about the origin [kg m^2/s]
  [[nodiscard]] double kinetic_energy(Input q, Input u) const;                   ///< [J]
  [[nodiscard]] double potential_energy(Input q) const;                          ///< [J], zero for still water

  /// Over a level bottom: drops the west column and puts a column at rest, as wide as the last one was at the
  /// beginning, before the east side. The nodes that become the west side, which must be a wall or held, are put
  /// straight above each other. State and model change together.
  void shift_east(mechanics::State& state);
  /// Of a model of a part of a mesh, after shift_east of the models of all parts and with the places that their owners
  /// have: brings what the shift changed beside the state, first places, volumes and masses, to that of the whole.
  /// @param nodes  gives numbers of nodes that other parts own (x, y, z one after the other) their owners' values
  /// @param cells  likewise, one number per cell
  void join_shift(const std::function<void(Output)>& nodes, const std::function<void(Output)>& cells);
  /// Of the columns that shift_east appends.
  [[nodiscard]] double east_width() const { return east_width_; }

  /// As given at the beginning, or at the last shift of a moving window.
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const Nodes& nodes() const { return nodes_; }
  [[nodiscard]] const Bottom& bottom() const { return bottom_; }
  [[nodiscard]] std::span<const double> first_volumes() const { return volume_; }
  [[nodiscard]] const linear::TwentySevenPointSolver& solver() const { return solver_; }
  /// A of the last linearisation.
  [[nodiscard]] const linear::TwentySevenPointMatrix& matrix() const { return matrix_; }
  /// The mesh's worst corner at q (mesh.hpp): a warning when below 0.2.
  [[nodiscard]] Corner worst_corner(Input q) const;
  /// Of the first cell's cube at the beginning [m].
  [[nodiscard]] double cell_size() const { return std::cbrt(volume_.front()); }

 private:
  static constexpr double tolerance_of_sweeps = 1e-3;  // of the correction that a sweep makes; the next one goes on

  [[nodiscard]] bool worth_sharing() const;
  [[nodiscard]] std::size_t cell_rows() const { return mesh_.plan.rows * mesh_.layers; }
  /// Rows of nodes around a row of cells, of coordinates or velocities.
  [[nodiscard]] NodeVectors around(std::size_t row, Input values) const;
  [[nodiscard]] PatchRows patches(std::size_t row, Input q) const;
  /// Throws mechanics::Infeasible where a node leaves the bottom.
  template <class Work>
  void on_bottom(const Work& linearise);
  void measure(Input q);
  [[noreturn]] void throw_folded(Input q) const;
  void assemble_and_factor();
  void add_surface_forces(Input q, double weight);
  void measure_body_force(double time);
  void kick_bodies(double h, Output u) const;
  [[nodiscard]] Vector gradient(std::size_t cell, std::size_t corner) const;

  /// Cells around a node with their gradients there.
  struct CellsAround {
    std::array<std::size_t, 8> cell;  // ascending
    std::array<Vector, 8> gradient;
    std::size_t count = 0;
  };
  [[nodiscard]] CellsAround cells_around(std::size_t node) const;
  void set_driven(std::size_t index, Place place, double time, Output u) const;
  /// Of the constraints' reactions on a node.
  [[nodiscard]] static Vector force(const CellsAround& cells, Input mu);

  Interval when_;  // of the last linearisation
  Mesh mesh_;
  Settings settings_;
  std::vector<double> volume_;
  double east_width_;
  Nodes nodes_;
  Bottom bottom_;
  linear::RowBlocks gradients_;              // by rows of cells, rows.hpp
  linear::RowBlocks patch_forces_;           // surface.hpp
  std::array<std::vector<double>, 3> push_;  // forces on the nodes of the surface
  Forcing forcing_;
  std::vector<Vector> body_force_;  // per unit mass, of the last linearisation; empty without
  std::vector<double> middle_, delta_;
  std::vector<Place> driven_place_;  // of driven nodes at the linearised configuration
  std::vector<double> no_cells_;
  linear::TwentySevenPointMatrix matrix_;
  linear::TwentySevenPointSolver solver_;
  bool sweeping_ = false;  // the last linearisation was a sweep of a conservative step
};

}  // namespace seiche::lagrangian_mesh_3d
