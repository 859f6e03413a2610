// Steps of the hexahedral Lagrangian mesh: a hump of 0.3 in the corner of a square box of water of depth 1, tau = 0.4
// h.
//
//   items_per_second   cells x steps / second
//   iterations         conjugate gradient iterations per solution
//   solves             solutions of the linear system per step
//
// Schemes: one_step (one solve) and conservative (to round-off: volumes and energy).
#include <benchmark/benchmark.h>

#include <cmath>

#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "verification/performance/work.hpp"

namespace {

using namespace seiche::lagrangian_mesh_3d;
namespace performance = seiche::performance;

/// A linearisation with its projection, per cell: predict (9 arrays, 6 operations), gradients (27, 297), inverted
/// corners (164 operations), assembly (41, 324), rates of the volumes (28, 47), mean velocities (6), reaction (34, 51),
/// advance (9, 6), reflection (9, 6). Forces act on the surface alone.
constexpr performance::Work linearisation = performance::pass(163, 901);

void steps(benchmark::State& state, Stepping stepping) {
  const std::size_t side = performance::count_of(state, 0);
  const double h = 1 / static_cast<double>(state.range(2));
  const double length = h * static_cast<double>(side);
  Flow flow(layer_mesh({.end = length,
                        .north = length,
                        .columns = side,
                        .rows = side,
                        .layers = performance::count_of(state, 1),
                        .elevation = [](double x, double y) { return 0.3 * std::exp(-0.1 * (x * x + y * y)); }}),
            {}, {.stepping = stepping}, {.tolerance = 1e-7});
  flow.advance(0.4 * h);
  const performance::Solutions before = performance::solutions_of(flow);
  for (auto _ : state) flow.advance(0.4 * h);
  const auto [solves, iterations, _] =
      (performance::solutions_of(flow) - before).over(static_cast<double>(state.iterations()));
  state.counters["iterations"] = iterations / solves;
  state.counters["solves"] = solves;
  const auto horizontal = static_cast<double>(side);
  const std::size_t cells = flow.model().constraints();
  performance::show(
      state, cells,
      (solves * static_cast<double>(cells)) *
          (linearisation + performance::lattice_solution(horizontal, horizontal, 27, iterations / solves)));
}

void timed(benchmark::internal::Benchmark* benchmark) {
  benchmark->UseRealTime()->Unit(benchmark::kMillisecond);
}

}  // namespace

/// Cells along a side of the box, layers, cells to a depth. Of so many steps however fast the machine is: the wave that
/// comes back to the corner steepens, and after some seven hundred steps the mesh inverts.
void many(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({96, 1, 2})->Args({96, 2, 2})->Args({96, 3, 2})->Args({96, 2, 4})->Args({96, 2, 10})->Iterations(200);
}
BENCHMARK_CAPTURE(steps, one_step, Stepping::one_step)->Apply(many)->Apply(timed);
BENCHMARK_CAPTURE(steps, one_step, Stepping::one_step)->Args({320, 2, 2})->Iterations(20)->Apply(timed);
BENCHMARK_CAPTURE(steps, conservative, Stepping::conservative)->Args({96, 2, 2})->Iterations(100)->Apply(timed);
