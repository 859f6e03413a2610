#include "seiche/models/dispersive_shallow_water_2d/model.hpp"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/models/dispersive_shallow_water_2d/undeformed.hpp"
#include "seiche/require.hpp"

namespace seiche::dispersive_shallow_water_2d {

namespace {

Lattice valid(Lattice lattice) {
  lattice.require_valid();
  return lattice;
}

}  // namespace

Model::Model(Lattice lattice, Settings settings, Forcing forcing)
    : lattice_(valid(std::move(lattice))),
      settings_(settings),
      forcing_(std::move(forcing)),
      masses_((require_within("inertia", settings.inertia, 1e-3, 1), lattice_.shape), lattice_.sides, lattice_.x,
              lattice_.y, settings.inertia),
      dispersion_(lattice_.shape, settings.gamma),
      drag_(settings.drag, lattice_, settings.inertia),
      gradients_(lattice_.shape.columns, lattice_.shape.rows),
      push_(3 * lattice_.shape.nodes(), 0.0),
      no_cells_(lattice_.shape.columns + 1, 0.0),
      matrix_(lattice_.shape.columns, lattice_.shape.rows),
      solver_(lattice_.shape.columns, lattice_.shape.rows, settings.solver,
              undeformed_lattice(lattice_, settings.inertia), settings.tolerance) {
  require_not_negative("gravity", settings.gravity);
  if (lattice_.bottom) bottom_.emplace(lattice_.shape, lattice_.bottom);
  volume_.assign(shape().cells(), 0.0);
  std::vector<double> places = lattice_.x;
  places.insert(places.end(), lattice_.y.begin(), lattice_.y.end());
  places.insert(places.end(), lattice_.z.begin(), lattice_.z.end());
  constraint_values(places, volume_);
  if (!plan_lattice::shore_edges(shape(), lattice_.sides).empty()) {
    shoreline_.emplace(shape(), lattice_.sides, lattice_.bottom, places);
  }
  for (std::size_t cell = 0; cell < shape().cells(); ++cell) {
    const auto [c0, c1, c2, c3] = shape().corners(cell);
    const auto j = bilinear_patch::jacobians({places[c0], places[c1], places[c2], places[c3]},
                                             {lattice_.y[c0], lattice_.y[c1], lattice_.y[c2], lattice_.y[c3]});
    mean_area_ += 0.5 * (j.c0 + j.c2) / static_cast<double>(shape().cells());
    if (!(volume_[cell] > 0)) {
      throw std::invalid_argument(fmt::format("cell {} at ({:g}, {:g}) holds {:g} of water; allowed: positive", cell,
                                              lattice_.x[c0], lattice_.y[c0], volume_[cell]));
    }
  }
  east_width_ = lattice_.x[shape().columns] - lattice_.x[shape().columns - 1];
  sum_masses();
  stand(places);
}

void Model::sum_masses() {
  const std::span<double> mass = masses_.mass();
  std::fill(mass.begin(), mass.end(), 0.0);
  for (std::size_t cell = 0; cell < shape().cells(); ++cell) {
    for (const std::size_t k : shape().corners(cell)) {
      mass[k] += (on_shore(k) ? Shoreline::share_of_mass : 0.25) * volume_[cell];
    }
  }
  if (!bottom_) masses_.stand_on_level_bottom();
}

mechanics::State Model::state(const InitialVelocity& velocity) const {
  mechanics::State state{.q = lattice_.x, .u = std::vector<double>(rates(), 0.0)};
  state.q.insert(state.q.end(), lattice_.y.begin(), lattice_.y.end());
  state.q.insert(state.q.end(), lattice_.z.begin(), lattice_.z.end());
  const std::size_t n = nodes();
  const auto set = [&](std::size_t k, const Velocity& given) {
    state.u[k] = given.u;
    state.u[n + k] = given.v;
    state.u[2 * n + k] = given.w;
  };
  if (const auto* nodal = std::get_if<std::vector<Velocity>>(&velocity)) {
    if (nodal->size() != n) {
      throw std::invalid_argument(fmt::format("{} velocities of nodes; allowed: {}", nodal->size(), n));
    }
    for (std::size_t k = 0; k < n; ++k) set(k, (*nodal)[k]);
  } else if (const auto& at = std::get<VelocityAt>(velocity)) {
    for (std::size_t k = 0; k < n; ++k) set(k, at(lattice_.x[k], lattice_.y[k]));
  }
  if (bottom_) find_normals(state.q, other_normals_);
  masses_.constrain(state.q, 0, bottom_ ? &other_normals_ : nullptr, true, state.u);
  return state;
}

void Model::find_normals(Input q, Normals& normals) const {
  const std::size_t n = nodes();
  for (auto* along : {&normals.x, &normals.y, &normals.z}) along->resize(n);
  try {
    for (std::size_t k = 0; k < n; ++k) {
      const auto b = lattice_.bottom->slope(q[k], q[n + k]);
      const double length = std::sqrt(1 + b.along_x * b.along_x + b.along_y * b.along_y);
      normals.x[k] = -b.along_x / length;
      normals.y[k] = -b.along_y / length;
      normals.z[k] = 1 / length;
      if (!(q[2 * n + k] > b.elevation) && !on_shore(k)) {
        throw mechanics::Infeasible(fmt::format("a marker at ({:g}, {:g}) is {:g} above the bottom (allowed: positive)",
                                                q[k], q[n + k], q[2 * n + k] - b.elevation),
                                    q[k]);
      }
    }
  } catch (const OutsidePlanBottom& failure) {
    throw mechanics::Infeasible(failure.what(), failure.place());
  }
}

void Model::stand(Input q) {
  const std::size_t n = nodes();
  if (bottom_) {
    find_normals(q, normals_);
    masses_.stand_on(normals_);
  }
  if (masses_.has_driven_sides()) masses_.turn_driven_sides(q.first(n), q.subspan(n, n), normals());
}

void Model::linearise(Interval when, Input q) {
  when_ = when;
  try {
    measure(q, 1, false);
    if (bottom_) bottom_->subtract_gradients(plan(q), gradients_);
    if (shoreline_) shoreline_->push(q, settings_.gravity, push_);
    if (dispersion_.active()) dispersion_.push(volume_, q, q, settings_.gravity, push_);
    stand(q);
  } catch (const OutsidePlanBottom& failure) {
    throw mechanics::Infeasible(failure.what(), failure.place());
  }
  push_bodies(when.middle());
  if (drag_.active()) drag_.measure(lattice_, volume_, q);
  assemble_and_factor();
  sweeping_ = false;
}

void Model::linearise_between(Interval when, Input q0, Input q1, int sweep) {
  when_ = when;
  middle_.resize(q0.size());
  for (std::size_t i = 0; i < q0.size(); ++i) middle_[i] = 0.5 * (q0[i] + q1[i]);
  try {
    // Simpson's mean: exact for gradients of polynomials of degree up to four.
    measure(q0, 1.0 / 6, false);
    measure(q1, 1.0 / 6, true);
    measure(middle_, 4.0 / 6, true);
    if (bottom_) bottom_->subtract_gradients_between(plan(q0), plan(q1), gradients_);
    if (shoreline_) shoreline_->push_between(q0, q1, settings_.gravity, push_);
    if (dispersion_.active()) dispersion_.push(volume_, q0, q1, settings_.gravity, push_);
    stand(middle_);
    if (shoreline_) {
      shoreline_->tilt_between(q0, q1, normals_);
      masses_.stand_on(normals_);
    }
  } catch (const OutsidePlanBottom& failure) {
    throw mechanics::Infeasible(failure.what(), failure.place());
  }
  push_bodies(when.middle());
  if (drag_.active()) drag_.measure(lattice_, volume_, middle_, sweep == 0);
  if (sweep == 0) assemble_and_factor();
  sweeping_ = true;
}

void Model::measure(Input q, double weight, bool add) {
  const std::size_t n = nodes();
  const std::size_t columns = shape().columns;
  const double bottom = bottom_ ? 0.0 : -lattice_.depth;
  const std::size_t scratch_of_row = 12 * columns;
  const auto threads = static_cast<std::size_t>(omp_get_max_threads());  // may have become more since the last step
  scratch_.resize(std::max(scratch_.size(), scratch_of_row * threads));
  std::atomic<bool> folded = false;
  std::atomic<bool> dry = false;
  const auto clear = [&](std::size_t row, std::size_t count) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::fill_n(push_.data() + axis * n + row * (columns + 1), count * (columns + 1), 0.0);
    }
  };
  // Even rows of cells have all rows of nodes but, where the rows are even in number, the last one.
  if (!add && shape().rows % 2 == 0) clear(shape().rows, 1);
  // Rows of one parity share no nodes; each row of nodes is added to from above and from below, in this order.
  for (std::size_t parity = 0; parity < 2; ++parity) {
    linear::share_out((shape().rows + 1 - parity) / 2, shape().cells() > linear::worth_threads, [&](std::size_t pair) {
      const std::size_t j = 2 * pair + parity;
      if (!add && parity == 0) clear(j, 2);
      const std::size_t k = j * (columns + 1);
      const auto rows = [&](std::size_t axis) {
        const double* lower = q.data() + axis * n + k;
        return NodeRows{lower, lower + columns + 1};
      };
      const auto forces = [&](std::size_t axis) {
        double* lower = push_.data() + axis * n + k;
        return ForceRows{lower, lower + columns + 1};
      };
      double* scratch = scratch_.data() + scratch_of_row * static_cast<std::size_t>(omp_get_thread_num());
      const RowExtremes least =
          measure_row(columns, j * columns, {rows(0), rows(1), rows(2)}, bottom, settings_.gravity, weight, add,
                      gradients_, {forces(0), forces(1), forces(2)}, scratch);
      if (least.jacobian <= 0) folded = true;
      if (least.depth <= 0) dry = true;
    });
  }
  if (folded) throw_folded(q);
  if (!bottom_ && dry) {
    const auto lowest = static_cast<std::size_t>(
                            std::min_element(q.begin() + static_cast<std::ptrdiff_t>(2 * n), q.end()) - q.begin()) -
                        2 * n;
    throw mechanics::Infeasible(fmt::format("the surface touches the bottom: z = {:g} at ({:g}, {:g}) (allowed: above "
                                            "{:g})",
                                            q[2 * n + lowest], q[lowest], q[n + lowest], bottom),
                                q[lowest]);
  }
}

