#include "seiche/exact/overturning/evolution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <boost/math/tools/toms748_solve.hpp>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact::overturning {

namespace {

/// Moments that the first guess of psi_s is extrapolated from: more cost more round-off than they gain.
constexpr std::size_t guess_moments = 6;

/// Power of the step by which the intermediate surfaces of stages 2 to 7 depart from the motion.
constexpr std::array stage_order{2, 3, 3, 3, 3, 6};

/// Lagrange's polynomial through the last moments at a later time.
void extrapolate(std::span<const Moment> past, double time, Eigen::VectorXd& psi_s) {
  const auto nodes = past.last(std::min(past.size(), guess_moments));
  psi_s.setZero(nodes.back().psi_s.size());
  for (const Moment& node : nodes) {
    double weight = 1;
    for (const Moment& other : nodes) {
      if (&other != &node) weight *= (time - other.time) / (node.time - other.time);
    }
    psi_s += weight * node.psi_s;
  }
}

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

Complex place(SurfaceView<const double> surface, std::size_t j) {
  return {label(j, surface.size()) + surface.displacement[j], surface.y[j]};
}

double damping(double wavenumber, std::size_t markers) {
  return std::exp(-36 * std::pow(2 * std::abs(wavenumber) / static_cast<double>(markers), 28));
}

}  // namespace

double energy_error(const Moment& start, const Moment& now) {
  const double before = start.invariants.energy();
  const double after = now.invariants.energy();
  const double defect = after - before - by_pressure(now.state).work;
  return defect == 0 ? 0 : std::abs(defect) / std::max(before, after);
}

void Stepper::rate(const State& state, double time, State& rate, Eigen::VectorXd& psi_s) {
  const auto surface = view(state);
  velocity_.solve(surface, psi_s);
  const auto change = view(rate);
  const std::size_t n = surface.size();
  double power = 0;
  double force = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Complex zeta = place(surface, i);
    const Complex f = velocity_.velocity(i);
    const double shrinks = 1 / std::norm(bars_.slope(zeta));
    change.displacement[i] = shrinks * f.real();
    change.y[i] = -shrinks * f.imag();
    change.potential[i] = 0.5 * shrinks * std::norm(f) - (zeta + bars_.offset(zeta)).imag();
    if (!pressure_) continue;
    const double p = pressure_(zeta.real(), time);
    change.potential[i] -= p;
    power += p * psi_s[static_cast<Eigen::Index>(i)];
    force += p * velocity_.tangent(i).imag();
  }
  by_pressure(rate).work = label(1, n) * power;
  by_pressure(rate).thrust = label(1, n) * force;
}

Moment Stepper::begin(double time, State state) {
  Moment moment{.time = time, .state = std::move(state), .rate = {}, .psi_s = {}, .invariants = {}};
  moment.rate.resize(moment.state.size());
  moment.psi_s.setZero(static_cast<Eigen::Index>(marker_count(moment.state)));
  // Nothing is known of psi_s yet, and the invariants of this moment are what later ones are compared with.
  velocity_.solve(view(std::as_const(moment.state)), moment.psi_s, 1e-15);
  rate(moment.state, time, moment.rate, moment.psi_s);
  moment.invariants = velocity_.invariants(view(std::as_const(moment.state)), moment.psi_s, bars_);
  return moment;
}

Stepper::Result Stepper::step(std::span<const Moment> past, double duration) {
  const Moment& from = past.back();
  Result result{from, 0};
  Moment& to = result.moment;
  to.time = from.time + duration;
  std::size_t stage = 0;
  Eigen::VectorXd extrapolated;
  const auto system = [&](const State& state, State& change, double time) {
    change.resize(state.size());
    extrapolate(past, time, extrapolated);
    Eigen::VectorXd& departure = departures_[stage];
    to.psi_s = extrapolated;
    if (last_duration_ > 0) to.psi_s += std::pow(duration / last_duration_, stage_order[stage]) * departure;
    rate(state, time, change, to.psi_s);
    departure = to.psi_s - extrapolated;
    ++stage;
  };
  State difference(from.state.size());
  pair_.do_step(system, from.state, from.rate, from.time, to.state, to.rate, duration, difference);
  for (const double d : difference) {
    if (!(std::abs(d) <= result.error)) result.error = std::abs(d);  // keeps a NaN
  }
  last_duration_ = std::isfinite(result.error) ? duration : 0;
  to.invariants = velocity_.invariants(view(std::as_const(to.state)), to.psi_s, bars_);
  return result;
}

