// Dirichlet cells without clipping: their areas, and gradients that are those of the areas.
#include <array>
#include <string>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/dirichlet_cells.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/geometry/moving_mesh.hpp"
#include "verification/jittered_mesh.hpp"

namespace seiche::verification::dirichlet_cells_test {

using free_lagrangian::Mesh;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 5.2";

/// The part of a convex polygon that is nearer to p than to q.
std::vector<Point> nearer(const std::vector<Point>& polygon, Point p, Point q) {
  const Point middle = 0.5 * (p + q);
  const auto side = [&](Point r) { return dot(r - middle, p - q); };
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double sa = side(a), sb = side(b);
    if (sa >= 0) kept.push_back(a);
    if ((sa >= 0) != (sb >= 0)) kept.push_back(a + sa / (sa - sb) * (b - a));
  }
  return kept;
}

double area_of(const std::vector<Point>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2;
}

Mesh block() {
  return free_lagrangian::jittered(free_lagrangian::free_patch(8, 6, {0, 0}, {1.25, 1}), 0.1, 5);
}

Triangulation triangulated(const Mesh& mesh) {
  return triangulate_polygon(mesh.places(), mesh.outline);
}

std::size_t index(int k) {
  return static_cast<std::size_t>(k);
}

/// [k][i] = dA_i/dr_k of so many nodes.
std::vector<std::vector<Point>> dense_gradients(const DirichletCells& cells, std::size_t n) {
  std::vector<std::vector<Point>> dense(n, std::vector<Point>(n));
  for (std::size_t k = 0; k < n; ++k) {
    for (int e = cells.begin()[k]; e < cells.begin()[k + 1]; ++e) {
      dense[k][index(cells.members()[index(e)])] = cells.gradients()[index(e)];
    }
  }
  return dense;
}

TEST_CASE("cells are Voronoi cells clipped by the outline", "[geometry]") {
  Check check("dirichlet_cells", "Areas of Dirichlet cells against clipping",
              "57 nodes in a rectangle, those inside moved at random. The area of every cell from the angles of the "
              "triangles, beside the rectangle cut by the bisectors with all other nodes. The area is also compared "
              "with a sum over nodes that wander in a box, over many flips.",
              source);
  const Mesh mesh = block();
  const Triangulation triangles = triangulated(mesh);
  std::vector<double> areas(mesh.nodes());
  dirichlet_areas(triangles, mesh.places(), areas);
  const std::vector<Point> centroids = dirichlet_centroids(triangles, mesh.places());
  Worst off, moment;
  for (std::size_t i = 0; i < mesh.nodes(); ++i) {
    std::vector<Point> cell{{0, 0}, {1.25, 0}, {1.25, 1}, {0, 1}};
    for (std::size_t j = 0; j < mesh.nodes(); ++j) {
      if (j != i) cell = nearer(cell, {mesh.x[i], mesh.y[i]}, {mesh.x[j], mesh.y[j]});
    }
    off.add(areas[i] - area_of(cell), static_cast<double>(i));
    Point sum;
    for (std::size_t k = 1; k + 1 < cell.size(); ++k) {
      const double part = orientation(cell[0], cell[k], cell[k + 1]) / 2;
      sum.x += part * (cell[0].x + cell[k].x + cell[k + 1].x) / 3;
      sum.y += part * (cell[0].y + cell[k].y + cell[k + 1].y) / 3;
    }
    moment.add(sum.x - areas[i] * centroids[i].x, static_cast<double>(i));
    moment.add(sum.y - areas[i] * centroids[i].y, static_cast<double>(i));
  }
  const Roundoff of_cell{
      .operations = 500, .scale = 1, .reason = "57 cuts of a polygon of the size 1, some ten roundings each"};
  check.that("areas", "Areas agree with Voronoi's cells from half-planes.", "largest difference", {off.value()},
             of_cell);
  check.that("centroids", "First moments agree with Voronoi's cells from half-planes.", "largest difference",
             {moment.value()}, of_cell);

  WanderingBox box(16, 16, 2);
  MovingTriangulation moving(triangulate_polygon(box.nodes(), box.mesh().outline), box.nodes());
  std::vector<double> cells(box.mesh().nodes());
  Worst sum;
  for (int k = 0; k < 300; ++k) {
    box.move(0.2);
    moving.move_to(box.nodes());
    dirichlet_areas(moving.mesh(), box.nodes(), cells);
    CompensatedSum total;
    for (const double a : cells) total.add(a);
    sum.add(total.value() - enclosed_area(box.nodes(), box.mesh().outline), k);
  }
  check.from("identity: the shares of a triangle add up to its area")
      .that("sum", "All cells together are the polygon, whatever flips.", "largest difference of the sum",
            {.value = sum.value(), .resolution = "297 nodes, 300 motions"},
            Roundoff{6 * 560, 0.2,
                     "six terms of each of 560 triangles, of the size |ab|^2 cot C/8, which thin ones make a hundred "
                     "times their area of 1/560"});
}

