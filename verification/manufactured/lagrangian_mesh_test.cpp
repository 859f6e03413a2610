// The two-dimensional Lagrangian mesh against a manufactured motion of a free square: orders for both schemes, on a
// straight and on a distorted mesh.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/double_shear.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::lagrangian_mesh_test {

using namespace lagrangian_mesh_2d;
using mechanics::Stepping;
using validation::DoubleShear;

/// Multiples of eight: nodes lie on the borders of interior and judged edge.
const std::vector<int> meshes{16, 24, 32, 48, 64};

/// Edges are judged on their middle three quarters: around the corners, where two edges' first-order errors meet, a few
/// cells are of first order in every respect.
constexpr double judged_edge = 0.75;

/// The square of side 2 in n x n cells, whose nodes within and along the sides are displaced smoothly.
Mesh label_mesh(std::size_t n, double distortion) {
  constexpr double pi = std::numbers::pi;
  Mesh mesh = free_patch(n, n, {-1, -1}, {1, 1});
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const double x = mesh.x[k], y = mesh.y[k];
    mesh.x[k] += distortion * std::sin(pi * x) * std::cos(pi * y);
    mesh.y[k] += distortion * std::cos(pi * x) * std::sin(pi * y);
  }
  return mesh;
}

/// Where a node is in the undistorted square.
Point lattice_place(const Mesh& mesh, std::size_t node) {
  const auto between = [](std::size_t index, std::size_t count) {
    return (2.0 * static_cast<double>(index) - static_cast<double>(count)) / static_cast<double>(count);
  };
  return {between(node % (mesh.columns + 1), mesh.columns), between(node / (mesh.columns + 1), mesh.rows)};
}

/// Label of a cell's middle: mean of its corners.
Point middle(const Mesh& mesh, std::size_t cell) {
  Point mean;
  for (const std::size_t node : mesh.corners(cell)) mean += 0.25 * Point{mesh.x[node], mesh.y[node]};
  return mean;
}

/// The top edge is the curve y = 1 + e2 sin t cos lx.
struct TopEdge {
  double height, slope;

  TopEdge(const DoubleShear::Parameters& motion, double t, double x)
      : height(1 + motion.second_amplitude * std::sin(t) * std::cos(motion.second_wavenumber * x)),
        slope(-motion.second_amplitude * motion.second_wavenumber * std::sin(t) *
              std::sin(motion.second_wavenumber * x)) {}
};

/// At t = 1: nodes of the interior, the middle half of the square each way (largest component), multipliers, shape of
/// the top edge, all nodes (root mean square over the mass), and slip, the largest displacement along the top edge.
std::array<double, 5> errors_of(std::size_t n, const Scheme& scheme, double distortion) {
  const DoubleShear motion;
  const auto velocity = [&](Point label) {
    const DoubleShear::Sample s = motion.at(label.x, label.y, 0);
    return Point{s.u, s.v};
  };
  const auto force = [&](Point label, double time) {
    const DoubleShear::Sample s = motion.at(label.x, label.y, time);
    return Point{s.force_x, s.force_y};
  };
  Flow flow(label_mesh(n, distortion), velocity, scheme, {.gravity = 0}, {.body_force = force});
  march(flow, 1, 0.4 / static_cast<double>(n));
  const Mesh& mesh = flow.model().mesh();
  Mean position, shape, lambda;
  Worst interior, slip;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const DoubleShear::Sample s = motion.at(mesh.x[k], mesh.y[k], flow.time());
    const double dx = flow.x()[k] - s.x, dy = flow.y()[k] - s.y;
    position.add(std::hypot(dx, dy), flow.model().nodes().mass()[k]);
    const Point place = lattice_place(mesh, k);
    if (std::abs(place.x) <= 0.5 && std::abs(place.y) <= 0.5) interior.add(worst(std::array{dx, dy}));
    if (k < mesh.node(0, mesh.rows) || std::abs(place.x) > judged_edge) continue;
    const TopEdge edge(motion.parameters(), flow.time(), flow.x()[k]);
    shape.add((flow.y()[k] - edge.height) / std::hypot(1, edge.slope));
    const double slope = TopEdge(motion.parameters(), flow.time(), s.x).slope;
    slip.add((dx + slope * dy) / std::hypot(1, slope));
  }
  const std::vector<double> pressure = flow.dynamic_pressure();  // mean of the last two steps
  const double tau = flow.time() / static_cast<double>(flow.steps());
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const Point label = middle(mesh, cell);
    lambda.add(pressure[cell] - motion.at(label.x, label.y, flow.time() - tau).pressure,
               flow.model().first_volumes()[cell]);
  }
  return {interior.value(), lambda.rms(), shape.rms(), position.rms(), slip.value()};
}

void check_orders(Check& check, const std::string& id, const std::string& scheme, Stepping stepping,
                  double distortion) {
  refine(
      check,
      {.axis = "width of a cell", .sizes = widths(2, meshes), .id = "convergence_" + id, .title = "Errors, " + scheme},
      {{id + "-interior", scheme + ": interior node positions converge at second order.",
        Order{2, 0.15, "second order; coarse meshes' interiors still feel the layer at the edges"}},
       {id + "-pressure", scheme + ": the pressure converges at second order.",
        Order{2, 0.1, "second order of smooth solutions"}},
       {id + "-shape", scheme + ": the surface shape converges at second order.",
        Order{2, 0.2, "second order, and first order at the corners, whose influence decays along the edge"}},
       {id + "-position", scheme + ": the rms error of all node positions converges at order 1.5.",
        Order{1.5, 0.1, "first-order errors in a layer of one cell"}},
       {id + "-slip", scheme + ": surface nodes slip along the surface to first order.",
        Order{1, 0.1, "slip of half a cell's pressure gradient; the next term is second-order accurate"}}},
      [&](double width) { return errors_of(cells_of(2, width), {.stepping = stepping}, distortion); });
}

TEST_CASE("the Lagrangian mesh is second-order accurate in the interior, in pressure and in the surface's shape",
          "[manufactured]") {
  Check check(
      "lagrangian_mesh_manufactured", "Two-dimensional Lagrangian mesh: manufactured motion of a free square",
      "Two shears, one after the other, move the square $|X|, |Y| \\le 1$ by a body force, with a free surface all "
      "around; $t = 1$, steps of a fifth of a cell. A surface node feels the pressure gradient half a cell below the "
      "surface and slips along it to first order; in a layer of one cell that makes order 1.5 in the root mean square. "
      "Everything else is second-order accurate. The distorted mesh is displaced within the square by up to 0.12.",
      "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4");
  check_orders(check, "one-step", "one-step scheme", Stepping::one_step, 0);
  check_orders(check, "conservative", "conservative scheme", Stepping::conservative, 0);
  check_orders(check, "one-step-distorted", "one-step scheme, distorted mesh", Stepping::one_step, 0.12);
  check_orders(check, "conservative-distorted", "conservative scheme, distorted mesh", Stepping::conservative, 0.12);
}

}  // namespace seiche::verification::lagrangian_mesh_test
