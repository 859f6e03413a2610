#include "seiche/exact/pressure_forced_wave.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/exact/overturning/initial.hpp"
#include "seiche/exact/stokes_wave.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

namespace ow = overturning;

namespace {

static_assert(ReferenceSolution<PressureForcedWave>);

/// Frank's last frame, in units of 1/sqrt(g k).
constexpr double last_frame = 7.4;
constexpr double switched_off = std::numbers::pi;

const PressureForcedWave::Parameters& checked(const PressureForcedWave::Parameters& p) {
  require_positive("wavelength", p.wavelength);
  require_positive("gravity", p.gravity);
  require_positive("tolerance", p.tolerance);
  require_positive("depth", std::isinf(p.depth) && p.depth > 0 ? p.wavelength : p.depth);
  // As of Stokes waves; the markers must be closer to each other than to the bottom.
  if (2 * std::numbers::pi * p.depth < 0.2 * p.wavelength) {
    throw std::invalid_argument(
        fmt::format("depth = {:g} is out of range: must be at least 0.2 wavelength/(2 pi) = {:g}", p.depth,
                    0.1 * p.wavelength / std::numbers::pi));
  }
  require_within("amplitude", p.amplitude, 0, p.wavelength);
  require_positive("amplitude + |pressure|/gravity", p.amplitude + std::abs(p.pressure) / p.gravity);
  require_within("k pressure/gravity", 2 * std::numbers::pi / p.wavelength * p.pressure / p.gravity, -1, 1);
  require_at_least("markers", static_cast<long>(p.markers), 64);
  require_within("markers modulo 2", static_cast<double>(p.markers % 2), 0, 0);
  if (p.last_time) require_positive("last_time", *p.last_time);
  return p;
}

/// In scaled units.
double surface_pressure(double strength, double x, double t) {
  return t <= switched_off ? -strength * std::sin(t) * std::sin(x - t) : 0;
}

}  // namespace

PressureForcedWave::PressureForcedWave(const Parameters& parameters)
    : MovingSurface(checked(parameters).wavelength, parameters.gravity), parameters_(parameters) {
  const double depth = parameters_.depth / length();
  ow::State start = ow::still_water(parameters_.markers);
  if (parameters_.amplitude > 0) {
    const StokesWave wave(parameters_.amplitude / length(), 2 * std::numbers::pi, depth, 1);
    start = ow::from_functions(
        parameters_.markers, [&](double x) { return wave.elevation(x); },
        [&](double x) { return wave.surface_potential(x); });
    kinetic_energy_ = wave.kinetic_energy() * parameters_.wavelength * length() * velocity() * velocity();
  }
  const double strength = parameters_.pressure / (velocity() * velocity());
  const double last_time = parameters_.last_time.value_or(last_frame * time_unit());
  auto motion =
      std::make_shared<ow::Evolution>(std::move(start), depth, parameters_.tolerance,
                                      [strength](double x, double t) { return surface_pressure(strength, x, t); });
  const double end = last_time / time_unit();
  motion->advance_to(std::min(switched_off, end));
  motion->advance_to(end);
  keep(std::move(motion), last_time, [unit = time_unit()](double) { return 0.4 * unit; });
}

double PressureForcedWave::pressure(double x, double t) const {
  return surface_pressure(parameters_.pressure, x / length(), t / time_unit());
}

PressureForcedWave::Action PressureForcedWave::action(double t) const {
  const ow::Moment moment = evolution().at(scaled_time(t));
  const auto sums = ow::by_pressure(moment.state);
  const double area = length() * length();
  return {area * velocity() * velocity() * sums.work, area * velocity() * sums.thrust};
}

double PressureForcedWave::linear_response(double x, double t) const {
  const double T = std::tanh(parameters_.depth / length());
  const double w = std::sqrt(T);
  const double head = parameters_.pressure / parameters_.gravity;
  const double A = T * head / (2 * (T - 4));
  const std::complex<double> i(0, 1);
  const double scaled = t / time_unit();
  const double forced = std::min(scaled, switched_off);
  const std::complex<double> turning = A * std::exp(-2.0 * i * forced);
  const std::complex<double> cosine = 0.5 * head - A;
  const std::complex<double> sine = 2.0 * i * A / w;
  const std::complex<double> N = -0.5 * head + turning + cosine * std::cos(w * forced) + sine * std::sin(w * forced);
  const std::complex<double> rate =
      -2.0 * i * turning + w * (sine * std::cos(w * forced) - cosine * std::sin(w * forced));
  const double free = w * (scaled - forced);
  return ((N * std::cos(free) + rate / w * std::sin(free)) * std::exp(i * x / length())).real();
}

double PressureForcedWave::scale() const {
  return parameters_.amplitude + std::abs(parameters_.pressure) / parameters_.gravity;
}

double PressureForcedWave::uncertainty() const {
  return uncertainty(well_resolved_until());
}

double PressureForcedWave::uncertainty(double t) const {
  Parameters coarser = parameters_;
  coarser.markers = std::max<std::size_t>(64, parameters_.markers * 3 / 8 * 2);
  coarser.tolerance = 10 * parameters_.tolerance;
  coarser.last_time = std::max(t, time_unit() * 1e-3);
  return distance_from(PressureForcedWave(coarser), t) / scale();
}

SelfTest PressureForcedWave::self_test() const {
  SelfTest identities;
  if (kinetic_energy_) {
    identities.push_back(
        {"kinetic energy at t = 0 is that of the Stokes wave",
         std::abs(integrals(0).kinetic_energy / *kinetic_energy_ - 1), 1e-13,
         "integral equation solved to 1e-15, kernels rounded at neighbouring markers 0.01 apart; Stokes wave to "
         "1e-14"});
  }
  std::ranges::move(balances(scale(), parameters_.tolerance), std::back_inserter(identities));
  return identities;
}

Provenance PressureForcedWave::provenance() {
  return {
      "Longuet-Higgins & Cokelet, The deformation of steep surface waves on water I, Proc. R. Soc. Lond. A 350 (1976) "
      "1",
      "dz/dt = conj f, dphi/dt = |f|^2/2 - g y - p_s, z_s f = phi_s + i psi_s with psi_s from Cauchy's integral; "
      "Stokes "
      "wave at t = 0; p_s = -p0 sin wt sin(kx - wt), w = sqrt(gk), 0 <= wt <= pi"};
}

}  // namespace seiche::exact
