// What the plan model conserves, and how a moving window shifts it.
#include <cmath>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/models/dispersive_shallow_water_2d/model.hpp"
#include "seiche/plan_lattice/window.hpp"

namespace seiche::dispersive_shallow_water_2d {

namespace {

using bilinear_patch::Corners;

Corners at(const double* values, const std::array<std::size_t, 4>& corners) {
  return {values[corners[0]], values[corners[1]], values[corners[2]], values[corners[3]]};
}

}  // namespace

double Model::cell_volume(Input q, std::size_t cell) const {
  const std::size_t n = nodes();
  const double bottom = bottom_ ? 0.0 : -lattice_.depth;
  const auto corners = shape().corners(cell);
  const Corners z = at(q.data() + 2 * n, corners);
  const double volume = bilinear_patch::volume(at(q.data(), corners), at(q.data() + n, corners),
                                               {z.c0 - bottom, z.c1 - bottom, z.c2 - bottom, z.c3 - bottom});
  return bottom_ ? volume - bottom_->volume(plan(q), cell) : volume;
}

void Model::constraint_values(Input q, Output f) const {
  for (std::size_t cell = 0; cell < shape().cells(); ++cell) f[cell] = cell_volume(q, cell) - volume_[cell];
}

double Model::mass() const {
  CompensatedSum sum;
  for (const double m : masses_.mass()) sum.add(m);
  return sum.value();
}

std::array<double, 2> Model::momentum(Input q, Input u) const {
  const std::size_t n = nodes();
  if (bottom_) find_normals(q, other_normals_);
  CompensatedSum along_x;
  CompensatedSum along_y;
  for (std::size_t k = 0; k < n; ++k) {
    double across = 0;
    if (bottom_) {
      across = (1 - settings_.inertia) *
               (u[k] * other_normals_.x[k] + u[n + k] * other_normals_.y[k] + u[2 * n + k] * other_normals_.z[k]);
    }
    along_x.add(masses_.mass()[k] * (u[k] - (bottom_ ? across * other_normals_.x[k] : 0.0)));
    along_y.add(masses_.mass()[k] * (u[n + k] - (bottom_ ? across * other_normals_.y[k] : 0.0)));
  }
  return {along_x.value(), along_y.value()};
}

std::array<double, 1> Model::angular_momentum(Input q, Input u) const {
  const std::size_t n = nodes();
  CompensatedSum sum;
  for (std::size_t k = 0; k < n; ++k) sum.add(masses_.mass()[k] * (q[k] * u[n + k] - q[n + k] * u[k]));
  return {sum.value()};
}

double Model::kinetic_energy(Input q, Input u) const {
  const std::size_t n = nodes();
  if (bottom_) find_normals(q, other_normals_);
  CompensatedSum sum;
  for (std::size_t k = 0; k < n; ++k) {
    const double across =
        bottom_ ? u[k] * other_normals_.x[k] + u[n + k] * other_normals_.y[k] + u[2 * n + k] * other_normals_.z[k]
                : u[2 * n + k];
    const double square = u[k] * u[k] + u[n + k] * u[n + k] + u[2 * n + k] * u[2 * n + k];
    sum.add(0.5 * masses_.mass()[k] * (square - (1 - settings_.inertia) * across * across));
  }
  return sum.value();
}

double Model::potential_energy(Input q, std::span<const char> counted) const {
  const std::size_t n = nodes();
  CompensatedSum sum;
  for (std::size_t cell = 0; cell < shape().cells(); ++cell) {
    if (!counted.empty() && counted[cell] == 0) continue;
    const auto corners = shape().corners(cell);
    sum.add(bilinear_patch::moment(at(q.data(), corners), at(q.data() + n, corners), at(q.data() + 2 * n, corners)));
  }
  if (shoreline_) sum.add(-shoreline_->bottom_moment(q, counted));
  if (dispersion_.active() && counted.empty()) sum.add(dispersion_.value(volume_, q));
  if (dispersion_.active() && !counted.empty()) {
    // It has the square of a cell's volume as a factor.
    std::vector<double> volumes = volume_;
    for (std::size_t cell = 0; cell < volumes.size(); ++cell) volumes[cell] *= counted[cell] != 0 ? 1 : 0;
    sum.add(dispersion_.value(volumes, q));
  }
  return settings_.gravity * sum.value();
}

void Model::shift_east(mechanics::State& state) {
  const std::size_t n = nodes();
  const std::size_t columns = shape().columns;
  const std::size_t rows = shape().rows;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    plan_lattice::shift_rows(std::span(state.q).subspan(axis * n, n), columns + 1);
    plan_lattice::shift_rows(std::span(state.u).subspan(axis * n, n), columns + 1);
  }
  plan_lattice::shift_rows(std::span(lattice_.x), columns + 1);
  plan_lattice::shift_rows(std::span(lattice_.y), columns + 1);
  plan_lattice::shift_rows(std::span(volume_), columns);
  drag_.shift_east();
  state.earlier_u.clear();
  for (std::vector<double>* multipliers : state.all_multipliers()) {
    if (multipliers->empty()) continue;
    plan_lattice::shift_rows(std::span(*multipliers), columns);
    for (std::size_t j = 0; j < rows; ++j) (*multipliers)[j * columns + columns - 1] = 0;
  }
  for (std::size_t j = 0; j <= rows; ++j) {
    const std::size_t east = shape().node(columns, j);
    lattice_.x[east] = state.q[east] = lattice_.x[east] + east_width_;
    state.q[n + east] = lattice_.y[east];
    state.q[2 * n + east] = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) state.u[axis * n + east] = 0;
  }
  for (std::size_t j = 0; j < rows; ++j) {
    const std::size_t cell = j * columns + columns - 1;
    volume_[cell] = cell_volume(state.q, cell);
  }
  sum_masses();
}

void Model::join_shift(const std::function<void(Output)>& nodes, const std::function<void(Output)>& cells) {
  const auto n = static_cast<std::ptrdiff_t>(this->nodes());
  std::vector<double> first(lattice_.x);
  first.insert(first.end(), lattice_.y.begin(), lattice_.y.end());
  first.insert(first.end(), lattice_.z.begin(), lattice_.z.end());
  nodes(first);
  lattice_.x.assign(first.begin(), first.begin() + n);
  lattice_.y.assign(first.begin() + n, first.begin() + 2 * n);
  cells(volume_);
  sum_masses();
}

}  // namespace seiche::dispersive_shallow_water_2d
