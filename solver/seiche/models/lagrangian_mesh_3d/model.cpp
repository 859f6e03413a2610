#include "seiche/models/lagrangian_mesh_3d/model.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/linear/cosine_lattice.hpp"
#include "seiche/require.hpp"

namespace seiche::lagrangian_mesh_3d {

namespace {

std::vector<double> volumes_of(const Mesh& mesh) {
  std::vector<double> volumes(mesh.cells());
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    volumes[cell] = hexahedron_volume(corners_of(mesh, mesh.x, mesh.y, mesh.z, cell));
  }
  return volumes;
}

double mean_height(const Mesh& mesh, std::size_t cell) {
  const auto r = mesh.corners(cell);
  double height = 0;
  for (std::size_t a = 0; a < 4; ++a) height += (mesh.z[r[a + 4]] - mesh.z[r[a]]) / 4;
  return height;
}

/// The undeformed lattice nearest to a mesh, which preconditions its systems: cells of the mesh's mean sides in plan,
/// layers of their mean heights.
linear::UndeformedLattice undeformed_lattice(const Mesh& mesh, double density) {
  const auto [columns, rows] = mesh.plan;
  double along = 0;
  double across = 0;
  mesh.plan.each_edge([&](std::size_t p, std::size_t q, std::size_t, std::size_t) {
    (q == p + 1 ? along : across) += std::hypot(mesh.x[q] - mesh.x[p], mesh.y[q] - mesh.y[p]);
  });
  along /= static_cast<double>(columns * (rows + 1));
  across /= static_cast<double>((columns + 1) * rows);
  double area = 0;
  std::vector<double> heights(mesh.layers, 0.0);
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const double height = mean_height(mesh, cell);
    heights[cell / mesh.plan.cells()] += height / static_cast<double>(mesh.plan.cells());
    area +=
        hexahedron_volume(corners_of(mesh, mesh.x, mesh.y, mesh.z, cell)) / height / static_cast<double>(mesh.cells());
  }
  // Sides in the proportion of the mean edges, with the mean area of a cell.
  const double to_area = std::sqrt(area / (along * across));
  return {.shape = {.nx = columns, .nz = rows, .layers = mesh.layers},
          .matrix = linear::hexahedral_lattice(along * to_area, across * to_area, heights, density, mesh.free_bottom),
          .scaled = true};
}

}  // namespace

Model::Model(Mesh mesh, Settings settings, Forcing forcing)
    : Water{lattice::valid_cells(mesh, settings, {mesh.plan.columns, mesh.plan.rows, mesh.layers}),
            volumes_of(mesh),
            {undeformed_lattice(mesh, settings.density), settings.tolerance},
            settings.tolerance},
      mesh_(std::move(mesh)),
      settings_(settings),
      east_width_(mesh_.x[mesh_.plan.columns] - mesh_.x[mesh_.plan.columns - 1]),
      nodes_(mesh_, volume_, settings.density),
      surface_(mesh_.plan.columns, mesh_.plan.rows, n_),
      forcing_(std::move(forcing)) {
  first_pushed_row_ = forcing_.body_force ? 0 : (mesh_.plan.rows + 1) * mesh_.layers;
}

mechanics::State Model::state(const Velocity& velocity, double time) const {
  mechanics::State state{
      .q = lattice::joined({mesh_.x, mesh_.y, mesh_.z}), .u = std::vector<double>(rates(), 0.0), .time = time};
  const auto given = lattice::nodal(velocity, n_, [&](const VelocityAt& at, std::size_t k) {
    return at({mesh_.x[k], mesh_.y[k], mesh_.z[k]});
  });
  for (std::size_t k = 0; k < n_; ++k) put_vector(given[k], k, state.u);
  Nodes nodes = nodes_;
  nodes.turn(state.q, state.q);
  nodes.project(n_, state.u);
  settle({time, 0}, state.q, state.u);
  return state;
}

