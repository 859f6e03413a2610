#include "seiche/models/lagrangian_mesh_2d/model.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/models/lagrangian_mesh_2d/lattice.hpp"
#include "seiche/require.hpp"

namespace seiche::lagrangian_mesh_2d {

namespace {

Mesh valid(Mesh mesh) {
  mesh.require_valid();
  return mesh;
}

std::vector<double> areas_of(const Mesh& mesh) {
  std::vector<double> areas(mesh.cells());
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) areas[cell] = cell_area(mesh, mesh.x, mesh.y, cell);
  return areas;
}

/// Speed along the curve of the velocity (u, v) = d s'.
double speed_along(Point direction, double u, double v) {
  return dot(direction, {u, v}) / dot(direction, direction);
}

}  // namespace

Model::Model(Mesh mesh, Settings settings, Forcing forcing)
    : mesh_(valid(std::move(mesh))),
      settings_(settings),
      forcing_(std::move(forcing)),
      nodes_((require_positive("density", settings.density), mesh_), areas_of(mesh_), settings.density,
             settings.tuned_surface_inertia),
      edges_(mesh_),
      area_(areas_of(mesh_)),
      barrier_(settings.corner_barrier * settings.density * settings.gravity),
      diagonals_(mesh_.columns, mesh_.rows),
      push_x_(mesh_.nodes(), 0.0),
      push_y_(mesh_.nodes(), 0.0),
      slide_push_(nodes_.slides().size(), 0.0),
      pushed_everywhere_(settings.hourglass > 0 || settings.corner_barrier > 0 || forcing_.body_force),
      no_cells_(mesh_.columns + 1, 0.0),
      matrix_(mesh_.columns, mesh_.rows),
      solver_(mesh_.columns, mesh_.rows, settings.solver, undeformed_lattice(mesh_, settings.density),
              settings.tolerance) {
  require_not_negative("gravity", settings.gravity);
  require_not_negative("hourglass", settings.hourglass);
  require_not_negative("corner_barrier", settings.corner_barrier);
  if (edges_.empty()) throw std::invalid_argument("the mesh has no free side; allowed: at least one");
  if (std::isnan(settings.lowest_corner) || settings.lowest_corner >= 1) {
    throw std::invalid_argument(fmt::format("lowest_corner = {:g}; allowed: below 1", settings.lowest_corner));
  }
  lowest_triangle_ = settings.lowest_corner * *std::max_element(area_.begin(), area_.end());
  if (settings.hourglass > 0) {
    const double mean_area = std::accumulate(area_.begin(), area_.end(), 0.0) / static_cast<double>(mesh_.cells());
    hourglass_stiffness_ = settings.hourglass * settings.density * settings.gravity * std::sqrt(mean_area);
    for (std::size_t cell = 0; cell < mesh_.cells(); ++cell) {
      const auto [r0, r1, r2, r3] = mesh_.corners(cell);
      hourglass_rest_.push_back({mesh_.x[r0] - mesh_.x[r1] + mesh_.x[r2] - mesh_.x[r3],
                                 mesh_.y[r0] - mesh_.y[r1] + mesh_.y[r2] - mesh_.y[r3]});
    }
  }
}

mechanics::State Model::state(const InitialVelocity& velocity, double time) const {
  mechanics::State state{.q = mesh_.x, .u = std::vector<double>(rates(), 0.0), .time = time};
  state.q.insert(state.q.end(), mesh_.y.begin(), mesh_.y.end());
  const std::size_t n = nodes_.size();
  const auto* given = std::get_if<std::vector<Point>>(&velocity);
  if (given != nullptr && given->size() != n) {
    throw std::invalid_argument(fmt::format("{} velocities of nodes; allowed: {}", given->size(), n));
  }
  const auto velocity_of = [&](std::size_t k) {
    if (given != nullptr) return (*given)[k];
    const auto& at = std::get<VelocityAt>(velocity);
    return at ? at({mesh_.x[k], mesh_.y[k]}) : Point{};
  };
  for (std::size_t k = 0; k < n; ++k) {
    // A node that is held in one direction, or slides, keeps what it may do.
    const Point u = velocity_of(k);
    state.u[k] = nodes_.wx()[k] > 0 ? u.x : 0.0;
    state.u[n + k] = nodes_.wy()[k] > 0 ? u.y : 0.0;
  }
  for (const Slide& slide : nodes_.slides()) {
    const Point node{mesh_.x[slide.node], mesh_.y[slide.node]};
    const double s = slide.curve->arc_length_at(node);
    const Point tangent = slide.curve->tangent(s);
    const double speed = dot(tangent, velocity_of(slide.node));
    state.u[slide.node] = speed * tangent.x;
    state.u[n + slide.node] = speed * tangent.y;
    // On the curve to the last bit, where it will be put after every step.
    const Point position = slide.curve->position(s);
    state.q[slide.node] = position.x;
    state.q[n + slide.node] = position.y;
    state.q.push_back(s);
  }
  settle({time, 0}, state.q, state.u);
  return state;
}

