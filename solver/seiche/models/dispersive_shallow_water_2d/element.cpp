#include "seiche/models/dispersive_shallow_water_2d/element.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/require.hpp"

namespace seiche::dispersive_shallow_water_2d {

SEICHE_SIMD_CLONES
double measure_row(std::size_t columns, const lattice::NodeVectors<Column>& rows, double bottom, double weight,
                   bool add, linear::RowBlocks::Row gradients) {
  using bilinear_patch::Corners;
  const lattice::NodeVectors<Column> r = rows;
  double* const g = gradients.data;
  const std::size_t stride = gradients.stride;
  double jacobian = std::numeric_limits<double>::infinity();
  if (!add) {
    for (std::size_t k = 0; k < Column::stored; ++k) std::fill_n(gradients[k], columns, 0.0);
  }
#pragma omp simd reduction(min : jacobian)
  for (std::size_t i = 0; i < columns; ++i) {
    const Corners x = bilinear_patch::corners_between(r[0], i);
    const Corners y = bilinear_patch::corners_between(r[1], i);
    const Corners z = bilinear_patch::corners_between(r[2], i);
    const Corners over{z.c0 - bottom, z.c1 - bottom, z.c2 - bottom, z.c3 - bottom};
    const Corners j = bilinear_patch::jacobians(x, y);
    const auto volume = bilinear_patch::volume_gradient(x, y, over, j);
    const auto put = [&](std::size_t axis, const Corners& along) __attribute__((always_inline)) {
      g[axis * stride + i] += weight * along.c0;
      g[(3 + axis) * stride + i] += weight * along.c1;
      g[(6 + axis) * stride + i] += weight * along.c2;
      g[(9 + axis) * stride + i] += weight * along.c3;
    };
    put(0, volume.x);
    put(1, volume.y);
    put(2, volume.z);
    jacobian = std::min(jacobian, std::min(std::min(j.c0, j.c1), std::min(j.c2, j.c3)));
  }
  return jacobian;
}

BottomVolume::BottomVolume(plan_lattice::Shape shape, std::shared_ptr<const PlanBottom> bottom)
    : shape_(shape), bottom_(std::move(bottom)) {}

BottomVolume::Edge BottomVolume::edge(const Ends& at) const {
  const Point way = at[1] - at[0];
  Edge edge;
  for (const auto [t, weight] : gauss_points()) {
    const auto b = bottom_->integral(at[0].x + t * way.x, at[0].y + t * way.y);
    edge.value += weight * way.y * b.value;
    edge.xp += weight * way.y * (1 - t) * b.elevation;
    edge.xq += weight * way.y * t * b.elevation;
    edge.yp += weight * way.y * (1 - t) * b.along_y;
    edge.yq += weight * way.y * t * b.along_y;
    edge.integral += weight * b.value;
  }
  return edge;
}

BottomVolume::Edge BottomVolume::edge_between(const Ends& from, const Ends& to) const {
  const Ends half{0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])};
  const Edge begin = edge(from);
  const Edge middle = edge(half);
  const Edge end = edge(to);
  const auto mean = [&](double Edge::*part) { return (begin.*part + 4 * (middle.*part) + end.*part) / 6; };
  const std::array way{to[0].x - from[0].x, to[0].y - from[0].y, to[1].x - from[1].x, to[1].y - from[1].y};
  std::array slope{mean(&Edge::xp), mean(&Edge::yp), mean(&Edge::xq), mean(&Edge::yq)};
  // What E grows by, less the mean gradient times the way. Both are the same for B and for its difference from B where
  // a point of the rule is in the middle.
  const double stretch = way[3] - way[1];
  double lacking = 0;
  for (const auto [t, weight] : gauss_points()) {
    const double dx = 0.5 * std::lerp(way[0], way[2], t);
    const double dy = 0.5 * std::lerp(way[1], way[3], t);
    const Point place = half[0] + t * (half[1] - half[0]);
    const double after = bottom_->increment(place.x, place.y, dx, dy);
    const double before = bottom_->increment(place.x, place.y, -dx, -dy);
    lacking += weight * ((half[1].y - half[0].y) * (after - before) + stretch / 2 * (after + before));
    lacking -= weight * stretch * (after + before) / 6;
  }
  complete(slope, way, lacking);
  return {end.value - begin.value, slope[0], slope[1], slope[2], slope[3], mean(&Edge::integral)};
}

