// Local flips give the triangles of a full rebuild, decided upon by signs that are right.
#include <string>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include "seiche/samples.hpp"
#include "verification/all_hold.hpp"
#include "verification/check.hpp"
#include "verification/geometry/moving_mesh.hpp"

namespace seiche::verification::triangulation_test {

using boost::multiprecision::cpp_rational;

template <class Number>
int sign(const Number& value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

cpp_rational rational_orientation(Point a, Point b, Point c) {
  const cpp_rational cx(c.x), cy(c.y);
  return (cpp_rational(a.x) - cx) * (cpp_rational(b.y) - cy) - (cpp_rational(a.y) - cy) * (cpp_rational(b.x) - cx);
}

cpp_rational rational_in_circle(Point a, Point b, Point c, Point d) {
  struct Row {
    Row(Point p, Point from)
        : x(cpp_rational(p.x) - cpp_rational(from.x)),
          y(cpp_rational(p.y) - cpp_rational(from.y)),
          square(x * x + y * y) {}
    cpp_rational x, y, square;
  };
  const Row ra(a, d), rb(b, d), rc(c, d);
  return ra.square * (rb.x * rc.y - rc.x * rb.y) + rb.square * (rc.x * ra.y - ra.x * rc.y) +
         rc.square * (ra.x * rb.y - rb.x * ra.y);
}

TEST_CASE("signs of orientation and in-circle are exact where rounding would decide", "[geometry]") {
  Check check("predicates", "Signs of orientation and in-circle",
              "Points on a line and on a circle, moved by a few units in the last place, far from the origin: plain "
              "floating-point arithmetic gives noise. The signs are compared with rational arithmetic.",
              "Shewchuk (1997)");
  Noise noise(1);
  const auto nudged = [&](double value) { return value * (1 + 0x1p-52 * std::round(2 * noise())); };
  double lines = 0, circles = 0, plain = 0;
  constexpr int tries = 5000;
  for (int k = 0; k < tries; ++k) {
    const double s = noise(), t = noise();
    const Point a{12 + s, 12 + s}, b{12 + t, 12 + t};
    const Point c{nudged(24), nudged(24)};
    lines += sign(orientation(a, b, c)) != sign(rational_orientation(a, b, c));
    const double naive = (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
    plain += sign(naive) != sign(rational_orientation(a, b, c));
    // 3, 4, 5 and 7, 24, 25: on one circle about (100, 100) until they are nudged.
    const Point p{nudged(100 + 15.0), nudged(100 + 20.0)}, q{nudged(100 - 7.0), nudged(100 + 24.0)};
    const Point r{nudged(100 - 20.0), nudged(100 - 15.0)}, o{nudged(100 + 24.0), nudged(100 - 7.0)};
    circles += sign(in_circle(p, q, r, o)) != sign(rational_in_circle(p, q, r, o));
  }
  all_hold(
      check, Bound{0, "the arithmetic is exact where the error bound does not settle the sign"},
      {{"Every orientation has its right sign.", lines}, {"Every in-circle determinant has its right sign.", circles}});
  check.that("noise", "Plain arithmetic fails on these points: the test means something.",
             "orientations of the wrong sign, plain", {plain > 0 ? 1.0 : 0.0},
             Qualitative{"at least one wrong sign", "otherwise the points would not be close enough to a line"});
}

/// Edges whose opposite node is strictly inside the circle.
double edges_not_delaunay(const Triangulation& mesh, Places nodes) {
  double found = 0;
  for (int t = 0; t < mesh.size(); ++t) {
    const auto& [a, b, c] = mesh[t].vertex;
    for (const int o : mesh[t].across) {
      if (o < t) continue;
      for (const int d : mesh[o].vertex) {
        if (d != a && d != b && d != c && in_circle(nodes[a], nodes[b], nodes[c], nodes[d]) > 0) ++found;
      }
    }
  }
  return found;
}

TEST_CASE("flips give the same triangles as a full rebuild over random motions", "[geometry]") {
  Check check("triangulation_flips", "Local flips against a full rebuild",
              "Nodes in a box wander at random, nodes on its sides along them. After every motion the triangles are "
              "compared with Boost.Polygon's Voronoi diagram, an independent method with integer arithmetic. In one "
              "run of 37 nodes 2e4 motions of all nodes, in another of 919 nodes a few large ones. Nodes have "
              "coordinates that are whole multiples of $2^{-28}$: both methods see the same numbers.");
  const auto run = [&](const std::string& id, int columns, int rows, int motions, double part) {
    WanderingBox box(columns, rows, 7);
    MovingTriangulation moving(triangulate_polygon(box.nodes(), box.mesh().outline), box.nodes());
    const double first = difference(triangles_of(moving.mesh()), triangles_of_sweep(box.nodes()));
    double different = first, doubtful = 0;
    for (int k = 0; k < motions; ++k) {
      box.move(part);
      moving.move_to(box.nodes());
      different += difference(triangles_of(moving.mesh()), triangles_of_sweep(box.nodes()));
      doubtful += edges_not_delaunay(moving.mesh(), box.nodes());
    }
    check.holds(id + "-built: The initial mesh equals the rebuilt one.", {first},
                Bound{0, "the Delaunay triangulation is unique"});
    check.holds(
        id + ": The triangles after flips equal the triangles of a rebuild after every motion.", {different},
        Bound{0, "the Delaunay triangulation is unique but for nodes on one circle, which random ones are not"});
    check.holds(id + "-edges: No edge is left that should be flipped.", {doubtful}, Bound{0, "Lawson (1977)"});
  };
  run("small", 5, 5, 20000, 0.1);
  run("large", 28, 30, 50, 0.7);
}

TEST_CASE("a non-convex outline retains its edges", "[geometry]") {
  Check check("triangulation_outline", "Flips within an outline that is not convex",
              "A layer of water with a steep wave for its surface, so that triangles of the nodes alone would bridge "
              "its trough. Nodes inside wander; the triangles are compared with a rebuild from scratch, by ears and "
              "insertion, and their area with the outline's.",
              "Frank, Discrete models of incompressible fluid (1994), section 5.2");
  free_lagrangian::Mesh mesh = free_lagrangian::layer_mesh(
      {.end = 4, .columns = 24, .rows = 6, .elevation = [](double x) { return 0.4 * std::cos(3 * x); }});
  MovingTriangulation moving(triangulate_polygon(mesh.places(), mesh.outline), mesh.places());
  const std::vector<bool> on = mesh.on_outline();
  Noise noise(3);
  double different = 0;
  Worst area;
  const std::vector<double> x = mesh.x, y = mesh.y;
  constexpr int motions = 300;
  for (int k = 0; k < motions; ++k) {
    for (std::size_t i = 0; i < mesh.nodes(); ++i) {
      if (on[i]) continue;
      // Along both axes, and along either alone.
      if (k % 3 != 1) mesh.x[i] = x[i] + 0.04 * noise();
      if (k % 3 != 2) mesh.y[i] = y[i] + 0.04 * noise();
    }
    moving.move_to(mesh.places());
    different +=
        difference(triangles_of(moving.mesh()), triangles_of(triangulate_polygon(mesh.places(), mesh.outline)));
    double sum = 0;
    for (const Triangle& t : moving.mesh().triangles()) {
      const auto& [a, b, c] = t.vertex;
      sum += orientation(mesh.places()[a], mesh.places()[b], mesh.places()[c]) / 2;
    }
    area.add(sum - enclosed_area(mesh.places(), mesh.outline), k);
  }
  check.that("triangles", "The number of triangles in which flips and a rebuild differ is zero.",
             "triangles in one set alone, all motions", {.value = different, .resolution = "300 motions of 175 nodes"},
             Bound{0, "the constrained Delaunay triangulation is unique"});
  check.from("identity")
      .that("area", "The triangles fill the area of the outline.", "largest difference of areas", {area.value()},
            Roundoff{300, 4, "a sum of 300 triangles that ends at the area of 4"});
}

}  // namespace seiche::verification::triangulation_test
