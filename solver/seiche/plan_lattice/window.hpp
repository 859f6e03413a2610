/// A window on a long tank that follows a wave travelling east.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>

#include "seiche/mechanics/state.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::plan_lattice {

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

/// Every row of `length` values moves one place to the west; the last place of each keeps its value.
template <class T>
void shift_rows(std::span<T> values, std::size_t length) {
  for (std::size_t row = 0; row < values.size(); row += length) {
    const std::span<T> all = values.subspan(row, length);
    std::copy(all.begin() + 1, all.end(), all.begin());
  }
}

/// Moves the window to where it must be at the state's time, by model.shift_east(state); returns by how many columns.
template <class Model>
long follow(const Window& window, std::size_t columns, Model& model, mechanics::State& state) {
  if (!window.reach) return 0;
  const double reach = window.reach(state.time);
  long shifts = 0;
  while (reach > state.q[columns] + (state.q[columns] - state.q[columns - 1])) {
    model.shift_east(state);
    ++shifts;
  }
  return shifts;
}

}  // namespace seiche::plan_lattice
