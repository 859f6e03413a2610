// What the two-dimensional Lagrangian mesh refuses, and how it says so.
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "verification/robustness/refusals.hpp"

namespace lagrangian_mesh_input_test {

using namespace seiche;
using namespace seiche::lagrangian_mesh_2d;
using namespace seiche::verification;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Mesh still_water() {
  return layer_mesh({.begin = 0, .end = 4, .columns = 4, .rows = 2});
}

GraphCurve::Function constant(double value) {
  return [value](double) { return value; };
}

TEST_CASE("bad meshes are refused with name, value and range", "[robustness]") {
  Check check("lagrangian_mesh_bad_mesh", "Bad meshes of the Lagrangian mesh",
              "A mesh of 4 x 2 cells with one thing wrong at a time: its size, its nodes, its cells, its walls.");
  Refusals refusals(check);
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words, auto change) {
    refusals.refused(text, words, [&] {
      Mesh mesh = still_water();
      change(mesh);
      Flow flow(std::move(mesh));
    });
  };
  refused("No columns.", {"columns", "= 0", "at least 1"}, [](Mesh& m) { m.columns = 0; });
  refused("No rows.", {"rows", "= 0", "at least 1"}, [](Mesh& m) { m.rows = 0; });
  refused("A node without an elevation.", {"15 and 14", "15 = (columns + 1)(rows + 1)"},
          [](Mesh& m) { m.y.pop_back(); });
  refused("A node whose place is not a number.", {"node 7", "nan", "finite"}, [](Mesh& m) { m.x[7] = not_a_number; });
  refused("A node that is infinitely high.", {"node 13", "inf", "finite"}, [](Mesh& m) { m.y[13] = infinity; });
  refused("A cell whose corner is turned over.", {"cell", "column 1", "not convex", "positive"},
          [](Mesh& m) { m.x[m.node(2, 1)] = 0.5; });
  refused("A cell with a corner that points inwards.", {"cell", "not convex"}, [](Mesh& m) {
    m.x[m.node(1, 1)] = 0.3;
    m.y[m.node(1, 1)] = -0.8;
    m.y[m.node(1, 2)] = -0.2;
  });
  refused("A cell of no area.", {"cell", "not convex"}, [](Mesh& m) {
    for (std::size_t j = 0; j <= m.rows; ++j) m.x[m.node(1, j)] = 0;
  });
  refused("A node off its wall.", {"node (0.01, -0.5)", "off the left wall"},
          [](Mesh& m) { m.x[m.node(0, 1)] = 0.01; });
  refused("A node off the bottom by 1e-10.", {"off the bottom wall", "at most 4e-12"},
          [](Mesh& m) { m.y[m.node(2, 0)] += 1e-10; });
  refused("A wall without a curve.", {"right wall", "no curve"}, [](Mesh& m) { m.sides.right = Wall{}; });
  refused("A moving wall that does not say where it is.", {"left moving wall", "place and velocity"},
          [](Mesh& m) { m.sides.left = MovingWall{.place = {}, .velocity = constant(0)}; });
  refused("A moving wall that meets a bottom with a slope.", {"moving wall", "level bottom"}, [](Mesh& m) {
    const double slope = 1e-3;
    for (std::size_t i = 0; i <= m.columns; ++i) m.y[m.node(i, 0)] = -1 + slope * m.x[m.node(i, 0)];
    m.sides.bottom = Wall{std::make_shared<GraphCurve>([=](double x) { return -1 + slope * x; }, constant(slope),
                                                       constant(0), 0.0, 4.0, 4)};
    m.sides.left = MovingWall{.place = constant(0), .velocity = constant(0)};
  });
  refused("A moving wall for a bottom.", {"moving wall at the bottom", "left or right"},
          [](Mesh& m) { m.sides.bottom = MovingWall{.place = constant(0), .velocity = constant(0)}; });
  refused("A prescribed side without velocities.", {"top prescribed side", "position and velocity"},
          [](Mesh& m) { m.sides.top = PrescribedSide{.position = [](Point p, double) { return p; }, .velocity = {}}; });
  refused("Water that is closed in on all sides.", {"no free side", "at least one"},
          [](Mesh& m) { m.sides.top = level_wall(0); });
  refusals.refused("A free surface that ends at a level wall.", {"level wall", "slope"}, [] {
    Mesh hanging = free_patch(2, 2, {0, 0}, {1, 1});
    for (std::size_t k = 0; k < hanging.nodes(); ++k) {
      std::swap(hanging.x[k], hanging.y[k]);
      hanging.y[k] *= -1;
    }
    hanging.sides.left = level_wall(0);
    Flow flow(std::move(hanging));
  });
}

