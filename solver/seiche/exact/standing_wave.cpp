#include "seiche/exact/standing_wave.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/entry.hpp"
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

using Parameters = DispersiveStandingWave::Parameters;

void require_valid(double kh, const Parameters& parameters) {
  require_all_positive({{"k H", kh}, {"alpha", parameters.alpha}});
  require_not_negative("gamma", parameters.gamma);
  // As gamma nears alpha the waves lose their dispersion and the second harmonic is resonant.
  require_within("gamma", parameters.gamma, 0, 0.99 * parameters.alpha);
  require_finite("weight_exponent", parameters.weight_exponent);
}

/// The averaged Lagrangian to fourth order in e: names of the header.
struct Averaged {
  double kappa2, alpha, gamma, n, nu, c0, c2;

  Averaged(double kh, const Parameters& parameters)
      : kappa2(kh * kh),
        alpha(parameters.alpha),
        gamma(parameters.gamma),
        n(parameters.weight_exponent + 5),
        nu(kappa2 * (1 + gamma * kappa2) / (1 + alpha * kappa2)),
        c0(0.375 * (1 + n * gamma * kappa2) - 0.5 * alpha * nu),
        c2(0.1875 * (1 + n * gamma * kappa2) - 0.75 * alpha * nu) {}

  [[nodiscard]] double steady_harmonic() const { return c0 / (1 + 4 * gamma * kappa2); }
  [[nodiscard]] double double_frequency_harmonic() const {
    return -2.0 / 3 * c2 * (1 + alpha * kappa2) / ((alpha - gamma) * kappa2);
  }
  /// N.
  [[nodiscard]] double quartic() const {
    return 0.25 * c0 * steady_harmonic() + 0.25 * c2 * double_frequency_harmonic() + 15.0 / 64 * alpha * nu -
           9.0 / 128 - 3.0 / 256 * gamma * n * (n + 1) * kappa2;
  }
};

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
  require_all_positive({{"amplitude", amplitude}, {"wavelength", wavelength}});
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

double DispersiveStandingWave::frequency_correction(double kh, const Parameters& parameters) {
  require_valid(kh, parameters);
  const Averaged averaged(kh, parameters);
  return -8 * averaged.quartic() / (1 + averaged.gamma * averaged.kappa2);
}

std::optional<double> DispersiveStandingWave::critical_depth(const Parameters& parameters) {
  const auto correction = [&](double kh) { return frequency_correction(kh, parameters); };
  constexpr double step = 0.05;
  constexpr double deepest = 6;
  for (int k = 1; k * step < deepest; ++k) {
    const double kh = k * step;
    if (!(correction(kh) * correction(kh + step) <= 0)) continue;
    return root(correction, kh, kh + step);
  }
  return std::nullopt;
}

std::optional<double> DispersiveStandingWave::critical_wavelength(const Parameters& parameters) {
  const auto kh = critical_depth(parameters);
  if (!kh) return std::nullopt;
  return 2 * std::numbers::pi / *kh;
}

std::optional<double> DispersiveStandingWave::exponent_for_critical_depth(double kh, double alpha, double gamma) {
  const auto correction = [&](double s) { return frequency_correction(kh, {alpha, gamma, s}); };
  if (gamma == 0) return std::nullopt;
  // C is a quadratic of s.
  const double constant = correction(0);
  const double curvature = 0.5 * (correction(1) + correction(-1)) - constant;
  const double slope = 0.5 * (correction(1) - correction(-1));
  const auto [first, second] = boost::math::tools::quadratic_roots(curvature, slope, constant);
  if (!std::isfinite(first)) return std::nullopt;
  return std::abs(first) < std::abs(second) ? first : second;
}

DispersiveStandingWave::DispersiveStandingWave(double amplitude, double wavelength, double depth, double gravity,
                                               const Parameters& parameters)
    : parameters_(parameters), gravity_(gravity), depth_(depth) {
  require_all_positive({{"amplitude", amplitude}, {"wavelength", wavelength}, {"depth", depth}, {"gravity", gravity}});
  wavenumber_ = 2 * std::numbers::pi / wavelength;
  require_valid(wavenumber_ * depth, parameters);
  relative_amplitude_ = amplitude / depth;
  // Labels do not cross while e + e^2 (|B0| + |B2|) < 1.
  const Averaged averaged(wavenumber_ * depth, parameters);
  const double second = std::abs(averaged.steady_harmonic()) + std::abs(averaged.double_frequency_harmonic());
  require_within("amplitude", amplitude, 0, 0.999 * depth * 2 / (1 + std::sqrt(1 + 4 * second)));
}

double DispersiveStandingWave::frequency() const {
  const RationalDispersion linear(gravity_, depth_, parameters_.gamma, parameters_.alpha);
  return linear.frequency(wavenumber_) * (1 + relative_amplitude_ * relative_amplitude_ * correction());
}

