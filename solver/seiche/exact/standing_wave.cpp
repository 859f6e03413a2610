#include "seiche/exact/standing_wave.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/entry.hpp"
#include "seiche/exact/identities.hpp"
#include "seiche/exact/roots.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::exact {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

void require_depth(std::string_view name, double depth) {
  if (depth != unbounded) require_positive(name, depth);
}

// Coefficients of the second-order potential.
double wave_part(double w) {
  return 3 * (std::pow(w, 8) - 1) / (16 * std::pow(w, 7));
}
double uniform_part(double w) {
  return (3 * std::pow(w, 4) + 1) / (16 * std::pow(w, 3));
}
double secular_part(double w) {
  return (std::pow(w, 4) - 1) / (8 * std::pow(w, 3));
}

}  // namespace

double StandingWave::linear_frequency(double kh) {
  require_depth("k h", kh);
  return std::sqrt(std::tanh(kh));
}

double StandingWave::frequency_correction(double kh) {
  const double w = linear_frequency(kh);
  return (9 / std::pow(w, 7) - 12 / std::pow(w, 3) - 3 * w - 2 * std::pow(w, 5)) / 32;
}

double StandingWave::second_harmonic(double kh) {
  const double w = linear_frequency(kh);
  return (w * w + 3 / std::pow(w, 6)) / 8;
}

double StandingWave::critical_depth() {
  // 32 w^7 omega_2 as a polynomial of z = w^4 = tanh^2 k h
  const auto polynomial = [](double z) { return 9 - z * (12 + z * (3 + 2 * z)); };
  return std::atanh(std::sqrt(root(polynomial, 0, 1)));
}

StandingWave::StandingWave(double amplitude, double wavelength, double depth, double gravity) : gravity_(gravity) {
  require_positive("amplitude", amplitude);
  require_positive("wavelength", wavelength);
  require_depth("depth", depth);
  require_positive("gravity", gravity);
  wavenumber_ = 2 * std::numbers::pi / wavelength;
  kh_ = wavenumber_ * depth;
  steepness_ = wavenumber_ * amplitude;
  w_ = linear_frequency(kh_);
  require_within("amplitude", amplitude, 0, 0.25 / (wavenumber_ * second_harmonic(kh_)));
}

double StandingWave::elevation(double x, double t) const {
  require_finite("x", x);
  require_finite("t", t);
  const double theta = frequency() * t;
  const double kx = wavenumber_ * x;
  const double w2 = w_ * w_;
  const double second = (w2 + 1 / w2 + (3 / (w2 * w2 * w2) - 1 / w2) * std::cos(2 * theta)) / 8;
  return steepness_ * (std::cos(kx) * std::cos(theta) + steepness_ * second * std::cos(2 * kx)) / wavenumber_;
}

StandingWave::Place StandingWave::inside(double x, double y, double t) const {
  const double top = std::max(0.0, elevation(x, t));
  const double bottom = -kh_ / wavenumber_;
  require_that<OutsideFluid>(y >= bottom && y <= top,
                             "y = {:.17g} is outside the fluid: must be in [{:g}, {:.17g}] at x = {:g}, t = {:g}", y,
                             bottom, top, x, t);
  return {wavenumber_ * x, wavenumber_ * y, frequency() * t};
}

double StandingWave::potential(double x, double y, double t) const {
  const Place p = inside(x, y, t);
  const double first = -cosh_profile(1, p.y, kh_) / w_ * std::cos(p.x) * std::sin(p.theta);
  const double second = wave_part(w_) * cosh_profile(2, p.y, kh_) * std::cos(2 * p.x) * std::sin(2 * p.theta) +
                        uniform_part(w_) * std::sin(2 * p.theta) + secular_part(w_) * p.theta;
  return std::sqrt(gravity_ / wavenumber_) / wavenumber_ * steepness_ * (first + steepness_ * second);
}

Velocity StandingWave::velocity(double x, double y, double t) const {
  const Place p = inside(x, y, t);
  const double first = -std::sin(p.theta) / w_;
  const double second = 2 * steepness_ * wave_part(w_) * std::sin(2 * p.theta);
  const double scale = std::sqrt(gravity_ / wavenumber_) * steepness_;
  return {-scale * (first * cosh_profile(1, p.y, kh_) * std::sin(p.x) +
                    second * cosh_profile(2, p.y, kh_) * std::sin(2 * p.x)),
          scale * (first * sinh_profile(1, p.y, kh_) * std::cos(p.x) +
                   second * sinh_profile(2, p.y, kh_) * std::cos(2 * p.x))};
}

