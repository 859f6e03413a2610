#include "seiche/exact/overturning_wave.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <gsl/gsl_sf_bessel.h>

#include "seiche/exact/entry.hpp"
#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/exact/stokes_wave.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

namespace ow = overturning;

namespace {

const OverturningWave::Parameters& checked(const OverturningWave::Parameters& p) {
  require_positive("amplitude", p.amplitude);
  require_positive("wavelength", p.wavelength);
  require_positive("gravity", p.gravity);
  require_positive("tolerance", p.tolerance);
  require_at_least("markers", static_cast<long>(p.markers), 64);
  require_within("markers modulo 2", static_cast<double>(p.markers % 2), 0, 0);
  if (p.last_time) require_positive("last_time", *p.last_time);
  const double steepest = p.wavelength / (2 * std::numbers::pi);
  if (std::isinf(p.depth) && p.depth > 0) {
    require_within("amplitude", p.amplitude, 0, steepest);
  } else {
    require_positive("depth", p.depth);
    require_within("amplitude", p.amplitude, 0, std::min(steepest, 0.99 * p.depth));
  }
  return p;
}

}  // namespace

OverturningWave::OverturningWave(const Parameters& parameters)
    : MovingSurface(checked(parameters).wavelength, parameters.gravity), parameters_(parameters) {
  const double depth = parameters_.depth / length();
  const double last_time =
      parameters_.last_time.value_or(2 * std::numbers::pi / std::sqrt(std::tanh(depth)) * time_unit());
  auto motion = std::make_shared<ow::Evolution>(
      ow::sinusoidal_wave(parameters_.markers, parameters_.amplitude / length(), depth), depth, parameters_.tolerance);
  motion->advance_to(last_time / time_unit());
  keep(std::move(motion), last_time, [](double tangent) { return 0.25 * tangent; });
}

double OverturningWave::uncertainty(double t) const {
  Parameters coarser = parameters_;
  coarser.markers = std::max<std::size_t>(64, parameters_.markers * 3 / 8 * 2);
  coarser.tolerance = 10 * parameters_.tolerance;
  coarser.last_time = std::max(t, time_unit() * 1e-3);
  return distance_from(OverturningWave(coarser), t) / parameters_.amplitude;
}

SelfTest OverturningWave::self_test() const {
  const double a = parameters_.amplitude / length();
  const double exact = 0.5 * std::numbers::pi * a * a * gsl_sf_bessel_I0(2 * a);
  const double start = evolution().moments().front().invariants.kinetic_energy;
  SelfTest identities{
      {"kinetic energy at t = 0 is (pi/2) A^2 I_0(2A)", std::abs(start / exact - 1), 1e-13,
       "integral equation solved to 1e-15, kernels rounded at neighbouring markers 0.01 apart; sum over the markers"}};
  std::ranges::move(balances(parameters_.amplitude, parameters_.tolerance), std::back_inserter(identities));
  return identities;
}

namespace {

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
    identities.push_back({"kinetic energy at t = 0 is that of the Stokes wave",
                          std::abs(integrals(0).kinetic_energy / *kinetic_energy_ - 1), 1e-13,
                          "integral equation solved to 1e-15, kernels rounded at neighbouring markers 0.01 apart; "
                          "Stokes wave to 1e-14"});
  }
  std::ranges::move(balances(scale(), parameters_.tolerance), std::back_inserter(identities));
  return identities;
}

namespace {

const std::vector<Quantity> points_of_surface{{"x", "m", "along the surface, in the surface's order"},
                                              {"y", "m", "elevation there"},
                                              {"phi", "m^2/s", "velocity potential"},
                                              {"u", "m/s", "horizontal velocity"},
                                              {"v", "m/s", "vertical velocity"}};

const Parameter points_of_profile{"points", "1", 0,
                                  0,        1e6, "points of a profile, at equal arc length; 0: at the markers"};

/// A surface that may overturn, and how many points of it are asked for.
template <class Wave>
struct Profiled : Wave {
  std::size_t points;