double DispersiveStandingWave::position(double label, double t) const {
  require_finite("label", label);
  require_finite("t", t);
  const Averaged averaged(wavenumber_ * depth_, parameters_);
  const double theta = frequency() * t;
  const double ka = wavenumber_ * label;
  const double second = averaged.steady_harmonic() + averaged.double_frequency_harmonic() * std::cos(2 * theta);
  const double e = relative_amplitude_;
  return label + e / wavenumber_ * (-std::sin(ka) * std::cos(theta) + 0.5 * e * second * std::sin(2 * ka));
}

SelfTest DispersiveStandingWave::self_test() const {
  const auto& [alpha, gamma, weight] = parameters_;
  // Without gamma the sum has a closed form.
  const double kh = wavenumber_ * depth_;
  const double z = alpha * kh * kh;
  const double closed = -(z * (z * (59 * z + 27) - 3) - 3) / (64 * z * (1 + z) * (1 + z));
  const double closed_scale = (z * (z * (59 * z + 27) + 3) + 3) / (64 * z * (1 + z) * (1 + z));
  const double without = frequency_correction(kh, {.alpha = alpha, .gamma = 0});
  // Long waves: only the resonance of the second harmonic is left.
  constexpr double long_kh = 1e-4;
  const double limit = 3 / (64 * (alpha - gamma) * long_kh * long_kh);
  // To the next order C is the limit times 1 + (-alpha + (2 s + 3) gamma) kappa^2; twice that also holds the rest.
  const double next_order = 2 * (alpha + std::abs(2 * weight + 3) * gamma) * long_kh * long_kh + 40 * epsilon;
  const double volume = position(2 * std::numbers::pi / wavenumber_, 0.3 * period()) - position(0, 0.3 * period());
  SelfTest identities{
      {"C at gamma = 0 in closed form", std::abs(without - closed) / closed_scale, 4e-14,
       "180 ulp: terms up to four times the closed form's, 40 roundings"},
      {"C -> 3/(64 (alpha - gamma) kappa^2) in long waves",
       std::abs(frequency_correction(long_kh, parameters_) / limit - 1), next_order,
       "relative rest (-alpha + (2 s + 3) gamma) kappa^2, at most the sum of the two, doubled for the orders beyond; "
       "40 roundings"},
      {"a wavelength of labels spans a wavelength", std::abs(volume * wavenumber_ / (2 * std::numbers::pi) - 1), 1e-15,
       "sines of 2 pi and 4 pi: their roundings"}};
  if (const auto critical = critical_depth(parameters_)) {
    identities.push_back({"C = 0 at the critical depth", std::abs(frequency_correction(*critical, parameters_)), 1e-14,
                          "terms up to 1 rounded 40 times"});
  }
  return identities;
}

ExactSolution dispersive_standing_entry() {
  return Entry<DispersiveStandingWave>{
      .name = "dispersive_standing",
      .title = "Standing wave of the dispersive shallow-water model, its frequency to third order",
      .citation =
          "derived: averaged Lagrangian (Whitham, Linear and nonlinear waves (1974), ch. 14) of the model of Frank, "
          "Discrete models of incompressible fluids (1994), ch. 3",
      .formula =
          "Omega = omega (1 + C (a/H)^2), C = -8 N/(1 + gamma kappa^2), N = c0^2/(4 (1 + 4 gamma kappa^2)) - c2^2 (1 + "
          "alpha kappa^2)/(6 (alpha - gamma) kappa^2) + (15/64) alpha nu - 9/128 - (3/256) gamma n (n + 1) kappa^2",
      .parameters = {{"amplitude", "m", 0.05, 1e-12, 1e6, "first harmonic of the elevation"},
                     wavelength_parameter(),
                     depth_parameter(1, 1e6),
                     gravity_parameter(),
                     {"alpha", "1", 1.0 / 3, 1e-6, 10, "factor of the vertical kinetic energy"},
                     {"gamma", "1", 0, 0, 10, "added potential energy of slopes, below alpha"},
                     {"weight_exponent", "1", 2, -10, 10, "that energy is weighted with this power of the depth"}},
      .inputs = {{"label", "m", 0, "place of the particle at rest"}, time_t},
      .outputs = {{"x", "m", "place of the particle, to second order"}},
      .scalars = {{"omega", "1/s", "angular frequency, to third order", &DispersiveStandingWave::frequency},
                  {"period", "s", "period", &DispersiveStandingWave::period},
                  {"correction", "1", "C: omega = omega_0 (1 + C (amplitude/depth)^2)",
                   [](const DispersiveStandingWave& wave) { return wave.correction(); }},
                  {"critical_wavelength", "m", "wavelength for this depth at which C = 0; NaN if there is none",
                   [](const DispersiveStandingWave& wave) {
                     return DispersiveStandingWave::critical_wavelength(wave.parameters()).value_or(none_given) *
                            wave.depth();
                   }}},
      .make = made_by(
          [](double amplitude, double length, double depth, double g, double alpha, double gamma, double weight) {
            return DispersiveStandingWave(amplitude, length, depth, g, {alpha, gamma, weight});
          },
          "amplitude", "wavelength", "depth", "gravity", "alpha", "gamma", "weight_exponent"),
      .row = [](const DispersiveStandingWave& wave, At at) { return Row{wave.position(at[0], at[1])}; }};
}

}  // namespace seiche::exact
