#include "validation/instruments/dispersive_standing_mode.hpp"

#include "validation/instruments/each.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace seiche::validation {
namespace {

using dispersive_shallow_water_1d::Channel;
using dispersive_shallow_water_1d::Markers;

std::vector<double> labels_of(const StandingBox& box) {
  return equal_labels(box.channel(), 0, box.length(), box.cells);
}

/// k x at the label of marker i.
double phase(const StandingBox& box, std::size_t i) {
  return std::numbers::pi * static_cast<double>(box.half_waves * i) / static_cast<double>(box.cells);
}

/// The elevations' part in the mode, step by step. With equal labels it is orthogonal to all other modes.
Oscillation oscillation(const StandingBox& box, const Markers& start, double periods,
                        const std::vector<int>& harmonics) {
  dispersive_shallow_water_1d::Flow flow(box.channel(), start, box.scheme);
  const double time = periods * 2 * std::numbers::pi / box.law().frequency(box.wavenumber);
  const auto steps = static_cast<long>(std::ceil(time / box.tau));
  std::vector<double> shape;
  for (std::size_t i = 0; i <= box.cells; ++i) {
    const bool wall = i == 0 || i == box.cells;
    shape.push_back((wall ? 1 : 2) * std::cos(phase(box, i)) / static_cast<double>(box.cells));
  }
  std::vector<double> samples;
  for (long n = 0; n <= steps; ++n) {
    if (n > 0) flow.advance(box.tau);
    samples.push_back(std::inner_product(shape.begin(), shape.end(), flow.y().begin(), 0.0));
  }
  return fit_oscillation(samples, box.tau, harmonics);
}

/// Depth over a label: H over dx/da, the derivative by the five-point rule, whose error is (k step)^4/30.
double depth_over(const StandingBox& box, const exact::DispersiveStandingWave& wave, double label) {
  const double step = 1e-3 / box.wavenumber;
  const auto span = [&](double half) { return wave.position(label + half, 0) - wave.position(label - half, 0); };
  return box.depth * 12 * step / (8 * span(step) - span(2 * step));
}

/// Markers at rest with these depths, all changed by the same amount, in cells of the volume that they have in flat
/// water.
Markers equal_cells(const StandingBox& box, std::vector<double> depths) {
  const double volume = box.spacing() * box.depth;
  const auto width = [&](std::size_t j) { return 2 * volume / (depths[j] + depths[j + 1]); };
  constexpr int iterations = 5;  // of Newton's method, from an excess of the order of the spacing's square
  for (int iteration = 0; iteration < iterations; ++iteration) {
    double excess = -box.length();
    double slope = 0;
    for (std::size_t j = 0; j < box.cells; ++j) {
      excess += width(j);
      slope += width(j) * width(j) / volume;
    }
    for (double& depth : depths) depth += excess / slope;
  }
  Markers markers;
  markers.x.push_back(0);
  for (std::size_t j = 0; j < box.cells; ++j) markers.x.push_back(markers.x.back() + width(j));
  for (const double depth : depths) markers.y.push_back(depth - box.depth);
  markers.u.assign(depths.size(), 0.0);
  markers.v = markers.u;
  return markers;
}

}  // namespace

std::size_t StandingBox::cells_of(double wavenumber, double spacing) {
  return static_cast<std::size_t>(std::max(2.0, std::round(std::numbers::pi / (wavenumber * spacing))));
}

Channel StandingBox::channel() const {
  return {.bottom = std::make_shared<LevelBottom>(depth),
          .gravity = gravity,
          .alpha = alpha,
          .slope_energy = slope_energy,
          .gamma = gamma,
          .depth_power = depth_power,
          .reference_depth = depth};
}

exact::FrankDispersion StandingBox::law() const {
  return {gravity, depth, spacing(), {.alpha = alpha, .beta = 0.5 * (1 - slope_energy), .gamma = gamma}};
}

double StandingBox::linear_frequency() const {
  const bool implicit = scheme.stepping == dispersive_shallow_water_1d::Stepping::conservative;
  return exact::discrete_frequency(law().frequency(wavenumber), tau,
                                   implicit ? exact::TimeScheme::conservative : exact::TimeScheme::one_step);
}

exact::DispersiveStandingWave::Parameters StandingBox::wave_parameters() const {
  return {.alpha = alpha, .gamma = gamma, .weight_exponent = depth_power};
}

Oscillation small_oscillation(const StandingBox& box, double amplitude, double periods) {
  Markers start = still_markers(box.channel(), labels_of(box));
  const double rate = amplitude * box.law().frequency(box.wavenumber);
  const double lever = 0.5 * box.spacing() / (box.depth * std::tan(0.5 * box.wavenumber * box.spacing()));
  for (std::size_t i = 0; i < start.size(); ++i) {
    start.v[i] = rate * std::cos(phase(box, i));
    start.u[i] = -rate * lever * std::sin(phase(box, i));
  }
  start.u.front() = 0;
  start.u.back() = 0;
  return oscillation(box, start, periods, {1});
}

double smallest_wave_frequency(const StandingBox& box, double periods, double relative_amplitude) {
  const double once = small_oscillation(box, relative_amplitude * box.depth, periods).frequency;
  const double twice = small_oscillation(box, 2 * relative_amplitude * box.depth, periods).frequency;
  return once + (once - twice) / 3;
}

Oscillation finite_oscillation(const StandingBox& box, double amplitude, double periods) {
  const exact::DispersiveStandingWave wave(amplitude, 2 * std::numbers::pi / box.wavenumber, box.depth, box.gravity,
                                           box.wave_parameters());
  const std::vector<double> depths =
      each(labels_of(box), [&](const double label) { return depth_over(box, wave, label); });
  return oscillation(box, equal_cells(box, std::move(depths)), periods, {1, 3});
}

}  // namespace seiche::validation