void Model::throw_folded(Input q) const {
  const Corner worst = worst_corner(q);
  const std::size_t corner = shape().corners(worst.cell)[0];
  throw mechanics::Infeasible(
      fmt::format(
          "the lattice folds: a corner of cell {} (column {}, row {}, at ({:g}, {:g})) has shape {:.3g} (1 at the "
          "beginning, allowed: positive)",
          worst.cell, worst.cell % shape().columns, worst.cell / shape().columns, q[corner], q[nodes() + corner],
          worst.shape),
      q[corner]);
}

Corner Model::worst_corner(Input q) const {
  const std::size_t n = nodes();
  Corner worst{.shape = std::numeric_limits<double>::infinity(), .cell = 0};
  for (std::size_t cell = 0; cell < shape().cells(); ++cell) {
    const auto [c0, c1, c2, c3] = shape().corners(cell);
    const auto j =
        bilinear_patch::jacobians({q[c0], q[c1], q[c2], q[c3]}, {q[n + c0], q[n + c1], q[n + c2], q[n + c3]});
    const double shape_of_corner = std::min(std::min(j.c0, j.c1), std::min(j.c2, j.c3)) / mean_area_;
    if (!(shape_of_corner >= worst.shape)) worst = {shape_of_corner, cell};
  }
  return worst;
}

