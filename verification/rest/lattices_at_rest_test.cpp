// Still water in lattices stays still: bit by bit at the still-water level, in 2DH to round-off if it is raised.
#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/dispersive_2dh_problems.hpp"
#include "verification/conservation/lagrangian_mesh_3d_problems.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"

namespace seiche::verification::lattices_at_rest_test {

using namespace mechanics;

namespace vertical {
using namespace lagrangian_mesh_2d;

/// Moves every node that may move at random: interior nodes anywhere, others along their wall or the still surface.
Mesh jittered(Mesh mesh, double part, unsigned seed) {
  std::minstd_rand random(seed);
  std::uniform_real_distribution<double> uniform(-part, part);
  const double width = (mesh.x[mesh.columns] - mesh.x[0]) / static_cast<double>(mesh.columns);
  const double height = 0.5 / static_cast<double>(mesh.rows);
  const auto slid = [&](const Side& side, std::size_t k, double by) {
    const auto& curve = *std::get<Wall>(side).curve;
    const Point r = curve.position(curve.arc_length_at({mesh.x[k], mesh.y[k]}) + by);
    mesh.x[k] = r.x;
    mesh.y[k] = r.y;
  };
  for (std::size_t j = 0; j <= mesh.rows; ++j) {
    for (std::size_t i = 0; i <= mesh.columns; ++i) {
      const std::size_t k = mesh.node(i, j);
      const bool side = i == 0 || i == mesh.columns, top = j == mesh.rows;
      if (side && (top || j == 0)) continue;
      if (side) {
        slid(i == 0 ? mesh.sides.left : mesh.sides.right, k, height * uniform(random));
      } else if (j == 0) {
        slid(mesh.sides.bottom, k, width * uniform(random));
      } else {
        mesh.x[k] += width * uniform(random);
        if (!top) mesh.y[k] += height * uniform(random);
      }
    }
  }
  return mesh;
}
}  // namespace vertical

namespace plan {
using namespace dispersive_shallow_water_2d;

struct Lake {
  std::string text;
  Lattice lattice;
  Settings settings = {};
  bool balances = true;  ///< to round-off where the water is raised
};

/// 20 x 20 cells over 10 x 10, nodes moved to where `place` puts them.
Lattice box(std::shared_ptr<const PlanBottom> bottom = {}, Sides sides = {},
            const std::function<Point(double x, double y)>& place = {}) {
  Lattice lattice = rectangular_lattice(
      {.end = 10, .north = 10, .columns = 20, .rows = 20, .sides = std::move(sides), .bottom = std::move(bottom)});
  for (std::size_t k = 0; place && k < lattice.x.size(); ++k) {
    const Point there = place(lattice.x[k], lattice.y[k]);
    lattice.x[k] = there.x;
    lattice.y[k] = there.y;
  }
  return lattice;
}

std::vector<Lake> lakes() {
  // A channel between slanted walls that narrows and has a bend, after Melville's (1980) wedge.
  const auto wedge = [](double x, double y) {
    const double south = x < 5 ? 0 : 0.4 * (x - 5);
    return Point{x, south + (10 - 0.1 * x - south) * y / 10};
  };
  const auto sheared = [](double x, double y) { return Point{x + 0.3 * y, y + 0.2 * x}; };
  const auto bump = std::make_shared<BumpBottom>();
  const plan_lattice::DrivenSide still{[](Place, double) { return Point{}; }};
  // Over bottoms that are no polynomials nodes that slide along walls feel what Gauss's rule on edges lacks there.
  return {{"a level bottom", box()},
          {"a polynomial bottom", box(quartic_bottom())},
          {"a bump that is no polynomial", box(bump), {}, false},
          {"slanted walls with a bend", box({}, {}, wedge)},
          {"slanted walls over a bump", box(bump, {}, wedge), {}, false},
          {"walls without right angles", box({}, {}, sheared)},
          {"a held and a driven side", box({}, {.west = plan_lattice::HeldSide{}, .north = still}), {}, false},
          {"improved dispersion and a layer that absorbs, over a polynomial bottom",
           box(quartic_bottom()),
           {.inertia = 0.4, .gamma = 1.0 / 15, .drag = {.absorption = [](Point at) { return at.x; }}}}};
}
}  // namespace plan

TEST_CASE("lakes at rest on random meshes stay at rest bitwise", "[rest]") {
  Check check("lattices_at_rest", "Still water on random meshes",
              "Meshes whose nodes are moved at random, in the vertical plane (12 x 5 cells by up to 10 %, nodes at "
              "walls and at the surface along them, two meshes each, 10000 steps of 0.02), in 2DH (20 x 20 cells by up "
              "to 15 %, 200 steps of 0.1) and of hexahedra (12 x 8 x 3 cells by up to 10 %, 1000 steps of 0.1), over "
              "any bottom and between any walls. Potential energies count from the still-water level, where their "
              "gradients vanish: no force, no pressure, no motion.");
  const auto rests = [&](const std::string& lake, auto& problem, double tau, int steps) {
    for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
      SchemeStepper stepper(problem.model, {.stepping = stepping});
      State state = problem.start;
      for (int n = 0; n < steps; ++n) stepper.step(state, tau);
      check.holds(lake + ": displacements and velocities are zero.", {largest_difference(state, problem.start)},
                  Bound{0, "every force is exactly zero"});
    }
  };
  {
    using namespace vertical;
    const Layer layer{.begin = 0, .end = 6, .columns = 12, .rows = 5};
    for (const auto& [lake, mesh] :
         {std::pair{"Mesh, vertical walls, level bottom", layer_mesh(layer)},
          std::pair{"Mesh, a wall of slope 1", layer_mesh_with_slope(layer, 1)},
          std::pair{"Mesh, a bump", layer_mesh({.end = 6, .columns = 12, .rows = 5, .bottom = bump()})}}) {
      for (const unsigned seed : {1U, 2U}) {
        MeshProblem problem(vertical::jittered(mesh, 0.1, seed));
        std::vector<double> rates(problem.model.rates());
        IndexReduced(problem.model).acceleration(0, problem.start.q, problem.start.u, rates);
        check.holds(std::string(lake) + ": no acceleration.", {worst(rates)}, Bound{1e-15, "the rounding of gravity"});
        rests(lake, problem, 0.02, 10000);
      }
    }
  }
  for (const plan::Lake& lake : plan::lakes()) {
    PlanProblem problem(jittered(lake.lattice, 0.075, 3), {}, lake.settings);
    rests("In 2DH, " + lake.text, problem, 0.1, 200);
  }
  using namespace lagrangian_mesh_3d;
  const plan_lattice::DrivenSide still{[](Place, double) { return Point{}; }};
  const auto bend = [](double x) { return x < 3 ? 0.0 : (x - 3) * 0.5; };
  Layer box{.begin = 0, .end = 6, .north = 4, .columns = 12, .rows = 8, .layers = 3};
  Layer wedge = box, shoal = box, wedge_over_shoal = box, window = box;
  wedge.south_wall = wedge_over_shoal.south_wall = bend;
  shoal.bottom = wedge_over_shoal.bottom = uneven_bottom();
  window.sides = {.west = plan_lattice::HeldSide{}, .north = still};
  for (const auto& [lake, layer] : {std::pair{"vertical walls along the axes", box},
                                    {"an uneven bottom", shoal},
                                    {"an uneven bottom and a wall with a bend", wedge_over_shoal},
                                    {"a wall with a bend", wedge},
                                    {"a held and a driven side", window}}) {
    HexahedralProblem problem(jittered(layer_mesh(layer), 0.03, 3));
    rests(std::string("Hexahedra, ") + lake, problem, 0.1, 1000);
  }
}

