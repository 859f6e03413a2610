/// A lattice model whose lattice is shared out among processes: what mechanics::OneStep and ConservativeStep step, each
/// process on its patch (decomposition.hpp).
///
/// The patch's own model computes everything that belongs to it. Beside it
///
///     solve     is PETSc's, over all cells (cell_system.hpp), and ends with the multipliers of the ring
///     react     and settle end with the velocities of the rim from their owners
///
/// so that positions, velocities and multipliers stay the same at all processes that hold them, bit by bit. In between,
/// after kick, velocities of the rim are wrong; constraint rates of owned cells do not need them.
///
/// A moving window shifts the columns of every patch by one, so that a process keeps its block of the lattice and the
/// water moves through the blocks: what a patch needs from the east is in its ring already, and the new column is the
/// easternmost patches' own affair. Then the owners' numbers go to those who hold copies.
///
/// A shoreline is the patches' own that reach it: nodes on the bottom have it below them wherever they are.
///
/// What one process finds infeasible stops all: linearise, enter, settle and shift_east throw on each of them.
///
/// When not to use it: on one machine, where the model alone with its own solvers is faster.
#pragma once

#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "distributed/cell_system.hpp"
#include "distributed/decomposition.hpp"
#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::distributed {

using mechanics::Input;
using mechanics::Interval;
using mechanics::Output;

/// @tparam Local  Model of dispersive_shallow_water_2d or of lagrangian_mesh_3d
template <class Local>
class DistributedModel {
 public:
  static constexpr bool warm_start = true;

  /// @param decomposition  must outlive the object
  /// @param local          model of decomposition.patch()
  /// @param sides          of the whole lattice
  /// @param tolerance      relative residual of solve
  DistributedModel(Decomposition& decomposition, std::unique_ptr<Local> local, const plan_lattice::Sides& sides,
                   double tolerance)
      : decomposition_(decomposition),
        local_(std::move(local)),
        system_(decomposition, local_->matrix(), tolerance),
        driven_(plan_lattice::any_side<plan_lattice::DrivenSide>(sides)) {}

  [[nodiscard]] std::size_t coordinates() const { return local_->coordinates(); }
  [[nodiscard]] std::size_t rates() const { return local_->rates(); }
  [[nodiscard]] std::size_t constraints() const { return local_->constraints(); }
  [[nodiscard]] double place(std::size_t rate) const { return local_->place(rate); }

  void linearise(Interval when, Input q) {
    together([&] { local_->linearise(when, q); });
    system_.assemble();
  }
  void linearise_between(Interval when, Input q0, Input q1, int sweep) {
    together([&] { local_->linearise_between(when, q0, q1, sweep); });
    if (sweep == 0) system_.assemble();
  }
  void advance(Input from, Input u, double h, Output to) const { local_->advance(from, u, h, to); }
  void kick(double h, Output u) const { local_->kick(h, u); }
  void enter(Input q, Output u) const {
    together([&] { local_->enter(q, u); });
  }
  void settle(Interval when, Output q, Output u) const {
    together([&] { local_->settle(when, q, u); });
    decomposition_.exchange_nodes(u);
  }
  void constraint_rates(Input u, Output w) const { local_->constraint_rates(u, w); }
  void react(Input mu, Output u) const {
    local_->react(mu, u);
    decomposition_.exchange_nodes(u);
  }
  void solve(Input right_hand_side, Output mu) { system_.solve(right_hand_side, mu); }

  /// As the model's own, of the whole lattice.
  void shift_east(mechanics::State& state) {
    together([&] { local_->shift_east(state); });
    const auto nodes = [this](Output values) { decomposition_.exchange_nodes(values); };
    const auto cells = [this](Output values) { decomposition_.exchange_cells(values); };
    nodes(state.q);
    nodes(state.u);
    for (std::vector<double>* multipliers : state.all_multipliers()) {
      if (!multipliers->empty()) cells(*multipliers);
    }
    local_->join_shift(nodes, cells);
  }

  /// Largest of all processes, so that the sweeps of ConservativeStep end together.
  [[nodiscard]] mechanics::SweepChange of_all(mechanics::SweepChange here) const {
    const bool finite = std::isfinite(here.largest_change) && std::isfinite(here.largest_rate);
    if (Decomposition::least(finite ? 1 : 0) < 1) throw mechanics::Infeasible("a velocity is not finite", 0);
    return {Decomposition::largest(here.largest_change), Decomposition::largest(here.largest_rate)};
  }

  [[nodiscard]] bool has_driven_sides() const { return driven_; }
  [[nodiscard]] const Local& local() const { return *local_; }
  [[nodiscard]] CellSystem& system() { return system_; }
  [[nodiscard]] const CellSystem& system() const { return system_; }

 private:
  /// Does what may be infeasible here, and throws everywhere if it was so anywhere.
  template <class Action>
  static void together(const Action& action) {
    std::exception_ptr own;
    constexpr double feasible = std::numeric_limits<double>::infinity();
    double place = feasible;
    const auto keep = [&](double where) {
      own = std::current_exception();
      place = std::isfinite(where) ? where : std::numeric_limits<double>::lowest();
    };
    try {
      action();
    } catch (const mechanics::Infeasible& failure) {
      keep(failure.place());
    }
    const double first = Decomposition::least(place);
    if (own) std::rethrow_exception(own);
    if (first < feasible) {
      throw mechanics::Infeasible(first, "another process stopped at x = {:g}", first);
    }
  }

  Decomposition& decomposition_;
  std::unique_ptr<Local> local_;
  CellSystem system_;
  bool driven_;
};

}  // namespace seiche::distributed
