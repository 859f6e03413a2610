#include "distributed/distributed_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <variant>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/require_that.hpp"

namespace seiche::distributed {

static_assert(mechanics::ConstrainedModel<DistributedModel<dispersive_shallow_water_2d::Model>>);
static_assert(mechanics::ConstrainedModel<DistributedModel<lagrangian_mesh_3d::Model>>);
static_assert(seiche::AnyFlow<Flow<PlanModel>> && seiche::AnyFlow<Flow<HexahedralModel>>);

namespace {

// PETSc solves; the patch's own solver is the one that costs nothing until it is asked.
std::unique_ptr<dispersive_shallow_water_2d::Model> local_model(dispersive_shallow_water_2d::Lattice part,
                                                                dispersive_shallow_water_2d::Settings settings,
                                                                const plan_lattice::Sides& sides) {
  settings.solver = linear::SolverMethod::iterative;
  // The drag along the shore belongs to the patches that reach it.
  if (std::holds_alternative<plan_lattice::ShoreSide>(sides.south) &&
      !std::holds_alternative<plan_lattice::ShoreSide>(part.sides.south)) {
    settings.drag.shore_rate = 0;
  }
  require_that(settings.drag.lattice_rate == 0,
               "lattice_rate on many processes; allowed: on one, with the model's own flow");
  require_that(settings.drag.breaking_slope == 0,
               "breaking_slope on many processes; allowed: on one, with the model's own flow");
  return std::make_unique<dispersive_shallow_water_2d::Model>(std::move(part), settings);
}

std::unique_ptr<lagrangian_mesh_3d::Model> local_model(lagrangian_mesh_3d::Mesh part,
                                                       lagrangian_mesh_3d::Settings settings,
                                                       const plan_lattice::Sides&) {
  return std::make_unique<lagrangian_mesh_3d::Model>(std::move(part), settings);
}

bool is_conservative(mechanics::Stepping stepping) {
  require_that(stepping != mechanics::Stepping::one_step_feedback,
               "one_step_feedback on many processes; allowed: one_step, conservative");
  return stepping == mechanics::Stepping::conservative;
}

template <class Model>
void require_movable(const plan_lattice::Window& window, const DistributedModel<Model>& model, const Patch& patch,
                     const plan_lattice::Sides& sides) {
  plan_lattice::require_movable(window, sides);
  if (!window.reach) return;
  if constexpr (std::is_same_v<Model, dispersive_shallow_water_2d::Model>) {
    require_that(!plan_lattice::any_side<plan_lattice::ShoreSide>(sides) && !model.local().absorbs(),
                 "a moving window with a shoreline or absorption; allowed: one of them");
  } else if (model.local().mesh().bottom) {
    throw std::invalid_argument("a moving window of hexahedra over an uneven bottom; allowed: a level one");
  }
  // Every patch in the east appends columns of its own width.
  const bool in_east = patch.columns.end == patch.lattice.columns;
  const double width = model.local().east_width();
  const double narrowest = Decomposition::least(in_east ? width : std::numeric_limits<double>::max());
  const double widest = Decomposition::largest(in_east ? width : 0);
  require_that(widest - narrowest <= 1e-12 * widest,
               "a moving window over an east column {:g} to {:g} wide; allowed: one width", narrowest, widest);
}

}  // namespace

template <class Kind>
Flow<Kind>::Flow(plan_lattice::Shape lattice, std::size_t layers, const MakePart& part,
                 const plan_lattice::Sides& sides, const typename Kind::Velocity& velocity,
                 const typename Kind::Settings& settings, bool smooth_start, mechanics::Stepping stepping,
                 plan_lattice::Window window)
    : decomposition_(lattice, std::is_same_v<Kind, PlanModel> ? 3 : 3 * (layers + 1), layers),
      model_(decomposition_, local_model(part(decomposition_.patch()), settings, sides), sides, settings.tolerance),
      state_(model_.local().state(velocity)),
      stepper_(model_),
      sweeper_(model_),
      conservative_(is_conservative(stepping)),
      smooth_start_(smooth_start && !model_.has_driven_sides() && !conservative_),
      window_(std::move(window)) {
  require_movable(window_, model_, decomposition_.patch(), sides);
  decomposition_.exchange_nodes(state_.u);
  mechanics::Start(model_).project(state_);
}

template <class Kind>
void Flow<Kind>::advance(double tau) {
  mechanics::require_step(tau);
  follow();
  if (conservative_) {
    sweeper_.step(state_, tau);
  } else if (state_.steps == 0 && smooth_start_) {
    mechanics::smooth_step(model_, stepper_, state_, tau);
  } else {
    stepper_.step(state_, tau);
  }
}

/// As plan_lattice::LatticeFlow, which looks at the last two nodes of the lattice's first row.
template <class Kind>
void Flow<Kind>::follow() {
  if (!window_.reach) return;
  const double reach = window_.reach(state_.time);
  const Patch& patch = decomposition_.patch();
  const std::size_t columns = patch.shape().columns;
  const bool in_corner = patch.rows.begin == 0 && patch.columns.end == patch.lattice.columns;
  const auto next = [&] {
    const std::vector<double>& q = state_.q;
    return Decomposition::largest(in_corner ? q[columns] + (q[columns] - q[columns - 1])
                                            : std::numeric_limits<double>::lowest());
  };
  while (reach > next()) {
    try {
      model_.shift_east(state_);
    } catch (const mechanics::Infeasible& failure) {
      throw Divergence(failure.what(), state_.time, state_.steps, failure.place());
    }
    ++shifts_;
  }
}

template <class Kind>
double Flow<Kind>::energy() const {
  const Patch& patch = decomposition_.patch();
  const plan_lattice::Shape shape = patch.shape();
  // Kinetic energy is a sum over nodes: those of other processes stand still here.
  std::vector<double> own = state_.u;
  const std::size_t plan = shape.nodes();
  for (std::size_t j = 0; j <= shape.rows; ++j) {
    for (std::size_t i = 0; i <= shape.columns; ++i) {
      if (patch.owns_node(i, j)) continue;
      for (std::size_t k = shape.node(i, j); k < own.size(); k += plan) own[k] = 0;
    }
  }
  std::vector<char> own_cells(shape.cells());
  for (std::size_t cell = 0; cell < shape.cells(); ++cell) {
    own_cells[cell] = patch.owns_cell(cell % shape.columns, cell / shape.columns) ? 1 : 0;
  }
  return Decomposition::sum(model_.local().kinetic_energy(state_.q, own) +
                            model_.local().potential_energy(state_.q, own_cells));
}

template <class Kind>
double Flow<Kind>::volume_defect() const {
  std::vector<double> defects(model_.constraints());
  model_.local().constraint_values(state_.q, defects);
  double worst = 0;
  for (const double defect : defects) worst = std::max(worst, std::abs(defect));
  return Decomposition::largest(worst);
}

template <class Kind>
double Flow<Kind>::rim_difference() {
  return std::max(decomposition_.largest_rim_difference(state_.q), decomposition_.largest_rim_difference(state_.u));
}

template <class Kind>
void Flow<Kind>::write(const std::filesystem::path& target) {
  write_fields(decomposition_,
               {{"x", "m", "place of the column at the surface", place(0)},
                {"y", "m", "place of the column at the surface", place(1)},
                {"z", "m", "elevation of the surface above still water", place(2)},
                {"u", "m/s", "velocity along x at the surface", velocity(0)},
                {"v", "m/s", "velocity along y at the surface", velocity(1)},
                {"w", "m/s", "vertical velocity of the surface", velocity(2)}},
               state_.time, target);
}

template class Flow<PlanModel>;
template class Flow<HexahedralModel>;

}  // namespace seiche::distributed
