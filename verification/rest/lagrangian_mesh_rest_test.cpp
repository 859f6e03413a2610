// Still water stays still, bit by bit, on any mesh between any walls.
#include <random>
#include <string>
#include <vector>

#include "seiche/mechanics/start.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/reference_integrators.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"

namespace seiche::verification::lagrangian_mesh_rest_test {

using namespace lagrangian_mesh_2d;
using namespace mechanics;

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
      const bool side = i == 0 || i == mesh.columns;
      const bool top = j == mesh.rows;
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

struct Lake {
  std::string id, text;
  Mesh mesh;
};

std::vector<Lake> lakes() {
  const Layer layer{.begin = 0, .end = 6, .columns = 12, .rows = 5};
  return {{"box", "vertical walls, level bottom", layer_mesh(layer)},
          {"inclined", "a wall of slope 1", layer_mesh_with_slope(layer, 1)},
          {"bump", "a bump on the bottom", layer_mesh_over(bump(), 0, 6, 12, 5)}};
}

TEST_CASE("a lake at rest on a random mesh stays at rest bit by bit", "[rest]") {
  Check check("lagrangian_mesh_rest", "Still water on random meshes",
              "12 x 5 cells, nodes moved at random by up to 10 % of a cell: interior ones anywhere, those at walls "
              "along them, those at the surface along it. The potential energy of the polygon of water is counted from "
              "the still-water level, where its gradient vanishes: no force, no pressure, no motion, whatever the "
              "mesh. Two meshes each; 10000 steps of 0.02.");
  for (const Lake& lake : lakes()) {
    for (const Integrator integrator : {Integrator::one_step, Integrator::conservative}) {
      Largest moved;
      Worst acceleration;
      for (unsigned seed = 1; seed <= 2; ++seed) {
        MeshProblem problem(jittered(lake.mesh, 0.1, seed));
        std::vector<double> rates(problem.model.rates());
        IndexReduced(problem.model).acceleration(0, problem.start.q, problem.start.u, rates);
        acceleration.add(worst(rates));
        State state = problem.start;
        const StepFunction step = make_integrator(integrator, problem.model);
        for (int n = 0; n < 10000; ++n) step(state, 0.02);
        moved.add(largest_difference(state, problem.start));
      }
      const std::string id = lake.id + "-" + std::string(name(integrator));
      check.holds(id + ": " + std::string(title(integrator)) + ", " + lake.text + ").", {moved.value()},
                  Bound{0, "every force is exactly zero"});
      if (integrator != Integrator::one_step) continue;
      check.holds(lake.text + ": no acceleration.", {acceleration.value()}, Bound{1e-15, "the rounding of gravity"});
    }
  }
}

}  // namespace seiche::verification::lagrangian_mesh_rest_test
