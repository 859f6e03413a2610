#include "seiche/exact/stokes_wave.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "seiche/exact/section_flux.hpp"
#include "seiche/exact/stokes_surface.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

static_assert(ReferenceSolution<StokesWave>);

namespace {

using std::numbers::pi;

/// Wavenumber of a medium in which the wave exists.
double checked_wavenumber(double wavelength, double depth, const char* depth_name, double gravity,
                          Resolution resolution) {
  require_positive("wavelength", wavelength);
  require_positive("gravity", gravity);
  require_within("resolution.refinement", resolution.refinement, 0.5, 2);
  require_within("resolution.clustering", resolution.clustering, 0.25, 4);
  if (!(depth > 0)) require_positive(depth_name, depth);
  const double wavenumber = 2 * pi / wavelength;
  constexpr double shallowest = 0.2;
  if (wavenumber * depth < shallowest) {
    throw std::invalid_argument(
        fmt::format("k {} = {:.17g}, k = 2 pi/wavelength, is out of range: must be at least {}; the crests of longer "
                    "waves are solitary waves: use "
                    "SolitaryWave",
                    depth_name, wavenumber * depth, shallowest));
  }
  return wavenumber;
}

double checked_amplitude(double amplitude, double wavenumber) {
  require_positive("amplitude", amplitude);
  require_within("k amplitude", wavenumber * amplitude, 1e-4, 0.4432);  // the limiting deep wave has 0.44316
  return wavenumber * amplitude;
}

}  // namespace

StokesWave::StokesWave(double amplitude, double wavelength, double mean_depth, double gravity, Resolution resolution)
    : wavenumber_(checked_wavenumber(wavelength, mean_depth, "mean_depth", gravity, resolution)),
      gravity_(gravity),
      celerity_(std::sqrt(gravity / wavenumber_)) {
  surface_ = std::make_shared<const StokesSurface>(StokesSurface::with_mean_depth(
      {checked_amplitude(amplitude, wavenumber_), {}}, wavenumber_ * mean_depth, resolution));
}

StokesWave::StokesWave(std::shared_ptr<const StokesSurface> surface, double wavenumber, double gravity)
    : surface_(std::move(surface)),
      wavenumber_(wavenumber),
      gravity_(gravity),
      celerity_(std::sqrt(gravity / wavenumber)) {}

StokesWave StokesWave::from_conformal_depth(double amplitude, double wavelength, double conformal_depth, double gravity,
                                            Resolution resolution) {
  const double k = checked_wavenumber(wavelength, conformal_depth, "conformal_depth", gravity, resolution);
  return {std::make_shared<const StokesSurface>(
              solve_stokes_wave({checked_amplitude(amplitude, k), {}}, k * conformal_depth, resolution)),
          k, gravity};
}

StokesWave StokesWave::from_crest_speed(double crest_speed, double wavelength, double conformal_depth, double gravity,
                                        Resolution resolution) {
  const double k = checked_wavenumber(wavelength, conformal_depth, "conformal_depth", gravity, resolution);
  require_within("crest_speed", crest_speed, 0.0015, 0.9999);
  return {std::make_shared<const StokesSurface>(solve_stokes_wave({{}, crest_speed}, k * conformal_depth, resolution)),
          k, gravity};
}

