// seiche-parallel: flows of the plan model and of hexahedra on many processes.
//
//     mpirun -n 4 seiche-parallel hump --columns 800 --rows 400 --time 20 --out run
//     mpirun -n 4 seiche-parallel reflection --amplitude 0.3 --angle 30 --time 60 --step 0.25 --out run
//     mpirun -n 4 seiche-parallel island --amplitude 0.096 --spacing 1 --time 30 --step 0.1 --out run
//     mpirun -n 4 seiche-parallel soliton --columns 240 --rows 40 --layers 2 --out run
//     srun seiche-parallel soliton --columns 8000 --rows 4000 --spacing 0.25 --every 5 --out run -- -pc_type bjacobi
//
// writes run/fields_0000.h5, ... by all processes together and run/parallel_hump.json by the first one. What follows
// "--" is for PETSc: -ksp_view, -log_view, -pc_type, -seiche_da_processors_x.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "distributed/distributed_flow.hpp"
#include "distributed/patches.hpp"
#include "reports/evidence/record_files.hpp"
#include "seiche/divergence.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/plan/reflection_pattern.hpp"
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

/// Of the first process alone, where there is one.
double from_first(double value) {
  constexpr double none = std::numeric_limits<double>::lowest();
  const double sent = rank() == 0 && std::isfinite(value) ? value : none;
  const double got = distributed::Decomposition::largest(sent);
  return got > none ? got : std::numeric_limits<double>::quiet_NaN();
}

/// The surface on the first process, in depths.
struct Surface {
  std::vector<double> x, y, z;
};
template <class Flow>
Surface gathered(Flow& flow, double depth) {
  Surface surface{flow.decomposition().gathered(flow.place(0)), flow.decomposition().gathered(flow.place(1)),
                  flow.decomposition().gathered(flow.place(2))};
  for (std::vector<double>* values : {&surface.x, &surface.y, &surface.z}) {
    for (double& value : *values) value /= depth;
  }
  return surface;
}

/// What is seen of the reflection at the end.
void measure_reflection(const Surface& surface, const Options& options, Findings& findings) {
  double wall = std::numeric_limits<double>::quiet_NaN();
  double incident = wall;
  Worst ahead;
  if (rank() == 0) {
    for (std::size_t k = options.columns; k < surface.z.size(); k += options.columns + 1) ahead.add(surface.z[k]);
    try {
      const auto pattern = validation::measured_reflection(
          {.columns = options.columns, .rows = options.rows, .x = surface.x, .y = surface.y, .z = surface.z},
          options.amplitude);
      wall = pattern.wall_amplitude.value;
      incident = pattern.incident_amplitude.value;
    } catch (const std::runtime_error& missing) {
      fmt::print(stderr, "seiche-parallel: {}\n", missing.what());
    }
  }
  findings.ahead = from_first(rank() == 0 ? ahead.value() : 0);
  findings.wall = from_first(wall);
  findings.incident = from_first(incident);
}

/// Highest of this process's markers on the south side, which is an island's shoreline.
template <class Flow>
void watch_shore(const Flow& flow, Largest& highest) {
  if (flow.patch().rows.begin > 0) return;
  for (std::size_t i = 0; i <= flow.patch().shape().columns; ++i) highest.add(flow.place(2)[i]);
}

void write_record(evidence::Record& record, const Surface& surface, double time, const Options& options) {
  if (rank() > 0) return;
  record.figure("surface", "Surface", fmt::format("At the end, t = {:g} sqrt(depth/g).", time))
      .panel({.x = "x [depth]", .y = "y [depth]", .z = "z [depth]"})
      .surface("surface",
               {.columns = options.columns, .rows = options.rows, .x = surface.x, .y = surface.y, .z = surface.z});
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
  const Units unit = units(options);
  Worst change;
  Largest rise, run_up;
  change.add(0);  // at the start
  rise.add(0);
  run_up.add(std::numeric_limits<double>::lowest());
  const bool shore = options.flow == "island";
  const Clock::time_point start = Clock::now();
  if (options.every > 0) write();
  for (long part = 1; flow.time() < options.time * unit.time; ++part) {
    const double until =
        options.every > 0 ? std::min(options.time, static_cast<double>(part) * options.every) : options.time;
    march(flow, until * unit.time, options.step * unit.time, [&] {
      if (shore) watch_shore(flow, run_up);
    });
    if (options.every > 0) write();
    change.add(flow.energy() - energy);
    rise.add(flow.energy() - energy);
  }
  const double stepping = seconds_since(start) - writing;
  if (options.every <= 0) write();

  const double per_step = stepping / static_cast<double>(flow.steps());
  const auto& system = flow.model().system();
  evidence::Record record = begun(options);
  const Surface surface = gathered(flow, unit.length);
  Findings findings{.steps = flow.steps(),
                    .energy = energy,
                    .energy_change = change.value(),
                    .energy_rise = rise.value(),
                    .rim_difference = flow.rim_difference(),
                    .run_up = shore ? distributed::Decomposition::largest(run_up.value()) / unit.length : 0};
  if (options.flow == "reflection") measure_reflection(surface, options, findings);
  judge(record, options, findings);
  record.wall_time = seconds_since(begin);
  record.measure("processes", ranks());
  record.measure("time to set up [s]", set_up);
  record.measure("time per step [s]", per_step);
  record.measure("time per step and 1000 cells [ms]",
                 1e6 * per_step / static_cast<double>(options.columns * options.rows * std::max(options.layers, one)));
  record.measure("time to write a file [s]", writing / static_cast<double>(files));
  record.measure("iterations per solution",
                 static_cast<double>(system.iterations()) / static_cast<double>(system.solutions()));
  record.measure("largest change of a cell's volume [depth^3]", flow.volume_defect() / std::pow(unit.length, 3));
  if (options.flow == "reflection") record.measure("columns left behind", static_cast<double>(flow.shifts()));
  const bool passed = record.as_declared();
  if (rank() == 0) {
    fmt::print("{} process(es), {} x {} cells, {} steps\n", ranks(), options.columns, options.rows, flow.steps());
    for (const auto& [quantity, value] : record.measurements()) fmt::print("  {:<36} {:.4g}\n", quantity, value);
    for (const auto& claim : record.claims()) {
      fmt::print("  {:<36} {:.3g}  {}\n", claim.claim.id, claim.judgement.measured,
                 evidence::name(claim.judgement.verdict));
    }
  }
  write_record(record, surface, flow.time() / unit.time, options);
  return passed ? 0 : 1;
}

