#include "seiche/exact/overturning/surface_curve.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/exact/entry.hpp"
#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/linear/fourier.hpp"
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

constexpr std::size_t nodes_per_marker = 16;

/// Largest value of periodic samples, by the parabola through the largest three.
template <class Value>
double maximum(std::size_t n, const Value& value) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < n; ++i) {
    if (value(i) > value(largest)) largest = i;
  }
  const double middle = value(largest);
  const double before = value((largest + n - 1) % n) - middle;
  const double after = value((largest + 1) % n) - middle;
  const double curvature = before + after;
  return curvature < 0 ? middle - (after - before) * (after - before) / (8 * curvature) : middle;
}

}  // namespace

TrigonometricInterpolant::TrigonometricInterpolant(std::span<const Complex> samples)
    : coefficients_(samples.size()), lowest_(-static_cast<long>((samples.size() - 1) / 2)) {
  linear::Fourier fourier(samples.size());
  fourier.coefficients(samples, coefficients_);
  std::ranges::rotate(coefficients_, coefficients_.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2 + 1));
  // The sawtooth has no derivative at its samples and no values in between.
  if (samples.size() % 2 == 0) coefficients_.back() = 0;
}

Complex TrigonometricInterpolant::operator()(double s) const {
  const Complex step(std::cos(s), std::sin(s));
  Complex sum = 0;
  for (auto c = coefficients_.rbegin(); c != coefficients_.rend(); ++c) sum = sum * step + *c;
  const double first = static_cast<double>(lowest_) * s;
  return sum * Complex(std::cos(first), std::sin(first));
}

TrigonometricInterpolant TrigonometricInterpolant::derivative() const {
  TrigonometricInterpolant result = *this;
  for (std::size_t i = 0; i < coefficients_.size(); ++i) {
    result.coefficients_[i] *= Complex(0, static_cast<double>(lowest_ + static_cast<long>(i)));
  }
  return result;
}

std::vector<Complex> TrigonometricInterpolant::refined(std::size_t refinement) const {
  const std::size_t n = coefficients_.size() * refinement;
  std::vector<Complex> values(n);
  for (std::size_t i = 0; i < coefficients_.size(); ++i) {
    const long k = lowest_ + static_cast<long>(i);
    values[k >= 0 ? static_cast<std::size_t>(k) : n - static_cast<std::size_t>(-k)] = coefficients_[i];
  }
  linear::Fourier(n).samples(values, values);
  return values;
}

SurfaceCurve::SurfaceCurve(std::span<const Complex> displacements)
    : periodic_((require_at_least("points", static_cast<long>(displacements.size()), 8), displacements)),
      tangent_(periodic_.derivative()),
      nodes_(periodic_.refined(nodes_per_marker)),
      tangents_(tangent_.refined(nodes_per_marker)) {
  for (Complex& z_s : tangents_) z_s += 1;
}

std::vector<double> SurfaceCurve::labels_at_equal_arc_length(std::size_t points) const {
  require_at_least("points", static_cast<long>(points), 2);
  const std::size_t n = tangents_.size();
  std::vector<Complex> speed(n);
  std::ranges::transform(tangents_, speed.begin(), [](Complex z_s) { return std::abs(z_s); });
  // Integral of the trigonometric interpolant of |z_s|, 0 at s = 0.
  linear::Fourier fourier(n);
  std::vector<Complex> arc(n);
  fourier.coefficients(speed, arc);
  const double mean = arc[0].real();
  arc[0] = 0;
  for (std::size_t i = 1; i < n; ++i) arc[i] = fourier.is_sawtooth(i) ? 0 : arc[i] / Complex(0, fourier.wavenumber(i));
  fourier.samples(arc, arc);
  const double start = arc[0].real();
  const double width = 2 * std::numbers::pi / static_cast<double>(n);
  std::vector<double> labels(points);
  std::size_t j = 0;
  const auto length_at = [&](std::size_t i) {
    return i == n ? 2 * std::numbers::pi * mean : mean * width * static_cast<double>(i) + arc[i].real() - start;
  };
  for (std::size_t p = 0; p + 1 < points; ++p) {
    const double wanted = 2 * std::numbers::pi * mean * static_cast<double>(p) / static_cast<double>(points - 1);
    while (j + 1 < n && length_at(j + 1) <= wanted) ++j;
    // Inverse function between two nodes: cubic in the length, with slopes 1/|z_s|.
    const double a = length_at(j);
    const double span = length_at(j + 1) - a;
    const double u = (wanted - a) / span;
    const double slope_a = span / (speed[j].real() * width);
    const double slope_b = span / (speed[(j + 1) % n].real() * width);
    const double value = u * u * (3 - 2 * u) + u * (1 - u) * ((1 - u) * slope_a - u * slope_b);
    labels[p] = width * (static_cast<double>(j) + value);
  }
  labels.back() = 2 * std::numbers::pi;
  return labels;
}