Model::Places Model::places(Interval when, Input q) {
  const std::size_t n = nodes_.size();
  if (nodes_.driven().empty()) return {q.data(), q.data() + n};
  patched_.assign(q.begin(), q.end());
  for (const Driven& node : nodes_.driven()) {
    const Point begin = nodes_.driven_place(node, when.begin);
    const Point end = nodes_.driven_place(node, when.end());
    patched_[node.node] = 0.5 * (begin.x + end.x);
    if (node.path != nullptr) patched_[n + node.node] = 0.5 * (begin.y + end.y);
  }
  return {patched_.data(), patched_.data() + n};
}

void Model::linearise(Interval when, Input q) {
  when_ = when;
  const Places at = places(when, q);
  try {
    for (std::size_t i = 0; i < nodes_.slides().size(); ++i) {
      Slide& slide = nodes_.slides()[i];
      const double s = q[2 * nodes_.size() + i];
      slide.direction = slide.curve->tangent(s);
      slide.bend = slide.curve->curvature(s);
    }
  } catch (const OutsideCurve& failure) {
    throw mechanics::Infeasible(failure.what(), failure.place());
  }
  measure(at);
  std::fill(push_x_.begin(), push_x_.end(), 0.0);
  std::fill(push_y_.begin(), push_y_.end(), 0.0);
  gather_forces(when, at, 1);
  for (std::size_t i = 0; i < nodes_.slides().size(); ++i) {
    const Slide& slide = nodes_.slides()[i];
    const double s = q[2 * nodes_.size() + i];
    slide_push_[i] = slide.contact_sign == 0 ? 0.0
                                             : -slide.contact_sign * settings_.density * settings_.gravity *
                                                   slide.curve->mean_moment_rate(s, s);
  }
  assemble_and_factor();
  sweeping_ = false;
}

void Model::linearise_between(Interval when, Input q0, Input q1, int sweep) {
  when_ = when;
  const std::size_t n = nodes_.size();
  middle_.resize(q0.size());
  for (std::size_t i = 0; i < q0.size(); ++i) middle_[i] = 0.5 * (q0[i] + q1[i]);
  try {
    for (std::size_t i = 0; i < nodes_.slides().size(); ++i) {
      Slide& slide = nodes_.slides()[i];
      const double s0 = q0[2 * n + i];
      const double s1 = q1[2 * n + i];
      slide.direction = slide.curve->mean_tangent(s0, s1);  // makes areas and energy exact on curves too
      slide_push_[i] = slide.contact_sign == 0 ? 0.0
                                               : -slide.contact_sign * settings_.density * settings_.gravity *
                                                     slide.curve->mean_moment_rate(s0, s1);
    }
  } catch (const OutsideCurve& failure) {
    throw mechanics::Infeasible(failure.what(), failure.place());
  }
  const Places at = places(when, middle_);
  measure(at);
  std::fill(push_x_.begin(), push_x_.end(), 0.0);
  std::fill(push_y_.begin(), push_y_.end(), 0.0);
  // Simpson's mean of the gradient of a cubic is exact.
  gather_forces(when, {q0.data(), q0.data() + n}, 1.0 / 6);
  gather_forces(when, at, 4.0 / 6);
  gather_forces(when, {q1.data(), q1.data() + n}, 1.0 / 6);
  if (sweep == 0) assemble_and_factor();
  sweeping_ = true;
}

void Model::measure(Places at) {
  const std::size_t columns = mesh_.columns;
  const std::size_t stride = columns + 1;
  std::atomic<bool> low = false;
  linear::share_out(mesh_.rows, mesh_.cells() > linear::worth_threads, [&](std::size_t j) {
    const std::size_t k = j * stride;
    const double least =
        measure_row(columns, j * columns, {at.x + k, at.x + k + stride}, {at.y + k, at.y + k + stride}, diagonals_);
    if (least <= lowest_triangle_) low = true;
  });
  if (low && folded(at)) throw_folded(at);
}