void Model::gather(Input q0, Input q1, Input at, int /*sweep*/) {
  const bool instant = q0.data() == q1.data();
  nodes_.turn(q0, q1);
  measure(at);
  // Simpson's mean of the gradient of a quartic, which is cubic, is exact.
  const double weight = settings_.density * settings_.gravity;
  surface_.push(at, instant ? weight : 4 * weight / 6, push_);
  if (!instant) {
    delta_.resize(q0.size());
    for (std::size_t i = 0; i < q0.size(); ++i) delta_[i] = q1[i] - q0[i];
    each_row([&](std::size_t row) {
      measure_row(mesh_.plan.columns, around(row, delta_), 1.0 / 12, true, gradients_.row(row));
    });
    surface_.push(q0, weight / 6, push_);
    surface_.push(q1, weight / 6, push_);
  }
  if (forcing_.body_force) {
    push_bodies([&](std::size_t k) {
      const Vector force = forcing_.body_force({mesh_.x[k], mesh_.y[k], mesh_.z[k]}, when_.middle());
      return std::array{force.x, force.y, force.z};
    });
  }
  hold();
}

void Model::measure(Input q) {
  if (!nodes_.driven().empty()) driven_from_.assign(q.begin(), q.end());
  std::atomic<bool> tangled = false;
  each_row([&](std::size_t row) {
    const NodeVectors r = around(row, q);
    if (inverted_corners_of_row(mesh_.plan.columns, r) > 0) tangled = true;
    measure_row(mesh_.plan.columns, r, 1, false, gradients_.row(row));
  });
  if (tangled) throw_tangled(q);
}

void Model::hold() {
  held_.clear();
  for (const std::size_t k : nodes_.slanted()) {
    held_.push_back({.node = k, .w = nodes_.left(k)});
    for (double& w : held_.back().w) w /= nodes_.mass()[k];
  }
}

void Model::kick(double h, Output u) const {
  Water::kick(h, u);
  nodes_.project(nodes_.on_bottom(), u);  // the bottom takes what would go through it
}

void Model::drive(double time, Input q, Output u) const {
  for (const Driven& driven : nodes_.driven()) {
    const Point v = driven.side->velocity(vector_at(q, driven.node), time);
    const double into_wall = dot(v, driven.wall);
    u[driven.node] = v.x - into_wall * driven.wall.x;
    u[n_ + driven.node] = v.y - into_wall * driven.wall.y;
  }
}

void Model::shift_east(mechanics::State& state) {
  const auto [columns, rows] = mesh_.plan;
  const auto layers = static_cast<double>(mesh_.layers);
  shift_columns(state, mesh_.x, mesh_.y, east_width_);
  const double bottom = state.q[2 * n_];
  for (std::size_t j = 0; j <= rows; ++j) {
    Point mean;
    for (std::size_t l = 0; l <= mesh_.layers; ++l) {
      const std::size_t west = mesh_.node(0, j, l);
      mean.x += state.q[west] / (layers + 1);
      mean.y += state.q[n_ + west] / (layers + 1);
    }
    for (std::size_t l = 0; l <= mesh_.layers; ++l) {
      const std::size_t west = mesh_.node(0, j, l);
      state.q[west] = mean.x;
      state.q[n_ + west] = mean.y;
      state.q[2 * n_ + mesh_.node(columns, j, l)] = bottom * static_cast<double>(mesh_.layers - l) / layers;
      const auto [u, v, w] = vector_at(state.u, west);
      const auto kept = lattice::times(nodes_.left(west), {u, v, w});
      put_vector({kept[0], kept[1], kept[2]}, west, state.u);
    }
  }
  // The new cells, and those whose west faces were straightened.
  for (std::size_t row = 0; row < cell_rows(); ++row) {
    for (const std::size_t cell : {row * columns, row * columns + columns - 1}) {
      volume_[cell] = cell_volume(state.q, cell);
    }
  }
  nodes_.weigh(mesh_, volume_, settings_.density);
}

double surely_stable_step(const Model& model) {
  if (model.settings().gravity == 0) return std::numeric_limits<double>::infinity();
  const Mesh& mesh = model.mesh();
  double height = std::numeric_limits<double>::infinity();
  for (std::size_t cell = mesh.cells() - mesh.plan.cells(); cell < mesh.cells(); ++cell) {
    height = std::min(height, mean_height(mesh, cell));
  }
  return std::sqrt(2 * height / model.settings().gravity);
}

}  // namespace seiche::lagrangian_mesh_3d