double StandingWave::pressure(double x, double y, double t) const {
  const Place p = inside(x, y, t);
  const double first = -cosh_profile(1, p.y, kh_) / w_ * std::cos(p.x) * std::cos(p.theta);
  const double second =
      2 * (wave_part(w_) * cosh_profile(2, p.y, kh_) * std::cos(2 * p.x) + uniform_part(w_)) * std::cos(2 * p.theta) +
      secular_part(w_);
  const double potential_rate =
      frequency() * std::sqrt(gravity_ / wavenumber_) / wavenumber_ * steepness_ * (first + steepness_ * second);
  const auto [u, v] = velocity(x, y, t);
  return -potential_rate - 0.5 * (u * u + v * v) - gravity_ * y;
}

SelfTest StandingWave::self_test() const {
  const double quarter = 0.5 * std::numbers::pi / wavenumber_;
  const double t = 0.15 * period();
  // Water that passes the section x = L/4 below y = 0 rises through y = 0 between x = 0 (a plane of symmetry) and it.
  const double depth = std::min(kh_, 40.0) / wavenumber_;  // below, exp(-40) of the velocity
  const double passed = integral<20>([&](double y) { return velocity(quarter, y, t).u; }, -depth, 0, 16);
  const double risen = integral<20>([&](double x) { return velocity(x, 0, t).v; }, 0, quarter, 16);
  const double level = integral<20>([&](double x) { return elevation(x, t); }, 0, 2 * quarter, 16) / (2 * quarter);
  const double crest = steepness_ / wavenumber_;
  return {
      {"flux through x = L/4 and through y = 0", std::abs(passed + risen) / std::abs(risen), 1e-14,
       "quadrature exact to round-off; 45 ulp for 30 roundings"},
      {"mean level = 0", std::abs(level) / crest, 1e-14, "quadrature exact to round-off; 45 ulp"},
      {"omega_2 = 0 at the critical depth", std::abs(frequency_correction(critical_depth())), 4e-15,
       "terms up to 1.3 rounded five times; slope 1 of omega_2 in k h"},
      {"omega_2 = -1/4 over unbounded depth", std::abs(frequency_correction(unbounded) + 0.25), 1e-16, "exact sums"}};
}

ExactSolution standing_entry() {
  return Entry<StandingWave>{
      .name = "standing",
      .title = "Standing wave between walls, to second order, its frequency to third",
      .citation = "Tadjbakhsh and Keller, Standing surface waves of finite amplitude, J. Fluid Mech. 8 (1960) 442",
      .formula =
          "eta = e cos x cos(omega t) + (e^2/8)(w^2 + w^-2 + (3 w^-6 - w^-2) cos(2 omega t)) cos 2x; omega = w + "
          "(e^2/64)(9 w^-7 - 12 w^-3 - 3 w - 2 w^5), w^2 = tanh k h",
      .parameters = {{"amplitude", "m", 0.05, 1e-12, 1e6, "coefficient of cos(k x) at first order"},
                     wavelength_parameter(),
                     depth_parameter(1, infinite),
                     gravity_parameter()},
      .inputs = {position_x, height_y, time_t},
      .outputs = {surface_eta, {"phi", "m^2/s", "velocity potential"}, velocity_u, velocity_v},
      .scalars = {{"omega", "1/s", "angular frequency, to third order", &StandingWave::frequency},
                  {"omega2", "1", "its correction: omega/sqrt(g k) = w + (k amplitude)^2 omega2/2",
                   [](const StandingWave& wave) { return StandingWave::frequency_correction(wave.relative_depth()); }},
                  {"second_harmonic", "1", "B: eta holds k amplitude^2 B cos(2 k x) at its highest",
                   [](const StandingWave& wave) { return StandingWave::second_harmonic(wave.relative_depth()); }},
                  {"period", "s", "period", &StandingWave::period},
                  {"critical_depth", "m", "depth for this wavelength at which omega2 is zero",
                   [](const StandingWave& wave) { return StandingWave::critical_depth() / wave.wavenumber(); }}},
      .make = from<StandingWave>("amplitude", "wavelength", "depth", "gravity"),
      .row = [](const StandingWave& wave, At at) {
        const double eta = wave.elevation(at[0], at[2]);
        const double y = std::isnan(at[1]) ? eta : at[1];
        const auto [u, v] = wave.velocity(at[0], y, at[2]);
        return Row{eta, wave.potential(at[0], y, at[2]), u, v};
      }};
}

}  // namespace seiche::exact