bool Model::folded(Places at) const {
  if (!mesh_.has_joined_sides()) return true;
  const std::size_t n = nodes_.size();
  const Corner worst = seiche::lagrangian_mesh_2d::worst_corner(mesh_, {at.x, n}, {at.y, n}, area_);
  return !(worst.shape > settings_.lowest_corner);
}

void Model::throw_folded(Places at) const {
  const std::size_t n = nodes_.size();
  const Corner worst = seiche::lagrangian_mesh_2d::worst_corner(mesh_, {at.x, n}, {at.y, n}, area_);
  throw mechanics::Infeasible(
      fmt::format("the mesh folds: a corner of cell {} (column {}, row {}) has shape {:.3g} (1 when square, allowed: "
                  "above {:g})",
                  worst.cell, worst.cell % mesh_.columns, worst.cell / mesh_.columns, worst.shape,
                  settings_.lowest_corner),
      at.x[mesh_.corners(worst.cell)[0]]);
}

void Model::assemble_and_factor() {
  const std::size_t columns = mesh_.columns;
  const std::size_t stride = columns + 1;
  const double* wx = nodes_.wx().data();
  const double* wy = nodes_.wy().data();
  linear::share_out(mesh_.rows, mesh_.cells() > linear::worth_threads, [&](std::size_t j) {
    const std::size_t k = j * stride;
    assemble_row(columns, j * columns, j + 1 < mesh_.rows, diagonals_, {wx + k, wx + k + stride},
                 {wy + k, wy + k + stride}, matrix_);
  });
  for (const Slide& slide : nodes_.slides()) {
    const Surroundings cells = around(slide.node);
    for (std::size_t a = 0; a < cells.count; ++a) {
      const double along_a = dot(slide.direction, cells.cells[a].gradient) / nodes_.mass()[slide.node];
      for (std::size_t b = a; b < cells.count; ++b) {
        const double along_b = dot(slide.direction, cells.cells[b].gradient);
        matrix_.coefficient(cells.cells[a].cell, cells.cells[b].cell) += along_a * along_b;
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

void Model::predict(Input from, Input u, double h, Output to) const {
  const std::size_t n = nodes_.size();
  for (std::size_t i = 0; i < 2 * n; ++i) to[i] = from[i] + h * u[i];
  for (std::size_t i = 0; i < nodes_.slides().size(); ++i) {
    const Slide& slide = nodes_.slides()[i];
    const Point tangent = slide.curve->tangent(from[2 * n + i]);
    move_along(slide, from[2 * n + i] + h * speed_along(tangent, u[slide.node], u[n + slide.node]), i, to);
  }
}

void Model::advance(Input from, Input u, double h, Output to) const {
  const std::size_t n = nodes_.size();
  for (std::size_t i = 0; i < 2 * n; ++i) to[i] = from[i] + h * u[i];
  for (std::size_t i = 0; i < nodes_.slides().size(); ++i) {
    const Slide& slide = nodes_.slides()[i];
    move_along(slide, from[2 * n + i] + h * speed_along(slide.direction, u[slide.node], u[n + slide.node]), i, to);
  }
}

void Model::move_along(const Slide& slide, double s, std::size_t index, Output q) const {
  try {
    const Point position = slide.curve->position(s);
    q[slide.node] = position.x;
    q[nodes_.size() + slide.node] = position.y;
    q[2 * nodes_.size() + index] = s;
  } catch (const OutsideCurve& failure) {
    throw mechanics::Infeasible(failure.what(), failure.place());
  }
}

void Model::kick(double h, Output u) const {
  const std::size_t n = nodes_.size();
  const std::size_t first = pushed_everywhere_ ? 0 : edges_.first_node();
  const double* wx = nodes_.wx().data();
  const double* wy = nodes_.wy().data();
  for (std::size_t k = first; k < n; ++k) {
    u[k] += h * wx[k] * push_x_[k];
    u[n + k] += h * wy[k] * push_y_[k];
  }
  for (std::size_t i = 0; i < nodes_.slides().size(); ++i) {
    const Slide& slide = nodes_.slides()[i];
    const double push = dot(slide.direction, {push_x_[slide.node], push_y_[slide.node]}) + slide_push_[i];
    const double kick = h * push / nodes_.mass()[slide.node];
    u[slide.node] += kick * slide.direction.x;
    u[n + slide.node] += kick * slide.direction.y;
  }
}

void Model::enter(Input q, Output u) const {
  const std::size_t n = nodes_.size();
  for (std::size_t i = 0; i < nodes_.slides().size(); ++i) {
    const Slide& slide = nodes_.slides()[i];
    const double speed = dot(slide.curve->tangent(q[2 * n + i]), {u[slide.node], u[n + slide.node]});
    u[slide.node] = speed * slide.direction.x;
    u[n + slide.node] = speed * slide.direction.y;
  }
  for (const Driven& node : nodes_.driven()) {
    const Point rate = nodes_.driven_rate(node, when_);
    u[node.node] = rate.x;
    if (node.path != nullptr) u[n + node.node] = rate.y;
  }
}

void Model::settle(Interval when, Output q, Output u) const {
  const std::size_t n = nodes_.size();
  for (std::size_t i = 0; i < nodes_.slides().size(); ++i) {
    const Slide& slide = nodes_.slides()[i];
    const double speed = speed_along(slide.direction, u[slide.node], u[n + slide.node]);
    const Point tangent = slide.curve->tangent(q[2 * n + i]);
    u[slide.node] = speed * tangent.x;
    u[n + slide.node] = speed * tangent.y;
  }
  for (const Driven& node : nodes_.driven()) {
    const Point place = nodes_.driven_place(node, when.end());
    const Point velocity = nodes_.driven_velocity(node, when.end());
    q[node.node] = place.x;
    u[node.node] = velocity.x;
    if (node.path != nullptr) {
      q[n + node.node] = place.y;
      u[n + node.node] = velocity.y;
    }
  }
}

void Model::constraint_rates(Input u, Output w) const {
  const std::size_t columns = mesh_.columns;
  const std::size_t stride = columns + 1;
  const double* ux = u.data();
  const double* uy = u.data() + nodes_.size();
  linear::share_out(mesh_.rows, mesh_.cells() > linear::worth_threads, [&](std::size_t j) {
    const std::size_t k = j * stride;
    rates_of_row(columns, j * columns, diagonals_, {ux + k, ux + k + stride}, {uy + k, uy + k + stride},
                 w.data() + j * columns);
  });
}

void Model::react(Input mu, Output u) const {
  const std::size_t columns = mesh_.columns;
  const std::size_t n = nodes_.size();
  linear::share_out(mesh_.rows + 1, mesh_.cells() > linear::worth_threads, [&](std::size_t j) {
    const std::size_t k = j * (columns + 1);
    const auto above = static_cast<std::ptrdiff_t>(j * columns);
    const auto below = above - static_cast<std::ptrdiff_t>(columns);
    react_row(columns, below, above, diagonals_, j == 0 ? no_cells_.data() : mu.data() + below,
              j == mesh_.rows ? no_cells_.data() : mu.data() + above, nodes_.wx().data() + k, nodes_.wy().data() + k,
              u.data() + k, u.data() + n + k);
  });
  for (const Slide& slide : nodes_.slides()) {
    const Surroundings cells = around(slide.node);
    double force = 0;
    for (std::size_t a = 0; a < cells.count; ++a) {
      force += mu[cells.cells[a].cell] * dot(slide.direction, cells.cells[a].gradient);
    }
    const double kick = force / nodes_.mass()[slide.node];
    u[slide.node] += kick * slide.direction.x;
    u[n + slide.node] += kick * slide.direction.y;
  }
}

void Model::solve(Input right_hand_side, Output mu) {
  solver_.solve(right_hand_side, mu, sweeping_ ? tolerance_of_sweeps : 0);
}

Point Model::gradient(std::size_t cell, std::size_t corner) const {
  const double ax = diagonals_.ax.data()[cell];
  const double ay = diagonals_.ay.data()[cell];
  const double bx = diagonals_.bx.data()[cell];
  const double by = diagonals_.by.data()[cell];
  switch (corner) {
    case 0:
      return {-by, bx};
    case 1:
      return {ay, -ax};
    case 2:
      return {by, -bx};
    default:
      return {-ay, ax};
  }
}

Model::Surroundings Model::around(std::size_t node) const {
  const std::size_t i = node % (mesh_.columns + 1);
  const std::size_t j = node / (mesh_.columns + 1);
  Surroundings found;
  const auto add = [&](std::size_t column, std::size_t row, std::size_t corner) {
    const std::size_t cell = row * mesh_.columns + column;
    found.cells[found.count++] = {cell, gradient(cell, corner)};
  };
  if (i < mesh_.columns && j < mesh_.rows) add(i, j, 0);
  if (i > 0 && j < mesh_.rows) add(i - 1, j, 1);
  if (i > 0 && j > 0) add(i - 1, j - 1, 2);
  if (i < mesh_.columns && j > 0) add(i, j - 1, 3);
  return found;
}

double Model::place(std::size_t rate) const {
  return mesh_.x[rate % nodes_.size()];
}

}  // namespace seiche::lagrangian_mesh_2d
