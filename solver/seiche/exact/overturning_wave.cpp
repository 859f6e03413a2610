#include "seiche/exact/overturning_wave.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gsl/gsl_sf_bessel.h>

#include "seiche/divergence.hpp"
#include "seiche/exact/overturning/curve_distance.hpp"
#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/exact/overturning/initial.hpp"
#include "seiche/exact/overturning/surface_curve.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace ow = overturning;
using Complex = std::complex<double>;

namespace {

static_assert(ReferenceSolution<OverturningWave>);

ow::SurfaceCurve curve(const ow::Moment& moment) {
  return ow::SurfaceCurve(ow::view(moment.state));
}

ow::PeriodicCurve periodic_curve(const OverturningWave::Profile& profile, double wavelength) {
  std::vector<Complex> points(profile.x.size());
  for (std::size_t j = 0; j < points.size(); ++j) points[j] = {profile.x[j], profile.y[j]};
  return ow::PeriodicCurve(points, wavelength);
}

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
    : parameters_(checked(parameters)),
      length_(parameters.wavelength / (2 * std::numbers::pi)),
      time_(std::sqrt(length_ / parameters.gravity)),
      velocity_(std::sqrt(length_ * parameters.gravity)) {
  const double depth = parameters_.depth / length_;
  last_time_ = parameters_.last_time.value_or(2 * std::numbers::pi / std::sqrt(std::tanh(depth)) * time_);
  auto evolution = std::make_shared<ow::Evolution>(
      ow::sinusoidal_wave(parameters_.markers, parameters_.amplitude / length_, depth), depth, parameters_.tolerance);
  evolution->advance_to(last_time_ / time_);
  evolution_ = std::move(evolution);
  const auto tangent =
      evolution_->first_zero([](const ow::Moment& moment) { return curve(moment).least_advance(); }, 1e-9);
  if (tangent) vertical_tangent_time_ = *tangent * time_;
  find_touch_down();
}

void OverturningWave::find_touch_down() {
  if (evolution_->ending() == ow::Ending::none) return;
  // The energy tells when two parts of the surface are too close for the markers between them.
  constexpr double resolved = 1e-6;
  constexpr double small_gap = 2 * std::numbers::pi / 20;
  const auto& moments = evolution_->moments();
  const double energy = moments.front().invariants.energy();
  const auto lost = std::ranges::find_if(
      moments, [&](const ow::Moment& m) { return std::abs(m.invariants.energy() / energy - 1) > resolved; });
  if (lost == moments.begin()) return;
  const double last = std::prev(lost)->time;
  const double before = last - 0.01;
  if (before <= 0) return;
  const auto late = curve(evolution_->at(last)).overhang();
  const auto early = curve(evolution_->at(before)).overhang();
  if (!late || !early || late->gap > small_gap || early->gap <= late->gap) return;
  touch_down_time_ = time_ * (last + (last - before) * late->gap / (early->gap - late->gap));
}

double OverturningWave::scaled_time(double t) const {
  require_within("t", t, 0, last_time_);
  const double scaled = t / time_;
  if (scaled > evolution_->now().time) {
    throw Divergence(evolution_->ending_reason(), end_time(), static_cast<long>(steps()),
                     evolution_->ending_place() * length_);
  }
  return scaled;
}

OverturningWave::Profile OverturningWave::profile(double t) const {
  const ow::Moment moment = evolution_->at(scaled_time(t));
  const auto surface = ow::view(moment.state);
  const auto rate = ow::view(moment.rate);
  const std::size_t n = surface.size();
  Profile result{t,
                 std::vector<double>(n),
                 std::vector<double>(n),
                 std::vector<double>(n),
                 std::vector<double>(n),
                 std::vector<double>(n)};
  for (std::size_t j = 0; j < n; ++j) {
    result.x[j] = length_ * (ow::label(j, n) + surface.displacement[j]);
    result.y[j] = length_ * surface.y[j];
    result.potential[j] = length_ * velocity_ * surface.potential[j];
    result.u[j] = velocity_ * rate.displacement[j];
    result.v[j] = velocity_ * rate.y[j];
  }
  return result;
}

OverturningWave::Profile OverturningWave::profile(double t, std::size_t points) const {
  const ow::Moment moment = evolution_->at(scaled_time(t));
  const auto surface = ow::view(moment.state);
  const auto rate = ow::view(moment.rate);
  const ow::SurfaceCurve shape(surface);
  std::vector<Complex> velocity(surface.size());
  std::vector<Complex> potential(surface.size());
  for (std::size_t j = 0; j < surface.size(); ++j) {
    velocity[j] = {rate.displacement[j], rate.y[j]};
    potential[j] = surface.potential[j];
  }
  const ow::TrigonometricInterpolant velocity_at(velocity);
  const ow::TrigonometricInterpolant potential_at(potential);
  Profile result;
  result.time = t;
  for (const double s : shape.labels_at_equal_arc_length(points)) {
    const Complex z = shape.point(s);
    const Complex uv = velocity_at(s);
    result.x.push_back(length_ * z.real());
    result.y.push_back(length_ * z.imag());
    result.potential.push_back(length_ * velocity_ * potential_at(s).real());
    result.u.push_back(velocity_ * uv.real());
    result.v.push_back(velocity_ * uv.imag());
  }
  return result;
}

OverturningWave::Extremes OverturningWave::extremes(double t) const {
  const ow::SurfaceCurve shape = curve(evolution_->at(scaled_time(t)));
  return {length_ * shape.highest(), length_ * shape.lowest()};
}

std::optional<OverturningWave::Jet> OverturningWave::jet(double t) const {
  const auto overhang = curve(evolution_->at(scaled_time(t))).overhang();
  if (!overhang) return {};
  return Jet{length_ * overhang->nose.real(), length_ * overhang->nose.imag(), length_ * overhang->throat.real(),
             length_ * overhang->throat.imag(), length_ * overhang->gap};
}

double OverturningWave::end_time() const {
  return evolution_->ending() == ow::Ending::none ? last_time_ : evolution_->now().time * time_;
}
std::string OverturningWave::ending_reason() const {
  return evolution_->ending_reason();
}
std::size_t OverturningWave::steps() const {
  return evolution_->moments().size() - 1;
}

OverturningWave::Integrals OverturningWave::integrals(double t) const {
  const ow::Invariants sums = evolution_->at(scaled_time(t)).invariants;
  const double area = length_ * length_;
  const double energy = area * velocity_ * velocity_;
  return {area * sums.volume, energy * sums.kinetic_energy, energy * sums.potential_energy,
          area * velocity_ * sums.impulse};
}

double OverturningWave::well_resolved_until() const {
  return vertical_tangent_time_ ? std::min(1.25 * *vertical_tangent_time_, end_time()) : end_time();
}

double OverturningWave::uncertainty() const {
  return uncertainty(well_resolved_until());
}

double OverturningWave::uncertainty(double t) const {
  Parameters coarser = parameters_;
  coarser.markers = std::max<std::size_t>(64, parameters_.markers * 3 / 8 * 2);
  coarser.tolerance = 10 * parameters_.tolerance;
  coarser.last_time = std::max(t, time_ * 1e-3);
  const Profile second = OverturningWave(coarser).profile(t);
  return ow::hausdorff_distance(periodic_curve(profile(t), parameters_.wavelength),
                                periodic_curve(second, parameters_.wavelength)) /
         parameters_.amplitude;
}

SelfTest OverturningWave::self_test() const {
  const double a = parameters_.amplitude / length_;
  const auto& moments = evolution_->moments();
  const ow::Invariants& start = moments.front().invariants;
  const double exact = 0.5 * std::numbers::pi * a * a * gsl_sf_bessel_I0(2 * a);
  Worst volume;
  Worst energy;
  Worst impulse;
  std::size_t resolved = 0;
  for (const ow::Moment& moment : moments) {
    if (moment.time * time_ > well_resolved_until()) break;
    ++resolved;
    volume.add(moment.invariants.volume - start.volume);
    energy.add(moment.invariants.energy() - start.energy());
    impulse.add(moment.invariants.impulse - start.impulse);
  }
  const std::string steps_say = fmt::format(
      "{} steps whose errors of fourth order are kept at {:g}/k and add up, over the amplitude; the solution of fifth "
      "order that is carried on errs less by a step, the fifth root of that",
      resolved, parameters_.tolerance);
  const double limit = static_cast<double>(resolved) * std::pow(parameters_.tolerance / a, 1.2);
  const std::string square = steps_say + "; twice as much of a square";
  return {
      {"kinetic energy at t = 0 is (pi/2) A^2 I_0(2A)", std::abs(start.kinetic_energy / exact - 1), 1e-13,
       "integral equation solved to 1e-15, kernels rounded at neighbouring markers 0.01 apart; sum over the markers"},
      {"volume is conserved", volume.value() / (2 * std::numbers::pi * a), limit, steps_say},
      {"energy is conserved", energy.value() / start.energy(), 2 * limit, square},
      {"horizontal impulse is conserved", impulse.value() / std::abs(start.impulse), 2 * limit, square}};
}

Provenance OverturningWave::provenance() {
  return {
      "Longuet-Higgins & Cokelet, The deformation of steep surface waves on water I, Proc. R. Soc. Lond. A 350 (1976) "
      "1; "
      "Baker, Meiron & Orszag, Generalized vortex methods for free-surface flow problems, J. Fluid Mech. 123 (1982) "
      "477",
      "dz/dt = conj f, dphi/dt = |f|^2/2 - g y, z_s f = phi_s + i psi_s with psi_s from Cauchy's integral; "
      "eta = A cos kx, phi = (A g/w) cosh(k(y + h))/cosh(kh) sin kx at t = 0"};
}

}  // namespace seiche::exact
