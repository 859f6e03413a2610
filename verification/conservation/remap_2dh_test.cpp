// What a remap of the 2DH model keeps, and a flow around an island whose lattice is rezoned.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/divergence.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/plan/island_flow.hpp"
#include "validation/instruments/plan/plan_remap.hpp"
#include "verification/check.hpp"
#include "verification/conservation/differences.hpp"

namespace seiche::verification::remap_2dh_test {

using namespace dispersive_shallow_water_2d;
using validation::remap, validation::Remapped, validation::RezonedFlow, validation::ShoreFollowing;

const std::string source = "L. G. Margolin, M. Shashkov, J. Comput. Phys. 184 (2003) 266";
constexpr double size = 4;  // [m], of the box
constexpr std::size_t cells = 16;

/// Nodes of a lattice of a box moved by up to a third of a cell, those of its sides along them.
std::pair<std::vector<double>, std::vector<double>> moved(const Lattice& lattice) {
  std::pair places{lattice.x, lattice.y};
  const double k = 2 * std::numbers::pi / size, way = size / cells / 3;
  for (std::size_t i = 0; i < lattice.shape.nodes(); ++i) {
    const double x = lattice.x[i], y = lattice.y[i];
    places.first[i] += way * std::sin(k * x) * std::cos(k * y);
    places.second[i] += way * std::cos(k * x) * std::sin(1.5 * k * y);
  }
  for (std::size_t i = 0; i <= lattice.shape.columns; ++i) {
    places.second[i] = 0;
    places.second[lattice.shape.node(i, lattice.shape.rows)] = size;
  }
  return places;
}

Lattice box() {
  return rectangular_lattice({.end = size, .north = size, .columns = cells, .rows = cells});
}

const Roundoff rounded{.operations = 100 * cells * cells,
                       .scale = size,
                       .reason = "about a hundred operations a cell on positions of the box's size"};

TEST_CASE("a remap of the 2DH model preserves a uniform stream", "[conservation]") {
  Check check("remap_2dh", "Remap of the two-dimensional horizontal model: conservation",
              "16 x 16 cells over a level bottom 1 m deep, one velocity; nodes move by up to a third of a cell, nodes "
              "on the sides along them.",
              source);
  const Model model(box());
  std::vector<double> u(3 * model.nodes(), 0.0);
  std::fill_n(u.begin(), model.nodes(), 1.0);
  std::fill_n(u.begin() + static_cast<std::ptrdiff_t>(model.nodes()), model.nodes(), -0.5);
  const auto [x, y] = moved(model.lattice());
  const Remapped now = remap(model, model.state().q, u, x, y);
  Worst off;
  for (std::size_t k = 0; k < model.nodes(); ++k) {
    off.add(now.velocity[k].u - 1);
    off.add(now.velocity[k].v + 0.5);
    off.add(now.velocity[k].w);
    off.add(now.lattice.z[k]);
  }
  check.that("stream", "The uniform velocity under a level surface is preserved by the remap to round-off.",
             "largest difference", {.value = off.value(), .resolution = "16 x 16 cells"}, rounded);
}

TEST_CASE("a remap of the 2DH model onto cells that have no area in a corner is infeasible", "[conservation]") {
  const Model model(box());
  std::vector<double> x = model.lattice().x;
  x[model.shape().node(2, 1)] = x[model.shape().node(1, 1)];
  CHECK_THROWS_WITH(remap(model, model.state().q, model.state().u, x, model.lattice().y),
                    Catch::Contains("would tangle"));
}

TEST_CASE("a remap of the 2DH model conserves water and momentum and keeps every column wet", "[conservation]") {
  Check check("remap_thin_2dh", "Remap of the two-dimensional horizontal model: rough and thin water",
              "16 x 16 cells over a level bottom, columns between 6 cm and 1 m deep at random, velocities of 1 m/s at "
              "random; nodes move by up to a third of a cell.",
              "validation/instruments/plan/plan_remap.hpp");
  Lattice rough = box();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (double& z : rough.z) z = std::pow(10, 0.6 * (number(random) - 1)) - 1;
  const Model model(rough);
  std::vector<double> u(3 * model.nodes());
  for (double& rate : u) rate = number(random);
  const auto [x, y] = moved(rough);
  const Remapped now = remap(model, model.state().q, u, x, y);
  const Model next(now.lattice);
  const std::size_t n = model.nodes();
  check.at("16 x 16 cells");
  check.that("wet", "Depths of all columns are positive after the remap.", "smallest depth is positive",
             {smallest(now.lattice.z) > -1 ? 1.0 : 0.0},
             Qualitative{"above the bottom", "a column sinks by a part of its depth in a pass"});
  check.that("told", "The water redistributed by the limiter of the remap is more than zero and at most 5 % of all.",
             "that water over all", {now.displaced / compensated_sum(model.first_volumes())},
             Bound{0.025 - 1e-6, "some, less than a twentieth", 0.025});
  check.from(source).that("water", "The volume of the water is conserved to round-off.", "change of the volume [m^3]",
                          {compensated_sum(next.first_volumes()) - compensated_sum(model.first_volumes())}, rounded);
  CompensatedSum before_x, before_y, after_x, after_y;
  for (std::size_t k = 0; k < n; ++k) {
    before_x.add(model.node_masses()[k] * u[k]);
    before_y.add(model.node_masses()[k] * u[n + k]);
    after_x.add(next.node_masses()[k] * now.velocity[k].u);
    after_y.add(next.node_masses()[k] * now.velocity[k].v);
  }
  check.from(source).that(
      "momentum", "Momentum is conserved by the remap to round-off.", "change of the momentum [m^4/s]",
      {std::hypot(after_x.value() - before_x.value(), after_y.value() - before_y.value())}, rounded);
}

TEST_CASE("a mesh that follows the shore withdraws thin films and retains its widths", "[conservation]") {
  Check check("rezone_film_2dh", "Places of the nodes next to a shoreline",
              "Still water around the conical island, columns 0.5 m apart; its shoreline is moved up the island, or "
              "its second row towards the shoreline.",
              "validation/instruments/plan/plan_remap.hpp");
  const validation::ConicalIsland island({.spacing = 0.5});
  Lattice lake = island.lattice();
  const std::size_t count = lake.shape.columns + 1;
  for (std::size_t k = count; k < lake.shape.nodes(); ++k) lake.z[k] = 0;
  const auto cells_beside = [&](std::size_t i) { return std::array{i > 0 ? i - 1 : 0, std::min(i, count - 2)}; };
  const auto width = [&](const auto& at, std::size_t i, std::size_t j) {
    const std::size_t k = j * count + i;
    return std::hypot(at.x[k] - at.x[k - count], at.y[k] - at.y[k - count]);
  };
  // Of the cells beside a column, from the shoreline to a row.
  const auto mean_depth = [&](const Lattice& lattice, std::span<const double> volumes, std::size_t i,
                              std::size_t rows) {
    double water = 0, area = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      for (const std::size_t beside : cells_beside(i)) {
        const std::size_t cell = row * lattice.shape.columns + beside;
        const auto [a, b, c, d] = lattice.shape.corners(cell);
        water += volumes[cell];
        area += 0.5 * ((lattice.x[c] - lattice.x[a]) * (lattice.y[d] - lattice.y[b]) -
                       (lattice.x[d] - lattice.x[b]) * (lattice.y[c] - lattice.y[a]));
      }
    }
    return water / area;
  };
  const auto radius = [&](std::size_t i) { return std::hypot(lake.x[i], lake.y[i]); };
  const auto lift = [&](Lattice& at, std::size_t k, double above) {
    at.z[k] = lake.bottom->slope(at.x[k], at.y[k]).elevation + above;
  };
  // A node of a row on the line through that of the shoreline, so far from the island's middle.
  const auto put = [&](Lattice& at, std::size_t i, std::size_t row, double from_middle, double above) {
    const std::size_t k = row * count + i;
    at.x[k] = from_middle / radius(i) * lake.x[i];
    at.y[k] = from_middle / radius(i) * lake.y[i];
    lift(at, k, above);
  };
  const Settings settings{.gravity = validation::ConicalIsland::gravity};
  // A film: the shoreline stands 0.25 m farther up, and the next row is 1.5 mm above the bottom.
  Lattice film = lake;
  for (std::size_t i = 0; i < count; ++i) {
    put(film, i, 0, radius(i) - 0.25, 0);
    lift(film, count + i, 0.0015);
  }
  const Model thin(film, settings);
  const mechanics::State state = thin.state();
  constexpr double edge_slope = 0.01;
  const ShoreFollowing following(lake, {.edge_slope = edge_slope});
  const auto drawn = following.places(state.q, thin.first_volumes());
  Worst off;
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double slope = 2 * mean_depth(film, thin.first_volumes(), i, 1) / width(film, i, 1);
    off.add(width(drawn, i, 1) / width(film, i, 1) / std::sqrt(slope / edge_slope) - 1);
  }
  // A tongue: one marker of the shoreline runs 0.4 m ahead, those beside it half as far.
  Lattice tongue = lake;
  const std::size_t ahead = count / 2;
  for (const std::size_t i : {ahead - 1, ahead, ahead + 1}) {
    const double left = 1 - (i == ahead ? 0.4 : 0.2) / radius(i);
    tongue.x[i] *= left;
    tongue.y[i] *= left;
    lift(tongue, i, 0);
  }
  const Model long_one(tongue, settings);
  const auto places_of = [&](double shore_slope) {
    return ShoreFollowing(lake, {.edge_slope = 0, .shore_slope = shore_slope})
        .places(long_one.state().q, long_one.first_volumes());
  };
  const auto as_it_comes = places_of(0), cut = places_of(1);
  const auto up = [&](std::size_t i) { return radius(i) - std::hypot(cut.x[i], cut.y[i]); };
  Largest steepest;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    steepest.add(std::abs(up(i + 1) - up(i)) / std::hypot(lake.x[i + 1] - lake.x[i], lake.y[i + 1] - lake.y[i]));
  }
  check.at("columns 0.5 m apart");
  check.that("cut", "The slope of a tongue that is drawn back agrees with the setting within 5 % on either side.",
             "steepest rise between neighbouring nodes of the shoreline over their distance", {steepest.value()},
             Bound{0.05, "columns are lines from the first shoreline to the outer side and not quite radii", 1});
  Worst pressed;
  for (std::size_t j = 1; j < lake.shape.rows; ++j) {
    pressed.add(std::min(0.0, width(cut, ahead, j) / width(as_it_comes, ahead, j) - 0.7));
  }
  check.that("pressed", "The narrowest cell of a column retains at least 0.7 of its width.",
             "width below 0.7 of its initial value", {pressed.value()},
             Roundoff{10, 10, "differences of positions up to 10 m away"});
  check.that("drawn", "The width of a film that is drawn back agrees with the wedge of the given slope within 1 %.",
             "width of the cells at the shoreline over the square root of the slope's deficit, minus 1", {off.value()},
             Bound{0.01,
                   "error of the pattern + - along a row that is not a circle: the bottom's spline moves its nodes by "
                   "some mm in half a metre"});
  const Remapped after = remap(thin, state.q, state.u, drawn.x, drawn.y);
  const Model next(after.lattice, settings);
  check.from(source).that("water", "The volume of the film is conserved to round-off.", "change of the volume over it",
                          {compensated_sum(next.first_volumes()) / compensated_sum(thin.first_volumes()) - 1},
                          Roundoff{static_cast<double>(lake.shape.cells()), 1,
                                   "every cell's volume rounds its own differences of positions of the basin's size"});
  check.that("downhill", "The potential energy of the film falls as the water is drawn downhill.",
             "potential energy after is less than before",
             {thin.potential_energy(next.state().q) < thin.potential_energy(state.q) ? 1.0 : 0.0},
             Qualitative{"less than before", "water leaves the slope above the others"});

  // A film over two rows: the shoreline 0.25 m farther up, two rows 0.09 m apart with 0.4 and 0.8 mm of water.
  Lattice sheet = lake;
  for (std::size_t i = 0; i < count; ++i) {
    for (const double row : {0.0, 1.0, 2.0}) {
      put(sheet, i, static_cast<std::size_t>(row), radius(i) - 0.25 + 0.09 * row, 0.0004 * row);
    }
  }
  const Model sheeted(sheet, settings);
  const auto gathered = following.places(sheeted.state().q, sheeted.first_volumes());
  const auto both = [&](const auto& at, std::size_t i) { return width(at, i, 1) + width(at, i, 2); };
  Worst off_rows;
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double slope = 2 * mean_depth(sheet, sheeted.first_volumes(), i, 2) / both(sheet, i);
    off_rows.add(both(gathered, i) / both(sheet, i) / std::sqrt(slope / edge_slope) - 1);
  }
  check.that("drawn-rows", "The width of a film over two rows agrees with the wedge of the given slope within 1 %.",
             "width of both rows of cells over the square root of the slope's deficit, minus 1", {off_rows.value()},
             Bound{0.01, "as for one row: nodes of a row that is not a circle move by some mm in decimetres"});

  // The second row 1 mm from the shoreline.
  Lattice narrow = lake;
  for (std::size_t i = 0; i < count; ++i) {
    narrow.x[count + i] = lake.x[i] * (radius(i) + 0.001) / radius(i);
    narrow.y[count + i] = lake.y[i] * (radius(i) + 0.001) / radius(i);
  }
  const Model squeezed(narrow);
  const auto kept = following.places(squeezed.state().q, squeezed.first_volumes());
  Smallest least;
  for (std::size_t j = 1; j < lake.shape.rows; ++j) {
    for (std::size_t i = 0; i < count; ++i) least.add(width(kept, i, j) / width(lake, i, j));
  }
  check.that("widths", "The narrowest cell after rows were put apart has the least width of the settings, to 1e-9.",
             "narrowest cell along its column, over its initial value", {least.value()},
             Bound{1e-9, "a quarter, to rounding", 0.25});
}

