// Particle-steps per second of weakly compressible SPH: the dam break of figure 2 at its beginning, column 1 x 2, tank
// 4 long, kernel cubic, h = 1.3 dx.
//
//   items_per_second  particles (walls too) x steps / second
//   bytes_per_particle  that the flow holds after its steps, all arrays and lists
//   interactions      ordered pairs of particles within each other's support, one of them fluid, per second: two
//                     evaluations per step; with turbulence the pass for the strain is not counted
//
// Arguments: particles across the column (50: 6100 particles as in the figure; 690: a million), threads.
#include <benchmark/benchmark.h>

#include <variant>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "verification/live_memory.hpp"
#include "verification/performance/work.hpp"

namespace {

namespace performance = seiche::performance;
namespace verification = seiche::verification;
using namespace seiche::wcsph;

/// Operations of an ordered pair in an evaluation: distances (24), kernel (13), rates with artificial viscosity (27).
/// With eddies their stresses (25) and a pass for the strain (38) come in its place (5) and laminar viscosity; with
/// density diffusion two passes more (34, 36). Filter and shifting have theirs once in a step, of two evaluations.
double operations_per_pair(const Settings& settings) {
  double operations = 64;
  if (std::holds_alternative<LaminarSps>(settings.viscosity)) operations += 12 + 13 + 38 - 5;
  if (settings.density_diffusion > 0) operations += 34 + 36;
  if (settings.filter_every > 0) operations += 43 / 2.0;
  if (settings.particle_shifting) operations += (32 + 60) / 2.0;
  return operations;
}

/// Runs the benchmark.
template <class Step>
double interactions_per_step(benchmark::State& state, const Flow& flow, const Step& step) {
  const long long before = flow.extremes().interactions;
  for (auto _ : state) step();
  const auto interactions = static_cast<double>(flow.extremes().interactions - before);
  state.counters["interactions"] = benchmark::Counter(interactions, benchmark::Counter::kIsRate);
  return interactions / static_cast<double>(state.iterations());
}

/// Sets the speed of sound.
Scene column(long across, Settings& settings) {
  constexpr double width = 0.057;
  settings.sound_speed = sound_speed_for(settings.gravity, 4 * width);
  return dam_break({.width = width,
                    .height = 2 * width,
                    .tank_length = 4 * width,
                    .wall_height = 3.5 * width,
                    .spacing = width / static_cast<double>(across)},
                   settings);
}

void dam_break_steps(benchmark::State& state, Settings settings) {
  const performance::Threads threads(state.range(1));
  const Scene scene = column(state.range(0), settings);
  const double held = verification::live_bytes();
  Flow flow(scene.particles, scene.spacing, settings);
  for (int step = 0; step < 10; ++step) flow.advance(flow.stable_step());
  const double interactions = interactions_per_step(state, flow, [&] { flow.advance(flow.stable_step()); });
  const auto particles = static_cast<double>(flow.particles().size());
  state.counters["particles"] = particles;
  state.counters["bytes_per_particle"] = (verification::live_bytes() - held) / particles;
  // Of a particle in an evaluation: the state is read, and its record, a cache line, is rewritten (18 operations); the
  // record is read, and rates written; state and rates are read and the new state is written (10). Records of
  // neighbours are in the cache; lists of candidates are a few bytes.
  performance::show(state, flow.particles().size(),
                    (2 * particles) * performance::pass(5 + 8 + 8 + 5 + 5 + 10, 28) +
                        performance::Work{0, interactions * operations_per_pair(settings)});
}

constexpr ArtificialViscosity some{0.3};
const Settings standard{.viscosity = some};
const Settings diffusive{.viscosity = some, .density_diffusion = 0.1};
const Settings extrapolated{.viscosity = some, .walls = WallPressure::extrapolated};
const Settings filtered{.viscosity = some, .filter_every = 1};
const Settings shifting{.viscosity = some, .particle_shifting = true};

void small(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgsProduct({{50}, {1, 2}})->UseRealTime();
}
void small_and_large(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgsProduct({{50, 690}, {1, 2}})->UseRealTime();
}

BENCHMARK_CAPTURE(dam_break_steps, artificial_viscosity, standard)->Apply(small_and_large);
BENCHMARK_CAPTURE(dam_break_steps, laminar_and_sps, Settings{.viscosity = LaminarSps{}})->Apply(small_and_large);
BENCHMARK_CAPTURE(dam_break_steps, density_diffusion, diffusive)->Apply(small);
BENCHMARK_CAPTURE(dam_break_steps, extrapolated_walls, extrapolated)->Apply(small);
BENCHMARK_CAPTURE(dam_break_steps, filter_every_step, filtered)->Apply(small);
BENCHMARK_CAPTURE(dam_break_steps, particle_shifting, shifting)->Apply(small);

/// Rates alone.
void dam_break_rates(benchmark::State& state) {
  const performance::Threads threads(1);
  Settings settings = standard;
  const Scene scene = column(state.range(0), settings);
  Flow flow(scene.particles, scene.spacing, settings);
  const double interactions = interactions_per_step(state, flow, [&] { benchmark::DoNotOptimize(flow.rates()); });
  const std::size_t particles = flow.particles().size();
  // Without the move, but the rates are copied.
  performance::show(state, particles,
                    static_cast<double>(particles) * performance::pass(5 + 8 + 8 + 5 + 10, 18) +
                        performance::Work{0, interactions * operations_per_pair(settings)});
}
BENCHMARK(dam_break_rates)->Arg(50)->Arg(690)->UseRealTime();

}  // namespace
