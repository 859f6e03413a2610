/// Water in the cells of a lattice: masses at nodes, every cell keeps its volume (Frank 1994, ch. 1, 2, 4).
///
/// @f[ m \ddot{\mathbf{r}} = \sum_s \lambda_s \frac{\partial V_s}{\partial \mathbf{r}}
///                         - \frac{\partial \Pi}{\partial \mathbf{r}}, \qquad V_s(\mathbf{r}) = \mathrm{const}, \qquad
///     A = J W J^T, \qquad J = \frac{\partial V}{\partial \mathbf{r}} @f]
///
/// What does not depend on the shape of a cell is here: J applied, transposed and in A, the solution, forces turned
/// into velocities, and sums over nodes. An element (cell_rows.hpp) says what a gradient of a cell's volume is; a model
/// adds volumes, forces and what holds its nodes. All coordinates of one axis lie together: q and u are (x, y(, z)).
///
/// columns x rows x layers cells; rows of cells along i are contiguous, layer after layer, and so are rows of nodes. In
/// the plane there is one layer, of cells and of nodes.
///
/// Rows of nodes move by the inverse masses of the model. Nodes on inclined walls or curves have none, but a W of their
/// own: they are few (`held_`).
///
/// When not to use it: cells that change neighbours.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/curve.hpp"
#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/lattice/cell_rows.hpp"
#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/linear/constraint_solver.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/ranges.hpp"

namespace seiche::lattice {

using mechanics::Input;
using mechanics::Interval;
using mechanics::Output;

/// The worst corner of a lattice: 1 where cells are as at first, 0 where one inverts.
struct Corner {
  double shape = 1;
  std::size_t cell = 0;
};

struct Cells {
  std::size_t columns, rows, layers = 1;
};

/// Of a mesh and settings that are valid. Throws std::invalid_argument.
template <class Mesh, class Settings>
Cells valid_cells(const Mesh& mesh, const Settings& settings, Cells cells) {
  mesh.require_valid();
  require_ranges(settings);
  return cells;
}

/// One after the other.
inline std::vector<double> joined(std::initializer_list<std::span<const double>> arrays) {
  std::vector<double> all;
  for (const std::span<const double> array : arrays) all.insert(all.end(), array.begin(), array.end());
  return all;
}

/// Velocities of all nodes: given one by one, or call(at, node) of a function of places, or zero where that is empty.
/// Throws std::invalid_argument for another number of them.
template <class At, class Velocity, class Call>
std::vector<Velocity> nodal(const std::variant<At, std::vector<Velocity>>& given, std::size_t nodes, const Call& call) {
  if (const auto* const all = std::get_if<1>(&given)) {
    if (all->size() == nodes) return *all;
    throw std::invalid_argument(fmt::format("{} velocities of nodes; allowed: {}", all->size(), nodes));
  }
  std::vector<Velocity> velocities(nodes);
  const At& at = std::get<0>(given);
  for (std::size_t k = 0; at && k < nodes; ++k) velocities[k] = call(at, k);
  return velocities;
}

/// A symmetric matrix, xx, yy(, zz), xy(, xz, yz), times a vector.
inline std::array<double, 2> times(const std::array<double, 3>& w, const std::array<double, 2>& v) {
  return {w[0] * v[0] + w[2] * v[1], w[2] * v[0] + w[1] * v[1]};
}
inline std::array<double, 3> times(const std::array<double, 6>& w, const std::array<double, 3>& v) {
  return {w[0] * v[0] + w[3] * v[1] + w[4] * v[2], w[3] * v[0] + w[1] * v[1] + w[5] * v[2],
          w[4] * v[0] + w[5] * v[1] + w[2] * v[2]};
}

/// Every row of `length` values moves one place to the west; the last place of each keeps its value.
template <class T>
void shift_rows(std::span<T> values, std::size_t length) {
  for (std::size_t row = 0; row < values.size(); row += length) {
    std::shift_left(values.begin() + static_cast<std::ptrdiff_t>(row),
                    values.begin() + static_cast<std::ptrdiff_t>(row + length), 1);
  }
}

/// @tparam E      the element
/// @tparam Model  derives from it and gives
///                   mobility()                 pointers to the nodes' inverse masses along the axes
///                   full_row(row)              whether W has entries off its diagonal there, if E::mobilities == 6
///                   node_masses(), momentum_of(k, u)   M u of a node; E::momenta of its axes are conserved
///                   look_below(q)              optional: what momentum_of needs to know
///                   cell_volume(q, cell), cell_shape(q, cell), place(rate)
///                   gather(q0, q1, at, sweep)   gradients, forces and holds at `at`, or means over q0 -> q1 if they
///                   differ
template <class E, class Model>
class Water {
 public:
  static constexpr std::size_t axes = E::axes;