TEST_CASE("raised water at rest in 2DH stays at rest to round-off", "[rest]") {
  Check check("dispersive_2dh_raised_rest", "Raised water at rest in 2DH",
              "The same lakes with the surface 0.2 above the level from which elevations count: gravity and pressure "
              "balance by the identity $d\\Pi - gz\\,dV = -\\tfrac12 g z^2\\,dA$, for straight walls and the exact "
              "volume over the bottom. For polynomial bottoms of degree four Gauss's rule on the edges is exact; "
              "others are left out.");
  for (const plan::Lake& lake : plan::lakes()) {
    if (!lake.balances) continue;
    plan::Lattice lattice = jittered(lake.lattice, 0.075, 3);
    std::ranges::fill(lattice.z, 0.2);
    plan::Settings settings = lake.settings;
    settings.solver = linear::SolverMethod::banded;
    PlanProblem problem(std::move(lattice), {}, settings);
    SchemeStepper stepper(problem.model, {});
    State state = problem.start;
    Largest fastest;
    for (int n = 0; n < 200; ++n) {
      stepper.step(state, 0.1);
      fastest.add(worst(state.u));
    }
    check.holds("Water at rest stays at rest (" + lake.text + ").", {fastest.value()},
                Bound{1e-11,
                      "roundings of forces, 1e-17 per node and step, that oscillate with the mesh's own frequencies "
                      "and are amplified by its near null modes"});
  }
}

}  // namespace seiche::verification::lattices_at_rest_test
