// The remap of the 2DH model on smooth fields: its order.
#include <cmath>
#include <numbers>
#include <vector>

#include "validation/instruments/plan/plan_remap.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::remap_2dh_test {

using namespace dispersive_shallow_water_2d;
using validation::remap, validation::Remapped;

constexpr double size = std::numbers::pi;

double elevation(double x, double y) {
  return 0.2 * std::cos(x) * std::cos(2 * y);
}
Velocity velocity(double x, double y) {
  return {.u = std::sin(x) * std::cos(y), .v = -std::cos(x) * std::sin(y), .w = std::cos(2 * x) * std::cos(y)};
}

struct Errors {
  double elevation, velocity;
};

/// Root mean squares over the nodes after a remap by up to 0.3 of a cell along both directions.
Errors errors(std::size_t n) {
  const Model model(rectangular_lattice({.end = size, .north = size, .columns = n, .rows = n, .elevation = elevation}));
  const mechanics::State state = model.state(velocity);
  const double way = 0.3 * size / static_cast<double>(n);
  std::vector<double> x = model.lattice().x;
  std::vector<double> y = model.lattice().y;
  for (std::size_t k = 0; k < model.nodes(); ++k) {
    const double from_x = x[k];
    const double from_y = y[k];
    x[k] += way * std::sin(from_x) * std::cos(from_y);
    y[k] += way * std::cos(from_x) * std::sin(from_y);
  }
  // The sides to round-off.
  for (std::size_t k = 0; k <= n; ++k) {
    const Shape shape = model.shape();
    y[shape.node(k, 0)] = x[shape.node(0, k)] = 0;
    y[shape.node(k, n)] = x[shape.node(n, k)] = size;
  }
  const Remapped now = remap(model, state.q, state.u, x, y);
  Errors sums{0, 0};
  for (std::size_t k = 0; k < model.nodes(); ++k) {
    const Velocity exact = velocity(x[k], y[k]);
    sums.elevation += std::pow(now.lattice.z[k] - elevation(x[k], y[k]), 2);
    sums.velocity += std::pow(now.velocity[k].u - exact.u, 2) + std::pow(now.velocity[k].v - exact.v, 2) +
                     std::pow(now.velocity[k].w - exact.w, 2);
  }
  const auto nodes = static_cast<double>(model.nodes());
  return {std::sqrt(sums.elevation / nodes), std::sqrt(sums.velocity / nodes)};
}

TEST_CASE("a remap of the 2DH model is third-order accurate", "[manufactured]") {
  Check check("remap_order_2dh", "Remap of the two-dimensional horizontal model: order",
              "A basin of sides $\\pi$ with smooth waves and velocities, whose n x n equal cells are exchanged for "
              "others: nodes move by up to 0.3 of a cell. Root mean squares of the errors at the new nodes.",
              "L. G. Margolin, M. Shashkov, J. Comput. Phys. 184 (2003) 266");
  const Order third{3, 0.3,
                    "cubics err by the fourth power; the bilinear cell's own error h^2, which conservation carries "
                    "along, by h^2 times the change of the cell's size, h"};
  refine(check, {"width of a cell", widths(size, {12, 16, 24, 32, 48, 64})},
         {{"elevation", "Elevations are carried to third order.", third},
          {"velocity", "Velocities are carried to third order.", third}},
         [](double width) {
           const Errors found = errors(cells_of(size, width));
           return std::array{found.elevation, found.velocity};
         });
}

}  // namespace seiche::verification::remap_2dh_test
