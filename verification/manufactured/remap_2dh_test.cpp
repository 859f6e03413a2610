// The remap of the 2DH model on smooth fields: its order.
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "seiche/samples.hpp"
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

/// Root mean squares of elevations and velocities over the nodes after a remap by up to 0.3 of a cell along both
/// directions.
std::array<double, 2> errors(std::size_t n) {
  const Model model(rectangular_lattice({.end = size, .north = size, .columns = n, .rows = n, .elevation = elevation}));
  const mechanics::State state = model.state(velocity);
  const double way = 0.3 * size / static_cast<double>(n);
  std::vector<double> x = model.lattice().x, y = model.lattice().y;
  for (std::size_t k = 0; k < model.nodes(); ++k) {
    const double from_x = x[k], from_y = y[k];
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
  Mean elevations, velocities;
  for (std::size_t k = 0; k < model.nodes(); ++k) {
    const Velocity exact = velocity(x[k], y[k]), found = now.velocity[k];
    elevations.add(now.lattice.z[k] - elevation(x[k], y[k]));
    velocities.add(std::hypot(found.u - exact.u, found.v - exact.v, found.w - exact.w));
  }
  return {elevations.rms(), velocities.rms()};
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
         [](double width) { return errors(cells_of(size, width)); });
}

}  // namespace seiche::verification::remap_2dh_test
