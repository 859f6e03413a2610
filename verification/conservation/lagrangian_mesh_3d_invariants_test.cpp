// Free bodies of fluid on the hexahedral mesh: momenta, and energy without gravity, to round-off.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_3d_problems.hpp"

namespace seiche::verification::lagrangian_mesh_3d_invariants_test {

using namespace lagrangian_mesh_3d;
using namespace mechanics;

constexpr double tau = 0.01;
constexpr int steps = 100;

InvariantsLedger run(HexahedralProblem& problem, Scheme scheme) {
  return watched_run(problem, scheme, tau, steps);
}

/// Rounding of the momenta of all nodes. The forces of the cells change them by small parts, whose own rounding does
/// not count.
Roundoff rounding(const HexahedralProblem& problem, double largest_arm) {
  double squares = 0;
  const std::size_t n = problem.model.nodes().size();
  for (std::size_t i = 0; i < 3 * n; ++i) {
    squares += std::pow(problem.model.nodes().mass()[i % n] * problem.start.u[i], 2);
  }
  return {.operations = 2.0 * steps,
          .scale = std::sqrt(squares) * largest_arm,
          .reason =
              "each velocity is rounded twice in each of 100 steps, at their middle and at their end; the roundings of "
              "all nodes' momenta (times their largest distance from the axis) add up as squares"};
}

TEST_CASE("a free body of fluid in space keeps momenta and energy to round-off", "[conservation]") {
  Check check("lagrangian_mesh_3d_free_body", "Free body of fluid in space: invariants",
              "6 x 5 x 4 cells of constant volume, off a cube at random, without gravity and without walls, 100 steps "
              "of 0.01. Linear and angular momentum are kept for any multipliers: the solver's tolerance is 1e-6 in "
              "one run and 1e-13 in the other. Kinetic energy changes by the multipliers times what the solver leaves "
              "of the rates of volumes: it is judged with the tight tolerance.");
  for (const double tolerance : {1e-6, 1e-13}) {
    HexahedralProblem problem = moving_body({.tolerance = tolerance});
    const InvariantsLedger ledger = run(problem, {});
    const std::string id = tolerance == 1e-6 ? "loose-" : "tight-";
    const std::string text = "Solver tolerance " + std::string(tolerance == 1e-6 ? "1e-6" : "1e-13");
    const auto keeps = [&](const std::string& what, double value, const Roundoff& criterion) {
      check.holds(id + what + ": " + text + ": " + what + " to round-off.", {value}, criterion);
    };
    keeps("momentum", ledger.largest_defect("momentum"), rounding(problem, 1));
    keeps("angular-momentum", ledger.largest_defect("angular_momentum"), rounding(problem, 6));
    if (tolerance < 1e-6) keeps("energy", ledger.entry("energy").largest_defect, rounding(problem, 1));
  }
  HexahedralProblem problem = moving_body({.tolerance = 1e-13});
  const InvariantsLedger ledger = run(problem, {.stepping = Stepping::conservative});
  const auto keeps = [&](const std::string& what, const std::string& entry) {
    check.holds("The conservative scheme conserves " + what + " to round-off.", {ledger.largest_defect(entry)},
                rounding(problem, 1));
  };
  keeps("momentum", "momentum");
  keeps("energy", "energy");
  keeps("volumes", "volume_worst");
}

TEST_CASE("water that no side holds keeps its horizontal momenta to round-off", "[conservation]") {
  Check check("lagrangian_mesh_3d_free_water", "Water without walls on a level bottom: invariants",
              "12 x 12 x 2 cells under gravity, sheared and stirred at random, without side walls, 100 steps of 0.01: "
              "momentum along x and y and angular momentum about the vertical, whatever the solver's tolerance. The "
              "energy errs by $O(\\tau^2)$, for its potential part is quartic.");
  for (const double tolerance : {1e-6, 1e-13}) {
    HexahedralProblem problem = spreading_water({.tolerance = tolerance});
    const InvariantsLedger ledger = run(problem, {});
    const std::string id = tolerance == 1e-6 ? "loose-" : "tight-";
    const auto keeps = [&](const std::string& what, double value, double arm) {
      check.holds(id + what + ": " + what + " to round-off.", {value}, rounding(problem, arm));
    };
    keeps("momentum",
          worst(std::array{ledger.entry("momentum_x").largest_defect, ledger.entry("momentum_y").largest_defect}), 1);
    keeps("angular-momentum", ledger.entry("angular_momentum_z").largest_defect, 12);
  }
}

}  // namespace seiche::verification::lagrangian_mesh_3d_invariants_test