double StokesWave::amplitude() const {
  return 0.5 * (crest_elevation() - trough_elevation());
}
double StokesWave::wavelength() const {
  return 2 * pi / wavenumber_;
}
double StokesWave::mean_depth() const {
  return surface_->mean_depth() / wavenumber_;
}
double StokesWave::conformal_depth() const {
  return surface_->solution().conformal_depth / wavenumber_;
}
double StokesWave::phase_speed() const {
  return celerity_ * surface_->speed();
}
double StokesWave::crest_speed() const {
  return std::exp(surface_->solution().log_speed[0]);
}
double StokesWave::bernoulli_constant() const {
  return celerity_ * celerity_ * surface_->bernoulli();
}
double StokesWave::crest_elevation() const {
  return surface_->crest() / wavenumber_;
}
double StokesWave::trough_elevation() const {
  return surface_->trough() / wavenumber_;
}
double StokesWave::crest_velocity() const {
  return -phase_speed() * std::expm1(surface_->solution().log_speed[0]);
}
double StokesWave::impulse() const {
  return celerity_ / wavenumber_ * surface_->integrals().impulse;
}
double StokesWave::kinetic_energy() const {
  return gravity_ / (wavenumber_ * wavenumber_) * surface_->integrals().kinetic_energy;
}
double StokesWave::potential_energy() const {
  return gravity_ / (wavenumber_ * wavenumber_) * surface_->integrals().potential_energy;
}
double StokesWave::maximum_slope() const {
  return surface_->maximum_slope();
}

double StokesWave::elevation(double x) const {
  require_finite("x", x);
  return surface_->elevation(wavenumber_ * x) / wavenumber_;
}

double StokesWave::surface_potential(double x) const {
  require_finite("x", x);
  return celerity_ / wavenumber_ * surface_->potential(wavenumber_ * x);
}

Velocity StokesWave::velocity(double x, double y) const {
  require_finite("x", x);
  require_finite("y", y);
  const Velocity scaled = surface_->velocity(wavenumber_ * x, wavenumber_ * y);
  return {celerity_ * scaled.u, celerity_ * scaled.v};
}

Provenance StokesWave::provenance() {
  return {
      "Schwartz, Computer extension and analytic continuation of Stokes' expansion for gravity waves, J. Fluid Mech. "
      "62 (1974) 553; Cokelet, Steep gravity waves in water of arbitrary uniform depth, Phil. Trans. R. Soc. A 286 "
      "(1977) 183; Longuet-Higgins, Integral properties of periodic gravity waves, Proc. R. Soc. A 342 (1975) 157",
      "theta = T tau with the symbol -i tanh(k d), c^2/2 d(q^2)/dphi + sin(theta)/q = 0, q = exp(tau), "
      "int cos(theta)/q dphi = 2 pi; f = c (1 - dW/dz) inside by a quotient of Cauchy sums"};
}

double StokesWave::uncertainty() const {
  // q^2 = 2 (B - y)/c^2 is a difference near the limiting wave: its rounding is divided by 2 q.
  constexpr double rounding = 1e-14;
  const double steep = std::max(1.0, 0.5 / crest_speed());
  const double gentle = std::max(1.0, 0.01 / surface_->crest());  // y is a difference of Bernoulli's constant
  return rounding * steep * gentle;
}

SelfTest StokesWave::self_test() const {
  const auto& integrals = surface_->integrals();
  const double c = surface_->speed();
  const double limit = 5 * uncertainty();
  const double scale = std::max(2 * integrals.kinetic_energy, 1e-3);
  const double deepest = std::min(surface_->mean_depth(), 40.0);
  const double crest = section_flux([&](double y) { return surface_->velocity(0, y).u; }, -deepest, surface_->crest());
  constexpr int points = 64;
  const double level = std::max(0.5 * (surface_->trough() - deepest), -1.0 + surface_->trough());
  double mean = 0;
  for (int j = 0; j < points; ++j) mean += surface_->velocity(2 * pi * j / points, level).u / points;
  return {{"2 T = c I", std::abs(2 * integrals.kinetic_energy - c * integrals.impulse) / scale, limit,
           "means over the nodes of values good to the stated uncertainty; relative to 2 T or 0.001"},
          {"volume flux through the crest section = c eta + I",
           std::abs(crest - c * surface_->crest() - integrals.impulse) / crest, limit,
           "280 Gauss points of velocities good to the stated uncertainty"},
          {"mean Eulerian velocity below the troughs = 0",
           std::abs(mean) / (c * -std::expm1(surface_->solution().log_speed[0])), limit,
           "64 equally spaced velocities, relative to that at the crest"}};
}

}  // namespace seiche::exact
