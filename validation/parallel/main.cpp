// seiche-parallel: flows of the plan model and of hexahedra on many processes.
//
//     mpirun -n 4 seiche-parallel hump --columns 800 --rows 400 --time 20 --out run
//     mpirun -n 4 seiche-parallel soliton --columns 240 --rows 40 --layers 2 --out run
//     srun seiche-parallel soliton --columns 8000 --rows 4000 --spacing 0.25 --every 5 --out run -- -pc_type bjacobi
//
// writes run/fields_0000.h5, ... by all processes together and run/parallel_hump.json by the first one. What follows
// "--" is for PETSc: -ksp_view, -log_view, -pc_type, -seiche_da_processors_x.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "reports/evidence/record_files.hpp"
#include "seiche/distributed/distributed_flow.hpp"
#include "seiche/distributed/patches.hpp"
#include "seiche/divergence.hpp"
#include "seiche/samples.hpp"
#include "validation/parallel/flows.hpp"

namespace {

using namespace seiche;
using namespace seiche::parallel;
using distributed::rank;
using distributed::ranks;

using Clock = std::chrono::steady_clock;
constexpr std::size_t one = 1;

/// Largest over the processes.
double seconds_since(Clock::time_point begin) {
  return distributed::Decomposition::largest(std::chrono::duration<double>(Clock::now() - begin).count());
}

template <class Flow>
void write_record(evidence::Record& record, Flow& flow, const Options& options) {
  const std::vector<double> x = flow.decomposition().gathered(flow.place(0));
  const std::vector<double> y = flow.decomposition().gathered(flow.place(1));
  const std::vector<double> z = flow.decomposition().gathered(flow.place(2));
  if (rank() > 0) return;
  record.figure("surface", "Surface", fmt::format("At the end, t = {:g}.", flow.time()))
      .panel({.x = "x [m]", .y = "y [m]", .z = "z [m]"})
      .surface("surface", {.columns = options.columns, .rows = options.rows, .x = x, .y = y, .z = z});
  evidence::write(record, options.out);
}

/// @param begin  of the set-up
template <class Flow>
int run(Flow& flow, const Options& options, Clock::time_point begin) {
  if (rank() == 0) std::filesystem::create_directories(options.out);
  const double set_up = seconds_since(begin);
  const double energy = flow.energy();

  long files = 0;
  double writing = 0;
  const auto write = [&] {
    const Clock::time_point start = Clock::now();
    flow.write(options.out / fmt::format("fields_{:04d}.h5", files++));
    writing += seconds_since(start);
  };
  Worst change;
  change.add(0);  // at the start
  const Clock::time_point start = Clock::now();
  if (options.every > 0) write();
  for (long part = 1; flow.time() < options.time; ++part) {
    flow.advance_to(
        options.every > 0 ? std::min(options.time, static_cast<double>(part) * options.every) : options.time,
        options.step);
    if (options.every > 0) write();
    change.add(flow.energy() - energy);
  }
  const double stepping = seconds_since(start) - writing;
  if (options.every <= 0) write();

  const double per_step = stepping / static_cast<double>(flow.steps());
  const auto& system = flow.model().system();
  evidence::Record record = begun(options);
  judge(record, options,
        {.steps = flow.steps(),
         .energy = energy,
         .energy_change = change.value(),
         .rim_difference = flow.rim_difference()});
  record.wall_time = seconds_since(begin);
  record.measure("processes", ranks());
  record.measure("time to set up [s]", set_up);
  record.measure("time per step [s]", per_step);
  record.measure("time per step and 1000 cells [ms]",
                 1e6 * per_step / static_cast<double>(options.columns * options.rows * std::max(options.layers, one)));
  record.measure("time to write a file [s]", writing / static_cast<double>(files));
  record.measure("iterations per solution",
                 static_cast<double>(system.iterations()) / static_cast<double>(system.solutions()));
  record.measure("largest change of a cell's volume [depth^3]", flow.volume_defect());
  const bool passed = record.as_declared();
  if (rank() == 0) {
    fmt::print("{} process(es), {} x {} cells, {} steps\n", ranks(), options.columns, options.rows, flow.steps());
    for (const auto& [quantity, value] : record.measurements()) fmt::print("  {:<36} {:.4g}\n", quantity, value);
    for (const auto& claim : record.claims()) {
      fmt::print("  {:<36} {:.3g}  {}\n", claim.claim.id, claim.judgement.measured,
                 evidence::name(claim.judgement.verdict));
    }
  }
  write_record(record, flow, options);
  return passed ? 0 : 1;
}

int run(const Options& options) {
  const Clock::time_point begin = Clock::now();
  if (options.layers == 0) {
    const dispersive_shallow_water_2d::Rectangle rectangle = water(options);
    distributed::PlanFlow flow(
        {rectangle.columns, rectangle.rows}, 1,
        [&](const distributed::Patch& patch) { return distributed::part_of(rectangle, patch); }, rectangle.sides,
        velocity(options), {.tolerance = options.tolerance}, true, mechanics::stepping_named(options.scheme));
    return run(flow, options, begin);
  }
  const lagrangian_mesh_3d::Mesh mesh = layer_mesh(layered_water(options));
  distributed::HexahedralFlow flow(
      mesh.plan, mesh.layers, [&](const distributed::Patch& patch) { return distributed::part_of(mesh, patch); },
      mesh.sides, layered_velocity(options), {.tolerance = options.tolerance}, true,
      mechanics::stepping_named(options.scheme));
  return run(flow, options, begin);
}

}  // namespace

int main(int argc, char** argv) {
  const distributed::Runtime runtime(argc, argv);
  Options options;
  CLI::App app("Flows of the plan model and of hexahedra on many processes; what follows -- is for PETSc",
               "seiche-parallel");
  app.footer(
      "Exit status: 0 every claim has its declared verdict, 1 a check failed, 2 wrong usage or input,\n"
      "3 the run could not finish (diverged, disk full, killed).");
  add_options(app, options);
  try {
    app.parse(argc, argv);
    return run(options);
  } catch (const CLI::ParseError& wrong) {
    const int status = rank() == 0 ? app.exit(wrong) : wrong.get_exit_code();
    return status == 0 ? 0 : 2;
  } catch (const std::invalid_argument& wrong) {
    if (rank() == 0) fmt::print(stderr, "seiche-parallel: {}\n", wrong.what());
    return 2;
  } catch (const std::exception& failure) {
    fmt::print(stderr, "seiche-parallel: process {}: {}\n", rank(), failure.what());
    return 3;
  }
}
