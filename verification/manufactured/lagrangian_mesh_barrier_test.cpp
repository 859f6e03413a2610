#include <cmath>
#include <vector>

#include "seiche/lattice/water.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/lagrangian_mesh_2d/nodes.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/difference.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::lagrangian_mesh_barrier_test {

using namespace lagrangian_mesh_2d;

TEST_CASE("the barrier's force is the slope of its energy", "[manufactured]") {
  Check check("lagrangian_mesh_barrier", "Corner barrier: force and energy",
              "Nine cells, of which the middle node is moved until four corners are sharp: the force on every node "
              "against differences of the energy, fourth order in their width.",
              "the energy of corner_barrier.hpp");
  Mesh mesh = free_patch(3, 3, {0, 0}, {3, 3});
  const std::vector<double> areas(mesh.cells(), 1.0);
  const std::size_t n = mesh.nodes();
  std::vector<double> q = lattice::joined({mesh.x, mesh.y});
  const std::size_t moved = mesh.node(1, 1);
  q[moved] += 0.42;
  q[n + moved] += 0.47;
  const CornerBarrier barrier(2.5);
  std::vector<double> push(2 * n, 0.0);
  barrier.push(mesh, areas, q, 1, push);
  const auto difference = [&](double width) {
    Largest largest;
    for (std::size_t k = 0; k < n; ++k) {
      const auto slope = [&](std::size_t coordinate) {
        return verification::difference(
            [&](double shift) {
              std::vector<double> there = q;
              there[coordinate] += shift;
              return barrier.energy(mesh, areas, there);
            },
            2 * width);
      };
      largest.add(std::hypot(push[k] + slope(k), push[n + k] + slope(n + k)));
    }
    return largest.value();
  };
  refine(check, {.axis = "width of the differences", .sizes = {0.008, 0.004, 0.002, 0.001, 0.0005}, .floor = 1e-9},
         {{"force", "The forces agree with the gradient of the energy: the difference falls at fourth order.",
           Order{4, 0.3, "fourth-order differences of a smooth energy"}}},
         difference);
}

}  // namespace seiche::verification::lagrangian_mesh_barrier_test
