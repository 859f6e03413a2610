/// What the flows of waves in three dimensions share beside lattice::Flow: a lattice seen from above, and a window on
/// it that moves. The flows themselves add how they begin.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>

#include "seiche/lattice/flow.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::plan_lattice {

/// A window on a long tank that follows a wave travelling east.
///
/// Before a step, while the water east of the window is not at rest any more, the west column is dropped and a column
/// at rest appended (shift_east of the models). A wall does best as the west side: a held side is unlike the undeformed
/// lattice that preconditions the solver, and doubles its iterations.
struct Window {
  std::function<double(double time)> reach = {};  ///< x beyond which all is at rest; empty: no window
};

/// Throws std::invalid_argument for a window over a west side that is neither a wall nor held.
void require_movable(const Window& window, const Sides& sides);

/// Nodes keep the normals of the first lattice's walls. Throws std::invalid_argument, with the place, for a window
/// between walls of which one bends. @param x, y  of that lattice
void require_straight_walls(const Window& window, const Sides& sides, Shape shape, std::span<const double> x,
                            std::span<const double> y);

/// @tparam Model  in space, with shift_east
template <class Model>
class LatticeFlow : public lattice::Flow<Model> {
 public:
  /// One step of length tau > 0. Throws std::invalid_argument for tau, Divergence; the state is then as before the
  /// step, but that a moving window has moved.
  void advance(double tau) override {
    mechanics::require_step(tau);
    if (window_.reach) {
      const double reach = window_.reach(this->time());
      const std::vector<double>& x = this->state_.q;
      const std::size_t east = shape_.columns;
      while (reach > x[east] + (x[east] - x[east - 1])) {
        this->model_->shift_east(this->state_);
        ++shifts_;
      }
    }
    this->step(tau);
  }

  [[nodiscard]] Shape shape() const { return shape_; }
  /// Columns that a moving window has left behind.
  [[nodiscard]] long shifts() const { return shifts_; }
  /// As of all lattices. Not with a moving window (std::logic_error), which loses water behind and gains water ahead.
  void observe() {
    if (window_.reach) throw std::logic_error("what a moving window holds is not conserved");
    lattice::Flow<Model>::observe();
  }

 protected:
  LatticeFlow(mechanics::Scheme scheme, Window window) : lattice::Flow<Model>(scheme), window_(std::move(window)) {}

  /// Projects the first velocities. Throws std::invalid_argument for the window, or if they cannot be projected.
  void begin_between(const Sides& sides, Shape shape, std::unique_ptr<Model>&& model, mechanics::State state,
                     double stable_step, bool smooth_start) {
    shape_ = shape;
    require_movable(window_, sides);
    const std::size_t n = state.u.size() / 3;
    require_straight_walls(window_, sides, shape_, std::span(state.q).first(n), std::span(state.q).subspan(n, n));
    this->begin_at_first(std::move(model), std::move(state), stable_step, smooth_start);
  }

 private:
  Shape shape_;
  Window window_;
  long shifts_ = 0;
};

}  // namespace seiche::plan_lattice