Complex SurfaceCurve::node(std::size_t i) const {
  const std::size_t n = nodes_.size();
  return nodes_[i % n] + label(i, n);
}

double SurfaceCurve::least_advance() const {
  return -maximum(tangents_.size(), [&](std::size_t i) { return -tangents_[i].real(); });
}

double SurfaceCurve::largest_curvature() const {
  const auto second = tangent_.derivative().refined(nodes_per_marker);
  return maximum(tangents_.size(), [&](std::size_t i) {
    return std::abs((std::conj(tangents_[i]) * second[i]).imag()) / std::pow(std::abs(tangents_[i]), 3);
  });
}

double SurfaceCurve::highest() const {
  return maximum(nodes_.size(), [&](std::size_t i) { return nodes_[i].imag(); });
}

double SurfaceCurve::lowest() const {
  return -maximum(nodes_.size(), [&](std::size_t i) { return -nodes_[i].imag(); });
}

double SurfaceCurve::label_of_vertical_tangent(std::size_t i) const {
  const std::size_t n = tangents_.size();
  const double a = tangents_[i % n].real();
  const double b = tangents_[(i + 1) % n].real();
  return label(i, n) + label(1, n) * a / (a - b);
}

std::optional<SurfaceCurve::Overhang> SurfaceCurve::overhang() const {
  const std::size_t n = tangents_.size();
  const auto recedes = [&](std::size_t i) { return tangents_[i % n].real() < 0; };
  std::optional<Overhang> widest;
  for (std::size_t i = 0; i < n; ++i) {
    if (recedes(i) || !recedes(i + 1)) continue;
    std::size_t end = i + 1;
    while (recedes(end + 1)) ++end;
    const Complex nose = point(label_of_vertical_tangent(i));
    const Complex throat = point(label_of_vertical_tangent(end));
    const double width = nose.real() - throat.real();
    if (!widest || width > widest->nose.real() - widest->throat.real()) widest = {nose, throat, gap(i, end)};
  }
  return widest;
}

double SurfaceCurve::gap(std::size_t nose, std::size_t throat) const {
  const std::size_t n = nodes_.size();
  const double middle = 0.5 * (node(nose).real() + node(throat).real());
  double least = std::numeric_limits<double>::infinity();
  // Upper side of the jet down to half its length, and its lower side; water ahead as far as one jet length.
  std::size_t first = nose;
  while (nose - first < n / 4 && first > 0 && node(first - 1).real() > middle) --first;
  for (std::size_t i = first; i < throat && node(i).real() > middle; i += 2) {
    for (std::size_t j = throat; j < throat + n / 2; j += 2) least = std::min(least, std::norm(node(j) - node(i)));
  }
  return std::sqrt(least);
}

double SurfaceCurve::distance(Complex place) const {
  const auto apart = [&](Complex z) {
    const Complex d = z - place;
    return Complex(d.real() - 2 * std::numbers::pi * std::round(d.real() / (2 * std::numbers::pi)), d.imag());
  };
  Smallest least;
  for (std::size_t i = 0; i < nodes_.size(); ++i) least.add(std::norm(apart(node(i))), label(i, nodes_.size()));
  // Gauss and Newton's iteration for the foot point: curves as close as these need no second derivative.
  double s = least.where();
  for (int i = 0; i < 4; ++i) {
    const Complex z_s = 1.0 + tangent_(s);
    s -= (std::conj(z_s) * apart(point(s))).real() / std::norm(z_s);
  }
  return std::sqrt(std::min(least.value(), std::norm(apart(point(s)))));
}

double SurfaceCurve::distance(const SurfaceCurve& other) const {
  constexpr std::size_t stride = 4;
  Largest largest;
  for (std::size_t i = 0; i < nodes_.size(); i += stride) largest.add(other.distance(node(i)));
  for (std::size_t i = 0; i < other.nodes_.size(); i += stride) largest.add(distance(other.node(i)));
  return largest.value();
}

MovingSurface::MovingSurface(double wavelength, double gravity, double scale, Computation coarser)
    : length_(wavelength / (2 * std::numbers::pi)),
      time_(std::sqrt(length_ / gravity)),
      velocity_(std::sqrt(length_ * gravity)),
      scale_(scale),
      coarser_(std::move(coarser)) {}

void MovingSurface::compute(Evolution motion, double last_time, const std::function<double(double tangent)>& jet_time,
                            double kink) {
  motion.advance_to(std::min(kink, last_time / time_));
  motion.advance_to(last_time / time_);
  evolution_ = std::make_shared<const Evolution>(std::move(motion));
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
    throw Divergence(fmt::format("t = {:g} is after the end of the wave: {}", t, evolution_->ending_reason()),
                     end_time(), static_cast<long>(steps()), evolution_->ending_place() * length_);
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
