// Cost of the exact solitary and Stokes waves: solving one from scratch, and one value at a point. Terms and Newton
// steps are as many as the wave and the place ask for.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "seiche/exact/solitary_wave.hpp"
#include "seiche/exact/stokes_wave.hpp"
#include "verification/performance/work.hpp"

namespace {

using seiche::exact::SolitaryWave;
using seiche::exact::StokesWave;
using seiche::performance::show_not_counted;

constexpr double wavelength = 2 * std::numbers::pi;

/// Positions that do not repeat within a loop, so that no branch is learnt.
double next_place(double x) {
  return std::fmod(x + 0.6180339887, 3.0);
}

void solve_solitary(benchmark::State& state) {
  const double amplitude = static_cast<double>(state.range(0)) / 100;
  for (auto _ : state) benchmark::DoNotOptimize(SolitaryWave(amplitude).froude());
  show_not_counted(state, "adaptive");
}
BENCHMARK(solve_solitary)->Arg(2)->Arg(10)->Arg(30)->Arg(50)->Arg(80)->Arg(83)->Unit(benchmark::kMillisecond);

void solve_stokes_deep(benchmark::State& state) {
  const double amplitude = static_cast<double>(state.range(0)) / 100;
  for (auto _ : state) benchmark::DoNotOptimize(StokesWave(amplitude, wavelength, StokesWave::deep, 1).phase_speed());
  show_not_counted(state, "adaptive");
}
BENCHMARK(solve_stokes_deep)->Arg(10)->Arg(30)->Arg(40)->Arg(44)->Unit(benchmark::kMillisecond);

/// Mean depth prescribed: an outer iteration on the conformal depth; amplitude a fifth of the depth.
void solve_stokes_finite(benchmark::State& state) {
  const double depth = static_cast<double>(state.range(0)) / 10;
  for (auto _ : state) {
    benchmark::DoNotOptimize(StokesWave(0.2 * depth, wavelength, depth, 1).phase_speed());
  }
  show_not_counted(state, "adaptive");
}
BENCHMARK(solve_stokes_finite)->Arg(2)->Arg(5)->Arg(10)->Unit(benchmark::kMillisecond);

template <class Value>
void evaluate(benchmark::State& state, const Value& value) {
  double x = 0;
  for (auto _ : state) {
    x = next_place(x);
    benchmark::DoNotOptimize(value(x));
  }
  show_not_counted(state, "adaptive");
}

template <class Wave>
void evaluate_velocity(benchmark::State& state, const Wave& wave) {
  evaluate(state, [&](double x) { return wave.velocity(x, -0.4); });
}
BENCHMARK_CAPTURE(evaluate_velocity, solitary, SolitaryWave(0.5));
BENCHMARK_CAPTURE(evaluate_velocity, solitary_steep, SolitaryWave(0.83));
BENCHMARK_CAPTURE(evaluate_velocity, stokes_deep, StokesWave(0.3, wavelength, StokesWave::deep, 1));
BENCHMARK_CAPTURE(evaluate_velocity, stokes_finite, StokesWave(0.2, wavelength, 1, 1));

template <class Wave>
void evaluate_elevation(benchmark::State& state, const Wave& wave) {
  evaluate(state, [&](double x) { return wave.elevation(x); });
}
BENCHMARK_CAPTURE(evaluate_elevation, solitary, SolitaryWave(0.5));
BENCHMARK_CAPTURE(evaluate_elevation, stokes_deep, StokesWave(0.3, wavelength, StokesWave::deep, 1));

}  // namespace
