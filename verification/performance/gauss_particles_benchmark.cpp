// Particle-steps per second of free particles under Gauss's principle: a wave on cubic splines, 36 particles to a cell.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

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

/// One projection: placing the particles, which factorises, and solving. Cells to a wavelength, and whether by
/// iteration.
void projection(benchmark::State& state) {
  const double length = 2 * std::numbers::pi;
  const auto cells = static_cast<std::size_t>(state.range(0));
  const Particles water = layer({.begin = 0,
                                 .end = length,
                                 .columns = 3 * cells,
                                 .rows = 3 * cells / 2,
                                 .surface = [](double x) { return 0.2 * std::cos(x); },
                                 .bottom = [](double) { return -std::numbers::pi; }});
  SplineSpace space({.cell_x = length / static_cast<double>(cells),
                     .left_wall = 0.0,
                     .period = length,
                     .bottom = true,
                     .ground = {.level = -std::numbers::pi}},
                    {.iterate_above = state.range(1) != 0 ? 0UL : 1000000UL});
  std::vector<double> u;
  std::vector<double> v;
  const auto project = [&] {
    u = water.x;
    v = water.y;
    space.place({0, 0}, water.x, water.y, water.mass, 0);
    space.project(u, v);
  };
  project();  // the analysis, or the lattice's modes
  for (auto _ : state) project();
  state.SetItemsProcessed(state.iterations() * static_cast<long>(water.size()));
  state.counters["unknowns"] = static_cast<double>(space.facts().unknowns);
}

BENCHMARK(projection)->ArgsProduct({{120, 240, 440}, {0, 1}})->Unit(benchmark::kMillisecond);

}  // namespace