TEST_CASE("gradients of cell areas are exact", "[geometry]") {
  Check check("dirichlet_gradients", "Gradients of Dirichlet cells",
              "All derivatives of the areas of 57 cells, of nodes that are no neighbours too, beside central "
              "differences with a step of 1e-6. Translations and rotations change no area. A pressure linear in the "
              "place of the nodes gives every node inside the force of the area of its cell times the gradient, on any "
              "mesh. Where a quadrangle's nodes are on one circle both diagonals have the same areas and gradients.",
              source);
  const Mesh mesh = block();
  const Triangulation triangles = triangulated(mesh);
  DirichletCells cells;
  cells.connect(triangles, static_cast<int>(mesh.nodes()));
  cells.measure(triangles, mesh.places());
  const std::size_t n = mesh.nodes();
  const auto dense = dense_gradients(cells, n);
  constexpr double step = 1e-6;
  Worst off;
  Mesh moved = mesh;
  std::vector<double> ahead(n), behind(n);
  for (std::size_t k = 0; k < n; ++k) {
    for (const bool along_x : {true, false}) {
      double& coordinate = along_x ? moved.x[k] : moved.y[k];
      const double old = coordinate;
      for (const double way : {step, -step}) {
        coordinate = old + way;
        dirichlet_areas(triangles, moved.places(), way > 0 ? ahead : behind);
      }
      coordinate = old;
      for (std::size_t i = 0; i < n; ++i) {
        const double exact = along_x ? dense[k][i].x : dense[k][i].y;
        off.add((ahead[i] - behind[i]) / (2 * step) - exact, static_cast<double>(k));
      }
    }
  }
  check.that("differences", "Analytic gradients of the cells agree with central differences of step 1e-6 within 1e-8.",
             "largest difference of a derivative", {.value = off.value(), .resolution = "step 1e-6"},
             Bound{1e-8,
                   "the rounding 1e-16 of an area over the step, a hundred times; the third derivative, of the order "
                   "of 1/h, times the step squared is less"});
  Worst rigid;
  for (std::size_t i = 0; i < n; ++i) {
    Point shift;
    double turn = 0;
    for (std::size_t k = 0; k < n; ++k) {
      shift += dense[k][i];
      turn += dense[k][i].y * mesh.x[k] - dense[k][i].x * mesh.y[k];
    }
    for (const double rate : {shift.x, shift.y, turn}) rigid.add(rate, static_cast<double>(i));
  }
  check.that("rigid", "Translations and rotations change no area.", "largest rate of an area", {rigid.value()},
             Roundoff{200, 0.3, "some thirty terms of each of seven triangles"});
  Worst linear;
  const std::vector<bool> on = mesh.on_outline();
  constexpr double px = 0.7, py = -1.3;
  for (std::size_t k = 0; k < n; ++k) {
    if (on[k]) continue;
    Point force;
    for (std::size_t i = 0; i < n; ++i) force += (px * mesh.x[i] + py * mesh.y[i]) * dense[k][i];
    linear.add(force.x + px * cells.areas()[k], static_cast<double>(k));
    linear.add(force.y + py * cells.areas()[k], static_cast<double>(k));
  }
  check.that("linear-pressure", "The force of a linear pressure is exact.", "largest difference of a force",
             {linear.value()}, Roundoff{200, 0.5, "some thirty terms of each of seven triangles"});

  // The same square with either diagonal, inside four triangles that lean on it.
  const std::vector<double> x{0, 1, 1, 0, 0.5, 1.9, 0.5, -0.9};
  const std::vector<double> y{0, 0, 1, 1, -0.9, 0.5, 1.9, 0.5};
  const auto cells_with = [&](std::array<int, 3> half, std::array<int, 3> other) {
    const Triangulation square(TriangleSet{{4, 1, 0}, {5, 2, 1}, {6, 3, 2}, {7, 0, 3}, half, other});
    DirichletCells found;
    found.connect(square, 8);
    found.measure(square, {x, y});
    return found;
  };
  const std::array with{cells_with({0, 1, 2}, {0, 2, 3}), cells_with({0, 1, 3}, {1, 2, 3})};
  const auto first = dense_gradients(with[0], 8);
  const auto second = dense_gradients(with[1], 8);
  Worst jump;
  for (std::size_t k = 0; k < 8; ++k) {
    jump.add(with[0].areas()[k] - with[1].areas()[k]);
    for (std::size_t i = 0; i < 8; ++i) jump.add(distance(first[k][i], second[k][i]));
  }
  check.that("flip", "A flip happens without a jump of areas and gradients.",
             "largest difference between both diagonals", {jump.value()},
             Roundoff{50, 1, "some ten terms of each of five triangles"});
}

}  // namespace seiche::verification::dirichlet_cells_test