TEST_CASE("bad constants and walls are refused with name, value and range", "[robustness]") {
  Check check("lagrangian_mesh_bad_constants", "Bad constants and walls of the Lagrangian mesh",
              "Settings out of their ranges, curves that are none, layers without water.");
  Refusals refusals(check);
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words, Settings settings) {
    refusals.refused(text, words, [&] { Flow flow(still_water(), {}, {}, settings); });
  };
  refused("Gravity upwards.", {"gravity", "= -1", "non-negative"}, {.gravity = -1});
  refused("Gravity that is not a number.", {"gravity", "nan", "finite"}, {.gravity = not_a_number});
  refused("Water without mass.", {"density", "= 0", "positive"}, {.density = 0});
  refused("A negative stiffness.", {"hourglass", "= -0.1", "non-negative"}, {.hourglass = -0.1});
  refused("A tolerance at which nothing is solved.", {"tolerance", "1e-05", "1e-06"}, {.tolerance = 1e-5});
  refused("A tolerance below rounding.", {"tolerance", "= 0"}, {.tolerance = 0});
  refusals.refused("The iterative solver without walls and bottom.", {"iterative", "walls"}, [] {
    Flow flow(free_patch(2, 2, {0, 0}, {1, 1}), {}, {}, {.solver = linear::SolverMethod::iterative});
  });
  refusals.refused("A wall without a direction.", {"direction", "= 0", "positive"}, [] { Line({0, 0}, {0, 0}); });
  refusals.refused("A wall that is nowhere.", {"line", "nan", "finite"}, [] { Line({not_a_number, 0}, {0, 1}); });
  refusals.refused("A bottom that ends before it begins.", {"end - begin", "= -1", "positive"},
                   [] { GraphCurve(constant(-1), constant(0), constant(0), 1, 0, 4); });
  refusals.refused("A bottom without a slope.", {"slope"}, [] { GraphCurve(constant(-1), {}, constant(0), 0, 1, 4); });
  refusals.refused("A bottom whose slope is not a number.", {"arc length", "nan", "finite"},
                   [] { GraphCurve(constant(-1), constant(not_a_number), constant(0), 0, 1, 4); });
  refusals.refused("A layer that ends before it begins.", {"end - begin", "= -1", "positive"},
                   [] { layer_mesh({.begin = 1, .end = 0}); });
  refusals.refused("A layer without depth.", {"depth", "= 0", "positive"}, [] { layer_mesh({.depth = 0}); });
  refusals.refused("A surface below the bottom.", {"no water", "elevation", "-1"},
                   [] { layer_mesh({.columns = 4, .elevation = [](double) { return -1.5; }}); });
  refusals.refused("A wall that leans inwards.", {"tan_slope", "= -1", "positive"},
                   [] { layer_mesh_with_slope({}, -1); });
  refusals.refused("A toe rounded by less than nothing.", {"rounding", "= -1", "non-negative"},
                   [] { layer_mesh_with_slope({}, 1, 0, -1); });
}

TEST_CASE("bad starts of the Lagrangian mesh are refused", "[robustness]") {
  Check check("lagrangian_mesh_bad_start", "Bad starts of the Lagrangian mesh",
              "Velocities that are not finite, and sweeps out of range.");
  Refusals refusals(check);
  refusals.refused("A negative number of sweeps.", {"fixed_sweeps", "= -1", "non-negative"},
                   [] { Flow flow(still_water(), {}, {.stepping = Stepping::conservative, .fixed_sweeps = -1}); });
  refusals.refused("A velocity that is not a number.", {"u[2]", "nan", "finite"}, [] {
    Flow flow(still_water(), [](Point r) { return Point{r.x > 1.5 ? not_a_number : 0, 0}; });
  });
}

TEST_CASE("meshes that cannot be rezoned are refused with the reason", "[robustness]") {
  Check check("lagrangian_mesh_bad_rezoning", "Meshes of the Lagrangian mesh that cannot be rezoned",
              "Layers and patches whose columns are to be put upright again, with one thing wrong at a time.");
  Refusals refusals(check);
  const auto layer = [](std::size_t columns, std::size_t rows) {
    return layer_mesh({.begin = 0, .end = 4, .columns = columns, .rows = rows});
  };
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words, const Mesh& mesh,
                           double drift = 0.2, const Forcing& forcing = {}) {
    refusals.refused(text, words, [&] { Flow(mesh, {}, {}, {}, forcing).keep_upright(drift); });
  };
  refused("No drift at all.", {"drift", "= 0", "1e-06"}, layer(4, 4), 0);
  refused("A drift that is not a number.", {"drift", "nan"}, layer(4, 4), not_a_number);
  refused("A drift of three cells.", {"drift", "= 3", "2"}, layer(4, 4), 3);
  refused("Two rows.", {"rows", "= 2", "at least 3"}, layer(4, 2));
  refused("Two columns.", {"columns", "= 2", "at least 3"}, layer(2, 4));
  refused("A free patch.", {"left side", "straight wall"}, free_patch(4, 4, {0, 0}, {1, 1}));
  refused("A bottom that goes on as the right wall.", {"right side", "straight wall"},
          layer_mesh_with_slope({.begin = 0, .end = 4, .columns = 8, .rows = 4}, 1, 2, 0.5));
  Mesh piston = layer(4, 4);
  piston.sides.left = MovingWall{.place = constant(0), .velocity = constant(0)};
  refused("A moving wall.", {"left side", "straight wall"}, piston);
  refused("A body force, which knows nodes by their labels.", {"body force"}, layer(4, 4), 0.2,
          {.surface_pressure = {}, .body_force = [](Point, double) {
             return Point{0, 0};
           }});
}

}  // namespace lagrangian_mesh_input_test