void Model::push_bodies(double time) {
  if (!forcing_.body_force) return;
  const std::size_t n = nodes();
  for (std::size_t k = 0; k < n; ++k) {
    const Point force = forcing_.body_force({lattice_.x[k], lattice_.y[k]}, time);
    push_[k] += masses_.mass()[k] * force.x;
    push_[n + k] += masses_.mass()[k] * force.y;
  }
}

void Model::assemble_and_factor() {
  const std::size_t columns = shape().columns;
  const std::size_t rows = shape().rows;
  linear::share_out(rows, shape().cells() > linear::worth_threads, [&](std::size_t j) {
    assemble_row(columns, j * columns, j * (columns + 1), masses_.full(j) || masses_.full(j + 1), j + 1 < rows,
                 gradients_, masses_.inverse(), matrix_);
  });
  try {
    solver_.factor(matrix_);
  } catch (const linear::NotPositiveDefinite& failure) {
    const std::size_t cell = failure.row();
    throw mechanics::Infeasible(fmt::format("cell {}: {}", cell, failure.what()), lattice_.x[shape().corners(cell)[0]]);
  }
}

void Model::advance(Input from, Input u, double h, Output to) const {
  const double* const begin = from.data();
  const double* const rate = u.data();
  double* const end = to.data();
  const std::size_t row = shape().columns + 1;
  linear::share_out(from.size() / row, from.size() > 3 * linear::worth_threads, [&](std::size_t j) {
#pragma omp simd
    for (std::size_t i = j * row; i < (j + 1) * row; ++i) end[i] = begin[i] + h * rate[i];
  });
}

