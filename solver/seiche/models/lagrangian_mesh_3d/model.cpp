#include "seiche/models/lagrangian_mesh_3d/model.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/models/lagrangian_mesh_3d/assembly.hpp"
#include "seiche/models/lagrangian_mesh_3d/surface.hpp"
#include "seiche/models/lagrangian_mesh_3d/undeformed.hpp"
#include "seiche/require.hpp"

namespace seiche::lagrangian_mesh_3d {

namespace {

double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Mesh valid(Mesh mesh) {
  mesh.require_valid();
  return mesh;
}

std::vector<double> volumes_of(const Mesh& mesh) {
  std::vector<double> volumes(mesh.cells());
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    volumes[cell] = hexahedron_volume(corners_of(mesh, mesh.x, mesh.y, mesh.z, cell));
  }
  return volumes;
}

}  // namespace

Model::Model(Mesh mesh, Settings settings, Forcing forcing)
    : mesh_(valid(std::move(mesh))),
      settings_(settings),
      volume_(volumes_of(mesh_)),
      east_width_(mesh_.x[mesh_.plan.columns] - mesh_.x[mesh_.plan.columns - 1]),
      nodes_((require_positive("density", settings.density), mesh_), volume_, settings.density),
      bottom_(mesh_.bottom, nodes_.on_bottom()),
      gradients_(mesh_.plan.columns, cell_rows(), components),
      patch_forces_(mesh_.plan.columns, mesh_.plan.rows, patch_forces),
      forcing_(std::move(forcing)),
      driven_place_(nodes_.driven().size()),
      no_cells_(mesh_.plan.columns + 1, 0.0),
      matrix_(mesh_.plan.columns, mesh_.plan.rows, mesh_.layers),
      solver_(undeformed_lattice(mesh_, settings.density), settings.tolerance) {
  require_not_negative("gravity", settings.gravity);
  for (auto& push : push_) push.assign(mesh_.plan.nodes(), 0.0);
}

mechanics::State Model::state(const Velocity& velocity, double time) const {
  const std::size_t n = nodes_.size();
  mechanics::State state{.q = mesh_.x, .u = std::vector<double>(rates(), 0.0), .time = time};
  state.q.insert(state.q.end(), mesh_.y.begin(), mesh_.y.end());
  state.q.insert(state.q.end(), mesh_.z.begin(), mesh_.z.end());
  const auto* given = std::get_if<std::vector<Vector>>(&velocity);
  if (given != nullptr && given->size() != n) {
    throw std::invalid_argument(fmt::format("{} velocities of nodes; allowed: {}", given->size(), n));
  }
  const auto velocity_of = [&](std::size_t k) {
    if (given != nullptr) return (*given)[k];
    const auto& at = std::get<VelocityAt>(velocity);
    return at ? at({mesh_.x[k], mesh_.y[k], mesh_.z[k]}) : Vector{};
  };
  Bottom bottom = bottom_;
  bottom.linearise(mesh_.x, mesh_.y);
  for (std::size_t k = 0; k < n; ++k) {
    const Vector u = k < bottom.nodes() ? bottom.along(k, velocity_of(k)) : nodes_.allowed(k, velocity_of(k));
    state.u[k] = u.x;
    state.u[n + k] = u.y;
    state.u[2 * n + k] = u.z;
  }
  settle({time, 0}, state.q, state.u);
  return state;
}

bool Model::worth_sharing() const {
  return mesh_.cells() >= linear::worth_threads;
}

NodeVectors Model::around(std::size_t row, Input values) const {
  const std::size_t stride = mesh_.plan.columns + 1;
  const std::size_t level = mesh_.plan.nodes();
  const std::size_t first = row / mesh_.plan.rows * level + row % mesh_.plan.rows * stride;
  NodeVectors rows;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double* const corner = values.data() + axis * nodes_.size() + first;
    rows[axis] = {corner, corner + stride, corner + level, corner + level + stride};
  }
  return rows;
}

void Model::linearise(Interval when, Input q) {
  when_ = when;
  on_bottom([&] { bottom_.linearise(q.first(nodes_.size()), q.subspan(nodes_.size(), nodes_.size())); });
  measure(q);
  for (auto& push : push_) std::fill(push.begin(), push.end(), 0.0);
  add_surface_forces(q, 1);
  measure_body_force(when.middle());
  assemble_and_factor();
  sweeping_ = false;
}

