#include "seiche/models/dispersive_shallow_water_2d/model.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::dispersive_shallow_water_2d {

namespace {

using bilinear_patch::at_corners;
using bilinear_patch::Corners;

/// The undeformed lattice nearest to a given one, which preconditions its systems: equal rectangles between four walls
/// over a level bottom, of the lattice's mean sizes, depth H and inertia alpha:
///
///     symbol = H [4 (h2/h1) s1^2 c2^2 + 4 (h1/h2) s2^2 c1^2] + h1 h2 c1^2 c2^2/(alpha H),   s, c of half the phases
linear::UndeformedLattice undeformed_lattice(const Lattice& lattice, double inertia) {
  const Shape shape = lattice.shape;
  double volume = 0;
  double area = 0;
  double length = 0;
  for (std::size_t cell = 0; cell < shape.cells(); ++cell) {
    const auto [c0, c1, c2, c3] = shape.corners(cell);
    const Corners x = at_corners(lattice.x, shape.corners(cell));
    const Corners y = at_corners(lattice.y, shape.corners(cell));
    const auto depth = [&](std::size_t k) { return lattice.z[k] - lattice.bed(lattice.x[k], lattice.y[k]); };
    const auto j = bilinear_patch::jacobians(x, y);
    volume += bilinear_patch::volume(x, y, {depth(c0), depth(c1), depth(c2), depth(c3)});
    area += 0.5 * (j.c0 + j.c2);
    length += std::hypot(x.c1 - x.c0, y.c1 - y.c0);
  }
  const double h1 = length / static_cast<double>(shape.cells());
  const double h2 = area / length;
  const double depth = volume / area;
  const auto symbol = [=](double theta, double psi, std::span<double> diagonal, std::span<double>) {
    const double s1 = std::pow(std::sin(theta / 2), 2);
    const double s2 = std::pow(std::sin(psi / 2), 2);
    const double c1 = 1 - s1;
    const double c2 = 1 - s2;
    diagonal[0] = 4 * depth * (h2 / h1 * s1 * c2 + h1 / h2 * s2 * c1) + h1 * h2 * c1 * c2 / (inertia * depth);
  };
  return {.shape = {.nx = shape.columns, .nz = shape.rows, .layers = 1}, .matrix = symbol, .scaled = true};
}

}  // namespace

Model::Model(Lattice lattice, Settings settings, Forcing forcing)
    : Water{lattice::valid_cells(lattice, settings, {lattice.shape.columns, lattice.shape.rows}),
            std::vector<double>(lattice.shape.cells()),
            {lattice.shape.columns, lattice.shape.rows, settings.solver, undeformed_lattice(lattice, settings.inertia),
             settings.tolerance},
            settings.tolerance},
      lattice_(std::move(lattice)),
      settings_(settings),
      forcing_(std::move(forcing)),
      masses_(shape(), lattice_.sides, lattice_.x, lattice_.y, settings.inertia),
      surface_(shape().columns, shape().rows, n_),
      drag_(settings.drag, lattice_, settings.inertia),
      normals_(n_, {0, 0, 1}),
      other_normals_(normals_) {
  if (lattice_.bottom) bottom_.emplace(shape(), lattice_.bottom);
  const std::vector<double> places = lattice::joined({lattice_.x, lattice_.y, lattice_.z});
  if (!plan_lattice::shore_edges(shape(), lattice_.sides).empty()) {
    shoreline_.emplace(shape(), lattice_.sides, lattice_.bottom, places);
  }
  for (std::size_t cell = 0; cell < volume_.size(); ++cell) {
    const std::size_t corner = first_node(cell);
    volume_[cell] = cell_volume(places, cell);
    mean_area_ += cell_area(shape(), lattice_.x, lattice_.y, cell) / static_cast<double>(volume_.size());
    require_that(volume_[cell] > 0, "cell {} at ({:g}, {:g}) holds {:g} of water; allowed: positive", cell,
                 lattice_.x[corner], lattice_.y[corner], volume_[cell]);
  }
  east_width_ = lattice_.x[shape().columns] - lattice_.x[shape().columns - 1];
  sum_masses();
  stand(places);
}