void Model::kick(double h, Output u) const {
  const std::size_t n = nodes();
  const std::size_t count = shape().columns + 1;
  if (drag_.absorbs()) drag_.absorb(h, u);
  linear::share_out(shape().rows + 1, shape().cells() > linear::worth_threads, [&](std::size_t j) {
    const std::size_t k = j * count;
    kick_row(count, k, masses_.full(j), h, {push_.data() + k, push_.data() + n + k, push_.data() + 2 * n + k},
             masses_.inverse(), {u.data() + k, u.data() + n + k, u.data() + 2 * n + k});
  });
  if (drag_.active()) drag_.slow(masses_.mass(), masses_.inverse(), settings_.gravity, h, u);
}

void Model::carry(Input q, bool onto, Output u) const {
  find_normals(q, other_normals_);
  masses_.carry(onto ? other_normals_ : normals_, onto ? normals_ : other_normals_, u);
}

// Only nodes of driven sides can have got a forbidden velocity.
void Model::enter(Input q, Output u) const {
  if (bottom_) carry(q, true, u);
  if (masses_.has_driven_sides()) masses_.constrain(q, when_.middle(), normals(), false, u);
}

void Model::settle(Interval when, Output q, Output u) const {
  if (shoreline_) shoreline_->land(q);
  if (bottom_) carry(q, false, u);
  if (masses_.has_driven_sides()) {
    masses_.constrain(q, when.end(), bottom_ ? &other_normals_ : nullptr, false, u);
  }
  drag_.settle();
}

void Model::constraint_rates(Input u, Output w) const {
  const std::size_t columns = shape().columns;
  const std::size_t n = nodes();
  linear::share_out(shape().rows, shape().cells() > linear::worth_threads, [&](std::size_t j) {
    const auto rows = [&](std::size_t axis) {
      const double* lower = u.data() + axis * n + j * (columns + 1);
      return NodeRows{lower, lower + columns + 1};
    };
    rates_of_row(columns, j * columns, gradients_, {rows(0), rows(1), rows(2)}, w.data() + j * columns);
  });
}

void Model::react(Input mu, Output u) const {
  const std::size_t columns = shape().columns;
  const std::size_t n = nodes();
  linear::share_out(shape().rows + 1, shape().cells() > linear::worth_threads, [&](std::size_t j) {
    const std::size_t k = j * (columns + 1);
    const auto above = static_cast<std::ptrdiff_t>(j * columns);
    const auto below = above - static_cast<std::ptrdiff_t>(columns);
    react_row(columns, k, masses_.full(j), below, above, gradients_, j == 0 ? no_cells_.data() : mu.data() + below,
              j == shape().rows ? no_cells_.data() : mu.data() + above, masses_.inverse(),
              {u.data() + k, u.data() + n + k, u.data() + 2 * n + k});
  });
}

void Model::solve(Input right_hand_side, Output mu) {
  solver_.solve(right_hand_side, mu, sweeping_ ? tolerance_of_sweeps : 0);
}

}  // namespace seiche::dispersive_shallow_water_2d
