// The 2DH model shared out among processes against the same model on one, and what it writes.
#include <unistd.h>

#include <filesystem>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/io/hdf5_table.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/distributed/problems.hpp"

namespace seiche::verification::flow_2dh_test {

using namespace distributed_flows;
using distributed::rank;
using distributed::ranks;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 4";
const std::string article =
    "The mesh is shared out among the processes of one program (MPI); each computes on its own block and a ring of its "
    "neighbours' cells, and PETSc solves the system of all cells by conjugate gradients, preconditioned by the "
    "diagonal. The flow on one process is stepped by the model itself, with a direct solver.\n\nThe two may differ by "
    "the residual of the iterations. A relative residual $\\varepsilon$ leaves at most the part $\\kappa\\varepsilon$ "
    "of the multipliers, $\\kappa$ being the condition number of the preconditioned matrix (from the Lanczos "
    "coefficients of the last solution), and they change velocities by less than the largest velocity $U$ in a step: "
    "after $N$ steps the difference is below $N\\kappa\\varepsilon U$. It must vanish with $\\varepsilon$, in "
    "proportion.";

void compare_with_one(const std::string& id, const std::string& title, const std::vector<Problem>& problems) {
  const std::vector<double> tolerances{1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
  std::vector<std::vector<Outcome>> outcomes;
  for (const Problem& problem : problems) {
    auto& of_problem = outcomes.emplace_back();
    for (const double tolerance : tolerances) of_problem.push_back(shared_out(problem, tolerance));
  }
  if (rank() > 0) return;

  Check check(fmt::format("distributed_{}_{}", id, ranks()),
              fmt::format("{} shared out among {} process(es)", title, ranks()), article, source);
  auto& panel = check.figure("tolerance", "Difference from the flow on one process", "Against the solver's tolerance.")
                    .panel({.x = "tolerance (relative residual)",
                            .y = "largest difference, depths or sqrt(g depth)",
                            .log_x = true,
                            .log_y = true});
  for (std::size_t p = 0; p < problems.size(); ++p) {
    const Problem& problem = problems[p];
    const Outcome reference = alone(problem);
    std::vector<double> differences;
    Largest rim;
    for (const Outcome& outcome : outcomes[p]) {
      differences.push_back(largest_difference(outcome, reference));
      rim.add(outcome.rim_difference);
    }
    const Outcome& finest = outcomes[p].back();
    const std::string resolution = fmt::format("{} steps of {}, relative residual {:.0e}, {} process(es)",
                                               problem.steps, problem.step, tolerances.back(), ranks());
    check.that("same-" + problem.id,
               fmt::format("The flow shared out among processes equals the flow of one process: {}.", problem.what),
               "largest difference of a coordinate over the depth or a velocity over sqrt(g depth)",
               {.value = differences.back(), .resolution = resolution},
               Bound{static_cast<double>(problem.steps) * finest.condition * tolerances.back() * speed(reference),
                     fmt::format("N kappa eps U with kappa = {:.3g}, U = {:.3g}", finest.condition, speed(reference))});
    check.that("vanishes-" + problem.id, "The difference falls with the first power of the tolerance.",
               "order of the largest difference in the tolerance", observed_order(tolerances, differences),
               Order{1, 0.25,
                     "the residual at which the iteration stops lies anywhere within the factor of one iteration below "
                     "the tolerance"});
    check.that("copies-" + problem.id,
               "The difference between the copies that several processes hold of a node is zero.",
               "largest difference between copies", {.value = rim.value(), .resolution = resolution},
               Bound{0, "copies are copied"});
    const double part = static_cast<double>(problem.steps) * finest.condition * tolerances.back();
    check.that(
        "energy-" + problem.id,
        "The energy of the water that the processes hold together equals the energy in one process.",
        "difference over the energy", {.value = finest.energy / reference.energy - 1, .resolution = resolution},
        Bound{2 * part,
              fmt::format(
                  "2 N kappa eps with kappa = {:.3g}: energies are quadratic in quantities that differ by N kappa eps",
                  finest.condition)});
    if (problem.window.reach) {
      check.that("shifts-" + problem.id,
                 "The number of columns left behind by the moving window equals the number in one process.",
                 "columns left behind, minus those on one process",
                 {.value = static_cast<double>(finest.shifts - reference.shifts),
                  .resolution = fmt::format("{} columns left behind", finest.shifts)},
                 Bound{0, "the water at the window's front is at rest"});
    }
    panel.line(problem.id, tolerances, differences);
  }
}

TEST_CASE("a 2DH flow distributed over processes agrees with one process to the tolerance of its solver") {
  compare_with_one("flow_2dh", "2DH model", {box(), shoal(), wedge()});
}

TEST_CASE("a 2DH flow with moving borders, distributed over processes, agrees with one process") {
  compare_with_one("moving_borders", "2DH model with a moving window, and with shorelines,",
                   {window(), canal(), island()});
}

TEST_CASE("the conservative scheme distributed over processes conserves the energy and ends its sweeps together") {
  constexpr double tolerance = 1e-11;
  const std::vector<Problem> problems{box(), shoal(), wedge(), canal()};
  std::vector<Outcome> outcomes;
  for (const Problem& problem : problems) {
    outcomes.push_back(shared_out(problem, tolerance, mechanics::Stepping::conservative));
  }
  if (rank() > 0) return;
  Check check(fmt::format("distributed_conservative_{}", ranks()),
              fmt::format("Conservative scheme shared out among {} process(es)", ranks()),
              "Flows over level and uneven bottoms, with a wave maker and with shorelines, by the conservative scheme. "
              "Sweeps of a step end when velocities no longer change at any process; every process does as many. The "
              "flow on one process has a direct solver and ends its own sweeps.",
              source);
  for (std::size_t p = 0; p < problems.size(); ++p) {
    const Problem& problem = problems[p];
    const Outcome& shared = outcomes[p];
    const Outcome reference = alone(problem, mechanics::Stepping::conservative);
    const std::string resolution =
        fmt::format("{} steps of {}, relative residual {:.0e}", problem.steps, problem.step, tolerance);
    constexpr double settled = 1e-11;
    const bool driven = std::holds_alternative<plan_lattice::DrivenSide>(problem.lattice.sides.west);
    if (!driven) {
      check.that("energy-" + problem.id, fmt::format("Energy is conserved by the shared flow: {}.", problem.what),
                 "change over the first value",
                 {.value = shared.energy / shared.first_energy - 1, .resolution = resolution},
                 Bound{static_cast<double>(problem.steps) * settled,
                       "sweeps end at the latest when velocities change by 1e-11 of the largest"});
    }
    check.that("same-" + problem.id,
               fmt::format("The flow of several processes equals the flow of one: {}.", problem.what),
               "largest difference of a coordinate over the depth or a velocity over sqrt(g depth)",
               {.value = largest_difference(shared, reference), .resolution = resolution},
               Bound{static_cast<double>(problem.steps) * (settled + shared.condition * tolerance) * speed(reference),
                     fmt::format("as for the one-step scheme, N kappa eps U with kappa = {:.3g}; and changes by "
                                 "further sweeps, 1e-11 of U each time",
                                 shared.condition)});
    check.that("copies-" + problem.id,
               "The difference between the copies that several processes hold of a node is zero.",
               "largest difference between copies", {.value = shared.rim_difference, .resolution = resolution},
               Bound{0, "copies are copied"});
  }
}

TEST_CASE("a mesh that tangles at one process stops all of them") {
  const Problem problem = box();
  distributed::PlanFlow flow(
      problem.lattice.shape, 1,
      [&](const distributed::Patch& patch) { return distributed::part_of(problem.lattice, patch); },
      problem.lattice.sides,
      [](double x, double y) { return plan::Velocity{.u = x < 4 && y < 4 ? 4 * std::sin(3 * y) : 0}; });
  double stopped = 0;
  try {
    for (long n = 0; n < problem.steps; ++n) flow.advance(problem.step);
  } catch (const Divergence&) {
    stopped = 1;
  }
  const double all_stopped = distributed::Decomposition::least(stopped);
  if (rank() > 0) return;
  Check check(fmt::format("distributed_breakdown_{}", ranks()), fmt::format("A breakdown on {} process(es)", ranks()),
              "A jet in the south-west corner of the box tangles the mesh there.", source);
  check.that("all-stop", "A breakdown in one process is a Divergence in all, with time and step.",
             "1 if all processes stopped",
             {.value = all_stopped, .resolution = fmt::format("{} steps before it", flow.steps())},
             Qualitative{"every process caught Divergence", "a process that continues alone waits forever"});
}

TEST_CASE("a shoreline that leaves the bottom at one process stops all of them") {
  Problem problem = canal();
  // Known between x = -11 and 11; the western shore, at x = -9.2 or west of it, moves 0.4 in a step.
  problem.lattice.bottom = std::make_shared<SplineBottom>(
      SplineBottom::sampled({.begin = -11, .end = 11, .south = -1, .north = 9, .spacing = 0.5},
                            [](double x, double) { return -1 + 0.01 * x * x; }));
  for (std::size_t k = 0; k < problem.lattice.shape.nodes(); ++k) {
    const std::size_t column = k % 33;
    if (column % 32 == 0)
      problem.lattice.z[k] = problem.lattice.bottom->slope(problem.lattice.x[k], problem.lattice.y[k]).elevation;
  }
  problem.velocity = [](double, double) { return plan::Velocity{.u = -2}; };
  problem.step = 0.2;
  double stopped = 0;
  std::string why;
  try {
    shared_out(problem, 1e-9);
  } catch (const Divergence& divergence) {
    stopped = 1;
    why = divergence.what();
  }
  const double all_stopped = distributed::Decomposition::least(stopped);
  if (rank() > 0) return;
  Check check(fmt::format("distributed_shore_breakdown_{}", ranks()),
              fmt::format("A shoreline that leaves the bottom, on {} process(es)", ranks()),
              "Water runs up the western shore of a canal, beyond the extent of the bottom.", source);
  check.that("all-stop", "A breakdown in one process at the end of a step is a Divergence in all.",
             "1 if all processes stopped", {.value = all_stopped, .resolution = why},
             Qualitative{"every process caught Divergence", "a process that continues alone waits forever"});
}

TEST_CASE("options that a moving window excludes are rejected on many processes too") {
  const auto refusal = [](const Problem& problem) -> std::string {
    try {
      shared_out(problem, 1e-9);
    } catch (const std::invalid_argument& refused) {
      return refused.what();
    }
    return "";
  };
  Problem free = window();
  free.lattice.sides.west = plan_lattice::FreeSide{};
  CHECK(refusal(free).find("a moving window over a west side that is free") != std::string::npos);
  Problem shore = canal();
  shore.lattice.sides.west = plan_lattice::HeldSide{};
  for (std::size_t k = 0; k < shore.lattice.shape.nodes(); k += shore.lattice.shape.columns + 1) {
    shore.lattice.z[k] += 0.1;
  }
  shore.window = window().window;
  CHECK(refusal(shore).find("a moving window with a shoreline") != std::string::npos);
}

TEST_CASE("the decay of the mesh's pattern is rejected") {
  const Problem problem = box();
  std::string message;
  try {
    const distributed::PlanFlow flow(
        problem.lattice.shape, 1,
        [&](const distributed::Patch& patch) { return distributed::part_of(problem.lattice, patch); },
        problem.lattice.sides, {}, {.drag = {.lattice_rate = 1}});
  } catch (const std::invalid_argument& refusal) {
    message = refusal.what();
  }
  CHECK(message.find("lattice_rate on many processes") != std::string::npos);
}

TEST_CASE("the fields written by all processes are read back unchanged") {
  const Problem problem = box();
  // One folder for all: the number of the first process's program.
  const auto folder =
      std::filesystem::temp_directory_path() /
      fmt::format("seiche-fields-{:.0f}",
                  distributed::Decomposition::largest(rank() == 0 ? static_cast<double>(::getpid()) : 0));
  std::filesystem::create_directories(folder);
  const auto file = folder / "fields.h5";
  distributed::PlanFlow flow(
      problem.lattice.shape, 1,
      [&](const distributed::Patch& patch) { return distributed::part_of(problem.lattice, patch); },
      problem.lattice.sides);
  for (int n = 0; n < 5; ++n) flow.advance(problem.step);
  flow.write(file);
  const std::array<std::string, 6> names{"x", "y", "z", "u", "v", "w"};
  std::vector<std::vector<double>> written;
  for (std::size_t k = 0; k < 6; ++k) {
    written.push_back(flow.decomposition().gathered(k < 3 ? flow.place(k) : flow.velocity(k - 3)));
  }
  if (rank() > 0) return;

  const io::Table read = io::read_hdf5(file);
  std::filesystem::remove_all(folder);
  Worst worst;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto& column = read.column(names[k]);
    REQUIRE(column.size() == written[k].size());
    for (std::size_t n = 0; n < column.size(); ++n) worst.add(column[n] - written[k][n]);
  }
  Check check(fmt::format("distributed_fields_file_{}", ranks()),
              fmt::format("Fields written by {} process(es) together", ranks()),
              "All processes write their parts of one HDF5 file; a reader with another HDF5 library reads it.", source);
  check.that("read-back", "The difference of coordinates and velocities read back, row by row, is zero.",
             "largest difference", {.value = worst.value(), .resolution = "40 x 20 cells"},
             Bound{0, "the file keeps all digits"});
}

}  // namespace seiche::verification::flow_2dh_test