  // What mechanics/constrained_model.hpp asks for.
  [[nodiscard]] std::size_t coordinates() const { return E::axes * n_; }
  [[nodiscard]] std::size_t rates() const { return E::axes * n_; }
  [[nodiscard]] std::size_t constraints() const { return volume_.size(); }
  /// Throws mechanics::Infeasible where a cell tangles or a node cannot stay.
  void linearise(Interval when, Input q) {
    linearise_over(when, q, q, q, 0);
    sweeping_ = false;
  }
  /// Factorised in sweep 0 only.
  void linearise_between(Interval when, Input q0, Input q1, int sweep) {
    middle_.resize(q0.size());
    for (std::size_t i = 0; i < q0.size(); ++i) middle_[i] = 0.5 * (q0[i] + q1[i]);
    linearise_over(when, q0, q1, middle_, sweep);
    sweeping_ = true;
  }
  void advance(Input from, Input u, double h, Output to) const {
    const std::size_t count = shape_.columns + 1;
    linear::share_out(E::axes * node_rows(), worth_sharing(), [&](std::size_t row) {
#pragma omp simd
      for (std::size_t i = row * count; i < (row + 1) * count; ++i) to[i] = from[i] + h * u[i];
    });
  }
  /// Of what is pushed, from `first_pushed_row_` on, and of `held_`.
  void kick(double h, Output u) const {
    const auto mobility = self().mobility();
    const std::size_t count = shape_.columns + 1;
    linear::share_out(node_rows() - first_pushed_row_, worth_sharing(), [&](std::size_t up) {
      const std::size_t row = first_pushed_row_ + up;
      Kick<E> here{.count = count, .h = h};
      for (std::size_t k = 0; k < E::mobilities; ++k) here.w[k] = mobility[k] + row * count;
      for (std::size_t axis = 0; axis < E::axes; ++axis) {
        here.push[axis] = push_.data() + axis * n_ + row * count;
        here.velocity[axis] = u.data() + axis * n_ + row * count;
      }
      if constexpr (E::mobilities == 6) here.full = self().full_row(row);
      E::run({.push = &here});
    });
    for (const Held& held : held_) {
      Components push;
      for (std::size_t axis = 0; axis < E::axes; ++axis) push[axis] = h * push_[axis * n_ + held.node];
      move_held(held, push, u);
    }
  }
  void constraint_rates(Input u, Output w) const {
    each_row([&](std::size_t row) {
      const auto cells = gradients_.row(row);
      const Rates<E> here{shape_.columns, static_cast<std::ptrdiff_t>(cells.stride), cells.data, around(row, u),
                          w.data() + row * shape_.columns};
      E::run({.rates = &here});
    });
  }
  void react(Input mu, Output u) const {
    const auto [columns, rows, layers] = shape_;
    const auto mobility = self().mobility();
    linear::share_out(node_rows(), worth_sharing(), [&](std::size_t row) {
      const std::size_t j = row % (rows + 1);
      const std::size_t l = row / (rows + 1);
      Reaction<E> here{.columns = columns, .stride = static_cast<std::ptrdiff_t>(gradients_.zeros().stride)};
      for (std::size_t k = 0; k < E::corners / 2; ++k) {
        const std::size_t south = k % 2 == 0 ? 1 : 0;
        const std::size_t below = E::corners == 8 && k < 2 ? 1 : 0;
        const bool outside = j < south || l < below || j - south >= rows || l - below >= layers;
        const std::size_t cell_row = (l - below) * rows + j - south;
        here.cells[k] = (outside ? gradients_.zeros() : gradients_.row(cell_row)).data;
        here.mu[k] = outside ? no_cells_.data() : mu.data() + cell_row * columns;
      }
      const std::size_t first = row * (columns + 1);
      for (std::size_t k = 0; k < E::mobilities; ++k) here.w[k] = mobility[k] + first;
      for (std::size_t axis = 0; axis < E::axes; ++axis) here.velocity[axis] = u.data() + axis * n_ + first;
      if constexpr (E::mobilities == 6) here.full = self().full_row(row);
      E::run({.reaction = &here});
    });
    for (const Held& held : held_) {
      const Around cells = cells_around(held.node);
      Components force{};
      for (std::size_t a = 0; a < cells.count; ++a) {
        for (std::size_t axis = 0; axis < E::axes; ++axis) force[axis] += mu[cells.cell[a]] * cells.gradient[a][axis];
      }
      move_held(held, force, u);
    }
  }
  void solve(Input right_hand_side, Output mu) {
    solver_.solve(right_hand_side, mu, sweeping_ ? tolerance_of_sweeps : 0);
  }
  /// Relative accuracy of solve, 0 for round-off: conservative steps go no further.
  [[nodiscard]] double solver_accuracy() const {
    return solver_.method() == linear::SolverMethod::iterative ? tolerance_ : 0;
  }
  void constraint_values(Input q, Output f) const {
    for (std::size_t cell = 0; cell < volume_.size(); ++cell) f[cell] = self().cell_volume(q, cell) - volume_[cell];
  }

