#include "seiche/models/lagrangian_mesh_2d/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::lagrangian_mesh_2d {

namespace {

/// Twice the areas of the triangles at the four corners.
std::array<double, 4> corner_triangles(const Mesh& mesh, std::span<const double> x, std::span<const double> y,
                                       std::size_t cell) {
  const auto corners = mesh.corners(cell);
  const auto at = [&](std::span<const double> values) { return bilinear_patch::at_corners(values, corners); };
  const auto j = bilinear_patch::jacobians(at(x), at(y));
  return {j.c0, j.c1, j.c2, j.c3};
}

void require_side(std::string_view name, const Side& side, const Mesh& mesh, double size, std::size_t first,
                  std::size_t stride, std::size_t count) {
  if (const auto* moving = std::get_if<MovingWall>(&side)) {
    require_that(moving->place && moving->velocity, "{} moving wall needs place and velocity", name);
    require_that(stride != 1, "a moving wall at the {}; allowed: left or right", name);
  } else if (const auto* given = std::get_if<PrescribedSide>(&side)) {
    require_that(given->position && given->velocity, "{} prescribed side needs position and velocity", name);
  }
  const auto* wall = std::get_if<Wall>(&side);
  require_that(wall == nullptr || wall->curve != nullptr, "{} wall has no curve", name);
  for (std::size_t k = first; wall != nullptr && k < first + count * stride; k += stride) {
    const Point node{mesh.x[k], mesh.y[k]};
    const double off = distance(node, wall->curve->position(wall->curve->arc_length_at(node)));
    require_that(off <= 1e-12 * size, "node ({:g}, {:g}) is {:g} off the {} wall; allowed: at most {:g}", node.x,
                 node.y, off, name, 1e-12 * size);
  }
}

}  // namespace

bool joined(const Side& one, const Side& other) {
  const auto* wall = std::get_if<Wall>(&one);
  const auto* next = std::get_if<Wall>(&other);
  return wall != nullptr && next != nullptr && wall->curve == next->curve;
}

bool Mesh::on_joined_sides(std::size_t cell, std::size_t corner) const {
  const std::size_t i = cell % columns + (corner == 1 || corner == 2 ? 1 : 0);
  const std::size_t j = cell / columns + (corner >= 2 ? 1 : 0);
  if ((i != 0 && i != columns) || (j != 0 && j != rows)) return false;
  return joined(i == 0 ? sides.left : sides.right, j == 0 ? sides.bottom : sides.top);
}

Wall vertical_wall(double place) {
  return {std::make_shared<Line>(Point{place, 0}, Point{0, 1})};
}

Wall level_wall(double level) {
  return {std::make_shared<Line>(Point{0, level}, Point{1, 0})};
}

void Mesh::require_valid() const {
  plan_lattice::require_places(*this, 1, 1, {{"x", x}, {"y", y}});
  Largest size;
  for (std::size_t k = 0; k < nodes(); ++k) size.add(std::max(std::abs(x[k]), std::abs(y[k])));
  for (std::size_t cell = 0; cell < cells(); ++cell) {
    const auto triangles = corner_triangles(*this, x, y, cell);
    const auto worst = std::min_element(triangles.begin(), triangles.end());
    const std::size_t at = corners(cell)[static_cast<std::size_t>(worst - triangles.begin())];
    require_that(*worst > 0,
                 "cell {} (column {}, row {}) is not convex at its corner ({:g}, {:g}): triangle {:g}; allowed: "
                 "positive",
                 cell, cell % columns, cell / columns, x[at], y[at], 0.5 * *worst);
  }
  require_side("left", sides.left, *this, size.value(), 0, columns + 1, rows + 1);
  require_side("right", sides.right, *this, size.value(), columns, columns + 1, rows + 1);
  require_side("bottom", sides.bottom, *this, size.value(), 0, 1, columns + 1);
  require_side("top", sides.top, *this, size.value(), rows * (columns + 1), 1, columns + 1);
}

double least_triangle(const Mesh& mesh, std::span<const double> x, std::span<const double> y, std::size_t cell) {
  auto triangles = corner_triangles(mesh, x, y, cell);
  for (std::size_t c = 0; c < triangles.size(); ++c) {
    if (mesh.on_joined_sides(cell, c)) triangles[c] = std::numeric_limits<double>::infinity();
  }
  return std::ranges::min(triangles);
}

SEICHE_SIMD_CLONES
double measure_row(std::size_t columns, const lattice::NodeVectors<Quadrilateral>& r,
                   linear::RowBlocks::Row diagonals) {
  const double* __restrict xl = r[0][0];
  const double* __restrict xu = r[0][1];
  const double* __restrict yl = r[1][0];
  const double* __restrict yu = r[1][1];
  double* __restrict ax = diagonals[0];
  double* __restrict ay = diagonals[1];
  double* __restrict bx = diagonals[2];
  double* __restrict by = diagonals[3];
  double worst = std::numeric_limits<double>::infinity();
#pragma omp simd reduction(min : worst)
  for (std::size_t i = 0; i < columns; ++i) {
    ax[i] = 0.5 * (xu[i + 1] - xl[i]);
    ay[i] = 0.5 * (yu[i + 1] - yl[i]);
    bx[i] = 0.5 * (xu[i] - xl[i + 1]);
    by[i] = 0.5 * (yu[i] - yl[i + 1]);
    // Opposite triangles add up to the whole cell.
    const double twice_area = 4 * (ax[i] * by[i] - bx[i] * ay[i]);
    const double bottom_x = xl[i + 1] - xl[i];
    const double bottom_y = yl[i + 1] - yl[i];
    const double at0 = bottom_x * (yu[i] - yl[i]) - bottom_y * (xu[i] - xl[i]);
    const double at1 = bottom_x * (yu[i + 1] - yl[i + 1]) - bottom_y * (xu[i + 1] - xl[i + 1]);
    worst = std::min(worst, std::min(std::min(at0, at1), twice_area - std::max(at0, at1)));
  }
  return worst;
}

SEICHE_SIMD_CLONES
void Quadrilateral::run(const lattice::RowLoop<Quadrilateral>& loop) {
  lattice::run_row(loop);
}

}  // namespace seiche::lagrangian_mesh_2d
