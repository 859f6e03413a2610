// The solvers of the pressure equation, and any number of threads, give one motion of the Lagrangian mesh.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <omp.h>

#include "seiche/linear/worth_threads.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace lagrangian_mesh_solvers_test {

using namespace seiche::lagrangian_mesh_2d;
using seiche::Worst;
using seiche::evidence::Bound;
using seiche::evidence::Qualitative;
using seiche::evidence::Roundoff;
using seiche::linear::SolverMethod;
using seiche::linear::worth_threads;
using seiche::verification::Check;

const std::string source = "the same scheme";

/// Water with an inclined surface, released between walls.
Flow released(std::size_t columns, std::size_t rows, Scheme scheme, SolverMethod method, double tolerance,
              double length = 6) {
  return Flow(layer_mesh({.begin = 0,
                          .end = length,
                          .columns = columns,
                          .rows = rows,
                          .elevation = [=](double x) { return 0.25 * std::cos(std::numbers::pi * x / length); }}),
              {}, scheme, {.solver = method, .tolerance = tolerance});
}

double largest_difference(const Flow& a, const Flow& b) {
  Worst largest;
  for (std::size_t i = 0; i < a.state().q.size(); ++i) {
    largest.add(a.state().q[i] - b.state().q[i]);
  }
  for (std::size_t i = 0; i < a.state().u.size(); ++i) {
    largest.add(a.state().u[i] - b.state().u[i]);
  }
  return largest.value();
}

const std::vector<std::pair<std::string, Stepping>> steppings{{"one-step", Stepping::one_step},
                                                              {"conservative", Stepping::conservative}};

/// Meshes that are worth threads.
void claim_threads(const std::string& id, Stepping stepping) {
  Check check("lagrangian_mesh_threads", "Lagrangian mesh: any number of threads",
              "Meshes that are worth threads, three steps with one and with two of them, banded and iterative solver: "
              "every bit is the same. Sums are taken in one order.");
  const int threads = omp_get_max_threads();
  constexpr std::size_t rows = 60;
  constexpr std::size_t columns = worth_threads / rows + 200;
  // On so fine a mesh a direct solver rounds more than sweeps wait for.
  const int sweeps = stepping == Stepping::conservative ? 4 : 0;
  for (const auto& [solver, method] : {std::pair{std::string("banded"), SolverMethod::banded},
                                       std::pair{std::string("iterative"), SolverMethod::iterative}}) {
    std::vector<std::vector<double>> results;
    for (const int count : {1, 2}) {
      omp_set_num_threads(count);
      Flow flow = released(columns, rows, {.stepping = stepping, .fixed_sweeps = sweeps}, method, 1e-10,
                           static_cast<double>(columns) / rows);
      for (int n = 0; n < 3; ++n) flow.advance(0.5 * flow.stable_step());
      std::vector<double> all = flow.state().q;
      all.insert(all.end(), flow.state().u.begin(), flow.state().u.end());
      all.insert(all.end(), flow.multipliers().begin(), flow.multipliers().end());
      results.push_back(std::move(all));
    }
    omp_set_num_threads(threads);
    check.that(
        {.id = id + "-" + solver,
         .text = id + ", " + solver + ": one and two threads give the same bits.",
         .quantity = "same bits",
         .source = source},
        {.value = results[0] == results[1] ? 1.0 : 0.0, .resolution = fmt::format("3 steps, {} cells", columns * rows)},
        Qualitative{"equal coordinates, rates and multipliers", "results must not depend on the machine's load"});
  }
}

TEST_CASE("banded and iterative solvers give one motion", "[robustness]") {
  Check check(
      "lagrangian_mesh_solvers", "Lagrangian mesh: two solvers, one motion",
      "Water with a surface of $0.25\\cos(\\pi x/6)$, 48 x 8 cells, 50 steps of 0.05: the mesh is well deformed. "
      "Banded Cholesky factorisation; conjugate gradients to relative residuals of 1e-13 and 1e-8.");
  for (const auto& [id, stepping] : steppings) {
    const auto run = [&, which = stepping](SolverMethod method, double tolerance) {
      Flow flow = released(48, 8, {.stepping = which}, method, tolerance);
      for (int n = 0; n < 50; ++n) flow.advance(0.05);
      return flow;
    };
    const Flow banded = run(SolverMethod::banded, 1e-10);
    const auto agrees = [&, name = id](const std::string& what, const Flow& other,
                                       const seiche::evidence::Criterion& limit) {
      check.that({.id = name + "-" + what,
                  .text = name + ": the " + what + " solver gives the banded one's motion.",
                  .quantity = "largest difference of a coordinate or rate",
                  .source = source},
                 {.value = largest_difference(banded, other), .resolution = "50 steps of 0.05"}, limit);
    };
    agrees("iterative", run(SolverMethod::iterative, 1e-13),
           Bound{std::sqrt(50) * 1e-13,
                 "a velocity of order 1 errs by the relative residual in each of 50 steps, either way"});
    agrees("loose-iterative", run(SolverMethod::iterative, 1e-8),
           Bound{50 * 1e-8, "a velocity of order 1 may err by the relative residual in each of 50 steps"});
  }
}

TEST_CASE("threads change no bit of the motion", "[robustness]") {
  claim_threads("one-step", Stepping::one_step);
}

TEST_CASE("threads change no bit of conservative motion", "[robustness][full]") {
  claim_threads("conservative", Stepping::conservative);
}

}  // namespace lagrangian_mesh_solvers_test
