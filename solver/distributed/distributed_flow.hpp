/// A flow of a lattice model whose lattice is shared out among processes, stepped by the one-step or the conservative
/// scheme.
///
///     Runtime runtime(argc, argv);
///     PlanFlow flow(lattice.shape, 1, [&](const Patch& patch) { return part_of(lattice, patch); }, lattice.sides,
///                   velocity, settings);
///     while (flow.time() < 20) flow.advance(0.2);
///     flow.write("fields.h5");
///
/// The same steps as the model's own Flow, to the tolerance of the solver, for any number of processes. All of them
/// call every function that is not const, and `energy`, `volume_defect` and `invariants`.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "distributed/distributed_model.hpp"
#include "distributed/fields_file.hpp"
#include "seiche/mechanics/conservative_step.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/model.hpp"
#include "seiche/models/dispersive_shallow_water_2d/model.hpp"
#include "seiche/models/lagrangian_mesh_3d/model.hpp"
#include "seiche/plan_lattice/lattice_flow.hpp"

namespace seiche::distributed {

/// What Flow asks of a lattice model.
struct PlanModel {
  using Local = dispersive_shallow_water_2d::Model;
  using Part = dispersive_shallow_water_2d::Lattice;
  using Settings = dispersive_shallow_water_2d::Settings;
  using Velocity = dispersive_shallow_water_2d::VelocityAt;
};
struct HexahedralModel {
  using Local = lagrangian_mesh_3d::Model;
  using Part = lagrangian_mesh_3d::Mesh;
  using Settings = lagrangian_mesh_3d::Settings;
  using Velocity = lagrangian_mesh_3d::Velocity;
};

template <class Kind>
class Flow {
 public:
  using Local = typename Kind::Local;
  using MakePart = std::function<typename Kind::Part(const Patch& patch)>;

  /// @param lattice  columns and rows of the whole
  /// @param layers   of cells, 1 for the plan model
  /// @param part     the process's part of the lattice: part_of (patches.hpp)
  /// @param sides    of the whole lattice
  /// @param smooth_start  as in the models' own flows
  /// @param stepping      one_step or conservative
  /// @param window        that moves; over a level bottom where the model is of hexahedra, and not with a shoreline or
  ///                      absorption
  /// Throws std::invalid_argument.
  Flow(plan_lattice::Shape lattice, std::size_t layers, const MakePart& part, const plan_lattice::Sides& sides,
       const typename Kind::Velocity& velocity = {}, const typename Kind::Settings& settings = {},
       bool smooth_start = true, mechanics::Stepping stepping = mechanics::Stepping::one_step,
       plan_lattice::Window window = {});

  /// One step of length tau > 0.
  void advance(double tau);
  void arrive(double time) { state_.time = time; }
  [[nodiscard]] double stable_step() const { return std::numeric_limits<double>::infinity(); }

  [[nodiscard]] double time() const { return state_.time; }
  [[nodiscard]] long steps() const { return state_.steps; }
  /// Columns that a moving window has left behind.
  [[nodiscard]] long shifts() const { return shifts_; }
  [[nodiscard]] const Patch& patch() const { return decomposition_.patch(); }
  [[nodiscard]] const mechanics::State& state() const { return state_; }
  [[nodiscard]] Decomposition& decomposition() { return decomposition_; }
  [[nodiscard]] DistributedModel<Local>& model() { return model_; }
  [[nodiscard]] const DistributedModel<Local>& model() const { return model_; }

  /// Of the nodes of the surface in the patch: places for axis 0, 1, 2, velocities likewise.
  [[nodiscard]] std::span<const double> place(std::size_t axis) const { return surface(state_.q, axis); }
  [[nodiscard]] std::span<const double> velocity(std::size_t axis) const { return surface(state_.u, axis); }

  [[nodiscard]] double energy() const;         ///< kinetic and potential of the whole, zero for still water
  [[nodiscard]] double volume_defect() const;  ///< largest of all cells
  [[nodiscard]] std::vector<Invariant> invariants() const {
    return {{"energy", energy(), 0}, {"volume_worst", volume_defect(), 0}};
  }
  /// Largest difference of a number at a node between the processes that hold it: 0.
  [[nodiscard]] double rim_difference();
  /// x, y, z, u, v, w of the surface's nodes into one HDF5 file (fields_file.hpp).
  void write(const std::filesystem::path& target);

 private:
  void follow();
  [[nodiscard]] std::span<const double> surface(const std::vector<double>& values, std::size_t axis) const {
    const std::size_t plan = decomposition_.patch().shape().nodes();
    const std::size_t levels = values.size() / (3 * plan);
    return {values.data() + ((axis + 1) * levels - 1) * plan, plan};
  }

  Decomposition decomposition_;
  DistributedModel<Local> model_;
  mechanics::State state_;
  mechanics::OneStep<DistributedModel<Local>> stepper_;
  mechanics::ConservativeStep<DistributedModel<Local>> sweeper_;
  bool conservative_;
  bool smooth_start_;
  plan_lattice::Window window_;
  long shifts_ = 0;
};

using PlanFlow = Flow<PlanModel>;
using HexahedralFlow = Flow<HexahedralModel>;

}  // namespace seiche::distributed
