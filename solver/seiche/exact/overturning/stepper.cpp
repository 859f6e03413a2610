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

void Stepper::rate(const State& state, State& rate, Eigen::VectorXd& psi_s) {
  const auto surface = view(state);
  velocity_.solve(surface, psi_s);
  const auto change = view(rate);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const std::complex<double> f = velocity_.velocity(i);
    change.displacement[i] = f.real();
    change.y[i] = -f.imag();
    change.potential[i] = 0.5 * std::norm(f) - surface.y[i];
  }
}

Moment Stepper::begin(double time, State state) {
  Moment moment{.time = time, .state = std::move(state), .rate = {}, .psi_s = {}, .invariants = {}};
  moment.rate.resize(moment.state.size());
  moment.psi_s.setZero(static_cast<Eigen::Index>(moment.state.size() / 3));
  // Nothing is known of psi_s yet, and the invariants of this moment are what later ones are compared with.
  velocity_.solve(view(std::as_const(moment.state)), moment.psi_s, 1e-15);
  rate(moment.state, moment.rate, moment.psi_s);
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
    rate(state, change, to.psi_s);
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
