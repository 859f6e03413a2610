// Particle-steps per second of weakly compressible SPH: the dam break of figure 2 at its beginning, column 1 x 2, tank
// 4 long, kernel cubic, h = 1.3 dx.
//
//   items_per_second  particles (walls too) x steps / second
//   interactions      ordered pairs of particles within each other's support, one of them fluid, per second: two
//                     evaluations per step; with turbulence the pass for the strain is not counted
//
// Arguments: particles across the column (50: 6100 particles as in the figure; 690: a million), threads.
#include <benchmark/benchmark.h>

#include <cmath>

#include <omp.h>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"

namespace {

using namespace seiche::wcsph;

void dam_break_steps(benchmark::State& state, Settings settings) {
  const auto across = static_cast<double>(state.range(0));
  omp_set_num_threads(static_cast<int>(state.range(1)));
  constexpr double width = 0.057;
  settings.sound_speed = sound_speed_for(settings.gravity, 4 * width);
  const Scene scene = dam_break({.width = width,
                                 .height = 2 * width,
                                 .tank_length = 4 * width,
                                 .wall_height = 3.5 * width,
                                 .spacing = width / across},
                                settings);
  Flow flow(scene.particles, scene.spacing, settings);
  for (int step = 0; step < 10; ++step) flow.advance();
  const long long before = flow.extremes().interactions;
  for (auto _ : state) flow.advance();
  state.SetItemsProcessed(state.iterations() * static_cast<long>(flow.particles().size()));
  state.counters["interactions"] =
      benchmark::Counter(static_cast<double>(flow.extremes().interactions - before), benchmark::Counter::kIsRate);
  state.counters["particles"] = static_cast<double>(flow.particles().size());
}

const Settings standard{.viscosity = ArtificialViscosity{0.3}};
const Settings diffusive{.viscosity = ArtificialViscosity{0.3}, .density_diffusion = 0.1};
const Settings extrapolated{.viscosity = ArtificialViscosity{0.3}, .walls = WallPressure::extrapolated};
const Settings filtered{.viscosity = ArtificialViscosity{0.3}, .filter_every = 1};
const Settings shifting{.viscosity = ArtificialViscosity{0.3}, .particle_shifting = true};

BENCHMARK_CAPTURE(dam_break_steps, artificial_viscosity, standard)
    ->Args({50, 1})
    ->Args({50, 2})
    ->Args({690, 1})
    ->Args({690, 2})
    ->UseRealTime();
BENCHMARK_CAPTURE(dam_break_steps, laminar_and_sps, Settings{.viscosity = LaminarSps{}})
    ->Args({50, 1})
    ->Args({50, 2})
    ->Args({690, 1})
    ->Args({690, 2})
    ->UseRealTime();

BENCHMARK_CAPTURE(dam_break_steps, density_diffusion, diffusive)->Args({50, 1})->Args({50, 2})->UseRealTime();
BENCHMARK_CAPTURE(dam_break_steps, extrapolated_walls, extrapolated)->Args({50, 1})->Args({50, 2})->UseRealTime();
BENCHMARK_CAPTURE(dam_break_steps, filter_every_step, filtered)->Args({50, 1})->Args({50, 2})->UseRealTime();
BENCHMARK_CAPTURE(dam_break_steps, particle_shifting, shifting)->Args({50, 1})->Args({50, 2})->UseRealTime();

/// Rates alone.
void dam_break_rates(benchmark::State& state) {
  const auto across = static_cast<double>(state.range(0));
  omp_set_num_threads(1);
  constexpr double width = 0.057;
  Settings settings;
  settings.viscosity = ArtificialViscosity{0.3};
  settings.sound_speed = sound_speed_for(settings.gravity, 4 * width);
  const Scene scene = dam_break({.width = width,
                                 .height = 2 * width,
                                 .tank_length = 4 * width,
                                 .wall_height = 3.5 * width,
                                 .spacing = width / across},
                                settings);
  Flow flow(scene.particles, scene.spacing, settings);
  const long long before = flow.extremes().interactions;
  for (auto _ : state) benchmark::DoNotOptimize(flow.rates());
  state.counters["interactions"] =
      benchmark::Counter(static_cast<double>(flow.extremes().interactions - before), benchmark::Counter::kIsRate);
}
BENCHMARK(dam_break_rates)->Arg(50)->Arg(690)->UseRealTime();

}  // namespace
