// The two-dimensional Lagrangian mesh does not know the direction of time.
#include <algorithm>
#include <cmath>
#include <string>

#include "validation/instruments/mechanics/reference_integrators.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"

namespace lagrangian_mesh_symmetries_test {

using namespace seiche::mechanics;
using namespace seiche::verification;

struct Run {
  double tau;
  int steps;
};

/// What is left after steps forward, reversal of the velocities, and the same steps.
double there_and_back(MeshProblem problem, Integrator integrator, Run run) {
  State state = problem.start;
  for (int turn = 0; turn < 2; ++turn) {
    const StepFunction step = make_integrator(integrator, problem.model);
    for (int n = 0; n < run.steps; ++n) step(state, run.tau);
    for (double& u : state.u) u = -u;
  }
  return largest_difference(state, problem.start);
}

TEST_CASE("a Lagrangian mesh returns when its velocities are reversed", "[conservation]") {
  Check check("lagrangian_mesh_reversible", "Lagrangian mesh: time reversal",
              "A free patch, 100 steps of 0.01, and sloshing water, 200 steps of 0.05: velocities reversed, the same "
              "steps, velocities reversed. Both schemes are symmetric: the start returns.");
  for (const Integrator integrator : {Integrator::one_step, Integrator::conservative}) {
    const auto returns = [&](const std::string& id, MeshProblem problem, Run run, double scale) {
      check.holds(std::string(title(integrator)) + ", " + id + ").",
                  {there_and_back(std::move(problem), integrator, run)},
                  Roundoff{2.0 * run.steps * (1 + 64 * std::pow(1 / scale, 2)), scale,
                           "each place, up to the largest, rounded once in a step, and distances within a cell "
                           "and velocities, up to 1, some 64 times"});
    };
    returns("patch", moving_patch(), {0.01, 100}, 1);
    returns("sloshing", sloshing(), {0.05, 200}, 6);
  }
}

}  // namespace lagrangian_mesh_symmetries_test
