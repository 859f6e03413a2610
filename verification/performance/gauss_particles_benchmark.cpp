// Particle-steps per second of free particles under Gauss's principle: a wave on cubic splines, 36 particles to a cell.
//
//   items_per_second   particles * steps / second
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "verification/performance/work.hpp"

namespace {

using namespace seiche;
using namespace seiche::gauss_particles;

/// A projection, of which one solution is refined twice. Of a particle with cubic splines: moments of the mass matrix
/// (110 operations), and three times load (64), velocity (44) and the difference that is still to be projected (2); its
/// place, mass and velocities, read and written. Of a cell: its matrix from the moments (4800).
performance::Work work_of(const SplineSpace& space, double particles) {
  constexpr double solutions = 3;
  const performance::Work own = particles * performance::pass(3 + solutions * 6, 110 + solutions * 110) +
                                static_cast<double>(space.facts().inner_cells) * performance::pass(0, 4800);
  const linear::FactorWork factor = space.factor_work();
  return own + performance::factorisation(factor) + solutions * performance::substitution(factor);
}

constexpr double length = 2 * std::numbers::pi;
constexpr double bottom = -std::numbers::pi;

Particles water(std::size_t columns, std::size_t rows) {
  return layer({.end = length,
                .columns = columns,
                .rows = rows,
                .surface = [](double x) { return 0.2 * std::cos(x); },
                .bottom = [](double) { return bottom; }});
}

LatticePlan plan(std::size_t cells, bool shift) {
  return {.cell_x = length / static_cast<double>(cells),
          .left_wall = 0.0,
          .period = length,
          .bottom = true,
          .ground = {.level = bottom},
          .shift = shift};
}

void show(benchmark::State& state, const SplineSpace& space, std::size_t particles) {
  state.counters["unknowns"] = static_cast<double>(space.facts().unknowns);
  performance::show(state, particles, work_of(space, static_cast<double>(particles)));
}

/// Cells to a wavelength, threads; the lattice is shifted at random at every step.
void wave_steps(benchmark::State& state) {
  const std::size_t cells = performance::count_of(state);
  const double h = length / static_cast<double>(cells);
  const performance::Threads threads(state.range(1));
  auto space = std::make_unique<SplineSpace>(plan(cells, true));
  const SplineSpace& splines = *space;
  Flow flow(water(6 * cells, 3 * cells), std::move(space), [](Point r) {
    const double speed = 0.2 * std::exp(r.y);
    return Point{speed * std::cos(r.x), speed * std::sin(r.x)};
  });
  flow.advance(0.2 * h);  // the analysis
  for (auto _ : state) flow.advance(0.2 * h);
  show(state, splines, flow.model().size());
}

BENCHMARK(wave_steps)->ArgsProduct({{20, 40, 80, 240}, {1, 2}})->Unit(benchmark::kMillisecond)->UseRealTime();

/// One projection: placing the particles, which factorises, and solving. Cells to a wavelength.
void projection(benchmark::State& state) {
  const std::size_t cells = performance::count_of(state);
  const Particles at = water(3 * cells, 3 * cells / 2);
  SplineSpace space(plan(cells, false));
  std::vector<double> u, v;
  const auto project = [&] {
    u = at.x;
    v = at.y;
    space.place({0, 0}, at.x, at.y, at.mass, 0);
    space.project(u, v);
  };
  project();  // the analysis
  for (auto _ : state) project();
  show(state, space, at.size());
}

BENCHMARK(projection)->Arg(120)->Arg(240)->Arg(440)->Unit(benchmark::kMillisecond);

}  // namespace