  [[nodiscard]] double mass() const {
    CompensatedSum sum;
    for (const double m : self().node_masses()) sum.add(m);
    return sum.value();
  }
  [[nodiscard]] std::array<double, E::momenta> momentum(Input q, Input u) const {
    return sums<E::momenta>(q, u, [](std::size_t, const Components& p, std::size_t axis) { return p[axis]; });
  }
  /// About the origin: along z, in space along all axes.
  [[nodiscard]] std::array<double, E::turns> angular_momentum(Input q, Input u) const {
    return sums<E::turns>(q, u, [&](std::size_t k, const Components& p, std::size_t turn) {
      const std::size_t a = E::turns == 1 ? 0 : (turn + 1) % 3;
      const std::size_t b = E::turns == 1 ? 1 : (turn + 2) % 3;
      return q[a * n_ + k] * p[b] - q[b * n_ + k] * p[a];
    });
  }
  [[nodiscard]] double kinetic_energy(Input q, Input u) const {
    CompensatedSum sum;
    each_momentum(q, u, [&](std::size_t k, const Components& p) {
      for (std::size_t axis = 0; axis < E::axes; ++axis) sum.add(0.5 * p[axis] * u[axis * n_ + k]);
    });
    return sum.value();
  }

  [[nodiscard]] std::span<const double> first_volumes() const {
    return volume_;
  }
  [[nodiscard]] const linear::ConstraintSolver& solver() const {
    return solver_;
  }
  /// A of the last linearisation.
  [[nodiscard]] const linear::StencilMatrix& matrix() const {
    return matrix_;
  }
  /// A warning when below 0.2.
  [[nodiscard]] Corner worst_corner(Input q) const {
    Corner worst{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t cell = 0; cell < volume_.size(); ++cell) {
      const double shape = self().cell_shape(q, cell);
      if (!(shape >= worst.shape)) worst = {shape, cell};  // not a number counts as the worst
    }
    return worst;
  }

