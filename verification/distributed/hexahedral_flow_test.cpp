// The hexahedral model shared out among processes against the same model on one.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "verification/check.hpp"
#include "verification/distributed/problems.hpp"
#include "verification/polynomial_bottom.hpp"

namespace seiche::verification::hexahedral_flow_test {

using namespace distributed_flows;
using distributed::rank;
using distributed::ranks;

/// @param bottom  null for a level one
lagrangian_mesh_3d::Mesh box_of_hexahedra(std::shared_ptr<const PlanBottom> bottom) {
  return lagrangian_mesh_3d::layer_mesh({.end = 12,
                                         .north = 8,
                                         .columns = 24,
                                         .rows = 16,
                                         .layers = 2,
                                         .elevation = [](double x, double y) { return 0.2 * hump(x + 3, y) / 0.3; },
                                         .bottom = std::move(bottom)});
}

/// @param where  and what, in words
void compare_with_one(const std::string& id, const std::string& where, const std::string& what,
                      const lagrangian_mesh_3d::Mesh& mesh, const lagrangian_mesh_3d::VelocityAt& velocity = {},
                      const plan_lattice::Window& window = {},
                      mechanics::Stepping stepping = mechanics::Stepping::one_step) {
  constexpr double tolerance = 1e-11;
  constexpr double step = 0.2;
  constexpr long steps = 30;
  distributed::HexahedralFlow flow(
      mesh.plan, mesh.layers, [&](const distributed::Patch& patch) { return distributed::part_of(mesh, patch); },
      mesh.sides, velocity, {.tolerance = tolerance}, true, stepping, window);
  const Outcome shared = outcome(flow, step, steps);
  if (rank() > 0) return;

  lagrangian_mesh_3d::Flow one(mesh, velocity, {.stepping = stepping}, {.tolerance = 1e-13}, window);
  for (long n = 0; n < steps; ++n) one.advance(step);
  Outcome reference{.shifts = one.shifts(), .energy = one.energy()};
  const std::size_t below = mesh.plan.nodes() * mesh.layers;
  for (const auto& values : {one.x(), one.y(), one.z(), one.u(), one.v(), one.w()}) {
    reference.numbers.insert(reference.numbers.end(), values.begin() + static_cast<std::ptrdiff_t>(below),
                             values.end());
  }
  Check check(fmt::format("distributed_hexahedral_{}_{}", id, ranks()),
              fmt::format("Hexahedral model{} shared out among {} process(es)", where, ranks()),
              "As the 2DH model: blocks of columns of cells, of all layers each, and a ring of neighbours' columns. A "
              "relative residual $\\varepsilon$ leaves at most the part $\\kappa\\varepsilon$ of the multipliers, "
              "which change velocities by less than the largest velocity $U$ in a step.",
              "decomposition of the mesh");
  const std::string resolution = fmt::format("{} x {} x {} cells, {} steps of {}, relative residual {:.0e}",
                                             mesh.plan.columns, mesh.plan.rows, mesh.layers, steps, step, tolerance);
  check.from("Frank, Discrete models of incompressible fluid (1994), chapter 4")
      .that("same", fmt::format("The flow shared out among processes equals the flow of one process: {}.", what),
            "largest difference of a coordinate over the depth or a velocity over sqrt(g depth), at the surface",
            {.value = largest_difference(shared, reference), .resolution = resolution},
            Bound{steps * shared.condition * tolerance * speed(reference),
                  fmt::format("N kappa eps U with kappa = {:.3g}, U = {:.3g}", shared.condition, speed(reference))});
  check.that("copies", "The difference between the copies that several processes hold of a node is zero.",
             "largest difference between copies", {.value = shared.rim_difference, .resolution = resolution},
             Bound{0, "copies are copied"});
  if (window.reach) {
    check.that("shifts", "The number of columns left behind by the moving window equals the number in one process.",
               "columns left behind, minus those on one process",
               {.value = static_cast<double>(shared.shifts - reference.shifts),
                .resolution = fmt::format("{} columns left behind", shared.shifts)},
               Bound{0, "the water at the window's front is at rest"});
  }
}

const std::string hump_in_box = "a hump of water off the middle of a box";

TEST_CASE("a flow of hexahedra distributed over processes agrees with one process") {
  compare_with_one("flow", "", hump_in_box, box_of_hexahedra(nullptr));
}

std::shared_ptr<const PlanBottom> slope() {
  return polynomial_bottom(
      {{.coefficient = -1}, {.coefficient = 0.02, .x_power = 1}, {.coefficient = 1e-3, .y_power = 2}});
}

TEST_CASE("a flow of hexahedra over an uneven bottom, distributed over processes, agrees with one process") {
  compare_with_one("slope", " over an uneven bottom", hump_in_box, box_of_hexahedra(slope()));
}

TEST_CASE(
    "a conservative flow of hexahedra over an uneven bottom, distributed over processes, agrees with one process") {
  compare_with_one("conservative", " over an uneven bottom, conservative scheme,", hump_in_box,
                   box_of_hexahedra(slope()), {}, {}, mechanics::Stepping::conservative);
}

TEST_CASE("a flow of hexahedra in a moving window, distributed over processes, agrees with one process") {
  const Problem in_plan = window();
  const plan::Lattice& lattice = in_plan.lattice;
  const auto surface = [&lattice](std::size_t i, std::size_t j) { return lattice.z[lattice.shape.node(i, j)]; };
  lagrangian_mesh_3d::Mesh mesh = lagrangian_mesh_3d::layer_mesh(
      {.begin = -12, .end = 21, .north = 12, .columns = 44, .rows = 16, .layers = 1, .sides = lattice.sides});
  for (std::size_t j = 0; j <= 16; ++j) {
    for (std::size_t i = 0; i <= 44; ++i) mesh.z[mesh.node(i, j, 1)] = surface(i, j);
  }
  const auto velocity = [&in_plan](plan_lattice::Place at) {
    const plan::Velocity top = in_plan.velocity(at.x, at.y);
    return lagrangian_mesh_3d::Vector{top.u, top.v, at.z > -0.5 ? top.w : 0};
  };
  compare_with_one("window", " in a moving window", in_plan.what, mesh, velocity, in_plan.window);
}

}  // namespace seiche::verification::hexahedral_flow_test
