#include "seiche/exact/overturning/evolution.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/require.hpp"

namespace seiche::exact::overturning {
namespace {

using Complex = std::complex<double>;

/// Relative change of the energy beyond the work of a pressure, or relative size of the upper half of the spectrum, at
/// which the surface is no longer resolved.
constexpr double resolution_lost = 3e-3;
/// Differences of the two orders below this are rounding errors, which shorter steps do not lower.
constexpr double roundoff_of_step = 2e-13;
/// Steps need not follow what the markers no longer resolve: tolerance of a step in terms of the energy error so far.
constexpr double share_of_energy_error = 1e-4;
/// A step this short, in units of sqrt(1/(g k)), has met a singularity: two parts of the surface touch.
constexpr double shortest_step = 1e-6;
constexpr double longest_step = 0.25;

double damping(double wavenumber, std::size_t markers) {
  return std::exp(-36 * std::pow(2 * std::abs(wavenumber) / static_cast<double>(markers), 28));
}

}  // namespace

Evolution::Evolution(State initial, double depth, double tolerance, SurfacePressure pressure)
    : depth_(depth),
      tolerance_(std::max(tolerance, roundoff_of_step)),
      pressure_(std::move(pressure)),
      stepper_(marker_count(initial), depth, pressure_),
      fourier_(marker_count(initial)),
      coefficients_(marker_count(initial)) {
  require_positive("tolerance", tolerance);
  moments_.push_back(stepper_.begin(0, std::move(initial)));
}

void Evolution::filter(State& state) {
  const auto surface = view(state);
  const std::size_t n = surface.size();
  const auto damp = [&] {
    fourier_.coefficients(coefficients_, coefficients_);
    for (std::size_t k = 0; k < n; ++k) coefficients_[k] *= damping(fourier_.wavenumber(k), n);
  };
  for (std::size_t j = 0; j < n; ++j) coefficients_[j] = surface.potential[j];
  damp();
  fourier_.samples(coefficients_, coefficients_);
  for (std::size_t j = 0; j < n; ++j) surface.potential[j] = coefficients_[j].real();
  for (std::size_t j = 0; j < n; ++j) coefficients_[j] = {surface.displacement[j], surface.y[j]};
  damp();
  double largest = 0;
  double tail = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double size = std::abs(coefficients_[k]);
    if (std::abs(fourier_.wavenumber(k)) >= 0.25 * static_cast<double>(n)) tail = std::max(tail, size);
    largest = std::max(largest, size);
  }
  tail_ = tail / largest;
  fourier_.samples(coefficients_, coefficients_);
  for (std::size_t j = 0; j < n; ++j) {
    surface.displacement[j] = coefficients_[j].real();
    surface.y[j] = coefficients_[j].imag();
  }
}

void Evolution::advance_to(double time) {
  while (now().time < time && ending_ == Ending::none) {
    const double left = time - now().time;
    // The last two steps are made equal rather than leaving a sliver.
    const double duration = duration_ >= left ? left : std::min(duration_, 0.5 * left);
    auto [next, error] = stepper_.step(moments_, duration);
    const double tolerance = std::max(tolerance_, share_of_energy_error * energy_error_);
    const bool accepted = error <= tolerance;
    if (accepted) {
      if (duration == left) next.time = time;
      filter(next.state);
      energy_error_ = energy_error(moments_.front(), next);
      if (!(energy_error_ <= resolution_lost)) ending_ = Ending::energy;
      if (tail_ > resolution_lost) ending_ = Ending::spectral_tail;
      moments_.push_back(std::move(next));
    }
    const double factor = std::isfinite(error) ? 0.9 * std::pow(tolerance / std::max(error, 1e-30), 0.2) : 0.2;
    const double proposal = duration * std::clamp(factor, 0.2, accepted ? 5.0 : 0.9);
    if (!accepted || duration == duration_ || proposal < duration_) duration_ = std::min(proposal, longest_step);
    if (!accepted && duration_ < shortest_step) ending_ = Ending::step_collapse;
  }
}

std::string Evolution::ending_reason() const {
  switch (ending_) {
    case Ending::none:
      return "";
    case Ending::step_collapse:
      return fmt::format("time step below {:g} of sqrt(1/(g k)): two parts of the surface touch", shortest_step);
    case Ending::energy:
      return fmt::format("energy changed by more than {:g} of itself: surface not resolved", resolution_lost);
    case Ending::spectral_tail:
      return fmt::format("upper half of the spectrum above {:g} of its largest coefficient: surface not resolved",
                         resolution_lost);
  }
  return "";
}

double Evolution::ending_place() const {
  // Where a surface breaks, the fluid is accelerated most.
  const auto surface = view(now().state);
  const auto rate = view(now().rate);
  std::size_t place = 0;
  double fastest = 0;
  for (std::size_t j = 0; j < surface.size(); ++j) {
    const double speed = std::hypot(rate.displacement[j], rate.y[j]);
    if (speed > fastest) {
      fastest = speed;
      place = j;
    }
  }
  return label(place, surface.size()) + surface.displacement[place];
}

Moment Evolution::at(double time) const {
  if (!(time >= moments_.front().time && time <= now().time)) {
    throw std::out_of_range(fmt::format("time {} outside [0, {}]", time, now().time));
  }
  const auto next = std::ranges::upper_bound(moments_, time, {}, &Moment::time);
  const std::span<const Moment> past(moments_.begin(), next);
  if (past.back().time == time) return past.back();
  return Stepper(marker_count(now().state), depth_, pressure_).step(past, time - past.back().time).moment;
}

std::optional<double> Evolution::first_zero(const std::function<double(const Moment&)>& g, double accuracy) const {
  double before = g(moments_.front());
  for (std::size_t m = 1; m < moments_.size(); ++m) {
    const double after = g(moments_[m]);
    if (after <= 0) {
      const auto at_time = [&](double t) { return g(at(t)); };
      double a = moments_[m - 1].time;
      double b = moments_[m].time;
      double ga = before;
      double gb = after;
      // Illinois: regula falsi that halves the value kept twice.
      while (b - a > accuracy && gb != 0) {
        const double t = (a * gb - b * ga) / (gb - ga);
        const double gt = at_time(t);
        if (std::min(t - a, b - t) < accuracy) return t;
        if (gt > 0) {
          a = t;
          ga = gt;
          gb *= 0.5;
        } else {
          b = t;
          gb = gt;
          ga *= 0.5;
        }
      }
      return b;
    }
    before = after;
  }
  return {};
}

}  // namespace seiche::exact::overturning
