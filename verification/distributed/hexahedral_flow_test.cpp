// The hexahedral model shared out among processes against the same model on one.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/layer.hpp"
#include "verification/check.hpp"
#include "verification/distributed/problems.hpp"

namespace {

using namespace seiche;
using namespace seiche::verification;
using namespace seiche::verification::distributed_flows;
using distributed::rank;
using distributed::ranks;
using evidence::Bound;

/// @param bottom  null for a level one
void compare_with_one(const std::string& id, const std::string& where, std::shared_ptr<const PlanBottom> bottom) {
  constexpr double tolerance = 1e-11;
  constexpr double step = 0.2;
  constexpr long steps = 30;
  const lagrangian_mesh_3d::Mesh mesh =
      lagrangian_mesh_3d::layer_mesh({.begin = 0,
                                      .end = 12,
                                      .south = 0,
                                      .north = 8,
                                      .columns = 24,
                                      .rows = 16,
                                      .layers = 2,
                                      .elevation = [](double x, double y) { return 0.2 * hump(x + 3, y) / 0.3; },
                                      .bottom = std::move(bottom)});
  distributed::HexahedralFlow flow(mesh.plan, mesh.layers,
                                   [&](const distributed::Patch& patch) { return distributed::part_of(mesh, patch); },
                                   mesh.sides, {}, {.tolerance = tolerance});
  const Outcome shared = outcome(flow, step, steps);
  if (rank() > 0) return;

  lagrangian_mesh_3d::Flow one(mesh, {}, {}, {.tolerance = 1e-13});
  for (long n = 0; n < steps; ++n) one.advance(step);
  Outcome reference{.energy = one.energy()};
  const std::size_t below = mesh.plan.nodes() * mesh.layers;
  for (const auto& values : {one.x(), one.y(), one.z(), one.u(), one.v(), one.w()}) {
    reference.numbers.insert(reference.numbers.end(), values.begin() + static_cast<std::ptrdiff_t>(below),
                             values.end());
  }
  Check check(
      fmt::format("distributed_hexahedral_{}_{}", id, ranks()),
      fmt::format("Hexahedral model{} shared out among {} process(es)", where, ranks()),
      "As the plan model: blocks of columns of cells, of all layers each, and a ring of neighbours' columns. A "
      "relative residual $\\varepsilon$ leaves at most the part $\\kappa\\varepsilon$ of the multipliers, which "
      "change velocities by less than the largest velocity $U$ in a step.");
  const std::string resolution =
      fmt::format("24 x 16 x 2 cells, {} steps of {}, relative residual {:.0e}", steps, step, tolerance);
  check.that({.id = "same",
              .text = "Shared out, the flow is that of one process: a hump of water off the middle of a box.",
              .quantity = "largest difference of a coordinate over the depth or a velocity over sqrt(g depth), at the "
                          "surface",
              .source = "Frank, Discrete models of incompressible fluid (1994), chapter 4"},
             {.value = largest_difference(shared, reference), .resolution = resolution},
             Bound{.limit = steps * shared.condition * tolerance * speed(reference),
                   .reason = fmt::format("N kappa eps U with kappa = {:.3g}, U = {:.3g}", shared.condition,
                                         speed(reference))});
  check.that({.id = "copies",
              .text = "What several processes hold of a node is the same, bit by bit.",
              .quantity = "largest difference between copies",
              .source = "decomposition of the lattice"},
             {.value = shared.rim_difference, .resolution = resolution},
             Bound{.limit = 0, .reason = "copies are copied"});
  check.measure("difference of energies", shared.energy - reference.energy);
  check.measure("iterations per solution", shared.iterations);
}

TEST_CASE("a flow of hexahedra shared out among processes is that of one process") {
  compare_with_one("flow", "", nullptr);
}

TEST_CASE("a flow of hexahedra over an uneven bottom shared out among processes is that of one process") {
  compare_with_one("slope", " over an uneven bottom",
                   std::make_shared<PolynomialBottom>(std::vector<PolynomialBottom::Term>{
                       {.coefficient = -1}, {.coefficient = 0.02, .x_power = 1}, {.coefficient = 1e-3, .y_power = 2}}));
}

}  // namespace
