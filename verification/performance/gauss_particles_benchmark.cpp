// Particle-steps per second of free particles under Gauss's principle: a wave on cubic splines, 36 particles to a cell.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"

namespace {

using namespace seiche;
using namespace seiche::gauss_particles;

/// Cells to a wavelength; the lattice is shifted at random at every step.
void wave_steps(benchmark::State& state) {
  const double length = 2 * std::numbers::pi;
  const double h = length / static_cast<double>(state.range(0));
  const auto cells = static_cast<std::size_t>(state.range(0));
  Flow flow(layer({.begin = 0,
                   .end = length,
                   .columns = 6 * cells,
                   .rows = 3 * cells,
                   .surface = [](double x) { return 0.2 * std::cos(x); },
                   .bottom = [](double) { return -std::numbers::pi; }}),
            std::make_unique<SplineSpace>(LatticePlan{.cell_x = h,
                                                      .left_wall = 0.0,
                                                      .period = length,
                                                      .bottom = true,
                                                      .ground = {.level = -std::numbers::pi},
                                                      .shift = true}),
            [](Point r) {
              const double speed = 0.2 * std::exp(r.y);
              return Point{speed * std::cos(r.x), speed * std::sin(r.x)};
            });
  for (auto _ : state) flow.advance(0.2 * h);
  state.SetItemsProcessed(state.iterations() * static_cast<long>(flow.model().size()));
  state.counters["unknowns"] = static_cast<double>(flow.model().space().facts().unknowns);
}

BENCHMARK(wave_steps)->Arg(20)->Arg(40)->Arg(80)->Arg(240)->Unit(benchmark::kMillisecond);

}  // namespace
