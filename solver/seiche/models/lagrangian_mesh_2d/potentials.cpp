#include "seiche/models/lagrangian_mesh_2d/potentials.hpp"

#include <cmath>
#include <limits>

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

namespace {

constexpr double onset = 0.3;

struct CornerNodes {
  std::size_t own, next, previous;  // counter-clockwise: next after own, previous before
};

/// visit(corner's nodes, its shape, its cell) for every corner below the onset.
template <class Visit>
void over_sharp_corners(const Mesh& mesh, std::span<const double> first_areas, const double* x, const double* y,
                        const Visit& visit) {
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const auto r = mesh.corners(cell);
    for (std::size_t c = 0; c < 4; ++c) {
      const CornerNodes k{r[c], r[(c + 1) % 4], r[(c + 3) % 4]};
      const double twice_triangle =
          (x[k.next] - x[k.own]) * (y[k.previous] - y[k.own]) - (y[k.next] - y[k.own]) * (x[k.previous] - x[k.own]);
      const double shape = twice_triangle / first_areas[cell];
      if (shape < onset) visit(k, shape, cell);
    }
  }
}

}  // namespace

double CornerBarrier::energy(const Mesh& mesh, std::span<const double> first_areas, const double* x,
                             const double* y) const {
  double sum = 0;
  over_sharp_corners(mesh, first_areas, x, y, [&](const CornerNodes&, double shape, std::size_t cell) {
    const double excess = onset / shape - 1;
    sum += shape > 0 ? std::pow(first_areas[cell], 1.5) * excess * excess : std::numeric_limits<double>::infinity();
  });
  return stiffness_ * sum;
}

void CornerBarrier::push(const Mesh& mesh, std::span<const double> first_areas, const double* x, const double* y,
                         double weight, std::span<double> push_x, std::span<double> push_y) const {
  over_sharp_corners(mesh, first_areas, x, y, [&](const CornerNodes& k, double shape, std::size_t cell) {
    // -dPi/d(twice the triangle).
    const double force =
        weight * stiffness_ * std::sqrt(first_areas[cell]) * 2 * (onset / shape - 1) * onset / (shape * shape);
    const double next_x = force * (y[k.previous] - y[k.own]);
    const double next_y = -force * (x[k.previous] - x[k.own]);
    const double previous_x = -force * (y[k.next] - y[k.own]);
    const double previous_y = force * (x[k.next] - x[k.own]);
    push_x[k.next] += next_x;
    push_y[k.next] += next_y;
    push_x[k.previous] += previous_x;
    push_y[k.previous] += previous_y;
    push_x[k.own] -= next_x + previous_x;
    push_y[k.own] -= next_y + previous_y;
  });
}

namespace {

Point alternating(const Mesh& mesh, const double* x, const double* y, std::size_t cell) {
  const auto [r0, r1, r2, r3] = mesh.corners(cell);
  return {x[r0] - x[r1] + x[r2] - x[r3], y[r0] - y[r1] + y[r2] - y[r3]};
}

}  // namespace

Hourglass::Hourglass(const Mesh& mesh, double stiffness) : stiffness_(stiffness) {
  for (std::size_t cell = 0; active() && cell < mesh.cells(); ++cell) {
    rest_.push_back(alternating(mesh, mesh.x.data(), mesh.y.data(), cell));
  }
}

double Hourglass::energy(const Mesh& mesh, const double* x, const double* y) const {
  double squares = 0;
  for (std::size_t cell = 0; cell < rest_.size(); ++cell) {
    const Point h = alternating(mesh, x, y, cell);
    const Point off{h.x - rest_[cell].x, h.y - rest_[cell].y};
    squares += dot(off, off);
  }
  return 0.5 * stiffness_ * squares;
}

void Hourglass::push(const Mesh& mesh, const double* x, const double* y, double weight, double* push_x,
                     double* push_y) const {
  for (std::size_t cell = 0; cell < rest_.size(); ++cell) {
    const Point h = alternating(mesh, x, y, cell);
    const auto r = mesh.corners(cell);
    for (std::size_t c = 0; c < 4; ++c) {
      const double towards = (c % 2 == 0 ? -weight : weight) * stiffness_;
      push_x[r[c]] += towards * (h.x - rest_[cell].x);
      push_y[r[c]] += towards * (h.y - rest_[cell].y);
    }
  }
}

}  // namespace seiche::lagrangian_mesh_2d