TEST_CASE("a wave that breaks on an island leaves its mesh valid", "[conservation]") {
  Check check("rezone_breaking_2dh", "The highest wave around the conical island",
              "Case C, columns 0.7 m apart, until the water behind the island has run up and down.",
              "validation/instruments/plan/plan_remap.hpp");
  const validation::ConicalIsland island({.height = 0.181, .spacing = 0.7});
  RezonedFlow flow = island.rezoned_flow();
  const double water = compensated_sum(flow.flow().model().first_volumes());
  Worst spilt;
  bool whole = true;
  try {
    march(flow, island.passage() + 6, island.step(),
          [&] { spilt.add(compensated_sum(flow.flow().model().first_volumes()) / water - 1, flow.time()); });
  } catch (const Divergence&) {
    whole = false;
  }
  const std::string resolution =
      fmt::format("columns 0.7 m apart, {} steps, rezoned {} times", flow.steps(), flow.rezoned());
  check.that("whole", "The grid is sound until the wave has passed the island.",
             "the mesh is valid at the end, and each rezoning succeeded",
             {.value = whole && flow.refused() == 0 ? 1.0 : 0.0, .resolution = resolution},
             Qualitative{"no cell is inverted, no column falls dry", "6 s after the crest would pass the middle"});
  check.from(source).that("water", "The volume of the water is conserved to round-off.",
                          "largest change over the first volume", {.value = spilt.value(), .resolution = resolution},
                          Roundoff{static_cast<double>(flow.flow().shape().cells()), 1,
                                   "every cell's volume rounds its own differences of positions of the basin's size"});
}

