// The remap of the two-dimensional Lagrangian mesh on a smooth flow: its order.
#include <cmath>
#include <numbers>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/lagrangian_mesh_2d/rezone.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::mesh_remap_test {

using namespace lagrangian_mesh_2d;

constexpr double size = std::numbers::pi;

Point velocity(Point r) {
  return {std::sin(r.x) * std::cos(r.y), -std::cos(r.x) * std::sin(2 * r.y)};
}

/// Root mean square over the nodes after a remap by up to 0.3 of a cell along both directions.
double error(std::size_t n) {
  const Model model(free_patch(n, n, {0, 0}, {size, size}));
  const Mesh& mesh = model.mesh();
  const mechanics::State state = model.state(velocity);
  const double way = 0.3 * size / static_cast<double>(n);
  std::vector<double> x = mesh.x, y = mesh.y;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    if (k % (n + 1) % n > 0) x[k] += way * std::sin(mesh.x[k]) * std::cos(mesh.y[k]);
    if (k / (n + 1) % n > 0) y[k] += way * std::cos(mesh.x[k]) * std::sin(mesh.y[k]);
  }
  const Remapped now = remap(model, state.q, state.u, x, y);
  Mean off;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) off.add(distance(now.velocity[k], velocity({x[k], y[k]})));
  return off.rms();
}

TEST_CASE("a remap of the mesh in the vertical plane is third-order accurate", "[manufactured]") {
  Check check("mesh_remap_order", "Remap of the two-dimensional mesh: order",
              "A patch of sides $\\pi$ with smooth velocities, whose n x n equal cells are exchanged for others: nodes "
              "move by up to 0.3 of a cell. Root mean square of the errors at the new nodes.",
              "L. G. Margolin, M. Shashkov, J. Comput. Phys. 184 (2003) 266");
  refine(
      check, {"width of a cell", widths(size, {12, 16, 24, 32, 48, 64})},
      {{"velocity", "Velocities are carried to third order.",
        Order{3, 0.3,
              "cubics err by the fourth power; the bilinear cell's own error h^2, which conservation carries along, by "
              "h^2 times the change of the cell's size, h"}}},
      [](double width) { return error(cells_of(size, width)); });
}

}  // namespace seiche::verification::mesh_remap_test
