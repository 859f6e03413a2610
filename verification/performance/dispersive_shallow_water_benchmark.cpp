// Marker-steps per second of the dispersive shallow-water model.
//
//   items_per_second     markers x steps / second
//   bytes_per_step, operations_per_step   work.hpp: arrays that the scheme has to read or write once, whatever the
//                        code does beyond that
//
// Channels: level between walls, level and periodic, and a plane beach with a shoreline at its end. Schemes: A
// one-step, B one-step with feedback, C conservative with three sweeps.
#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "seiche/exact/model_waves.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "verification/performance/work.hpp"

namespace {

using namespace seiche;
using namespace seiche::dispersive_shallow_water_1d;

constexpr double spacing = 0.25;
constexpr double tau = 0.05;
constexpr int sweeps = 3;
constexpr double toe = -20;  // of the beach, slope 1:20

enum class Site { walls, periodic, beach };

/// A solitary wave in water of depth 1 with n markers, still far from the beach.
Flow start(Site site, std::size_t n, Scheme scheme) {
  const SolitaryStart wave{.amplitude = 0.1, .crest = -50};
  const double length = spacing * static_cast<double>(n);
  if (site == Site::beach) {
    const double begin = -spacing * static_cast<double>(n - 1);
    const Channel channel{.bottom = std::make_shared<PiecewiseLinearBottom>(std::vector<double>{begin - 100, toe, -toe},
                                                                            std::vector<double>{-1, -1, 1}),
                          .left = End::wall,
                          .right = End::tip};
    return {channel, solitary_markers(channel, begin, 0, spacing, wave), scheme};
  }
  const Channel channel{.bottom = std::make_shared<LevelBottom>(1.0), .period = site == Site::periodic ? length : 0};
  return {channel, solitary_markers(channel, -length / 2, length / 2, spacing, wave), scheme};
}

/// Arrays of a step with A: x, y, p, r read and written, 1/m and 1/(alpha m) read, two rows of the elimination written
/// and read again, multipliers written: 8 + 2 + 4 + 1. B also reads the rest volumes. A sweep of C: x, y, p, r read,
/// their values at the end and at the middle read and written, the rest as before: 4 + 8 + 2 + 4 + 1; four more per
/// step.
///
/// Operations on a level bottom: predictor 4, widths and means 3, gravity 20, diagonal 12, coupling 8, kick 6, rates of
/// cells 11, elimination and substitution 9, reaction 13, reflection 4, advance 4. B: defects of volumes 5. A sweep of
/// C: middle and motion 6, mean of the force over the motion 27, the rest without predictor and reflection: 119; 12
/// more per step. On a slope, per solve: bottom and frames 16, mobilities 15, and 42 where gradients and rates are
/// turned.
performance::Work work_of(Stepping stepping, double sloping) {
  constexpr double turning = 16 + 15 + 42;
  switch (stepping) {
    case Stepping::one_step:
      return performance::pass(15, 94 + turning * sloping);
    case Stepping::one_step_feedback:
      return performance::pass(16, 99 + turning * sloping);
    case Stepping::conservative:
      return performance::pass(sweeps * 19 + 4, sweeps * (119 + turning * sloping) + 12);
  }
  return {};
}

void marker_steps(benchmark::State& state, Site site, Stepping stepping) {
  const Scheme scheme{.stepping = stepping, .fixed_sweeps = stepping == Stepping::conservative ? sweeps : 0};
  const performance::Threads threads(state.range(1));
  Flow flow = start(site, performance::count_of(state), scheme);
  const auto markers = static_cast<double>(flow.x().size());
  // A wave that reached the shore would change the work: begin again in time.
  constexpr double longest_time = 20;
  for (auto _ : state) {
    flow.advance(tau);
    if (flow.time() > longest_time) {
      state.PauseTiming();
      flow = start(site, performance::count_of(state), scheme);
      state.ResumeTiming();
    }
  }
  performance::show(state, flow.x().size(),
                    markers * work_of(stepping, site == Site::beach ? -toe / spacing / markers : 0));
  benchmark::DoNotOptimize(flow.x().data());
}

/// Markers and threads.
void channels(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({1000, 1})->Args({10000, 1})->Args({1000000, 1});
}
void threaded_channels(benchmark::internal::Benchmark* benchmark) {
  channels(benchmark);
  benchmark->Args({1000000, 2})->UseRealTime();
}

#define SEICHE_MARKER_STEPS(site, stepping, sizes) \
  BENCHMARK_CAPTURE(marker_steps, site##_##stepping, Site::site, Stepping::stepping)->Apply(sizes)

SEICHE_MARKER_STEPS(walls, one_step, threaded_channels);
SEICHE_MARKER_STEPS(walls, one_step_feedback, threaded_channels);
SEICHE_MARKER_STEPS(walls, conservative, threaded_channels);
SEICHE_MARKER_STEPS(periodic, one_step, channels);
SEICHE_MARKER_STEPS(periodic, one_step_feedback, channels);
SEICHE_MARKER_STEPS(periodic, conservative, channels);
SEICHE_MARKER_STEPS(beach, one_step, threaded_channels);
SEICHE_MARKER_STEPS(beach, one_step_feedback, threaded_channels);
SEICHE_MARKER_STEPS(beach, conservative, threaded_channels);

}  // namespace
