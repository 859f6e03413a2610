// What the two-dimensional Lagrangian mesh refuses, and how it says so.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "verification/robustness/refusals.hpp"

namespace seiche::verification::lagrangian_mesh_input_test {

using namespace lagrangian_mesh_2d;

Mesh still_water() {
  return layer_mesh({.end = 4, .columns = 4, .rows = 2});
}

GraphCurve::Function constant(double value) {
  return [value](double) { return value; };
}

TEST_CASE("bad meshes are rejected with name, value and range", "[robustness]") {
  Check check("lagrangian_mesh_bad_mesh", "Bad meshes of the Lagrangian mesh",
              "A mesh of 4 x 2 cells with one error at a time: its size, its nodes, its cells, its walls.");
  Refusals refusals(check);
  const auto refused = refusals.of(still_water(), [&](Mesh mesh) { Flow flow(std::move(mesh)); });
  refused({"columns", "= 0", "at least 1"}, [](Mesh& m) { m.columns = 0; });
  refused({"rows", "= 0", "at least 1"}, [](Mesh& m) { m.rows = 0; });
  refused({"y has 14 values", "15, one per node of 4 x 2 cells"}, [](Mesh& m) { m.y.pop_back(); });
  refused({"node 7", "nan", "finite"}, [](Mesh& m) { m.x[7] = not_a_number; });
  refused({"node 13", "inf", "finite"}, [](Mesh& m) { m.y[13] = infinity; });
  refused({"cell", "column 1", "not convex", "positive"}, [](Mesh& m) { m.x[m.node(2, 1)] = 0.5; });
  refused({"cell", "not convex"}, [](Mesh& m) {
    m.x[m.node(1, 1)] = 0.3;
    m.y[m.node(1, 1)] = -0.8;
    m.y[m.node(1, 2)] = -0.2;
  });
  refused({"cell", "not convex"}, [](Mesh& m) {
    for (std::size_t j = 0; j <= m.rows; ++j) m.x[m.node(1, j)] = 0;
  });
  refused({"node (0.01, -0.5)", "off the left wall"}, [](Mesh& m) { m.x[m.node(0, 1)] = 0.01; });
  refused({"off the bottom wall", "at most 4e-12"}, [](Mesh& m) { m.y[m.node(2, 0)] += 1e-10; });
  refused({"right wall", "no curve"}, [](Mesh& m) { m.sides.right = Wall{}; });
  refused({"left moving wall", "place and velocity"},
          [](Mesh& m) { m.sides.left = MovingWall{.place = {}, .velocity = constant(0)}; });
  refused({"moving wall", "level bottom"}, [](Mesh& m) {
    const double slope = 1e-3;
    for (std::size_t i = 0; i <= m.columns; ++i) m.y[m.node(i, 0)] = -1 + slope * m.x[m.node(i, 0)];
    m.sides.bottom = Wall{std::make_shared<GraphCurve>([=](double x) { return -1 + slope * x; }, constant(slope),
                                                       constant(0), 0.0, 4.0, 4)};
    m.sides.left = MovingWall{.place = constant(0), .velocity = constant(0)};
  });
  refused({"moving wall at the bottom", "left or right"},
          [](Mesh& m) { m.sides.bottom = MovingWall{.place = constant(0), .velocity = constant(0)}; });
  refused({"top prescribed side", "position and velocity"},
          [](Mesh& m) { m.sides.top = PrescribedSide{.position = [](Point p, double) { return p; }, .velocity = {}}; });
  refused({"no free side", "at least one"}, [](Mesh& m) { m.sides.top = level_wall(0); });
  refusals.refused({"level wall", "slope"}, [] {
    Mesh hanging = free_patch(2, 2, {0, 0}, {1, 1});
    for (std::size_t k = 0; k < hanging.nodes(); ++k) {
      std::swap(hanging.x[k], hanging.y[k]);
      hanging.y[k] *= -1;
    }
    hanging.sides.left = level_wall(0);
    Flow flow(std::move(hanging));
  });
}

TEST_CASE("bad constants and walls are rejected with name, value and range", "[robustness]") {
  Check check("lagrangian_mesh_bad_constants", "Bad constants and walls of the Lagrangian mesh",
              "Settings out of their ranges, invalid curves, layers without water.");
  Refusals refusals(check);
  const auto use = [](const Settings& s) { Flow(still_water(), {}, {}, s); };
  const auto refused = refusals.with<Settings>(use);
  refusals.outside_ranges("Settings",
                          "gravity non-negative and finite; density positive and finite; hourglass non-negative and "
                          "finite; corner_barrier non-negative and finite",
                          Settings{}, use);
  refused({"tolerance", "1e-05", "1e-06"}, {.tolerance = 1e-5});
  refused({"tolerance", "= 0"}, {.tolerance = 0});
  refusals.refused({"iterative", "walls"}, [] {
    Flow flow(free_patch(2, 2, {0, 0}, {1, 1}), {}, {}, {.solver = linear::SolverMethod::iterative});
  });
  refusals.refused({"direction", "= 0", "positive"}, [] { Line({0, 0}, {0, 0}); });
  refusals.refused({"line", "nan", "finite"}, [] { Line({not_a_number, 0}, {0, 1}); });
  refusals.refused({"end - begin", "= -1", "positive"},
                   [] { GraphCurve(constant(-1), constant(0), constant(0), 1, 0, 4); });
  refusals.refused({"slope"}, [] { GraphCurve(constant(-1), {}, constant(0), 0, 1, 4); });
  refusals.refused({"arc length", "nan", "finite"},
                   [] { GraphCurve(constant(-1), constant(not_a_number), constant(0), 0, 1, 4); });
  refusals.refused({"end - begin", "= -1", "positive"}, [] { layer_mesh({.begin = 1, .end = 0}); });
  refusals.refused({"depth", "= 0", "positive"}, [] { layer_mesh({.depth = 0}); });
  refusals.refused({"no water", "elevation", "-1"},
                   [] { layer_mesh({.columns = 4, .elevation = [](double) { return -1.5; }}); });
  refusals.refused({"tan_slope", "= -1", "positive"}, [] { layer_mesh_with_slope({}, -1); });
  refusals.refused({"rounding", "= -1", "non-negative"}, [] { layer_mesh_with_slope({}, 1, 0, -1); });
}

TEST_CASE("bad starts of the Lagrangian mesh are rejected", "[robustness]") {
  Check check("lagrangian_mesh_bad_start", "Bad starts of the Lagrangian mesh",
              "Velocities that are not finite, and sweeps out of range.");
  Refusals refusals(check);
  refusals.refused({"fixed_sweeps", "= -1", "non-negative"},
                   [] { Flow flow(still_water(), {}, {.stepping = Stepping::conservative, .fixed_sweeps = -1}); });
  refusals.refused({"u[2]", "nan", "finite"}, [] {
    Flow flow(still_water(), [](Point r) { return Point{r.x > 1.5 ? not_a_number : 0, 0}; });
  });
}

TEST_CASE("meshes that cannot be rezoned are rejected with the reason", "[robustness]") {
  Check check("lagrangian_mesh_bad_rezoning", "Meshes of the Lagrangian mesh that cannot be rezoned",
              "Layers and patches with rezoning, with one error at a time.");
  Refusals refusals(check);
  const auto layer = [](std::size_t columns, std::size_t rows) {
    return layer_mesh({.end = 4, .columns = columns, .rows = rows});
  };
  const auto refused = [&](const std::vector<std::string>& words, const Mesh& mesh, double drift = 0.2,
                           const Forcing& forcing = {}) {
    refusals.refused(words, [&] { Flow(mesh, {}, {}, {}, forcing).keep_upright(drift); });
  };
  refused({"drift", "= 0", "1e-06"}, layer(4, 4), 0);
  refused({"drift", "nan"}, layer(4, 4), not_a_number);
  refused({"drift", "= 3", "2"}, layer(4, 4), 3);
  refused({"rows", "= 2", "at least 3"}, layer(4, 2));
  refused({"columns", "= 2", "at least 3"}, layer(2, 4));
  refused({"left side", "straight wall"}, free_patch(4, 4, {0, 0}, {1, 1}));
  refused({"right side", "straight wall"}, layer_mesh_with_slope({.end = 4, .columns = 8, .rows = 4}, 1, 2, 0.5));
  Mesh piston = layer(4, 4);
  piston.sides.left = MovingWall{.place = constant(0), .velocity = constant(0)};
  refused({"left side", "straight wall"}, piston);
  const auto none = [](Point, double) { return Point{0, 0}; };
  refused({"body force"}, layer(4, 4), 0.2, {.surface_pressure = {}, .body_force = none});
}

}  // namespace seiche::verification::lagrangian_mesh_input_test
