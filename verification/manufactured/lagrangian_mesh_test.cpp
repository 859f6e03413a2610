// The two-dimensional Lagrangian mesh against a manufactured motion of a free square: orders for both schemes, on a
// straight and on a distorted mesh.
#include <string>
#include <vector>

#include "validation/instruments/mesh/mesh_double_shear.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::lagrangian_mesh_test {

using mechanics::Stepping;

const std::string source = "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4";

/// Multiples of eight: nodes lie on the borders of interior and judged edge.
const std::vector<int> meshes{16, 24, 32, 48, 64};

void check_orders(Check& check, const std::string& id, const std::string& scheme, Stepping stepping,
                  double distortion) {
  refine(
      check,
      {.axis = "width of a cell", .sizes = widths(2, meshes), .id = "convergence_" + id, .title = "Errors, " + scheme},
      {{id + "-interior",
        scheme + ": interior node positions converge at second order.",
        {2, 0.15, "second order; coarse meshes' interiors still feel the layer at the edges"}},
       {id + "-pressure",
        scheme + ": the pressure converges at second order.",
        {2, 0.1, "second order of smooth solutions"}},
       {id + "-shape",
        scheme + ": the surface shape converges at second order.",
        {2, 0.2, "second order, and first order at the corners, whose influence decays along the edge"}},
       {id + "-position",
        scheme + ": the rms error of all node positions converges at order 1.5.",
        {1.5, 0.1, "first-order errors in a layer of one cell"}},
       {id + "-slip",
        scheme + ": surface nodes slip along the surface to first order.",
        {1, 0.1, "slip of half a cell's pressure gradient; the next term is second-order accurate"}}},
      [&](double width) {
        const auto e = validation::double_shear_errors(
            {.n = cells_of(2, width), .scheme = {.stepping = stepping}, .distortion = distortion});
        return std::array{e.interior, e.rms_lambda, e.shape, e.rms_position, e.slip};
      });
}

TEST_CASE("the Lagrangian mesh is second-order accurate in the interior, in pressure and in the surface's shape",
          "[manufactured]") {
  Check check(
      "lagrangian_mesh_manufactured", "Two-dimensional Lagrangian mesh: manufactured motion of a free square",
      "Two shears, one after the other, move the square $|X|, |Y| \\le 1$ by a body force, with a free surface all "
      "around; $t = 1$, steps of a fifth of a cell. A surface node feels the pressure gradient half a cell below the "
      "surface and slips along it to first order; in a layer of one cell that makes order 1.5 in the root mean square. "
      "Everything else is second-order accurate. The distorted mesh is displaced within the square by up to 0.12.",
      source);
  check_orders(check, "one-step", "one-step scheme", Stepping::one_step, 0);
  check_orders(check, "conservative", "conservative scheme", Stepping::conservative, 0);
  check_orders(check, "one-step-distorted", "one-step scheme, distorted mesh", Stepping::one_step, 0.12);
  check_orders(check, "conservative-distorted", "conservative scheme, distorted mesh", Stepping::conservative, 0.12);
}

}  // namespace seiche::verification::lagrangian_mesh_test
