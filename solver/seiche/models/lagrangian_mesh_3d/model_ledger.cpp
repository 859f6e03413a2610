// What the hexahedral model conserves, its surface forces, and how a moving window shifts it.

#include "seiche/compensated_sum.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/models/lagrangian_mesh_3d/model.hpp"
#include "seiche/models/lagrangian_mesh_3d/surface.hpp"
#include "seiche/plan_lattice/window.hpp"

namespace seiche::lagrangian_mesh_3d {

PatchRows Model::patches(std::size_t row, Input q) const {
  const std::size_t n = nodes_.size();
  const std::size_t stride = mesh_.plan.columns + 1;
  PatchRows rows{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows.south[axis] = q.data() + axis * n + n - mesh_.plan.nodes() + row * stride;
    rows.north[axis] = rows.south[axis] + stride;
  }
  return rows;
}

void Model::add_surface_forces(Input q, double weight) {
  const std::size_t rows = mesh_.plan.rows;
  const std::size_t columns = mesh_.plan.columns;
  const linear::RowBlocks& forces = patch_forces_;
  linear::share_out(rows, worth_sharing(), [&](std::size_t j) {
    press_patches(columns, patches(j, q), weight * settings_.density * settings_.gravity, patch_forces_.row(j));
  });
  linear::share_out(rows + 1, worth_sharing(), [&](std::size_t j) {
    const std::size_t first = j * (columns + 1);
    gather_push(columns, j > 0 ? forces.row(j - 1) : forces.zeros(), j < rows ? forces.row(j) : forces.zeros(),
                {push_[0].data() + first, push_[1].data() + first, push_[2].data() + first});
  });
}

void Model::constraint_values(Input q, Output f) const {
  const std::size_t n = nodes_.size();
  for (std::size_t cell = 0; cell < mesh_.cells(); ++cell) {
    f[cell] =
        hexahedron_volume(corners_of(mesh_, q.first(n), q.subspan(n, n), q.subspan(2 * n, n), cell)) - volume_[cell];
  }
}

double Model::mass() const {
  CompensatedSum sum;
  for (const double m : nodes_.mass()) sum.add(m);
  return sum.value();
}

std::array<double, 3> Model::momentum(Input, Input u) const {
  const std::size_t n = nodes_.size();
  std::array<CompensatedSum, 3> sum;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis].add(nodes_.mass()[k] * u[axis * n + k]);
  }
  return {sum[0].value(), sum[1].value(), sum[2].value()};
}

std::array<double, 3> Model::angular_momentum(Input q, Input u) const {
  const std::size_t n = nodes_.size();
  std::array<CompensatedSum, 3> sum;
  for (std::size_t k = 0; k < n; ++k) {
    const double m = nodes_.mass()[k];
    sum[0].add(m * (q[n + k] * u[2 * n + k] - q[2 * n + k] * u[n + k]));
    sum[1].add(m * (q[2 * n + k] * u[k] - q[k] * u[2 * n + k]));
    sum[2].add(m * (q[k] * u[n + k] - q[n + k] * u[k]));
  }
  return {sum[0].value(), sum[1].value(), sum[2].value()};
}

double Model::kinetic_energy(Input, Input u) const {
  const std::size_t n = nodes_.size();
  CompensatedSum sum;
  for (std::size_t k = 0; k < n; ++k) {
    sum.add(0.5 * nodes_.mass()[k] * (u[k] * u[k] + u[n + k] * u[n + k] + u[2 * n + k] * u[2 * n + k]));
  }
  return sum.value();
}

double Model::potential_energy(Input q) const {
  CompensatedSum moment;
  for (std::size_t j = 0; j < mesh_.plan.rows; ++j) moment.add(moment_of_row(mesh_.plan.columns, patches(j, q)));
  return settings_.density * settings_.gravity * moment.value();
}

void Model::shift_east(mechanics::State& state) {
  const std::size_t n = nodes_.size();
  const auto [columns, rows] = mesh_.plan;
  const std::size_t layers = mesh_.layers;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    plan_lattice::shift_rows(std::span(state.q).subspan(axis * n, n), columns + 1);
    plan_lattice::shift_rows(std::span(state.u).subspan(axis * n, n), columns + 1);
  }
  plan_lattice::shift_rows(std::span(mesh_.x), columns + 1);
  plan_lattice::shift_rows(std::span(mesh_.y), columns + 1);
  plan_lattice::shift_rows(std::span(volume_), columns);
  state.earlier_u.clear();
  for (auto* multipliers : state.all_multipliers()) {
    if (multipliers->empty()) continue;
    plan_lattice::shift_rows(std::span(*multipliers), columns);
    for (std::size_t row = 0; row < cell_rows(); ++row) (*multipliers)[row * columns + columns - 1] = 0;
  }
  const double bottom = state.q[2 * n];
  for (std::size_t j = 0; j <= rows; ++j) {
    double mean_x = 0;
    double mean_y = 0;
    for (std::size_t l = 0; l <= layers; ++l) {
      mean_x += state.q[mesh_.node(0, j, l)] / static_cast<double>(layers + 1);
      mean_y += state.q[n + mesh_.node(0, j, l)] / static_cast<double>(layers + 1);
    }
    for (std::size_t l = 0; l <= layers; ++l) {
      const std::size_t west = mesh_.node(0, j, l);
      const std::size_t east = mesh_.node(columns, j, l);
      state.q[west] = mean_x;
      state.q[n + west] = mean_y;
      mesh_.x[east] = state.q[east] = mesh_.x[east] + east_width_;
      state.q[n + east] = mesh_.y[east];
      state.q[2 * n + east] = bottom * static_cast<double>(layers - l) / static_cast<double>(layers);
      const Vector left = nodes_.allowed(west, {state.u[west], state.u[n + west], state.u[2 * n + west]});
      state.u[west] = left.x;
      state.u[n + west] = left.y;
      state.u[2 * n + west] = left.z;
      for (std::size_t axis = 0; axis < 3; ++axis) state.u[axis * n + east] = 0;
    }
  }
  // The new cells, and those whose west faces were straightened.
  const Input q(state.q);
  for (std::size_t row = 0; row < cell_rows(); ++row) {
    for (const std::size_t cell : {row * columns, row * columns + columns - 1}) {
      volume_[cell] = hexahedron_volume(corners_of(mesh_, q.first(n), q.subspan(n, n), q.subspan(2 * n, n), cell));
    }
  }
  nodes_.weigh(mesh_, volume_, settings_.density);
}

void Model::join_shift(const std::function<void(Output)>& nodes, const std::function<void(Output)>& cells) {
  const auto n = static_cast<std::ptrdiff_t>(nodes_.size());
  std::vector<double> first(mesh_.x);
  first.insert(first.end(), mesh_.y.begin(), mesh_.y.end());
  first.insert(first.end(), mesh_.z.begin(), mesh_.z.end());
  nodes(first);
  mesh_.x.assign(first.begin(), first.begin() + n);
  mesh_.y.assign(first.begin() + n, first.begin() + 2 * n);
  cells(volume_);
  nodes_.weigh(mesh_, volume_, settings_.density);
}

Corner Model::worst_corner(Input q) const {
  const std::size_t n = nodes_.size();
  return seiche::lagrangian_mesh_3d::worst_corner(mesh_, q.first(n), q.subspan(n, n), q.subspan(2 * n, n), volume_);
}

}  // namespace seiche::lagrangian_mesh_3d