void Model::linearise_between(Interval when, Input q0, Input q1, int sweep) {
  when_ = when;
  middle_.resize(q0.size());
  delta_.resize(q0.size());
  for (std::size_t i = 0; i < q0.size(); ++i) {
    middle_[i] = 0.5 * (q0[i] + q1[i]);
    delta_[i] = q1[i] - q0[i];
  }
  on_bottom([&] {
    const std::size_t n = nodes_.size();
    bottom_.linearise_between(q0.first(n), q0.subspan(n, n), q1.first(n), q1.subspan(n, n));
  });
  measure(middle_);
  linear::share_out(cell_rows(), worth_sharing(), [&](std::size_t row) {
    add_measured_row(mesh_.plan.columns, around(row, delta_), 1.0 / 12, gradients_.row(row));
  });
  for (auto& push : push_) std::fill(push.begin(), push.end(), 0.0);
  // Simpson's mean of the gradient of a quartic, which is cubic, is exact.
  add_surface_forces(q0, 1.0 / 6);
  add_surface_forces(middle_, 4.0 / 6);
  add_surface_forces(q1, 1.0 / 6);
  measure_body_force(when.middle());
  if (sweep == 0) assemble_and_factor();
  sweeping_ = true;
}

template <class Work>
void Model::on_bottom(const Work& linearise) {
  try {
    linearise();
  } catch (const OutsidePlanBottom& failure) {
    throw mechanics::Infeasible(failure.what(), failure.place());
  }
}

void Model::measure(Input q) {
  const std::size_t n = nodes_.size();
  for (std::size_t d = 0; d < nodes_.driven().size(); ++d) {
    const std::size_t k = nodes_.driven()[d].node;
    driven_place_[d] = {q[k], q[n + k], q[2 * n + k]};
  }
  std::atomic<bool> folded = false;
  linear::share_out(cell_rows(), worth_sharing(), [&](std::size_t row) {
    const NodeVectors r = around(row, q);
    if (folded_corners_of_row(mesh_.plan.columns, r) > 0) folded = true;
    measure_row(mesh_.plan.columns, r, gradients_.row(row));
  });
  if (folded) throw_folded(q);
}

void Model::throw_folded(Input q) const {
  const std::size_t n = nodes_.size();
  const Corner worst = worst_corner(q);
  const std::size_t columns = mesh_.plan.columns;
  const std::size_t corner = mesh_.corners(worst.cell)[0];
  throw mechanics::Infeasible(
      fmt::format(
          "the mesh folds: a corner of cell {} (column {}, row {}, layer {}) at x = {:.4g}, y = {:.4g} has shape "
          "{:.3g} (1 for a box, allowed: above 0)",
          worst.cell, worst.cell % columns, worst.cell / columns % mesh_.plan.rows, worst.cell / mesh_.plan.cells(),
          q[corner], q[n + corner], worst.shape),
      q[corner]);
}

void Model::assemble_and_factor() {
  const std::size_t rows = mesh_.plan.rows;
  const std::size_t columns = mesh_.plan.columns;
  const std::size_t stride = columns + 1;
  const std::size_t level = mesh_.plan.nodes();
  const std::array mobility{nodes_.wx().data(), nodes_.wy().data(), nodes_.wz().data()};
  const linear::RowBlocks& gradients = gradients_;
  linear::share_out(cell_rows(), worth_sharing(), [&](std::size_t row) {
    const std::size_t j = row % rows;
    const std::size_t first = row / rows * level + j * stride;
    const bool north = j + 1 < rows;
    const bool above = row + rows < cell_rows();
    NodeVectors w;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double* const corner = mobility[axis] + first;
      w[axis] = {corner, corner + stride, corner + level, corner + level + stride};
    }
    const auto row_if = [&](bool there, std::size_t r) { return there ? gradients.row(r) : gradients.zeros(); };
    const LaterRows later{.north = row_if(north, row + 1),
                          .above = {row_if(above && j > 0, row + rows - 1), row_if(above, row + rows),
                                    row_if(above && north, row + rows + 1)},
                          .has_north = north,
                          .has_above = {above && j > 0, above, above && north}};
    assemble_row(columns, gradients.row(row), later, w, matrix_.own.data() + row * columns, matrix_.later.row(row));
  });
  for (const Slide& slide : nodes_.slides()) {
    const CellsAround cells = cells_around(slide.node);
    const auto along = [&](std::size_t a) {
      return slide.direction.x * cells.gradient[a].x + slide.direction.y * cells.gradient[a].y;
    };
    for (std::size_t a = 0; a < cells.count; ++a) {
      for (std::size_t b = a; b < cells.count; ++b) {
        matrix_.coefficient(cells.cell[a], cells.cell[b]) += along(a) * along(b) / nodes_.mass()[slide.node];
      }
    }
  }
  for (std::size_t k = 0; k < bottom_.nodes(); ++k) {
    const CellsAround cells = cells_around(k);
    for (std::size_t a = 0; a < cells.count; ++a) {
      const Vector along = bottom_.along(k, cells.gradient[a]);
      for (std::size_t b = a; b < cells.count; ++b) {
        matrix_.coefficient(cells.cell[a], cells.cell[b]) += dot(along, cells.gradient[b]) / nodes_.mass()[k];
      }
    }
  }
  try {
    solver_.factor(matrix_);
  } catch (const linear::NotPositiveDefinite& failure) {
    const std::size_t cell = failure.row();
    throw mechanics::Infeasible(fmt::format("cell {}: {}", cell, failure.what()), mesh_.x[mesh_.corners(cell)[0]]);
  }
}