TEST_CASE("fronts continue to break while their mesh is rezoned", "[conservation]") {
  Check check("rezone_fronts_2dh", "Breaking fronts on a mesh that is rezoned",
              "Case C of the conical island, columns 1 m apart, until the crest would be 2 s beyond the middle of the "
              "island; the mesh is rezoned before every step.",
              "validation/instruments/plan/plan_remap.hpp");
  const validation::ConicalIsland island({.height = 0.181, .spacing = 1});
  RezonedFlow flow(island.lattice(), [&](double x, double y) { return island.velocity(x, y); }, {},
                   island.model_settings(), {.drift = 1e-6});
  long remembered = 0, rezoned = 0;
  march(flow, island.passage() + 2, island.step(), [&] {
    const bool anew = flow.rezoned() > std::exchange(rezoned, flow.rezoned());
    if (anew && flow.flow().model().breaking().going_on() > 0) ++remembered;
  });
  check.that(
      "go-on", "The number of fronts that continue breaking after a rezoning, though no longer steep, is positive.",
      "steps with such fronts after a rezoning, more than none",
      {.value = remembered > 0 ? 1.0 : 0.0,
       .resolution = fmt::format("columns 1 m apart, {} steps, rezoned {} times", flow.steps(), flow.rezoned())},
      Qualitative{"a breaking front without a steep position", "only a front retained across the rezoning can be one"});
}

