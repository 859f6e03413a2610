// Parts of a step of overlapping particles: a disc of n spacings to the radius, turned and sheared by one eddy.
//
//   items_per_second   particles / second; its inverse is the time per particle
//   analyses           of the matrix's pattern, per step
#include <benchmark/benchmark.h>

#include <numbers>

#include "seiche/models/overlapping_particles/flow.hpp"
#include "verification/performance/work.hpp"

namespace {

using namespace seiche;
using namespace seiche::overlapping_particles;

/// Of a ring: the particles in a support.
const double members = std::numbers::pi * Settings().support * Settings().support;

Particles disc(int n) {
  return staggered_disc(1, 1.0 / n);
}

Point eddy(Point r) {
  const double turning = 1 - r.x * r.x - r.y * r.y;
  return {-turning * r.y, turning * r.x};
}

/// Whether the lists still hold all pairs, on the cell grid.
void neighbours(benchmark::State& state) {
  const Particles p = disc(static_cast<int>(state.range(0)));
  const double reach = Settings().support * p.spacing;
  const Walls walls({}, reach);
  Neighbourhoods near(reach);
  near.update(p.x, p.y, walls);
  for (auto _ : state) benchmark::DoNotOptimize(near.update(p.x, p.y, walls));
  performance::show_not_counted(state, p.size(), "branching");
}

/// Gradients, assembly and factor at a configuration that stays: no new pattern.
void linearisation(benchmark::State& state) {
  Model model(disc(static_cast<int>(state.range(0))));
  const mechanics::State start = model.state();
  model.linearise({}, start.q);
  for (auto _ : state) model.linearise({}, start.q);
  performance::show(state, model.size(), performance::ring_pressures(model, model.size(), members, 0));
}

/// Whole steps of a fifth of the spacing. Counted are the multipliers; the search for neighbours branches.
void steps(benchmark::State& state) {
  const auto n = static_cast<int>(state.range(0));
  Flow flow(disc(n), eddy);
  const long before = flow.model().solver().analyses();
  for (auto _ : state) flow.advance(0.2 / n);
  const Model& model = flow.model();
  state.counters["analyses"] =
      static_cast<double>(model.solver().analyses() - before) / static_cast<double>(state.iterations());
  performance::show(state, model.size(), performance::ring_pressures(model, model.size(), members, 1));
}

BENCHMARK(neighbours)->Arg(20)->Arg(50)->Arg(180)->Unit(benchmark::kMillisecond);
BENCHMARK(linearisation)->Arg(20)->Arg(50)->Arg(180)->Unit(benchmark::kMillisecond);
BENCHMARK(steps)->Arg(20)->Arg(50)->Arg(180)->Unit(benchmark::kMillisecond)->Iterations(4);

}  // namespace
