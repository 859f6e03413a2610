// The two-dimensional Lagrangian mesh does not know the direction of time, nor the frame.
#include <algorithm>
#include <cmath>
#include <string>

#include "seiche/mechanics/named_integrator.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"

namespace lagrangian_mesh_symmetries_test {

using namespace seiche::mechanics;
using namespace seiche::verification;
using seiche::Point;
using seiche::Worst;
using seiche::evidence::Roundoff;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 1";

struct Run {
  double tau;
  int steps;
};

State after(MeshProblem& problem, Integrator integrator, Run run) {
  State state = problem.start;
  const StepFunction step = make_integrator(integrator, problem.model);
  for (int n = 0; n < run.steps; ++n) step(state, run.tau);
  return state;
}

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

/// Largest difference of places after turning b's back by `angle` and shifting it.
double difference_of_places(const State& a, const State& b, double angle, double shift) {
  const std::size_t n = a.q.size() / 2;
  Worst largest;
  for (std::size_t k = 0; k < n; ++k) {
    const Point r = turned({b.q[k] - shift, b.q[n + k] - shift}, -angle);
    largest.add(r.x - a.q[k]);
    largest.add(r.y - a.q[n + k]);
  }
  return largest.value();
}

TEST_CASE("a Lagrangian mesh returns when its velocities are reversed", "[conservation]") {
  Check check("lagrangian_mesh_reversible", "Lagrangian mesh: time reversal",
              "A free patch, 100 steps of 0.01, and sloshing water, 200 steps of 0.05: velocities reversed, the same "
              "steps, velocities reversed. Both schemes are symmetric: the start returns.");
  for (const Integrator integrator : {Integrator::one_step, Integrator::conservative}) {
    const auto returns = [&](const std::string& id, MeshProblem problem, Run run, double scale) {
      check.that(
          {.id = std::string(name(integrator)) + "-" + id,
           .text = std::string(title(integrator)) + ", " + id + ": the start returns.",
           .quantity = "largest difference of a coordinate or a rate",
           .source = source},
          {.value = there_and_back(std::move(problem), integrator, run),
           .resolution = std::to_string(run.steps) + " steps each way"},
          Roundoff{.operations = 2.0 * run.steps * (1 + 64 * std::pow(1 / scale, 2)),
                   .scale = scale,
                   .reason = "each place, up to the largest, rounded once in a step, and distances within a cell "
                             "and velocities, up to 1, some 64 times"});
    };
    returns("patch", moving_patch(), {0.01, 100}, 1);
    returns("sloshing", sloshing(), {0.05, 200}, 6);
  }
}

TEST_CASE("a turned or shifted patch of fluid moves likewise", "[conservation]") {
  Check check("lagrangian_mesh_frames", "Free patch of fluid: frames",
              "The patch turned by 0.7 about the origin, or shifted by 1000 along both axes: the same motion, to the "
              "rounding of the coordinates; 100 steps of 0.01.");
  const Run run{0.01, 100};
  for (const Integrator integrator : {Integrator::one_step, Integrator::conservative}) {
    MeshProblem plain = moving_patch();
    const State reference = after(plain, integrator, run);
    const auto same = [&](const std::string& id, const std::string& text, double angle, double shift,
                          const seiche::evidence::Criterion& limit) {
      MeshProblem other = moving_patch(angle, shift);
      check.that({.id = std::string(name(integrator)) + "-" + id,
                  .text = std::string(title(integrator)) + ": " + text,
                  .quantity = "largest difference of a coordinate",
                  .source = source},
                 {.value = difference_of_places(reference, after(other, integrator, run), angle, shift),
                  .resolution = "tau = 0.01, 100 steps"},
                 limit);
    };
    same("turned", "a turned patch moves likewise.", 0.7, 0,
         Roundoff{.operations = 200 * 64.0,
                  .scale = 1,
                  .reason = "two runs of 100 steps, each coordinate of order 1 rounded some 64 times in a step"});
    same("shifted", "a shifted patch moves likewise.", 0, 1000,
         Roundoff{.operations = 100,
                  .scale = 1000,
                  .reason = "one rounding of coordinates of 1000 per step; differences of neighbours inherit it"});
  }
}

}  // namespace lagrangian_mesh_symmetries_test