TEST_CASE("a rezoned flow around an island conserves water and records the energy removed by rezoning",
          "[conservation]") {
  Check check("rezone_2dh", "A flow around an island on a rezoned mesh: conservation",
              "Case A of the conical island without friction, columns 1 m apart, conservative steps, until the crest "
              "would be at the middle of the island; and still water.",
              source);
  const validation::ConicalIsland island(
      {.height = 0.045, .spacing = 1, .scheme = {.stepping = mechanics::Stepping::conservative}, .drag = {}});
  RezonedFlow flow = island.rezoned_flow();
  const double water = compensated_sum(flow.flow().model().first_volumes()), begin = flow.energy();
  Worst spilt, drift;
  march(flow, island.passage(), island.step(), [&] {
    spilt.add(compensated_sum(flow.flow().model().first_volumes()) / water - 1, flow.time());
    drift.add((flow.energy() + flow.lost()) / begin - 1, flow.time());
  });
  const auto cells_of_all = static_cast<double>(flow.flow().shape().cells()), steps = static_cast<double>(flow.steps());
  check.at(fmt::format("columns 1 m apart, {} steps, rezoned {} times", flow.steps(), flow.rezoned()));
  check.that("rezoned", "The mesh is rezoned in at least one step, and not in every step.", "times",
             {static_cast<double>(flow.rezoned())},
             Bound{steps / 2 - 0.5, "once or more, not in every step", steps / 2});
  check.that(
      "water", "The volume of the water is conserved to round-off.", "largest change over the first volume",
      {spilt.value()},
      Roundoff{cells_of_all, 1, "every cell's volume rounds its own differences of positions of the basin's size"});
  check.from("Frank (1994), chapter 1")
      .that("booked", "The sum of energy and booked loss of rezoning is conserved to round-off.",
            "largest change over the first value", {drift.value()},
            Roundoff{static_cast<double>(flow.steps() + flow.rezoned()), 100,
                     "positions of 20 m and sides of 0.2 m next to the shore: each step and each rezoning rounds their "
                     "differences anew"});
  check.from("Frank (1994), chapter 1")
      .that("taken", "The energy removed by rezoning is positive and at most 1 % of the first value.",
            "energy removed by rezoning over its first value", {flow.lost() / begin},
            Bound{0.005,
                  "0 to 1 %: the energy removed is quadratic in the differences between neighbouring nodes, next to "
                  "the shore alone",
                  0.005});

  Lattice lake = island.flow().model().lattice();
  for (std::size_t k = lake.shape.columns + 1; k < lake.shape.nodes(); ++k) lake.z[k] = 0;
  const Model still(lake, {.gravity = 9.81});
  const ShoreFollowing following(lake);
  const mechanics::State rest = still.state();
  const auto places = following.places(rest.q, still.first_volumes());
  check.that("lake", "The displacement of nodes by rezoning a lake at rest is zero to round-off.",
             "largest way of a node [m]",
             {worst(std::array{largest_difference(places.x, lake.x), largest_difference(places.y, lake.y)})},
             Roundoff{10, 20, "a cubic at its own node, positions of 20 m"});
  const Remapped same = remap(still, rest.q, rest.u, lake.x, lake.y);
  Worst risen;
  for (std::size_t k = 0; k < lake.shape.nodes(); ++k) {
    risen.add(same.lattice.z[k] - lake.z[k]);
    risen.add(same.velocity[k].u);
    risen.add(same.velocity[k].v);
    risen.add(same.velocity[k].w);
  }
  check.that("rest", "Elevation and velocity after a remap of a lake at rest are zero to round-off.",
             "largest elevation or velocity", {risen.value()},
             Roundoff{100, 20, "volumes of cells from positions of 20 m"});
}

}  // namespace seiche::verification::remap_2dh_test
