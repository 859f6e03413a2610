#include "seiche/exact/overturning/stepper.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const std::complex<double> f = velocity_.velocity(i);
    change.displacement[i] = f.real();
    change.y[i] = -f.imag();
    change.potential[i] = 0.5 * std::norm(f) - surface.y[i];
  }
  by_pressure(rate).work = 0;
  by_pressure(rate).thrust = 0;
  if (pressure_) add_pressure(state, time, rate, psi_s);
}

void Stepper::add_pressure(const State& state, double time, State& rate, const Eigen::VectorXd& psi_s) const {
  const auto surface = view(state);
  const auto change = view(rate);
  const std::size_t n = surface.size();
  double power = 0;
  double force = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double p = pressure_(label(i, n) + surface.displacement[i], time);
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
  moment.invariants = velocity_.invariants(view(std::as_const(moment.state)), moment.psi_s);
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
  to.invariants = velocity_.invariants(view(std::as_const(to.state)), to.psi_s);
  return result;
}

}  // namespace seiche::exact::overturning
