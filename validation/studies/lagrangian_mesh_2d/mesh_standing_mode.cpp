#include "validation/studies/lagrangian_mesh_2d/mesh_standing_mode.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/exact/standing_wave.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"

namespace seiche::validation {
namespace {

using namespace lagrangian_mesh_2d;

Layer layer_of(const MeshTank& tank) {
  return {.begin = 0, .end = tank.length(), .depth = 1, .columns = tank.columns, .rows = tank.rows};
}

/// Amplitudes in the mode at t = 0, tau, ... until `time`.
std::vector<double> series(const MeshTank& tank, Flow& flow, double time) {
  const auto steps = static_cast<long>(std::ceil(time / tank.tau));
  std::vector<double> samples{mode_amplitude(tank, flow)};
  for (long n = 0; n < steps; ++n) {
    flow.advance(tank.tau);
    samples.push_back(mode_amplitude(tank, flow));
  }
  return samples;
}

}  // namespace

std::size_t MeshTank::columns_of(double wavenumber, double width, std::size_t half_waves) {
  const double length = std::numbers::pi * static_cast<double>(half_waves) / wavenumber;
  return static_cast<std::size_t>(std::max(1.0, std::round(length / width)));
}

exact::LagrangianMeshDispersion MeshTank::law() const {
  return {1, 1, column_width(), rows,
          tuned_surface_inertia ? exact::SurfaceInertia::tuned : exact::SurfaceInertia::nodal};
}

double MeshTank::linear_frequency() const {
  const bool implicit = scheme.stepping == Stepping::conservative;
  return exact::discrete_frequency(law().frequency(wavenumber), tau,
                                   implicit ? exact::TimeScheme::conservative : exact::TimeScheme::one_step);
}

Settings MeshTank::settings() const {
  return {.hourglass = hourglass, .tuned_surface_inertia = tuned_surface_inertia};
}

double mode_amplitude(const MeshTank& tank, const Flow& flow) {
  const auto y = flow.surface_y();
  const auto columns = static_cast<double>(tank.columns);
  const double phase = std::numbers::pi * static_cast<double>(tank.half_waves) / columns;
  double sum = 0.5 * (y.front() + std::cos(phase * columns) * y.back());
  for (std::size_t i = 1; i < tank.columns; ++i) sum += std::cos(phase * static_cast<double>(i)) * y[i];
  // The shortest wave is its own mirror image: its square sums to the number of columns, not to half of it.
  return sum * (tank.half_waves == tank.columns ? 1 : 2) / columns;
}

Oscillation small_oscillation(const MeshTank& tank, double amplitude, double periods) {
  const double k = tank.wavenumber;
  const double omega = tank.law().frequency(k);
  const double speed = amplitude * omega / tank.law().surface_response(k);
  Flow flow(
      layer_mesh(layer_of(tank)),
      [&](Point r) {
        return Point{0, r.y == 0 ? speed * std::cos(k * r.x) : 0.0};
      },
      tank.scheme, tank.settings());
  return fit_oscillation(series(tank, flow, periods * 2 * std::numbers::pi / omega), tank.tau);
}

double smallest_wave_frequency(const MeshTank& tank, double periods, double amplitude) {
  const double once = small_oscillation(tank, amplitude, periods).frequency;
  const double twice = small_oscillation(tank, 2 * amplitude, periods).frequency;
  return once + (once - twice) / 3;
}

std::unique_ptr<Flow> finite_standing_wave(const MeshTank& tank, double amplitude) {
  const exact::StandingWave wave(amplitude, 2 * std::numbers::pi / tank.wavenumber, 1, 1);
  Layer layer = layer_of(tank);
  layer.elevation = [&](double x) { return wave.elevation(x, 0); };
  return std::make_unique<Flow>(layer_mesh(layer), Flow::Velocity{}, tank.scheme, tank.settings());
}

std::vector<double> finite_series(const MeshTank& tank, double amplitude, double time) {
  return series(tank, *finite_standing_wave(tank, amplitude), time);
}

Oscillation finite_oscillation(const MeshTank& tank, double amplitude, double time) {
  return fit_oscillation(finite_series(tank, amplitude, time), tank.tau, harmonics_of_mode);
}

}  // namespace seiche::validation
