// The solvers of the pressure equation give one motion of the Lagrangian mesh.
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "verification/conservation/mechanical_problem.hpp"

namespace seiche::verification::lagrangian_mesh_solvers_test {

using namespace lagrangian_mesh_2d;
using linear::SolverMethod;

/// Water with an inclined surface, released between walls.
Flow released(Stepping stepping, SolverMethod method, double tolerance) {
  const auto elevation = [](double x) { return 0.25 * std::cos(std::numbers::pi * x / 6); };
  return Flow(layer_mesh({.end = 6, .columns = 48, .rows = 8, .elevation = elevation}), {}, {.stepping = stepping},
              {.solver = method, .tolerance = tolerance});
}

TEST_CASE("banded and iterative solvers give one motion", "[robustness]") {
  Check check("lagrangian_mesh_solvers", "Lagrangian mesh: two solvers, one motion",
              "Water with a surface of $0.25\\cos(\\pi x/6)$, 48 x 8 cells, 50 steps of 0.05: the mesh is well "
              "deformed. Banded Cholesky factorisation; conjugate gradients to relative residuals of 1e-13 and 1e-8.");
  for (const auto& [id, stepping] :
       {std::pair{std::string("one-step"), Stepping::one_step}, {"conservative", Stepping::conservative}}) {
    const auto run = [&, which = stepping](SolverMethod method, double tolerance) {
      Flow flow = released(which, method, tolerance);
      for (int n = 0; n < 50; ++n) flow.advance(0.05);
      return flow;
    };
    const Flow banded = run(SolverMethod::banded, 1e-10);
    const auto agrees = [&, name = id](const std::string& what, const Flow& other, const evidence::Criterion& limit) {
      check.holds(name + ": the " + what + " solver gives the banded one's motion.",
                  {largest_difference(banded.state(), other.state())}, limit);
    };
    agrees("iterative", run(SolverMethod::iterative, 1e-13),
           Bound{std::sqrt(50) * 1e-13,
                 "a velocity of order 1 errs by the relative residual in each of 50 steps, either way"});
    agrees("loose-iterative", run(SolverMethod::iterative, 1e-8),
           Bound{50 * 1e-8, "a velocity of order 1 may err by the relative residual in each of 50 steps"});
  }
}

}  // namespace seiche::verification::lagrangian_mesh_solvers_test