void Model::sum_masses() {
  const std::span<double> mass = masses_.mass();
  std::ranges::fill(mass, 0.0);
  for (std::size_t cell = 0; cell < volume_.size(); ++cell) {
    for (const std::size_t k : shape().corners(cell)) {
      mass[k] += (on_shore(k) ? Shoreline::share_of_mass : 0.25) * volume_[cell];
    }
  }
  if (!bottom_) masses_.stand_on(normals_);
}

mechanics::State Model::state(const InitialVelocity& velocity) const {
  mechanics::State state{.q = lattice::joined({lattice_.x, lattice_.y, lattice_.z}),
                         .u = std::vector<double>(rates(), 0.0)};
  const auto given = lattice::nodal(
      velocity, n_, [&](const VelocityAt& at, std::size_t k) { return at(lattice_.x[k], lattice_.y[k]); });
  for (std::size_t k = 0; k < n_; ++k) put_vector({given[k].u, given[k].v, given[k].w}, k, state.u);
  if (bottom_) find_normals(state.q, other_normals_);
  masses_.constrain(state.q, 0, other_normals_, true, state.u);
  return state;
}

void Model::find_normals(Input q, Normals& normals) const {
  for (std::size_t k = 0; k < n_; ++k) {
    const auto b = lattice_.bottom->slope(q[k], q[n_ + k]);
    const double length = std::sqrt(1 + b.along_x * b.along_x + b.along_y * b.along_y);
    normals[k] = {-b.along_x / length, -b.along_y / length, 1 / length};
    if (!(q[2 * n_ + k] > b.elevation) && !on_shore(k)) {
      throw mechanics::Infeasible(q[k], "a marker at ({:g}, {:g}) is {:g} above the bottom (allowed: positive)", q[k],
                                  q[n_ + k], q[2 * n_ + k] - b.elevation);
    }
  }
}

void Model::stand(Input q) {
  if (bottom_) {
    find_normals(q, normals_);
    masses_.stand_on(normals_);
  }
  if (masses_.has_driven_sides()) masses_.turn_driven_sides(q.first(n_), q.subspan(n_, n_), normals_);
}

void Model::gather(Input q0, Input q1, Input at, int sweep) {
  const bool instant = q0.data() == q1.data();
  // Simpson's mean: exact for gradients of polynomials of degree up to four.
  if (!instant) measure(q0, 1.0 / 6, false);
  if (!instant) measure(q1, 1.0 / 6, true);
  measure(at, instant ? 1 : 4.0 / 6, !instant);
  if (bottom_) bottom_->subtract_gradients(q0, q1, gradients_);
  if (shoreline_) shoreline_->push(q0, q1, settings_.gravity, push_);
  if (settings_.gamma > 0) push_dispersion(shape(), settings_.gravity * settings_.gamma, volume_, q0, q1, push_);
  stand(at);
  if (shoreline_ && !instant) {
    shoreline_->tilt_between(q0, q1, normals_);
    masses_.stand_on(normals_);
  }
  if (forcing_.body_force) {
    push_bodies([&](std::size_t k) {
      const Point force = forcing_.body_force({lattice_.x[k], lattice_.y[k]}, when_.middle());
      return std::array{force.x, force.y};
    });
  }
  if (drag_.active()) drag_.measure(lattice_, volume_, at, sweep == 0);
}

void Model::measure(Input q, double weight, bool add) {
  const double bottom = bottom_ ? 0.0 : -lattice_.depth;
  std::atomic<bool> tangled = false;
  each_row([&](std::size_t j) {
    if (measure_row(shape_.columns, around(j, q), bottom, weight, add, gradients_.row(j)) <= 0) tangled = true;
  });
  surface_.push(q, settings_.gravity * weight, push_);
  if (tangled) throw_tangled(q);
  const Input z = q.last(n_);
  const auto lowest = static_cast<std::size_t>(std::ranges::min_element(z) - z.begin());
  if (!bottom_ && z[lowest] <= bottom) {
    throw mechanics::Infeasible(q[lowest],
                                "the surface touches the bottom: z = {:g} at ({:g}, {:g}) (allowed: above "
                                "{:g})",
                                z[lowest], q[lowest], q[n_ + lowest], bottom);
  }
}

