// A step of particles of variable mass: a solitary hump in a channel 40 depths long, nodes at fixed x.
//
//   items_per_second   nodes / second; its inverse is the time per node
//   iterations         of the convective term per step
#include <benchmark/benchmark.h>

#include <cmath>

#include "seiche/models/variable_mass/flow.hpp"
#include "verification/performance/work.hpp"

namespace {

using namespace seiche;
using namespace seiche::variable_mass;

/// Counted are the pressures, solved for in every iteration of the convective term; flips and geometry branch.
void variable_mass_steps(benchmark::State& state) {
  const auto rows = static_cast<int>(state.range(0));
  const auto hump = [](double x) { return 0.1 / std::pow(std::cosh(0.26 * (x - 20)), 2); };
  Flow flow(free_lagrangian::layer_mesh({.end = 40, .columns = 40 * rows, .rows = rows}),
            {.elevation = hump,
             .velocity =
                 [&](Point r) {
                   return Point{hump(r.x), 0};
                 }},
            {ControlKind::fixed_x, 1, 1}, {.stabilisation = 0.01});
  for (auto _ : state) flow.advance(0.4 / rows);
  const double iterations = static_cast<double>(flow.iterations()) / static_cast<double>(flow.steps());
  state.counters["iterations"] = iterations;
  const std::size_t nodes = flow.water().nodes();
  performance::show(state, nodes,
                    performance::ring_pressures(flow.water(), nodes, performance::triangulated, iterations));
}

BENCHMARK(variable_mass_steps)->Arg(8)->Arg(16)->Arg(50)->Unit(benchmark::kMillisecond)->Iterations(8);

}  // namespace
