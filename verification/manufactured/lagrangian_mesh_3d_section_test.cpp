// A flow without y: the hexahedral mesh is the mesh in the vertical plane, over an uneven bottom too.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/polynomial_bottom.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::lagrangian_mesh_3d_section_test {

using mechanics::Stepping;

namespace section = lagrangian_mesh_2d;
namespace space = lagrangian_mesh_3d;

constexpr double length = 8;
constexpr std::size_t columns = 24, rows = 2, layers = 3;
constexpr double duration = 4;

double hump(double x) {
  return 0.1 * std::exp(-(x - 3) * (x - 3));
}

/// b = -1 + c1 x + c2 x^2, in space and in the plane.
struct Slope {
  double c1, c2;

  [[nodiscard]] std::shared_ptr<const PlanBottom> bottom() const {
    return polynomial_bottom({{-1, 0, 0}, {c1, 1, 0}, {c2, 2, 0}});
  }
  [[nodiscard]] std::shared_ptr<const GraphCurve> curve() const {
    return std::make_shared<GraphCurve>([*this](double x) { return -1 + c1 * x + c2 * x * x; },
                                        [*this](double x) { return c1 + 2 * c2 * x; },
                                        [*this](double) { return 2 * c2; }, 0, length, 80);
  }
};

/// Largest difference of a node's place between the two meshes at the end.
double difference(const Slope& slope, Stepping stepping, double tau) {
  section::Flow plane(
      section::layer_mesh(
          {.end = length, .columns = columns, .rows = layers, .elevation = hump, .bottom = slope.curve()}),
      section::VelocityAt{}, {.stepping = stepping});
  space::Flow water(space::layer_mesh({.end = length,
                                       .north = 1.3,
                                       .columns = columns,
                                       .rows = rows,
                                       .layers = layers,
                                       .elevation = [](double x, double) { return hump(x); },
                                       .bottom = slope.bottom()}),
                    {}, {.stepping = stepping}, {.tolerance = 1e-15});
  march(plane, duration, tau);
  march(water, duration, tau);
  const space::Mesh& mesh = water.model().mesh();
  Worst off;
  for (std::size_t k = 0; k < mesh.x.size(); ++k) {
    const std::size_t column = k % (columns + 1), layer = k / ((columns + 1) * (rows + 1));
    const std::size_t in_plane = plane.model().mesh().node(column, layer);
    off.add(water.x()[k] - plane.x()[in_plane]);
    off.add(water.z()[k] - plane.y()[in_plane]);
    off.add(water.y()[k] - mesh.y[k]);
  }
  return off.value();
}

TEST_CASE("hexahedra without transverse motion agree with the mesh in the plane, over slopes too", "[manufactured]") {
  Check check("lagrangian_mesh_3d_section", "Hexahedra beside the mesh in the plane, over a slope",
              "A hump over a bottom that rises along x, 24 x 3 cells in the plane, 24 x 2 x 3 in space, until t = 4. "
              "On a plane slope both slide the same way, to round-off. On a curved one the plane mesh has arc lengths "
              "as coordinates, the hexahedra one more constraint: two second-order schemes.",
              "Frank, Discrete models of incompressible fluid (1994), chapters 2 and 4.1");
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    const std::string id = stepping == Stepping::one_step ? "one-step" : "conservative";
    check.holds(
        "Over a plane slope every node is where the node of the mesh in the plane is, " + id + ".",
        {difference({.c1 = 0.08, .c2 = 0}, stepping, 0.1)},
        Roundoff{40 * 8, length, "positions up to 8 h, rounded with the seven other corners in each of 40 steps"});
  }
  refine(check, {"step", {0.2, 0.1, 0.05, 0.025}},
         {{"bent-order", "The difference over a bent slope falls at second order in the step.",
           Order{2, 0.3, "both schemes are symmetric and second-order accurate"}}},
         [](double tau) { return difference({.c1 = 0, .c2 = 0.01}, Stepping::one_step, tau); });
}

}  // namespace seiche::verification::lagrangian_mesh_3d_section_test