Evolution::Evolution(State initial, double depth, double tolerance, SurfacePressure pressure, Bars bars)
    : depth_(depth),
      tolerance_(std::max(tolerance, roundoff_of_step)),
      pressure_(std::move(pressure)),
      bars_(bars),
      stepper_(marker_count(initial), depth, pressure_, bars),
      fourier_(marker_count(initial)),
      coefficients_(marker_count(initial)) {
  require_positive("tolerance", tolerance);
  const auto surface = view(initial);
  for (std::size_t j = 0; j < surface.size(); ++j) {
    const Complex offset = bars_.offset(bars_.origin(place(view(std::as_const(initial)), j)));
    surface.displacement[j] -= offset.real();
    surface.y[j] -= offset.imag();
  }
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
  if (ending_ == Ending::step_collapse) {
    return fmt::format("two parts of the surface touch (time step below {:g} of sqrt(1/(g k)))", shortest_step);
  }
  if (ending_ == Ending::energy) {
    return fmt::format("the markers no longer resolve the surface (energy changed by more than {:g} of itself)",
                       resolution_lost);
  }
  if (ending_ == Ending::none) return "";
  return fmt::format(
      "the markers no longer resolve the surface (upper half of the spectrum above {:g} of its largest coefficient)",
      resolution_lost);
}

Moment Evolution::in_space(Moment moment) const {
  const auto surface = view(moment.state);
  const auto rate = view(moment.rate);
  for (std::size_t j = 0; j < surface.size(); ++j) {
    const Complex zeta = place(view(std::as_const(moment.state)), j);
    const Complex offset = bars_.offset(zeta);
    const Complex velocity = bars_.slope(zeta) * Complex(rate.displacement[j], rate.y[j]);
    surface.displacement[j] += offset.real();
    surface.y[j] += offset.imag();
    rate.displacement[j] = velocity.real();
    rate.y[j] = velocity.imag();
  }
  return moment;
}

double Evolution::ending_place() const {
  // Where a surface breaks, the fluid is accelerated most.
  const Moment last = in_space(now());
  const auto surface = view(last.state);
  const auto rate = view(last.rate);
  Largest fastest;
  for (std::size_t j = 0; j < surface.size(); ++j) {
    fastest.add(std::hypot(rate.displacement[j], rate.y[j]), label(j, surface.size()) + surface.displacement[j]);
  }
  return fastest.where();
}

Moment Evolution::at(double time) const {
  require_that<std::out_of_range>(time >= moments_.front().time && time <= now().time, "time {} outside [0, {}]", time,
                                  now().time);
  const auto next = std::ranges::upper_bound(moments_, time, {}, &Moment::time);
  const std::span<const Moment> past(moments_.begin(), next);
  if (past.back().time == time) return in_space(past.back());
  Stepper stepper(marker_count(now().state), depth_, pressure_, bars_);
  return in_space(stepper.step(past, time - past.back().time).moment);
}

std::optional<double> Evolution::first_zero(const std::function<double(const Moment&)>& g, double accuracy) const {
  double before = g(in_space(moments_.front()));
  for (std::size_t m = 1; m < moments_.size(); ++m) {
    const double after = g(in_space(moments_[m]));
    if (after <= 0) {
      const auto close = [accuracy](double a, double b) { return b - a < accuracy; };
      std::uintmax_t evaluations = 60;
      return boost::math::tools::toms748_solve([&](double t) { return g(at(t)); }, moments_[m - 1].time,
                                               moments_[m].time, before, after, close, evaluations)
          .second;
    }
    before = after;
  }
  return {};
}

State from_functions(std::size_t markers, const std::function<double(double)>& elevation,
                     const std::function<double(double)>& potential) {
  State state = still_water(markers);
  const auto surface = view(state);
  for (std::size_t j = 0; j < markers; ++j) {
    surface.y[j] = elevation(label(j, markers));
    surface.potential[j] = potential(label(j, markers));
  }
  return state;
}

State sinusoidal_wave(std::size_t markers, double amplitude, double depth) {
  const auto elevation = [&](double x) { return amplitude * std::cos(x); };
  return from_functions(markers, elevation, [&](double x) {
    const double y = elevation(x);
    // cosh(y + h)/cosh(h) without overflow in deep water.
    const double decay = (std::exp(y) + std::exp(-y - 2 * depth)) / (1 + std::exp(-2 * depth));
    return amplitude / std::sqrt(std::tanh(depth)) * decay * std::sin(x);
  });
}

}  // namespace seiche::exact::overturning