void Model::kick(double h, Output u) const {
  if (drag_.absorbs()) drag_.absorb(h, u);
  Water::kick(h, u);
  if (drag_.active()) drag_.slow(masses_.mass(), masses_.inverse(), settings_.gravity, h, u);
}

void Model::carry(Input q, bool onto, Output u) const {
  find_normals(q, other_normals_);
  masses_.carry(onto ? other_normals_ : normals_, onto ? normals_ : other_normals_, u);
}

// Only nodes of driven sides can have got a forbidden velocity.
void Model::enter(Input q, Output u) const {
  if (bottom_) carry(q, true, u);
  if (masses_.has_driven_sides()) masses_.constrain(q, when_.middle(), normals_, false, u);
}

void Model::settle(Interval when, Output q, Output u) const {
  if (shoreline_) shoreline_->land(q);
  if (bottom_) carry(q, false, u);
  if (masses_.has_driven_sides()) masses_.constrain(q, when.end(), other_normals_, false, u);
  drag_.breaking().settle();
}

std::array<double, 3> Model::momentum_of(std::size_t k, Input u) const {
  const double m = masses_.mass()[k];
  const double less = 1 - settings_.inertia;
  if (!bottom_) return {m * u[k], m * u[n_ + k], m * settings_.inertia * u[2 * n_ + k]};
  const Vector3 v = vector_at(u, k);
  const Vector3 p = m * (v - less * dot(v, other_normals_[k]) * other_normals_[k]);
  return {p.x, p.y, p.z};
}

double Model::cell_volume(Input q, std::size_t cell) const {
  const double bottom = bottom_ ? 0.0 : -lattice_.depth;
  const auto corners = shape().corners(cell);
  const Corners z = at_corners(q.subspan(2 * n_), corners);
  const double volume = bilinear_patch::volume(at_corners(q, corners), at_corners(q.subspan(n_), corners),
                                               {z.c0 - bottom, z.c1 - bottom, z.c2 - bottom, z.c3 - bottom});
  const auto point = [&](std::size_t a) { return Point{q[corners[a]], q[n_ + corners[a]]}; };
  return bottom_ ? volume - bottom_->volume({point(0), point(1), point(2), point(3)}) : volume;
}

/// Over the mean Jacobian at the beginning.
double Model::cell_shape(Input q, std::size_t cell) const {
  const auto corners = shape().corners(cell);
  return smallest(bilinear_patch::jacobians(at_corners(q, corners), at_corners(q.subspan(n_), corners))) / mean_area_;
}

double Model::potential_energy(Input q, std::span<const char> counted) const {
  double sum = surface_.moment(q, counted);
  if (shoreline_) sum -= shoreline_->bottom_moment(q, counted);
  if (settings_.gamma > 0) {
    // It has the square of a cell's volume as a factor.
    std::vector<double> volumes = volume_;
    for (std::size_t cell = 0; cell < counted.size(); ++cell) volumes[cell] *= counted[cell] != 0 ? 1 : 0;
    sum += dispersion_energy(shape(), settings_.gamma, volumes, q);
  }
  return settings_.gravity * sum;
}

void Model::shift_east(mechanics::State& state) {
  shift_columns(state, lattice_.x, lattice_.y, east_width_);
  drag_.breaking().shift_east();
  const std::size_t columns = shape_.columns;
  for (std::size_t east = columns; east < n_; east += columns + 1) state.q[2 * n_ + east] = 0;
  for (std::size_t cell = columns - 1; cell < volume_.size(); cell += columns) {
    volume_[cell] = cell_volume(state.q, cell);
  }
  sum_masses();
}

}  // namespace seiche::dispersive_shallow_water_2d
