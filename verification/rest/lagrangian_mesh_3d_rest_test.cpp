// Still water stays still, bit by bit, on any hexahedral mesh between straight walls.
#include <string>
#include <vector>

#include "seiche/mechanics/scheme.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_3d_problems.hpp"

namespace seiche::verification::lagrangian_mesh_3d_rest_test {

using namespace lagrangian_mesh_3d;
using namespace mechanics;

struct Lake {
  std::string id, text;
  Mesh mesh;
};

std::vector<Lake> lakes() {
  Layer layer{.begin = 0, .end = 6, .south = 0, .north = 4, .columns = 12, .rows = 8, .layers = 3};
  Layer wedge = layer;
  wedge.south_wall = [](double x) { return x < 3 ? 0.0 : (x - 3) * 0.5; };
  Layer window = layer;
  window.sides.west = plan_lattice::HeldSide{};
  window.sides.north = plan_lattice::DrivenSide{[](Place, double) { return Point{}; }};
  Layer shoal = layer;
  shoal.bottom = uneven_bottom();
  Layer wedge_over_shoal = wedge;
  wedge_over_shoal.bottom = uneven_bottom();
  return {{"box", "vertical walls along the axes", layer_mesh(layer)},
          {"shoal", "an uneven bottom", layer_mesh(shoal)},
          {"wedge-shoal", "an uneven bottom and a wall with a bend", layer_mesh(wedge_over_shoal)},
          {"wedge", "a wall with a bend", layer_mesh(wedge)},
          {"window", "a held and a driven side", layer_mesh(window)}};
}

TEST_CASE("a lake at rest on a random hexahedral mesh stays at rest bit by bit", "[rest]") {
  Check check("lagrangian_mesh_3d_rest", "Still water on random hexahedral meshes",
              "12 x 8 x 3 cells, inner nodes moved at random by up to a tenth of a cell. The potential energy counts "
              "from the still-water level, where its gradient vanishes: no force, no pressure, no motion, whatever the "
              "mesh. 1000 steps of 0.1.");
  for (const Lake& lake : lakes()) {
    for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
      HexahedralProblem problem(jittered(lake.mesh, 0.03, 3));
      SchemeStepper<Model> stepper(problem.model, {.stepping = stepping});
      State state = problem.start;
      for (int n = 0; n < 1000; ++n) stepper.step(state, 0.1);
      check.holds(lake.text + ").", {largest_difference(state, problem.start)},
                  Bound{0, "every force is exactly zero"});
    }
  }
}

}  // namespace seiche::verification::lagrangian_mesh_3d_rest_test