template <class Lattice>
distributed::PlanFlow::MakePart part_of(const Lattice& lattice) {
  return [&lattice](const distributed::Patch& patch) { return distributed::part_of(lattice, patch); };
}

int run_plan(Options options) {
  const Clock::time_point begin = Clock::now();
  const mechanics::Stepping stepping = mechanics::stepping_named(options.scheme);
  if (options.flow == "island") {
    const validation::ConicalIsland basin(island(options));
    const dispersive_shallow_water_2d::Lattice lattice = basin.lattice();
    options.columns = lattice.shape.columns;
    options.rows = lattice.shape.rows;
    const double longest = basin.step() / units(options).time;
    if (options.step > longest) options.step = longest;
    dispersive_shallow_water_2d::Settings settings = basin.model_settings();
    settings.tolerance = options.tolerance;
    distributed::PlanFlow flow(
        lattice.shape, 1, part_of(lattice), lattice.sides,
        [&basin](double x, double y) { return basin.velocity(x, y); }, settings, false, stepping);
    return run(flow, options, begin);
  }
  const bool reflected = options.flow == "reflection";
  const validation::PlanReflection reflection =
      reflected ? plan_reflection(oblique_wave(options), reflection_window(options)) : validation::PlanReflection{};
  const dispersive_shallow_water_2d::Rectangle rectangle = reflected ? reflection.water : water(options);
  options.columns = rectangle.columns;
  options.rows = rectangle.rows;
  distributed::PlanFlow flow({rectangle.columns, rectangle.rows}, 1, part_of(rectangle), rectangle.sides,
                             reflected ? reflection.velocity : velocity(options), {.tolerance = options.tolerance},
                             true, stepping, reflection.window);
  return run(flow, options, begin);
}

int run_hexahedra(Options options) {
  const Clock::time_point begin = Clock::now();
  const bool reflected = options.flow == "reflection";
  const validation::LayeredReflection reflection =
      reflected ? layered_reflection(oblique_wave(options), reflection_window(options), options.layers)
                : validation::LayeredReflection{};
  const lagrangian_mesh_3d::Mesh mesh = layer_mesh(reflected ? reflection.water : layered_water(options));
  options.columns = mesh.plan.columns;
  options.rows = mesh.plan.rows;
  distributed::HexahedralFlow flow(
      mesh.plan, mesh.layers, [&](const distributed::Patch& patch) { return distributed::part_of(mesh, patch); },
      mesh.sides, reflected ? reflection.velocity : layered_velocity(options), {.tolerance = options.tolerance}, true,
      mechanics::stepping_named(options.scheme), reflection.window);
  return run(flow, options, begin);
}

/// Says what went wrong, once where it went wrong everywhere, and leaves no process waiting for this one.
/// @return the status
int failed(const distributed::Runtime& runtime, int status, const std::exception& failure) {
  const bool everywhere = runtime.all_failed();
  if (!everywhere) {
    fmt::print(stderr, "seiche-parallel: process {}: {}\n", rank(), failure.what());
    std::fflush(stderr);
    MPI_Abort(PETSC_COMM_WORLD, status);
  }
  if (rank() == 0) fmt::print(stderr, "seiche-parallel: {}\n", failure.what());
  return status;
}

}  // namespace

int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape): before MPI runs, nobody else waits
  const distributed::Runtime runtime(argc, argv);
  Options options;
  CLI::App app("Flows of the 2DH model and of hexahedra on many processes; what follows -- is for PETSc",
               "seiche-parallel");
  app.footer(
      "Exit status: 0 all claims as expected; 1 at least one unexpected result; 2 invalid input or usage;\n"
      "3 run not completed (diverged, disk full, killed).");
  add_options(app, options);
  try {
    app.parse(argc, argv);
    if (fits_itself(options) && app.count("--columns") + app.count("--rows") > 0) {
      throw std::invalid_argument(fmt::format("--columns or --rows of {}; allowed: of hump and soliton", options.flow));
    }
    return options.layers > 0 && options.flow != "island" ? run_hexahedra(options) : run_plan(options);
  } catch (const CLI::ParseError& wrong) {
    const int status = rank() == 0 ? app.exit(wrong) : wrong.get_exit_code();
    return status == 0 ? 0 : 2;
  } catch (const std::invalid_argument& wrong) {
    return failed(runtime, 2, wrong);
  } catch (const std::exception& failure) {
    return failed(runtime, 3, failure);
  }
}
