#include "seiche/exact/overturning/moving_surface.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "seiche/divergence.hpp"
#include "seiche/exact/identities.hpp"
#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/exact/overturning/surface_curve.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact::overturning {

namespace {

using Complex = std::complex<double>;

SurfaceCurve curve(const Moment& moment) {
  const auto surface = view(moment.state);
  std::vector<Complex> displacements(surface.size());
  for (std::size_t j = 0; j < surface.size(); ++j) displacements[j] = {surface.displacement[j], surface.y[j]};
  return SurfaceCurve(displacements);
}

}  // namespace

MovingSurface::MovingSurface(double wavelength, double gravity)
    : length_(wavelength / (2 * std::numbers::pi)),
      time_(std::sqrt(length_ / gravity)),
      velocity_(std::sqrt(length_ * gravity)) {}

void MovingSurface::keep(std::shared_ptr<const Evolution> evolution, double last_time,
                         const std::function<double(double tangent)>& jet_time) {
  evolution_ = std::move(evolution);
  last_time_ = last_time;
  const auto tangent = evolution_->first_zero([](const Moment& moment) { return curve(moment).least_advance(); }, 1e-9);
  if (tangent) vertical_tangent_time_ = *tangent * time_;
  well_resolved_until_ = end_time();
  if (vertical_tangent_time_) {
    well_resolved_until_ = std::min(*vertical_tangent_time_ + jet_time(*vertical_tangent_time_), end_time());
  }
  find_touch_down();
}

void MovingSurface::find_touch_down() {
  if (evolution_->ending() == Ending::none) return;
  // The energy tells when two parts of the surface are too close for the markers between them.
  constexpr double resolved = 1e-6;
  constexpr double small_gap = 2 * std::numbers::pi / 20;
  const auto& moments = evolution_->moments();
  const auto lost =
      std::ranges::find_if(moments, [&](const Moment& now) { return energy_error(moments.front(), now) > resolved; });
  if (lost == moments.begin()) return;
  const double last = std::prev(lost)->time;
  const double before = last - 0.01;
  if (before <= 0) return;
  const auto late = curve(evolution_->at(last)).overhang();
  const auto early = curve(evolution_->at(before)).overhang();
  if (!late || !early || late->gap > small_gap || early->gap <= late->gap) return;
  touch_down_time_ = time_ * (last + (last - before) * late->gap / (early->gap - late->gap));
}

double MovingSurface::scaled_time(double t) const {
  require_within("t", t, 0, last_time_);
  const double scaled = t / time_;
  if (scaled > evolution_->now().time) {
    throw Divergence(evolution_->ending_reason(), end_time(), static_cast<long>(steps()),
                     evolution_->ending_place() * length_);
  }
  return scaled;
}

MovingSurface::Profile MovingSurface::profile(double t, std::size_t points) const {
  const Moment moment = evolution_->at(scaled_time(t));
  const auto surface = view(moment.state);
  const auto rate = view(moment.rate);
  const std::size_t n = surface.size();
  Profile result;
  result.time = t;
  const auto add = [&](Complex z, Complex velocity, double potential) {
    result.x.push_back(length_ * z.real());
    result.y.push_back(length_ * z.imag());
    result.potential.push_back(length_ * velocity_ * potential);
    result.u.push_back(velocity_ * velocity.real());
    result.v.push_back(velocity_ * velocity.imag());
  };
  std::vector<Complex> velocity(n);
  std::vector<Complex> potential(n);
  for (std::size_t j = 0; j < n; ++j) {
    velocity[j] = {rate.displacement[j], rate.y[j]};
    potential[j] = surface.potential[j];
    if (points == 0) add({label(j, n) + surface.displacement[j], surface.y[j]}, velocity[j], surface.potential[j]);
  }
  if (points == 0) return result;
  const SurfaceCurve shape = curve(moment);
  const TrigonometricInterpolant velocity_at(velocity);
  const TrigonometricInterpolant potential_at(potential);
  for (const double s : shape.labels_at_equal_arc_length(points)) {
    add(shape.point(s), velocity_at(s), potential_at(s).real());
  }
  return result;
}

MovingSurface::Extremes MovingSurface::extremes(double t) const {
  const SurfaceCurve shape = curve(evolution_->at(scaled_time(t)));
  return {length_ * shape.highest(), length_ * shape.lowest()};
}

double MovingSurface::largest_curvature(double t) const {
  return curve(evolution_->at(scaled_time(t))).largest_curvature() / length_;
}

std::optional<MovingSurface::Jet> MovingSurface::jet(double t) const {
  const auto overhang = curve(evolution_->at(scaled_time(t))).overhang();
  if (!overhang) return {};
  return Jet{length_ * overhang->nose.real(), length_ * overhang->nose.imag(), length_ * overhang->throat.real(),
             length_ * overhang->throat.imag(), length_ * overhang->gap};
}

double MovingSurface::end_time() const {
  return evolution_->ending() == Ending::none ? last_time_ : evolution_->now().time * time_;
}
std::string MovingSurface::ending_reason() const {
  return evolution_->ending_reason();
}
std::size_t MovingSurface::steps() const {
  return evolution_->moments().size() - 1;
}

MovingSurface::Integrals MovingSurface::integrals(double t) const {
  const Invariants sums = evolution_->at(scaled_time(t)).invariants;
  const double area = length_ * length_;
  const double energy = area * velocity_ * velocity_;
  return {area * sums.volume, energy * sums.kinetic_energy, energy * sums.potential_energy,
          area * velocity_ * sums.impulse};
}

SelfTest MovingSurface::balances(double amplitude, double tolerance, const std::optional<Identity>& first) const {
  const double a = amplitude / length_;
  const auto& moments = evolution_->moments();
  const Invariants& start = moments.front().invariants;
  Worst volume, energy, impulse, largest_energy, largest_impulse;
  std::size_t resolved = 0;
  for (const Moment& moment : moments) {
    if (moment.time * time_ > well_resolved_until()) break;
    ++resolved;
    const Invariants& now = moment.invariants;
    volume.add(now.volume - start.volume);
    energy.add(now.energy() - start.energy() - by_pressure(moment.state).work);
    largest_energy.add(now.energy());
    impulse.add(now.impulse - start.impulse - by_pressure(moment.state).thrust);
    largest_impulse.add(now.impulse);
  }
  const auto kept = [&](const std::string& name, double defect, double times) {
    return kept_by_steps(name, defect, static_cast<double>(resolved), tolerance / a, times);
  };
  const bool forced = evolution_->forced();
  SelfTest identities;
  if (first) identities.push_back(*first);
  identities.push_back(kept("volume is conserved", volume.value() / (2 * std::numbers::pi * a), 1));
  identities.push_back(kept(forced ? "energy changes by the work of the pressure" : "energy is conserved",
                            energy.value() / largest_energy.value(), 2));
  identities.push_back(
      kept(forced ? "horizontal impulse changes by the thrust of the pressure" : "horizontal impulse is conserved",
           impulse.value() / largest_impulse.value(), 2));
  return identities;
}

double MovingSurface::distance_from(const MovingSurface& other, double t) const {
  const SurfaceCurve there = curve(other.evolution_->at(other.scaled_time(t)));
  return length_ * curve(evolution_->at(scaled_time(t))).distance(there);
}

}  // namespace seiche::exact::overturning
