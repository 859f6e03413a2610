// Steps of the two-dimensional Lagrangian mesh: a solitary wave of amplitude 0.3 in water of depth 1, tau = h1/5.
//
//   items_per_second   cells x steps / second
//   solves             solutions of the linear system per step
//   iterations         conjugate gradient iterations per step
//   factorisations     per step
//
// Schemes: one_step (one solve) and conservative (to round-off: areas and energy). Solvers: chosen by size, or named.
#include <benchmark/benchmark.h>

#include <cmath>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "verification/performance/work.hpp"

namespace {

using namespace seiche;
using namespace seiche::lagrangian_mesh_2d;
using linear::SolverMethod;

constexpr double amplitude = 0.3;
constexpr double longest_run = 8;  // then from the beginning again: before the wave reaches the wall

/// A linearisation with its projection, per cell: predict (6 arrays, 4 operations), diagonals and corners (6, 29),
/// assembly (11, 48), rates of the areas (7, 11), mean velocities (4), reaction (11, 18), advance (6, 4), reflection
/// (6, 4). Forces act on the surface alone.
constexpr performance::Work linearisation = performance::pass(57, 118);

performance::Work work_of(const performance::Solutions& in_step, double columns, double rows) {
  const auto& [solves, iterations, factorisations] = in_step;
  const double cells = columns * rows;
  const performance::Work work = (solves * cells) * linearisation;
  if (iterations > 0) {
    return work + (solves * cells) * performance::lattice_solution(columns, 1, 9, iterations / solves);
  }
  const linear::FactorWork factor = performance::band(columns, rows);
  return work + factorisations * performance::factorisation(factor) + solves * performance::substitution(factor);
}

Flow start(std::size_t columns, std::size_t rows, double column_width, Stepping stepping, SolverMethod solver,
           double tolerance) {
  const double length = column_width * static_cast<double>(columns);
  const auto elevation = [](double x) { return amplitude / std::pow(std::cosh(std::sqrt(0.75 * amplitude) * x), 2); };
  const auto velocity = [&](Point r) {
    const double eta = elevation(r.x);
    return Point{std::sqrt(1 + amplitude) * eta / (1 + eta), 0};
  };
  return Flow(layer_mesh({.begin = -length / 2,
                          .end = length / 2,
                          .depth = 1,
                          .columns = columns,
                          .rows = rows,
                          .elevation = elevation}),
              velocity, {.stepping = stepping}, {.solver = solver, .tolerance = tolerance});
}

void step(benchmark::State& state, Stepping stepping, SolverMethod solver, double tolerance) {
  const std::size_t columns = performance::count_of(state, 0), rows = performance::count_of(state, 1);
  const double column_width = 2.0 / static_cast<double>(rows);
  const double tau = column_width / 5;
  const auto started = [&] {
    Flow flow = start(columns, rows, column_width, stepping, solver, tolerance);
    for (int k = 0; k < 4; ++k) flow.advance(tau);
    return flow;
  };
  Flow flow = started();
  performance::Solutions before = performance::solutions_of(flow), done;
  for (auto _ : state) {
    if (flow.time() > longest_run) {
      state.PauseTiming();
      done += performance::solutions_of(flow) - before;
      flow = started();
      before = performance::solutions_of(flow);
      state.ResumeTiming();
    }
    flow.advance(tau);
  }
  done += performance::solutions_of(flow) - before;
  const performance::Solutions in_step = done.over(static_cast<double>(state.iterations()));
  state.SetLabel(flow.model().solver().method() == SolverMethod::banded ? "banded" : "iterative");
  state.counters["solves"] = in_step.solves;
  state.counters["iterations"] = in_step.iterations;
  state.counters["factorisations"] = in_step.factorisations;
  performance::show(state, columns * rows, work_of(in_step, static_cast<double>(columns), static_cast<double>(rows)));
}

void small_meshes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({240, 8})->Args({480, 16})->Args({960, 32})->Unit(benchmark::kMillisecond);
}

/// Where solvers change places.
void crossover(benchmark::internal::Benchmark* benchmark) {
  for (const long rows : {12, 16, 24, 32}) benchmark->Args({30 * rows, rows});
  benchmark->Unit(benchmark::kMillisecond);
}

void large_meshes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({1024, 64})->Args({512, 512})->Args({4096, 256})->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(step, one_step, Stepping::one_step, SolverMethod::automatic, 1e-10)->Apply(small_meshes);
BENCHMARK_CAPTURE(step, conservative, Stepping::conservative, SolverMethod::automatic, 1e-10)->Apply(small_meshes);
BENCHMARK_CAPTURE(step, one_step_banded, Stepping::one_step, SolverMethod::banded, 1e-10)->Apply(crossover);
BENCHMARK_CAPTURE(step, one_step_iterative, Stepping::one_step, SolverMethod::iterative, 1e-10)->Apply(crossover);
BENCHMARK_CAPTURE(step, one_step_iterative_1e_13, Stepping::one_step, SolverMethod::iterative, 1e-13)->Apply(crossover);
BENCHMARK_CAPTURE(step, one_step, Stepping::one_step, SolverMethod::automatic, 1e-10)->Apply(large_meshes);
BENCHMARK_CAPTURE(step, one_step_1e_13, Stepping::one_step, SolverMethod::automatic, 1e-13)->Apply(large_meshes);
BENCHMARK_CAPTURE(step, conservative, Stepping::conservative, SolverMethod::automatic, 1e-10)->Apply(large_meshes);

}  // namespace