Vector Model::gradient(std::size_t cell, std::size_t corner) const {
  const auto row = gradients_.row(cell / mesh_.plan.columns);
  const std::size_t i = cell % mesh_.plan.columns;
  return {row[component(corner, 0)][i], row[component(corner, 1)][i], row[component(corner, 2)][i]};
}

Model::CellsAround Model::cells_around(std::size_t node) const {
  const auto [columns, rows] = mesh_.plan;
  const std::size_t i = node % (columns + 1);
  const std::size_t j = node / (columns + 1) % (rows + 1);
  const std::size_t l = node / mesh_.plan.nodes();
  CellsAround found;
  const auto add = [&](std::size_t dx, std::size_t dy, std::size_t dz) {
    // The cell west, south, below of the node where a difference is 1.
    if (i < dx || j < dy || l < dz || i - dx >= columns || j - dy >= rows || l - dz >= mesh_.layers) return;
    const std::size_t cell = ((l - dz) * rows + j - dy) * columns + i - dx;
    const std::size_t corner = 4 * dz + (dy == 0 ? dx : 3 - dx);
    found.cell[found.count] = cell;
    found.gradient[found.count++] = gradient(cell, corner);
  };
  for (std::size_t dz = 2; dz-- > 0;) {
    for (std::size_t dy = 2; dy-- > 0;) {
      for (std::size_t dx = 2; dx-- > 0;) add(dx, dy, dz);
    }
  }
  return found;
}

void Model::advance(Input from, Input u, double h, Output to) const {
  for (std::size_t i = 0; i < from.size(); ++i) to[i] = from[i] + h * u[i];
}

void Model::kick(double h, Output u) const {
  const std::size_t n = nodes_.size();
  const std::size_t top = n - mesh_.plan.nodes();
  const std::array mobility{nodes_.wx().data() + top, nodes_.wy().data() + top, nodes_.wz().data() + top};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double* const rates = u.data() + axis * n + top;
    for (std::size_t k = 0; k < mesh_.plan.nodes(); ++k) rates[k] += h * mobility[axis][k] * push_[axis][k];
  }
  for (const Slide& slide : nodes_.slides()) {
    if (slide.node < top) continue;
    const double push = slide.direction.x * push_[0][slide.node - top] + slide.direction.y * push_[1][slide.node - top];
    const double kick = h * push / nodes_.mass()[slide.node];
    u[slide.node] += kick * slide.direction.x;
    u[n + slide.node] += kick * slide.direction.y;
  }
  kick_bodies(h, u);
  // The bottom takes what would go through it.
  for (std::size_t k = 0; k < bottom_.nodes(); ++k) {
    const Vector left = bottom_.along(k, {u[k], u[n + k], u[2 * n + k]});
    u[k] = left.x;
    u[n + k] = left.y;
    u[2 * n + k] = left.z;
  }
}

void Model::measure_body_force(double time) {
  if (!forcing_.body_force) return;
  body_force_.resize(nodes_.size());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    body_force_[k] = forcing_.body_force({mesh_.x[k], mesh_.y[k], mesh_.z[k]}, time);
  }
}

