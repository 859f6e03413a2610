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
constexpr double amplitude = 0.3;

Flow start(std::size_t columns, std::size_t rows, double h, Stepping stepping, double tolerance) {
  const exact::SerreSolitary wave(amplitude);
  const double length = h * static_cast<double>(columns), width = h * static_cast<double>(rows);
  const double crest = length / 2;
  const auto elevation = [&](double x, double y) {
    const double square = std::pow(x - length / 4, 2) + std::pow(y - width / 3, 2);
    return wave.elevation(x - crest) + 0.3 * std::exp(-0.3 * square);
  };
  const auto velocity = [&](double x, double) {
    const double u = wave.depth_averaged_velocity(x - crest);
    return Velocity{u, 0, (u - wave.speed()) * wave.elevation_slope(x - crest)};
  };
  return Flow(
      rectangular_lattice({.end = length, .north = width, .columns = columns, .rows = rows, .elevation = elevation}),
      velocity, {.stepping = stepping}, {.solver = linear::SolverMethod::iterative, .tolerance = tolerance});
}

/// A linearisation with its projection, per cell: predict (9 arrays, 6 operations), gradients of volumes and forces
/// (18, 397, most of them of bilinear_patch.hpp), kick (12, 9), assembly (20, 85), rates of the volumes (16, 23), mean
/// velocities (6), reaction (22, 27), advance (9, 6), reflection (9, 6).
constexpr performance::Work linearisation = performance::pass(121, 559);

void step(benchmark::State& state, Stepping stepping, double tolerance) {
  const std::size_t columns = performance::count_of(state, 0), rows = performance::count_of(state, 1);
  const double h = static_cast<double>(state.range(2)) / 1000;
  const performance::Threads threads(state.range(3));
  const double tau = 0.5 * h;
  Flow flow = start(columns, rows, h, stepping, tolerance);
  for (int k = 0; k < 20; ++k) flow.advance(tau);
  const performance::Solutions before = performance::solutions_of(flow);
  for (auto _ : state) flow.advance(tau);
  const auto [solves, iterations, _] =
      (performance::solutions_of(flow) - before).over(static_cast<double>(state.iterations()));
  state.counters["solves"] = solves;
  state.counters["iterations"] = iterations;
  const performance::Work solution =
      performance::lattice_solution(static_cast<double>(columns), static_cast<double>(rows), 9, iterations / solves);
  performance::show(state, columns * rows, (solves * static_cast<double>(columns * rows)) * (linearisation + solution));
}

void timed(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMillisecond)->UseRealTime();
}
/// Long before the wave reaches the wall.
void small_size(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({96, 96, 500, 1})->Iterations(40);
}
void large_sizes(benchmark::internal::Benchmark* benchmark) {
  for (const int threads : {1, 2}) benchmark->Args({320, 320, 500, threads})->Args({1000, 1000, 500, threads});
  benchmark->Iterations(20);
}
void spacings(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgsProduct({{320}, {320}, {1000, 500, 250, 100}, {1}})->Iterations(20);
}
void medium_size(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({320, 320, 500, 1})->Iterations(10);
}

BENCHMARK_CAPTURE(step, one_step, Stepping::one_step, 1e-7)->Apply(small_size)->Apply(timed);
BENCHMARK_CAPTURE(step, one_step_large, Stepping::one_step, 1e-7)->Apply(large_sizes)->Apply(timed);
BENCHMARK_CAPTURE(step, one_step_spacing, Stepping::one_step, 1e-7)->Apply(spacings)->Apply(timed);
BENCHMARK_CAPTURE(step, one_step_1e_12, Stepping::one_step, 1e-12)->Apply(medium_size)->Apply(timed);
BENCHMARK_CAPTURE(step, conservative, Stepping::conservative, 1e-10)->Apply(medium_size)->Apply(timed);

}  // namespace