void BottomVolume::subtract_gradients(mechanics::Input q0, mechanics::Input q1, linear::RowBlocks& gradients) const {
  const std::size_t n = shape_.nodes();
  shape_.each_edge([&](std::size_t p, std::size_t q, std::size_t left, std::size_t right) {
    const auto ends = [&](mechanics::Input at) { return Ends{Point{at[p], at[n + p]}, Point{at[q], at[n + q]}}; };
    const Edge here = q0.data() == q1.data() ? edge(ends(q0)) : edge_between(ends(q0), ends(q1));
    const std::array at{here.at_p(), here.at_q()};
    // Cells on its left have it anticlockwise.
    const auto subtract = [&](std::size_t cell, const std::array<std::size_t, 2>& corners, double sign) {
      if (cell == plan_lattice::Shape::outside) return;
      const linear::RowBlocks::Row row = gradients.row(cell / shape_.columns);
      for (std::size_t end = 0; end < 2; ++end) {
        row[3 * corners[end]][cell % shape_.columns] -= sign * at[end].x;
        row[3 * corners[end] + 1][cell % shape_.columns] -= sign * at[end].y;
      }
    };
    const bool along_row = q == p + 1;
    subtract(left, along_row ? std::array<std::size_t, 2>{0, 1} : std::array<std::size_t, 2>{1, 2}, 1);
    subtract(right, along_row ? std::array<std::size_t, 2>{3, 2} : std::array<std::size_t, 2>{0, 3}, -1);
  });
}

double BottomVolume::volume(const std::array<Point, 4>& at) const {
  return edge({at[0], at[1]}).value + edge({at[1], at[2]}).value - edge({at[3], at[2]}).value -
         edge({at[0], at[3]}).value;
}

namespace {

double cube(double a) {
  return a * a * a;
}

/// Derivatives of |D|^2/A^3 with respect to the diagonals between two configurations of a cell.
std::array<Vector3, 2> gradient(const Diagonals& from, const Diagonals& to) {
  const Vector3 a = 0.5 * (from.a + to.a);
  const Vector3 b = 0.5 * (from.b + to.b);
  const double a0 = from.area();
  const double a1 = to.area();
  const double inverse = 0.5 * (1 / cube(a0) + 1 / cube(a1));
  const double divided = -(a0 * a0 + a0 * a1 + a1 * a1) / cube(a0 * a1);  // (1/a1^3 - 1/a0^3)/(a1 - a0)
  const Point d0 = from.d();
  const Point d1 = to.d();
  const double by_area = 0.5 * (0.5 * (d0.x * d0.x + d0.y * d0.y + d1.x * d1.x + d1.y * d1.y)) * divided;
  const Point d = inverse * (d0 + d1);
  return {Vector3{-b.z * d.x + by_area * b.y, -b.z * d.y - by_area * b.x, d.x * b.x + d.y * b.y},
          Vector3{a.z * d.x - by_area * a.y, a.z * d.y + by_area * a.x, -d.x * a.x - d.y * a.y}};
}

}  // namespace

Diagonals::Diagonals(mechanics::Input q, const plan_lattice::Shape& shape, std::size_t cell) {
  const auto [c0, c1, c2, c3] = shape.corners(cell);
  a = vector_at(q, c2) - vector_at(q, c0);
  b = vector_at(q, c3) - vector_at(q, c1);
}

double dispersion_energy(const plan_lattice::Shape& shape, double gamma, std::span<const double> volumes,
                         mechanics::Input q) {
  CompensatedSum sum;
  for (std::size_t cell = 0; cell < shape.cells(); ++cell) {
    const Diagonals at(q, shape, cell);
    sum.add(gamma / 8 * volumes[cell] * volumes[cell] * dot(at.d(), at.d()) / cube(at.area()));
  }
  return sum.value();
}

void push_dispersion(const plan_lattice::Shape& shape, double weight, std::span<const double> volumes,
                     mechanics::Input q0, mechanics::Input q1, mechanics::Output forces) {
  for (std::size_t cell = 0; cell < shape.cells(); ++cell) {
    const auto corners = shape.corners(cell);
    const auto slope = gradient({q0, shape, cell}, {q1, shape, cell});
    const double half = weight / 8 * volumes[cell] * volumes[cell];
    for (std::size_t c = 0; c < 4; ++c) {
      const Vector3 force = vector_at(forces, corners[c]) + (c < 2 ? half : -half) * slope[c % 2];
      put_vector(force, corners[c], forces);
    }
  }
}

SEICHE_SIMD_CLONES
void Column::run(const lattice::RowLoop<Column>& loop) {
  lattice::run_row(loop);
}

}  // namespace seiche::dispersive_shallow_water_2d
