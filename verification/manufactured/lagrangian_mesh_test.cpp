// The two-dimensional Lagrangian mesh against a manufactured motion of a free square: orders for both schemes, on a
// straight and on a distorted mesh.
#include <string>
#include <vector>

#include <fmt/format.h>

#include "reports/evidence/slope_guide.hpp"
#include "validation/instruments/mesh/mesh_double_shear.hpp"
#include "verification/check.hpp"

namespace lagrangian_mesh_test {

using namespace seiche::verification;
using seiche::mechanics::Stepping;
using seiche::validation::double_shear_errors;
using seiche::validation::DoubleShearErrors;

const std::string source = "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4";

struct Variant {
  std::string id, text;
  Stepping stepping;
  double distortion;
};

/// Multiples of eight: nodes lie on the borders of interior and judged edge.
const std::vector<std::size_t> meshes{16, 24, 32, 48, 64};

struct Quantity {
  std::string id, text;
  double DoubleShearErrors::*error;
  Order order;
};

const std::vector<Quantity> quantities = {
    {"interior",
     "places in the interior are of second order",
     &DoubleShearErrors::interior,
     {2, 0.15, "second order; coarse meshes' interiors still feel the layer at the edges"}},
    {"pressure",
     "the pressure is of second order",
     &DoubleShearErrors::rms_lambda,
     {2, 0.1, "second order of smooth solutions"}},
    {"shape",
     "the surface's shape is of second order",
     &DoubleShearErrors::shape,
     {2, 0.2, "second order, and first order at the corners, whose influence decays along the edge"}},
    {"position",
     "places of all nodes are of order 1.5 in the root mean square",
     &DoubleShearErrors::rms_position,
     {1.5, 0.1, "errors of first order in a layer of one cell"}},
    {"slip",
     "surface nodes slip along the surface to first order",
     &DoubleShearErrors::slip,
     {1, 0.1, "slip of half a cell's pressure gradient; the next term is of second order"}},
};

void check_orders(Check& check, const Variant& variant) {
  std::vector<double> cells;
  std::vector<double> widths;
  std::vector<std::vector<double>> errors(quantities.size());
  for (const std::size_t n : meshes) {
    const DoubleShearErrors all =
        double_shear_errors({.n = n, .scheme = {.stepping = variant.stepping}, .distortion = variant.distortion});
    cells.push_back(static_cast<double>(n));
    widths.push_back(2 / cells.back());
    for (std::size_t k = 0; k < quantities.size(); ++k) errors[k].push_back(all.*quantities[k].error);
  }
  auto& panel = check
                    .figure("convergence_" + variant.id, "Errors under refinement, " + variant.text,
                            "Against the number of cells across; grey lines have slopes 1 and 2.")
                    .panel({.x = "cells n", .y = "error", .log_x = true, .log_y = true});
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    const Quantity& quantity = quantities[k];
    panel.line(quantity.id, cells, errors[k]);
    check.that({.id = fmt::format("{}-{}", variant.id, quantity.id),
                .text = fmt::format("{}: {}.", variant.text, quantity.text),
                .quantity = "order of the error",
                .source = source},
               observed_order(widths, errors[k]), quantity.order);
  }
  seiche::validation::slope_guide(panel, -1, cells, 1.5 * errors[4].back());
  seiche::validation::slope_guide(panel, -2, cells, errors[0].back() / 1.5);
}

TEST_CASE("the Lagrangian mesh is of second order in the interior, in pressure and in the surface's shape",
          "[manufactured]") {
  Check check("lagrangian_mesh_manufactured", "Two-dimensional Lagrangian mesh: manufactured motion of a free square",
              "Two shears, one after the other, move the square $|X|, |Y| \\le 1$ by a body force, with a free surface "
              "all around; $t = 1$, steps of a fifth of a cell. A surface node feels the pressure gradient half a cell "
              "below the surface and slips along it to first order; in a layer of one cell that makes order 1.5 in the "
              "root mean square. Everything else is of second order. The distorted mesh is displaced within the square "
              "by up to 0.12.");
  check_orders(check, {"one-step", "one-step scheme", Stepping::one_step, 0});
  check_orders(check, {"conservative", "conservative scheme", Stepping::conservative, 0});
  check_orders(check, {"one-step-distorted", "one-step scheme, distorted mesh", Stepping::one_step, 0.12});
  check_orders(check, {"conservative-distorted", "conservative scheme, distorted mesh", Stepping::conservative, 0.12});
}

}  // namespace lagrangian_mesh_test
