#include "seiche/models/lagrangian_mesh_2d/corner_barrier.hpp"

#include <cmath>
#include <limits>

namespace seiche::lagrangian_mesh_2d {

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

}  // namespace seiche::lagrangian_mesh_2d