  Profiled(const typename Wave::Parameters& parameters, const Values& p)
      : Wave(parameters), points(Given{"points", p.at("points")}) {}
};

template <class Wave>
std::vector<Row> points_at(const Profiled<Wave>& wave, At at) {
  const auto profile = wave.points > 0 ? wave.profile(at[0], wave.points) : wave.profile(at[0]);
  std::vector<Row> rows;
  for (std::size_t j = 0; j < profile.x.size(); ++j) {
    rows.push_back({profile.x[j], profile.y[j], profile.potential[j], profile.u[j], profile.v[j]});
  }
  return rows;
}

/// Scalars of both: times of breaking, NaN where it does not, then two of its own.
template <class Wave>
std::vector<Scalar<Profiled<Wave>>> breaking(std::vector<Scalar<Profiled<Wave>>> own) {
  using W = Profiled<Wave>;
  std::vector<Scalar<W>> all{{"vertical_tangent_time", "s", "when the front is first vertical; NaN if it is not",
                              [](const W& w) { return w.vertical_tangent_time().value_or(none_given); }},
                             {"touch_down_time", "s", "when the jet meets the water below; NaN if it does not",
                              [](const W& w) { return w.touch_down_time().value_or(none_given); }},
                             {"end_time", "s", "last time computed", &W::end_time}};
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

std::optional<double> last_time(const Values& p) {
  return p.at("last_time") > 0 ? std::optional(p.at("last_time")) : std::nullopt;
}

}  // namespace

ExactSolution overturning_wave_entry() {
  return Entry<Profiled<OverturningWave>>{
      .name = "overturning_wave",
      .title = "A wave steepens, overturns and plunges: fully nonlinear potential flow up to touch-down",
      .citation =
          "Longuet-Higgins & Cokelet, The deformation of steep surface waves on water I, Proc. R. Soc. Lond. A 350 "
          "(1976) 1; Baker, Meiron & Orszag, Generalized vortex methods for free-surface flow problems, J. Fluid Mech. "
          "123 (1982) 477",
      .formula =
          "dz/dt = conj f, dphi/dt = |f|^2/2 - g y, z_s f = phi_s + i psi_s with psi_s from Cauchy's integral; eta = A "
          "cos kx, phi = (A g/w) cosh(k(y + h))/cosh(kh) sin kx at t = 0",
      .parameters = {{"amplitude", "m", 0.5, 1e-9, 1e6, "half the height of the cosine it starts from"},
                     wavelength_parameter(),
                     depth_parameter(infinite, infinite),
                     gravity_parameter(),
                     {"markers", "1", 512, 64, 4096, "markers per wavelength, even"},
                     {"last_time", "s", 0, 0, 1e9, "end of the computation; 0: one period of the linear wave"},
                     points_of_profile},
      .inputs = {time_t},
      .outputs = points_of_surface,
      .scalars =
          breaking<OverturningWave>({{"kinetic", "m^4/s^2", "kinetic energy per wavelength at the start, density 1",
                                      [](const OverturningWave& w) { return w.integrals(0).kinetic_energy; }},
                                     {"potential", "m^4/s^2", "potential energy per wavelength at the start, density 1",
                                      [](const OverturningWave& w) { return w.integrals(0).potential_energy; }}}),
      .make =
          [](const Values& p) {
            return Profiled<OverturningWave>({.amplitude = p.at("amplitude"),
                                              .wavelength = p.at("wavelength"),
                                              .depth = p.at("depth"),
                                              .gravity = p.at("gravity"),
                                              .markers = Given{"markers", p.at("markers")},
                                              .last_time = last_time(p)},
                                             p);
          },
      .row = {},
      .curve = points_at<OverturningWave>};
}

ExactSolution pressure_forced_wave_entry() {
  return Entry<Profiled<PressureForcedWave>>{
      .name = "pressure_forced_wave",
      .title = "A Stokes wave is pushed by a travelling pressure until it overturns: fully nonlinear potential flow",
      .citation =
          "Longuet-Higgins & Cokelet, The deformation of steep surface waves on water I, Proc. R. Soc. Lond. A 350 "
          "(1976) 1",
      .formula =
          "dz/dt = conj f, dphi/dt = |f|^2/2 - g y - p_s, z_s f = phi_s + i psi_s with psi_s from Cauchy's integral; "
          "Stokes wave at t = 0; p_s = -p0 sin wt sin(kx - wt), w = sqrt(gk), 0 <= wt <= pi",
      .parameters = {{"amplitude", "m", 0.3, 0, 1e6, "half the height of the Stokes wave; 0: water at rest"},
                     wavelength_parameter(),
                     depth_parameter(std::numbers::pi, infinite),
                     gravity_parameter(),
                     {"pressure", "m^2/s^2", 0.1, -1e6, 1e6, "amplitude p0 of the pressure over the density"},
                     {"markers", "1", 256, 192, 4096, "markers per wavelength, even"},
                     {"last_time", "s", 0, 0, 1e9, "end of the computation; 0: 7.4/sqrt(g k)"},
                     points_of_profile},
      .inputs = {time_t},
      .outputs = points_of_surface,
      .scalars = breaking<PressureForcedWave>(
          {{"energy", "m^4/s^2", "kinetic and potential, per wavelength at the start, density 1",
            [](const PressureForcedWave& w) {
              return w.integrals(0).kinetic_energy + w.integrals(0).potential_energy;
            }},
           {"work", "m^4/s^2", "of the pressure up to the end, per wavelength, density 1",
            [](const PressureForcedWave& w) { return w.action(w.end_time()).work; }}}),
      .make =
          [](const Values& p) {
            return Profiled<PressureForcedWave>({.amplitude = p.at("amplitude"),
                                                 .wavelength = p.at("wavelength"),
                                                 .depth = p.at("depth"),
                                                 .gravity = p.at("gravity"),
                                                 .pressure = p.at("pressure"),
                                                 .markers = Given{"markers", p.at("markers")},
                                                 .last_time = last_time(p)},
                                                p);
          },
      .row = {},
      .curve = points_at<PressureForcedWave>};
}

}  // namespace seiche::exact
