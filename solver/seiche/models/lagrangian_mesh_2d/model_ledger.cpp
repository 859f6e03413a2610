// Forces from the potential, and what the model conserves.
#include <algorithm>
#include <cmath>

#include "seiche/models/lagrangian_mesh_2d/model.hpp"

namespace seiche::lagrangian_mesh_2d {

namespace {

/// r0 - r1 + r2 - r3.
double alternating(const double* z, const std::array<std::size_t, 4>& r) {
  return z[r[0]] - z[r[1]] + z[r[2]] - z[r[3]];
}

/// (v_2 - v_0) x (w_3 - w_1) and the like, symmetric in v and w: the second derivative of a cell's area along them.
double bilinear(const std::array<std::size_t, 4>& r, const double* vx, const double* vy, const double* wx,
                const double* wy) {
  const auto along = [](const double* z, std::size_t from, std::size_t to) { return z[to] - z[from]; };
  return 0.5 * (along(vx, r[0], r[2]) * along(wy, r[1], r[3]) + along(wx, r[0], r[2]) * along(vy, r[1], r[3]) -
                along(vx, r[1], r[3]) * along(wy, r[0], r[2]) - along(wx, r[1], r[3]) * along(vy, r[0], r[2]));
}

}  // namespace

void Model::gather_forces(Interval when, Places at, double weight) {
  double* fx = push_x_.data();
  double* fy = push_y_.data();
  edges_.push_down(at.x, at.y, weight * settings_.density * settings_.gravity, fx, fy);
  if (forcing_.surface_pressure) {
    const double time = when.middle();
    edges_.press([&](double x) { return forcing_.surface_pressure(x, time); }, at.x, at.y, weight, fx, fy);
  }
  if (hourglass_stiffness_ > 0) add_hourglass_forces(at, weight);
  if (barrier_.active()) barrier_.push(mesh_, area_, at.x, at.y, weight, push_x_, push_y_);
  if (forcing_.body_force) {
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const Point force = forcing_.body_force(nodes_.label(k), when.middle());
      fx[k] += weight * nodes_.mass()[k] * force.x;
      fy[k] += weight * nodes_.mass()[k] * force.y;
    }
  }
}

void Model::add_hourglass_forces(Places at, double weight) {
  const double stiffness = weight * hourglass_stiffness_;
  for (std::size_t cell = 0; cell < mesh_.cells(); ++cell) {
    const auto r = mesh_.corners(cell);
    const double hx = stiffness * (alternating(at.x, r) - hourglass_rest_[cell].x);
    const double hy = stiffness * (alternating(at.y, r) - hourglass_rest_[cell].y);
    for (std::size_t c = 0; c < 4; ++c) {
      push_x_[r[c]] += c % 2 == 0 ? -hx : hx;
      push_y_[r[c]] += c % 2 == 0 ? -hy : hy;
    }
  }
}

void Model::constraint_values(Input q, Output f) const {
  const std::span<const double> x = q.first(nodes_.size());
  const std::span<const double> y = q.subspan(nodes_.size(), nodes_.size());
  for (std::size_t cell = 0; cell < mesh_.cells(); ++cell) f[cell] = cell_area(mesh_, x, y, cell) - area_[cell];
}

void Model::curvature(Input u, Input v, Output b) const {
  const std::size_t n = nodes_.size();
  for (std::size_t cell = 0; cell < mesh_.cells(); ++cell) {
    b[cell] = bilinear(mesh_.corners(cell), u.data(), u.data() + n, v.data(), v.data() + n);
  }
  for (const Slide& slide : nodes_.slides()) {
    const auto speed = [&](Input rates) {
      return slide.direction.x * rates[slide.node] + slide.direction.y * rates[n + slide.node];
    };
    const double product = speed(u) * speed(v);
    const Surroundings cells = around(slide.node);
    for (std::size_t a = 0; a < cells.count; ++a) {
      b[cells.cells[a].cell] +=
          product * (cells.cells[a].gradient.x * slide.bend.x + cells.cells[a].gradient.y * slide.bend.y);
    }
  }
}

double Model::mass() const {
  double sum = 0;
  for (const double m : nodes_.mass()) sum += m;
  return sum;
}

std::array<double, 2> Model::momentum(Input, Input u) const {
  const std::size_t n = nodes_.size();
  std::array<double, 2> sum{};
  for (std::size_t k = 0; k < n; ++k) {
    sum[0] += nodes_.mass()[k] * u[k];
    sum[1] += nodes_.inertia_y()[k] * u[n + k];
  }
  return sum;
}

std::array<double, 1> Model::angular_momentum(Input q, Input u) const {
  const std::size_t n = nodes_.size();
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) {
    sum += nodes_.inertia_y()[k] * q[k] * u[n + k] - nodes_.mass()[k] * q[n + k] * u[k];
  }
  return {sum};
}

double Model::kinetic_energy(Input, Input u) const {
  const std::size_t n = nodes_.size();
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) {
    sum += nodes_.mass()[k] * u[k] * u[k] + nodes_.inertia_y()[k] * u[n + k] * u[n + k];
  }
  return 0.5 * sum;
}

double Model::potential_energy(Input q) const {
  const std::size_t n = nodes_.size();
  const double* x = q.data();
  const double* y = q.data() + n;
  double moment = edges_.moment(x, y);
  for (std::size_t i = 0; i < nodes_.slides().size(); ++i) {
    const Slide& slide = nodes_.slides()[i];
    if (slide.contact_sign != 0) moment += slide.contact_sign * slide.curve->moment(q[2 * n + i]);
  }
  double energy = settings_.density * settings_.gravity * moment;
  if (hourglass_stiffness_ > 0) {
    double squares = 0;
    for (std::size_t cell = 0; cell < mesh_.cells(); ++cell) {
      const auto r = mesh_.corners(cell);
      const double hx = alternating(x, r) - hourglass_rest_[cell].x;
      const double hy = alternating(y, r) - hourglass_rest_[cell].y;
      squares += hx * hx + hy * hy;
    }
    energy += 0.5 * hourglass_stiffness_ * squares;
  }
  if (barrier_.active()) energy += barrier_.energy(mesh_, area_, x, y);
  return energy;
}

Corner Model::worst_corner(Input q) const {
  const std::size_t n = nodes_.size();
  return seiche::lagrangian_mesh_2d::worst_corner(mesh_, q.first(n), q.subspan(n, n), area_);
}

}  // namespace seiche::lagrangian_mesh_2d