 protected:
  using Components = std::array<double, E::axes>;
  /// A symmetric matrix: xx, yy(, zz), xy(, xz, yz).
  using Symmetric = std::array<double, E::axes*(E::axes + 1) / 2>;
  struct Held {
    std::size_t node = 0;
    Symmetric w{};
  };
  /// Cells around a node, with their gradients there.
  struct Around {
    std::array<std::size_t, E::corners> cell;
    std::array<Components, E::corners> gradient;
    std::size_t count = 0;
  };

  /// @param volumes  of the cells at the beginning
  Water(Cells cells, std::vector<double> volumes, linear::ConstraintSolver solver, double tolerance)
      : shape_(cells),
        n_((cells.columns + 1) * (cells.rows + 1) * (E::corners == 8 ? cells.layers + 1 : 1)),
        volume_(std::move(volumes)),
        gradients_(cells.columns, cells.rows * cells.layers, E::stored),
        push_(E::axes * n_, 0.0),
        no_cells_(cells.columns + 1, 0.0),
        matrix_(cells.columns, cells.rows, cells.layers),
        solver_(std::move(solver)),
        tolerance_(tolerance) {}

  [[nodiscard]] const Model& self() const {
    return static_cast<const Model&>(*this);
  }
  [[nodiscard]] bool worth_sharing() const {
    return volume_.size() > linear::worth_threads;
  }
  [[nodiscard]] std::size_t cell_rows() const {
    return shape_.rows * shape_.layers;
  }
  [[nodiscard]] std::size_t node_rows() const {
    return n_ / (shape_.columns + 1);
  }
  /// Rows of nodes around a row of cells, of quantities that begin at these places.
  template <std::size_t count>
  [[nodiscard]] std::array<Rows<E>, count> around(std::size_t row, const std::array<const double*, count>& from) const {
    const std::size_t stride = shape_.columns + 1;
    const std::size_t level = stride * (shape_.rows + 1);
    const std::size_t first = row / shape_.rows * level + row % shape_.rows * stride;
    std::array<Rows<E>, count> rows;
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t r = 0; r < E::corners / 2; ++r) rows[k][r] = from[k] + first + r % 2 * stride + r / 2 * level;
    }
    return rows;
  }
  [[nodiscard]] NodeVectors<E> around(std::size_t row, Input values) const {
    return around(row, axes_of(values));
  }
  [[nodiscard]] std::array<const double*, E::axes> axes_of(Input values) const {
    std::array<const double*, E::axes> from;
    for (std::size_t axis = 0; axis < E::axes; ++axis) from[axis] = values.data() + axis * n_;
    return from;
  }
  [[nodiscard]] Around cells_around(std::size_t node) const {
    const auto [columns, rows, layers] = shape_;
    const std::size_t i = node % (columns + 1);
    const std::size_t j = node / (columns + 1) % (rows + 1);
    const std::size_t l = node / ((columns + 1) * (rows + 1));
    const auto stride = static_cast<std::ptrdiff_t>(gradients_.row(0).stride);
    Around found;
    for (std::size_t corner = 0; corner < E::corners; ++corner) {
      // The node is this corner of the cell west, south, below of it where the corner's place is 1.
      const auto dx = static_cast<std::size_t>(place_of[corner][0]);
      const auto dy = static_cast<std::size_t>(place_of[corner][1]);
      const auto dz = static_cast<std::size_t>(place_of[corner][2]);
      if (i < dx || j < dy || l < dz || i - dx >= columns || j - dy >= rows || l - dz >= layers) continue;
      const std::size_t row = (l - dz) * rows + j - dy;
      found.gradient[found.count] =
          gradient_at<E>(corner, gradients_.row(row).data, stride, static_cast<std::ptrdiff_t>(i - dx));
      found.cell[found.count++] = row * columns + i - dx;
    }
    return found;
  }

  /// take(node, M u of it).
  template <class Take>
  void each_momentum(Input q, Input u, const Take& take) const {
    if constexpr (requires { self().look_below(q); }) self().look_below(q);
    for (std::size_t k = 0; k < n_; ++k) take(k, self().momentum_of(k, u));
  }
  /// Of value(node, M u of it, number) over all nodes.
  template <std::size_t count, class Value>
  [[nodiscard]] std::array<double, count> sums(Input q, Input u, const Value& value) const {
    std::array<CompensatedSum, count> sum;
    each_momentum(q, u, [&](std::size_t k, const Components& p) {
      for (std::size_t number = 0; number < count; ++number) sum[number].add(value(k, p, number));
    });
    std::array<double, count> values;
    for (std::size_t number = 0; number < count; ++number) values[number] = sum[number].value();
    return values;
  }
  /// work(row) for all rows of cells.
  template <class Work>
  void each_row(const Work& work) const {
    linear::share_out(cell_rows(), worth_sharing(), work);
  }
  /// A and its factorisation. Throws mechanics::Infeasible.
  void assemble_and_factor() {
    const auto mobility = self().mobility();
    const std::size_t rows = shape_.rows;
    each_row([&](std::size_t row) {
      const std::size_t j = row % rows;
      const auto cells = std::as_const(gradients_).row(row);
      Assembly<E> here{.columns = shape_.columns,
                       .stride = static_cast<std::ptrdiff_t>(cells.stride),
                       .cells = cells.data,
                       .later = {},
                       .w = around(row, mobility),
                       .full = false,
                       .parts = {}};
      for (std::size_t k = 0; k < (shape_.layers > 1 ? 14 : 5); ++k) here.parts[k] = matrix_[k] + row * shape_.columns;
      const bool north = j + 1 < rows;
      const bool above = row + rows < cell_rows();
      if (north) here.later[0] = std::as_const(gradients_).row(row + 1).data;
      if (above && j > 0) here.later[1] = std::as_const(gradients_).row(row + rows - 1).data;
      if (above) here.later[2] = std::as_const(gradients_).row(row + rows).data;
      if (above && north) here.later[3] = std::as_const(gradients_).row(row + rows + 1).data;
      if constexpr (E::mobilities == 6) {
        const std::size_t nodes = row / rows * (rows + 1) + j;
        here.full = self().full_row(nodes) || self().full_row(nodes + 1);
      }
      E::run({.assembly = &here});
    });
    for (const Held& held : held_) {
      const Around cells = cells_around(held.node);
      for (std::size_t a = 0; a < cells.count; ++a) {
        const Components along = times(held.w, cells.gradient[a]);
        for (std::size_t b = a; b < cells.count; ++b) {
          double sum = 0;
          for (std::size_t axis = 0; axis < E::axes; ++axis) sum += along[axis] * cells.gradient[b][axis];
          matrix_.coefficient(cells.cell[a], cells.cell[b]) += sum;
        }
      }
    }
    try {
      solver_.factor(matrix_);
    } catch (const linear::NotPositiveDefinite& failure) {
      throw mechanics::Infeasible(self().place(first_node(failure.row())), "cell {}: {}", failure.row(),
                                  failure.what());
    }
  }
  /// @param lowest  allowed shape
  [[noreturn]] void throw_tangled(Input q, double lowest = 0) const {
    const Corner worst = worst_corner(q);
    const auto [columns, rows, layers] = shape_;
    const std::size_t corner = first_node(worst.cell);
    throw mechanics::Infeasible(
        q[corner],
        "the mesh tangled: cell {} (column {}, row {}, layer {}) at ({:.4g}, {:.4g}) has relative corner Jacobian "
        "{:.3g}, must be above {:g}",
        worst.cell, worst.cell % columns, worst.cell / columns % rows, worst.cell / (columns * rows), q[corner],
        q[n_ + corner], worst.shape, lowest);
  }
  /// Corner 0.
  [[nodiscard]] std::size_t first_node(std::size_t cell) const {
    const std::size_t row = cell / shape_.columns;
    return (row + row / shape_.rows) * (shape_.columns + 1) + cell % shape_.columns;
  }
  /// u += W push.
  void move_held(const Held& held, const Components& push, Output u) const {
    const Components kick = times(held.w, push);
    for (std::size_t axis = 0; axis < E::axes; ++axis) u[axis * n_ + held.node] += kick[axis];
  }
  void linearise_over(Interval when, Input q0, Input q1, Input at, int sweep) {
    when_ = when;
    const std::size_t first = first_pushed_row_ * (shape_.columns + 1);
    for (std::size_t axis = 0; axis < E::axes; ++axis) std::fill_n(&push_[axis * n_ + first], n_ - first, 0.0);
    static_cast<Model&>(*this).gather(q0, q1, at, sweep);
    if (sweep == 0) assemble_and_factor();
  }
  /// What shift_east of the models has in common: drops the west column of the state and of the first places x, y in
  /// plan, and puts a column of this width before the east side: at rest, with the places of the last one beside it.
  void shift_columns(mechanics::State& state, std::vector<double>& x, std::vector<double>& y, double width) {
    const std::size_t columns = shape_.columns;
    for (std::vector<double>* values : {&state.q, &state.u, &x, &y}) shift_rows(std::span(*values), columns + 1);
    shift_rows(std::span(volume_), columns);
    state.earlier_u.clear();
    for (std::vector<double>* multipliers : state.all_multipliers()) {
      if (multipliers->empty()) continue;
      shift_rows(std::span(*multipliers), columns);
      for (std::size_t row = 1; row <= cell_rows(); ++row) (*multipliers)[row * columns - 1] = 0;
    }
    for (std::size_t east = columns; east < n_; east += columns + 1) {
      x[east] = state.q[east] = x[east] + width;
      state.q[n_ + east] = y[east];
      for (std::size_t axis = 0; axis < E::axes; ++axis) state.u[axis * n_ + east] = 0;
    }
  }
  /// And join_shift: numbers that other parts own.
  void join_columns(std::vector<double>& x, std::vector<double>& y, const std::function<void(Output)>& nodes,
                    const std::function<void(Output)>& cells) {
    std::vector<double> first = joined({x, y});
    first.resize(E::axes * n_);
    nodes(first);
    std::copy_n(first.begin(), n_, x.begin());
    std::copy_n(first.begin() + static_cast<std::ptrdiff_t>(n_), n_, y.begin());
    cells(volume_);
  }
  /// Adds mass times acceleration(node), along the first axes, to the push.
  template <class Acceleration>
  void push_bodies(const Acceleration& acceleration) {
    for (std::size_t k = 0; k < n_; ++k) {
      const auto f = acceleration(k);
      for (std::size_t axis = 0; axis < f.size(); ++axis) push_[axis * n_ + k] += self().node_masses()[k] * f[axis];
    }
  }

  static constexpr double tolerance_of_sweeps = 1e-3;  // of the correction that a sweep makes; the next one goes on

  Cells shape_;
  std::size_t n_;
  std::vector<double> volume_;        // of the cells at the beginning
  linear::RowBlocks gradients_;       // by rows of cells
  std::vector<double> push_;          // forces on nodes along x, y(, z)
  std::size_t first_pushed_row_ = 0;  // of nodes; nothing pushes those before
  std::vector<Held> held_;
  std::vector<double> middle_, no_cells_;
  linear::StencilMatrix matrix_;
  linear::ConstraintSolver solver_;
  double tolerance_;
  Interval when_;          // of the last linearisation
  bool sweeping_ = false;  // which was a sweep of a conservative step
};

}  // namespace seiche::lattice