void Model::kick_bodies(double h, Output u) const {
  const std::size_t n = nodes_.size();
  for (std::size_t k = 0; k < body_force_.size(); ++k) {
    const Vector force = k < bottom_.nodes() ? body_force_[k] : nodes_.allowed(k, body_force_[k]);
    u[k] += h * force.x;
    u[n + k] += h * force.y;
    u[2 * n + k] += h * force.z;
  }
}

Vector Model::force(const CellsAround& cells, Input mu) {
  Vector sum;
  for (std::size_t a = 0; a < cells.count; ++a) {
    const double pressure = mu[cells.cell[a]];
    const Vector& gradient = cells.gradient[a];
    sum = {sum.x + pressure * gradient.x, sum.y + pressure * gradient.y, sum.z + pressure * gradient.z};
  }
  return sum;
}

void Model::set_driven(std::size_t index, Place place, double time, Output u) const {
  const Driven& driven = nodes_.driven()[index];
  const Point v = driven.side->velocity(place, time);
  const double into_wall = v.x * driven.wall.x + v.y * driven.wall.y;
  u[driven.node] = v.x - into_wall * driven.wall.x;
  u[nodes_.size() + driven.node] = v.y - into_wall * driven.wall.y;
}

void Model::enter(Input, Output u) const {
  for (std::size_t d = 0; d < driven_place_.size(); ++d) set_driven(d, driven_place_[d], when_.middle(), u);
}

void Model::settle(Interval when, Output q, Output u) const {
  const std::size_t n = nodes_.size();
  for (std::size_t d = 0; d < driven_place_.size(); ++d) {
    const std::size_t k = nodes_.driven()[d].node;
    set_driven(d, {q[k], q[n + k], q[2 * n + k]}, when.end(), u);
  }
}

void Model::constraint_rates(Input u, Output w) const {
  const std::size_t columns = mesh_.plan.columns;
  linear::share_out(cell_rows(), worth_sharing(), [&](std::size_t row) {
    rates_of_row(columns, gradients_.row(row), around(row, u), w.data() + row * columns);
  });
}

void Model::react(Input mu, Output u) const {
  const std::size_t columns = mesh_.plan.columns;
  const std::size_t rows = mesh_.plan.rows;
  const std::size_t n = nodes_.size();
  linear::share_out((rows + 1) * (mesh_.layers + 1), worth_sharing(), [&](std::size_t row) {
    const std::size_t j = row % (rows + 1);
    const std::size_t l = row / (rows + 1);
    CellRows cells{.gradients = {gradients_.zeros(), gradients_.zeros(), gradients_.zeros(), gradients_.zeros()},
                   .mu = {no_cells_.data(), no_cells_.data(), no_cells_.data(), no_cells_.data()}};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t south = k % 2 == 0 ? 1 : 0;
      const std::size_t below = k < 2 ? 1 : 0;
      if (j < south || l < below || j - south >= rows || l - below >= mesh_.layers) continue;
      const std::size_t cell_row = (l - below) * rows + j - south;
      cells.gradients[k] = gradients_.row(cell_row);
      cells.mu[k] = mu.data() + cell_row * columns;
    }
    const std::size_t k = row * (columns + 1);
    react_row(columns, cells, {nodes_.wx().data() + k, nodes_.wy().data() + k, nodes_.wz().data() + k},
              {u.data() + k, u.data() + n + k, u.data() + 2 * n + k});
  });
  for (const Slide& slide : nodes_.slides()) {
    const CellsAround cells = cells_around(slide.node);
    double force = 0;
    for (std::size_t a = 0; a < cells.count; ++a) {
      force += mu[cells.cell[a]] * (slide.direction.x * cells.gradient[a].x + slide.direction.y * cells.gradient[a].y);
    }
    const double kick = force / nodes_.mass()[slide.node];
    u[slide.node] += kick * slide.direction.x;
    u[n + slide.node] += kick * slide.direction.y;
  }
  for (std::size_t k = 0; k < bottom_.nodes(); ++k) {
    const Vector kick = bottom_.along(k, force(cells_around(k), mu));
    const double inverse_mass = 1 / nodes_.mass()[k];
    u[k] += inverse_mass * kick.x;
    u[n + k] += inverse_mass * kick.y;
    u[2 * n + k] += inverse_mass * kick.z;
  }
}

void Model::solve(Input right_hand_side, Output mu) {
  solver_.solve(right_hand_side, mu, sweeping_ ? tolerance_of_sweeps : 0);
}

}  // namespace seiche::lagrangian_mesh_3d
