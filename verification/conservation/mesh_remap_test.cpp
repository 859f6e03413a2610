// What a remap of the two-dimensional Lagrangian mesh keeps, and a wave whose mesh is rezoned.
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/lagrangian_mesh_2d/rezone.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/differences.hpp"

namespace seiche::verification::mesh_remap_test {

using namespace lagrangian_mesh_2d;

const std::string source = "L. G. Margolin, M. Shashkov, J. Comput. Phys. 184 (2003) 266";
constexpr double size = 4;  // [m], of the patch
constexpr std::size_t cells = 16;

/// Nodes of a patch moved by up to a third of a cell, those of its sides along them.
std::pair<std::vector<double>, std::vector<double>> moved(const Mesh& mesh) {
  std::pair places{mesh.x, mesh.y};
  const double k = 2 * std::numbers::pi / size, way = size / cells / 3;
  for (std::size_t j = 0; j <= cells; ++j) {
    for (std::size_t i = 0; i <= cells; ++i) {
      const std::size_t node = mesh.node(i, j);
      const double x = mesh.x[node], y = mesh.y[node];
      if (i > 0 && i < cells) places.first[node] += way * std::sin(k * x) * std::cos(k * y);
      if (j > 0 && j < cells) places.second[node] += way * std::cos(k * x) * std::sin(1.5 * k * y);
    }
  }
  return places;
}

/// Water up to the right wall, with a solitary wave's height and pace.
Flow hump(mechanics::Stepping stepping) {
  const auto elevation = [](double x) { return 0.5 / std::pow(std::cosh(0.6 * (x + 4)), 2); };
  const auto pace = [&](Point r) { return Point{1.2 * elevation(r.x) / (1 + elevation(r.x)), 0}; };
  Flow flow(layer_mesh({.begin = -10, .end = 0, .depth = 1, .columns = 40, .rows = 8, .elevation = elevation}), pace,
            {.stepping = stepping});
  flow.keep_upright();
  return flow;
}
constexpr double end = 6, tau = 0.025;

const Roundoff rounded{.operations = 100 * cells * cells,
                       .scale = size,
                       .reason = "about a hundred operations a cell on positions of the patch's size"};

TEST_CASE("a remap of the mesh in the vertical plane conserves momentum", "[conservation]") {
  Check check("mesh_remap", "Remap of the two-dimensional mesh: conservation",
              "A free patch of 16 x 16 cells, 4 m wide, with velocities of 1 m/s; nodes move by up to a third of a "
              "cell, nodes on the sides along them.",
              source);
  const Model model(free_patch(cells, cells, {0, 0}, {size, size}));
  const mechanics::State state = model.state();
  const auto [x, y] = moved(model.mesh());
  const auto turning = [](Point r) { return Point{std::sin(2 * r.x + r.y), std::cos(r.x - 3 * r.y)}; };
  const std::vector<double> u = model.state(turning).u;
  const Remapped now = remap(model, state.q, u, x, y);
  const Model next(now.mesh);
  CompensatedSum along, up;
  for (std::size_t k = 0; k < model.mesh().nodes(); ++k) {
    along.add(next.nodes().mass()[k] * now.velocity[k].x - model.nodes().mass()[k] * u[k]);
    up.add(next.nodes().mass()[k] * now.velocity[k].y - model.nodes().mass()[k] * u[model.mesh().nodes() + k]);
  }
  check.at("16 x 16 cells");
  check.that("momentum", "Momentum is conserved by the remap to round-off.", "change of the momentum [m^3/s]",
             {std::hypot(along.value(), up.value())}, rounded);
  const Remapped same = remap(model, state.q, u, model.mesh().x, model.mesh().y);
  const Remapped stream = remap(model, state.q, model.state([](Point) { return Point{1, -0.5}; }).u, x, y);
  Worst changed, off;
  for (std::size_t k = 0; k < model.mesh().nodes(); ++k) {
    changed.add(same.velocity[k].x - u[k]);
    changed.add(same.velocity[k].y - u[model.mesh().nodes() + k]);
    off.add(stream.velocity[k].x - 1);
    off.add(stream.velocity[k].y + 0.5);
  }
  check.that("same", "The velocity change by a remap to the same positions is zero to round-off.",
             "largest difference of a velocity [m/s]", {changed.value()}, rounded);
  check.that("stream", "The uniform velocity of water is preserved by the remap to round-off.",
             "largest difference of a velocity [m/s]", {off.value()}, rounded);
}

TEST_CASE("a rezoned mesh conserves water and records its energy loss", "[conservation]") {
  Check check("mesh_rezone", "A high wave at a wall on a rezoned mesh: conservation",
              "A hump of water, a/h = 0.5, runs against a wall; 40 x 8 cells, conservative steps. And still water.",
              source);
  Flow flow = hump(mechanics::Stepping::conservative);
  const double water = compensated_sum(flow.model().first_volumes()), begin = flow.energy();
  Worst spilt, drift;
  march(flow, end, tau, [&] {
    const Mesh& mesh = flow.model().mesh();
    CompensatedSum area;
    for (std::size_t cell = 0; cell < mesh.cells(); ++cell) area.add(cell_area(mesh, flow.x(), flow.y(), cell));
    spilt.add(area.value() / water - 1, flow.time());
    drift.add((flow.energy() + flow.rezoning().lost) / begin - 1, flow.time());
  });
  const auto steps = static_cast<double>(flow.steps());
  const auto rezoned = static_cast<double>(flow.rezoning().done);
  check.at(fmt::format("40 x 8 cells, {} steps, rezoned {} times", steps, rezoned));
  check.that("rezoned", "The mesh is rezoned in at least one step, and not in every step.", "times", {rezoned},
             Bound{steps / 2 - 0.5, "once or more, not in every step", steps / 2});
  check.that("water", "The area of the water is conserved by rezoning.", "largest change over the first area",
             {spilt.value()},
             Roundoff{40 * 8 * (steps + rezoned), 1, "every cell's area rounds in every step and in every rezoning"});
  check.from("Frank (1994), chapter 1")
      .that("booked", "The sum of energy and booked loss of rezoning is conserved to round-off.",
            "largest change over the first value", {drift.value()},
            Roundoff{(steps + rezoned) * 41 * 9, 1,
                     "each step and each rezoning rounds the energy, a sum over the nodes, anew"});
  check.from("Frank (1994), chapter 1")
      .that("taken", "The energy removed by rezoning is positive and at most 1 % of the first value.",
            "energy removed by rezoning over its first value", {flow.rezoning().lost / begin},
            Bound{0.005,
                  "0 to 1 %: the energy removed is quadratic in the differences between neighbouring nodes, in the "
                  "sheet at the wall alone",
                  0.005});

  const Mesh lake = layer_mesh({.begin = -10, .end = 0, .depth = 1, .columns = 40, .rows = 8});
  const Model still(lake);
  const mechanics::State rest = still.state();
  const UprightColumns columns(lake);
  const auto places = columns.places(rest.q);
  check.that("lake", "The displacement of columns by rezoning a lake at rest is zero to round-off.",
             "largest way of a node [m]",
             {worst(std::array{largest_difference(places.x, lake.x), largest_difference(places.y, lake.y)})},
             Roundoff{100, 10, "areas of columns from positions of 10 m"});
}

TEST_CASE("rezoned columns conserve their water and the surface slope", "[conservation]") {
  Check check("mesh_upright_columns", "Rezoned columns",
              "Water 1 m deep between a vertical wall and a slope of 45 degrees, under waves of 0.2 m, in columns "
              "sheared by a surface current of a quarter of a cell.",
              source);
  constexpr std::size_t columns = 40, rows = 8;
  const auto elevation = [](double x) { return 0.2 * std::cos(2 * x); };
  Mesh mesh =
      layer_mesh_with_slope({.end = 10, .depth = 1, .columns = columns, .rows = rows, .elevation = elevation}, 1);
  const UprightColumns upright(mesh);
  const Mesh first = mesh;
  // Along the polygon of the surface, and within: no water passes the surface.
  for (std::size_t i = 1; i < columns; ++i) {
    for (std::size_t j = 1; j <= rows; ++j) {
      const std::size_t k = mesh.node(i, j), next = mesh.node(i + 1, j);
      const double part = 0.25 * static_cast<double>(j) / rows;
      mesh.x[k] = std::lerp(first.x[k], first.x[next], part);
      mesh.y[k] = std::lerp(first.y[k], first.y[next], part);
    }
  }
  const auto area_of = [&](std::span<const double> x, std::span<const double> y, std::size_t column) {
    double area = 0;
    for (std::size_t j = 0; j < rows; ++j) area += cell_area(mesh, x, y, j * columns + column);
    return area;
  };
  const Model model(mesh);
  const mechanics::State state = model.state();
  const auto places = upright.places(state.q);
  Worst changed, bent;
  CompensatedSum whole;
  for (std::size_t i = 0; i < columns; ++i) {
    const double was = area_of(mesh.x, mesh.y, i), is = area_of(places.x, places.y, i);
    changed.add(is / was - 1, first.x[first.node(i, 0)]);
    whole.add(is - was);
  }
  for (std::size_t i = 0; i <= columns; ++i) {
    const std::size_t low = first.node(i, 0), high = first.node(i, rows);
    const double slope = (first.x[high] - first.x[low]) / (first.y[high] - first.y[low]);
    for (std::size_t j = 1; j <= rows; ++j) {
      const std::size_t k = first.node(i, j);
      bent.add(places.x[k] - places.x[low] - slope * (places.y[k] - places.y[low]), first.x[low]);
    }
  }
  check.at("40 x 8 cells");
  check.that("water", "The area of the water is conserved to round-off.", "change of the area [m^2]", {whole.value()},
             Roundoff{100 * columns, 10, "areas of columns from positions of 10 m"});
  check.that(
      "column",
      "The area of every column changes by at most the error of a polygon, curvature times width squared over 8.",
      "largest change of an area over it",
      {.value = changed.value(), .where = fmt::format("x = {:.2f} m", changed.where())},
      Bound{0.25 * 0.25 / 8,
            "the error of an edge's polygon is its curvature times its width squared over eight: up to 0.8/m where the "
            "water is 0.8 m deep, and a quarter of a metre"});
  check.that("slope", "The distance of nodes from the initial line of their column is zero to round-off.",
             "largest distance of a node from the line [m]", {bent.value()}, Roundoff{100, 10, "positions of 10 m"});
}

}  // namespace seiche::verification::mesh_remap_test
