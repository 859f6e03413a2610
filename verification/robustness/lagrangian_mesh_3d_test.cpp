// What the hexahedral Lagrangian mesh refuses, and how it breaks down: with reason, time, step and place.
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/polynomial_bottom.hpp"
#include "verification/robustness/breakdown.hpp"
#include "verification/robustness/refusals.hpp"

namespace seiche::verification::lagrangian_mesh_3d_test {

using namespace lagrangian_mesh_3d;

Layer still_layer() {
  return {.begin = 0, .end = 4, .north = 3, .columns = 4, .rows = 3, .layers = 2};
}

std::shared_ptr<const PlanBottom> plane_bottom(double slope) {
  return polynomial_bottom({{-1, 0, 0}, {slope, 1, 0}});
}

TEST_CASE("bad hexahedral meshes and settings are rejected with name, value and range", "[robustness]") {
  Check check("lagrangian_mesh_3d_input", "Bad input of the hexahedral mesh",
              "A mesh of 4 x 3 x 2 cells with one error at a time: its layer, its nodes, its sides, its settings.");
  Refusals refusals(check);
  const auto layer = refusals.of(still_layer(), [&](Layer l) { layer_mesh(l); });
  layer({"end = 0", "begin = 0"}, [](Layer& l) { l.end = 0; });
  layer({"north = 0", "south = 0"}, [](Layer& l) { l.north = 0; });
  layer({"depth", "0", "positive"}, [](Layer& l) { l.depth = 0; });
  layer({"layers", "= 0", "at least 1"}, [](Layer& l) { l.layers = 0; });
  layer({"columns", "= 0", "at least 1"}, [](Layer& l) { l.columns = 0; });
  layer({"elevation -1.5", "x = 2", "above the bottom -1"},
        [](Layer& l) { l.elevation = [](double x, double) { return x < 2 ? 0 : -1.5; }; });
  layer({"elevation nan", "above the bottom"},
        [](Layer& l) { l.elevation = [](double, double) { return not_a_number; }; });
  const auto mesh = refusals.of(layer_mesh(still_layer()), [&](Mesh m) { Flow flow(std::move(m)); });
  mesh({"z has 59 values", "60, one per node"}, [](Mesh& m) { m.z.pop_back(); });
  mesh({"node 7", "nan", "finite"}, [](Mesh& m) { m.x[7] = not_a_number; });
  mesh({"corner", "of cell", "positive"}, [](Mesh& m) { m.x[m.node(1, 1, 1)] = 2.5; });
  mesh({"bottom node 3", "the others' elevation, -1"}, [](Mesh& m) { m.z[3] += 1e-10; });
  mesh({"driven side", "no velocity"}, [](Mesh& m) { m.sides.north = plan_lattice::DrivenSide{}; });
  mesh({"bottom node 3", "the bottom's elevation, -0.8"}, [](Mesh& m) {
    m.bottom = plane_bottom(0.05);
    for (std::size_t k = 0; k < m.plan.nodes(); ++k) m.z[k] = -1 + 0.05 * m.x[k] + (k == 3 ? 1e-10 : 0);
  });
  layer({"elevation 0", "x = 4", "above the bottom 0"}, [](Layer& l) { l.bottom = plane_bottom(0.25); });
  Layer sloped = still_layer();
  sloped.bottom = plane_bottom(0.05);
  const Window window{.reach = [](double t) { return t; }};
  const auto over_slope = refusals.of(layer_mesh(sloped), [](Mesh m) { Flow flow(std::move(m)); });
  over_slope({"driven side", "uneven bottom"},
             [](Mesh& m) { m.sides.west = plan_lattice::DrivenSide{[](Place, double) { return Point{}; }}; });
  refusals.refused({"moving window", "uneven bottom"}, [&] { Flow flow(layer_mesh(sloped), {}, {}, {}, window); });
  over_slope({"free bottom", "uneven"}, [](Mesh& m) { m.free_bottom = true; });
  refusals.refused({"bends outwards", "(2, 0)", "180"}, [] {
    Layer l = still_layer();
    l.south_wall = [](double x) { return x < 2 ? 0.0 : 0.3 * (2 - x); };
    Flow flow(layer_mesh(l));
  });
  const auto with_settings = [](const Settings& s) { Flow(layer_mesh(still_layer()), {}, {}, s); };
  refusals.outside_ranges("Settings", "gravity non-negative and finite; density positive and finite", Settings{},
                          with_settings);
  refusals.refused({"tolerance", "[1e-15, 0.0001]"}, [&] { with_settings({.tolerance = 1e-16}); });
  refusals.refused({"moving window", "WallSide, HeldSide"}, [&] {
    Layer l = still_layer();
    l.sides.west = plan_lattice::FreeSide{};
    Flow flow(layer_mesh(l), {}, {}, {}, window);
  });
  refusals.refused({"3 velocities", "60"}, [] { Flow flow(layer_mesh(still_layer()), std::vector<Vector>(3)); });
}

TEST_CASE("a wave that tangles hexahedra at a wall stops with time, step and position", "[robustness]") {
  Check check("lagrangian_mesh_3d_tangle", "A high wave inverts hexahedra at a wall",
              "A solitary wave of height 0.7 is reflected by a vertical wall. Surface nodes beside the wall overtake "
              "the wall's: a corner of a cell is inverted. The run stops there, whatever the scheme.");
  constexpr double a = 0.7;
  const double celerity = std::sqrt(1 + a), decay = std::sqrt(0.75 * a / (1 + a));
  const auto elevation = [=](double x, double) { return a / std::pow(std::cosh(decay * x), 2); };
  const auto velocity = [=](Place r) {
    const double eta = elevation(r.x, r.y), slope = -2 * decay * std::tanh(decay * r.x) * eta;
    const double u = celerity * eta / (1 + eta);
    return Vector{u, 0, (u - celerity) * slope * (1 + r.z) / (1 + eta)};
  };
  const Layer tank{.begin = -12, .end = 12, .north = 1, .columns = 48, .rows = 2, .layers = 4, .elevation = elevation};
  for (const auto& [id, stepping] :
       {std::pair{"one-step", Stepping::one_step}, {"conservative", Stepping::conservative}}) {
    Flow flow(layer_mesh(tank), velocity, {.stepping = stepping});
    holds_of_breakdown(check, id, run_until_breakdown(flow, 30, 0.05), "mesh tangled", 10, 12);
  }
}

TEST_CASE("a moving window over still water leaves it at rest", "[robustness]") {
  Check check("lagrangian_mesh_3d_window", "A moving window over still water",
              "A window of 4 x 3 x 2 cells moves over water at rest: ten columns are dropped and appended. The water "
              "stays at rest, and the window has its exact position.");
  Layer layer = still_layer();
  layer.sides.west = plan_lattice::HeldSide{};
  Flow flow(layer_mesh(layer), {}, {}, {}, {.reach = [](double t) { return 4 + t; }});
  march(flow, 10.5, 0.25);
  check.holds("Velocities of still water in a moving window are zero.",
              {worst(std::array{worst(flow.state().u), worst(flow.surface_z())})},
              Bound{0, "every force is exactly zero"});
  check.holds("The moving window has followed the stated reach.", {flow.x().back()},
              Bound{0, "one column of width 1 for each unit of time", 14});
  check.holds("The west side of the window follows at its length.", {flow.x().front()},
              Roundoff{3, 14, "a mean over three nodes", 10});
  check.holds("The number of columns left behind by the window is counted.", {static_cast<double>(flow.shifts())},
              Bound{0, "one for each unit of time, once the water beyond the next column stirs", 10});
}

}  // namespace seiche::verification::lagrangian_mesh_3d_test
