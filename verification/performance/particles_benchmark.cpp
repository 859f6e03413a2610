// Particle-steps per second of the conservative particle method: levels G1, M2, H2, in cache and out of it.
//
// The flow is a gentle standing wave between walls, so that no limiter or jump makes the work uneven; a dam break adds
// the cost of jumps for H2.
#include <cmath>
#include <numbers>

#include <benchmark/benchmark.h>

#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "verification/performance/work.hpp"

namespace {

using namespace seiche::shallow_water_particles;
namespace performance = seiche::performance;

Particles standing_wave(std::size_t count) {
  return particles_from_profile(
      equal_width_edges(0, 1, count), [](double x) { return 1 + 0.05 * std::cos(2 * std::numbers::pi * x); },
      [](double) { return 0.0; });
}

/// As the algorithm needs it: edges, velocities (read and written), masses and their inverses (read) are 8 doubles; two
/// curves, their slopes and four Newton steps of one Riemann problem are about 110 operations, reconstruction and
/// predictor about 60.
void count_work(benchmark::State& state, std::size_t particles, double operations) {
  performance::show(state, particles, static_cast<double>(particles) * performance::pass(8, operations));
}

void standing_wave_steps(benchmark::State& state, Level level) {
  const std::size_t count = performance::count_of(state);
  const performance::Threads threads(state.range(1));
  ParticleFlow flow(standing_wave(count), {}, {}, {.level = level});
  // A step safely below the limit at all phases of the wave; recomputing it is the caller's cost, not the kernel's.
  const double tau = 0.8 * flow.largest_step().tau;
  for (auto _ : state) flow.advance(tau);
  count_work(state, count, level == Level::godunov ? 110 : 170);
}

void dam_break_steps(benchmark::State& state) {
  const std::size_t count = performance::count_of(state);
  ParticleFlow flow(dam_break(0, 0.4, 1, {1, 0}, {0.5, 0}, count));
  const double tau = 0.25 * flow.largest_step().tau;
  for (auto _ : state) flow.advance(tau);
  count_work(state, count, 170);
}

BENCHMARK_CAPTURE(standing_wave_steps, G1, Level::godunov)->Apply(performance::rows_and_threads);
BENCHMARK_CAPTURE(standing_wave_steps, M2, Level::muscl)->Apply(performance::rows_and_threads);
BENCHMARK_CAPTURE(standing_wave_steps, H2, Level::hand_over)->Apply(performance::rows_and_threads);
BENCHMARK(dam_break_steps)->Name("dam_break_steps/H2")->Arg(1000)->Arg(10000);

}  // namespace
