// Steps of the 2DH model: a solitary wave of amplitude 0.3 and a hump of 0.3 behind it in water of depth 1.
//
//   items_per_second   cells x steps / second
//   solves             solutions of the linear system per step
//   iterations         conjugate gradient iterations per step
//
// Arguments: columns, rows, 1000 h, threads. Schemes: one_step (one solve) and conservative (energy and volumes to
// round-off). Solvers: conjugate gradients, preconditioned by the undeformed lattice, to a relative residual of 1e-7 or
// 1e-12; CHOLMOD.
#include <benchmark/benchmark.h>

#include <cmath>

#include "seiche/exact/model_waves.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "verification/performance/work.hpp"

namespace {

using namespace seiche;
using namespace seiche::dispersive_shallow_water_2d;
using linear::SolverMethod;

constexpr double amplitude = 0.3;

Flow start(std::size_t columns, std::size_t rows, double h, Stepping stepping, SolverMethod solver, double tolerance) {
  const exact::SerreSolitary wave(amplitude);
  const double length = h * static_cast<double>(columns);
  const double width = h * static_cast<double>(rows);
  const double crest = length / 2;
  const double hump_x = length / 4;
  const double hump_y = width / 3;
  return Flow(rectangular_lattice({.end = length,
                                   .north = width,
                                   .columns = columns,
                                   .rows = rows,
                                   .elevation =
                                       [&](double x, double y) {
                                         const double square =
                                             (x - hump_x) * (x - hump_x) + (y - hump_y) * (y - hump_y);
                                         return wave.elevation(x - crest) + 0.3 * std::exp(-0.3 * square);
                                       }}),
              [&](double x, double) {
                const double u = wave.depth_averaged_velocity(x - crest);
                return Velocity{u, 0, (u - wave.speed()) * wave.elevation_slope(x - crest)};
              },
              {.stepping = stepping}, {.solver = solver, .tolerance = tolerance});
}

/// A linearisation with its projection, per cell: predict (9 arrays, 6 operations), gradients of volumes and forces
/// (18, 397, most of them of bilinear_patch.hpp), kick (12, 9), assembly (20, 85), rates of the volumes (16, 23), mean
/// velocities (6), reaction (22, 27), advance (9, 6), reflection (9, 6).
constexpr performance::Work linearisation = performance::pass(121, 559);

performance::Work work_of(double solves, double iterations, double columns, double rows) {
  const linear::FactorWork factor = performance::band(columns, rows);
  const double cells = columns * rows;
  const performance::Work work = (solves * cells) * linearisation;
  if (iterations > 0) {
    return work + (solves * cells) * performance::lattice_solution(columns, rows, 9, iterations / solves);
  }
  return work + solves * (performance::factorisation(factor) + performance::substitution(factor));
}

void step(benchmark::State& state, Stepping stepping, SolverMethod solver, double tolerance) {
  const auto columns = static_cast<std::size_t>(state.range(0));
  const auto rows = static_cast<std::size_t>(state.range(1));
  const double h = static_cast<double>(state.range(2)) / 1000;
  const performance::Threads threads(state.range(3));
  const double tau = 0.5 * h;
  Flow flow = start(columns, rows, h, stepping, solver, tolerance);
  for (int k = 0; k < 20; ++k) flow.advance(tau);
  const linear::ConstraintSolver& system = flow.model().solver();
  const long solves = system.solutions();
  const long iterations = system.iterations();
  for (auto _ : state) flow.advance(tau);
  const auto steps = static_cast<double>(state.iterations());
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(columns * rows));
  const double solves_per_step = static_cast<double>(system.solutions() - solves) / steps;
  const double iterations_per_step = static_cast<double>(system.iterations() - iterations) / steps;
  state.counters["solves"] = solves_per_step;
  state.counters["iterations"] = iterations_per_step;
  performance::show(
      state, work_of(solves_per_step, iterations_per_step, static_cast<double>(columns), static_cast<double>(rows)));
}

/// Long before the wave reaches the wall.
void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMillisecond)->UseRealTime();
  benchmark->Args({96, 96, 500, 1})->Iterations(40);
}
void large_sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(20);
  for (const int threads : {1, 2}) benchmark->Args({320, 320, 500, threads})->Args({1000, 1000, 500, threads});
}
void spacings(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(20);
  for (const int h : {1000, 500, 250, 100}) benchmark->Args({320, 320, h, 1});
}
void medium_size(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(10)->Args({320, 320, 500, 1});
}

BENCHMARK_CAPTURE(step, one_step, Stepping::one_step, SolverMethod::iterative, 1e-7)->Apply(sizes);
BENCHMARK_CAPTURE(step, one_step_large, Stepping::one_step, SolverMethod::iterative, 1e-7)->Apply(large_sizes);
BENCHMARK_CAPTURE(step, one_step_spacing, Stepping::one_step, SolverMethod::iterative, 1e-7)->Apply(spacings);
BENCHMARK_CAPTURE(step, one_step_1e_12, Stepping::one_step, SolverMethod::iterative, 1e-12)->Apply(medium_size);
BENCHMARK_CAPTURE(step, conservative, Stepping::conservative, SolverMethod::iterative, 1e-10)->Apply(medium_size);

}  // namespace
