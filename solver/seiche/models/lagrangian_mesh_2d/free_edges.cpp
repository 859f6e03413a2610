#include "seiche/models/lagrangian_mesh_2d/free_edges.hpp"

namespace seiche::lagrangian_mesh_2d {

FreeEdges::FreeEdges(const Mesh& mesh) {
  const auto free = [](const Side& side) { return std::holds_alternative<FreeSide>(side); };
  const auto row = static_cast<std::ptrdiff_t>(mesh.columns + 1);
  const auto last = static_cast<std::ptrdiff_t>(mesh.nodes() - 1);
  const auto right = static_cast<std::ptrdiff_t>(mesh.columns);
  const bool top_only = !free(mesh.sides.left) && !free(mesh.sides.right) && !free(mesh.sides.bottom);
  first_node_ = top_only ? mesh.node(0, mesh.rows) : 0;
  // Clockwise around the water.
  if (free(mesh.sides.top)) strips_.push_back({last - right, 1, mesh.columns});
  if (free(mesh.sides.right)) strips_.push_back({last, -row, mesh.rows});
  if (free(mesh.sides.bottom)) strips_.push_back({right, -1, mesh.columns});
  if (free(mesh.sides.left)) strips_.push_back({0, row, mesh.rows});
}

double FreeEdges::moment(const double* x, const double* y) const {
  double sum = 0;
  over_edges([&](std::ptrdiff_t a, std::ptrdiff_t b) {
    sum += (x[b] - x[a]) * (y[a] * y[a] + y[a] * y[b] + y[b] * y[b]) / 6;
  });
  return sum;
}

void FreeEdges::push_down(const double* x, const double* y, double weight, double* push_x, double* push_y) const {
  const double sixth = weight / 6;
  over_edges([&](std::ptrdiff_t a, std::ptrdiff_t b) {
    const double square = sixth * (y[a] * y[a] + y[a] * y[b] + y[b] * y[b]);
    const double width = sixth * (x[b] - x[a]);
    push_x[a] += square;
    push_x[b] -= square;
    push_y[a] -= width * (2 * y[a] + y[b]);
    push_y[b] -= width * (y[a] + 2 * y[b]);
  });
}

void FreeEdges::press(const std::function<double(double)>& pressure, const double* x, const double* y, double weight,
                      double* push_x, double* push_y) const {
  over_edges([&](std::ptrdiff_t a, std::ptrdiff_t b) {
    const double half = 0.5 * weight * pressure(0.5 * (x[a] + x[b]));
    const double dx = half * (x[b] - x[a]);
    const double dy = half * (y[b] - y[a]);
    push_x[a] += dy;
    push_x[b] += dy;
    push_y[a] -= dx;
    push_y[b] -= dx;
  });
}

}  // namespace seiche::lagrangian_mesh_2d
