#include "seiche/exact/slope_climb/climb.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>

#include "seiche/divergence.hpp"

namespace seiche::exact::slope_climb {
namespace {

namespace odeint = boost::numeric::odeint;
using Complex = std::complex<double>;
using Eigen::Index;

constexpr double held = 4;         // depths at the far end, over which water is let go gradually
constexpr double shortest = 1e-6;  // step

/// From 0 to 1 with three derivatives 0 at both ends.
double smooth_step(double u) {
  const double t = std::clamp(u, 0.0, 1.0);
  return t * t * t * t * (35 + t * (-84 + t * (70 - 20 * t)));
}

}  // namespace

Climb::Climb(double slope, const Eigen::VectorXcd& z, const Eigen::VectorXd& phi, double tolerance)
    : n_(static_cast<std::size_t>(z.size())),
      slope_(slope),
      flow_(n_ - 1, slope),
      state_(3 * n_),
      moved_(z.size()),
      stepper_(odeint::make_controlled(tolerance, 0.0, odeint::runge_kutta_dopri5<State>())) {
  for (std::size_t k = 0; k < n_; ++k) {
    const auto i = static_cast<Index>(k);
    state_[k] = z[i].real();
    state_[n_ + k] = z[i].imag();
    state_[2 * n_ + k] = phi[i];
    moved_[i] = smooth_step((state_[k] - state_[0]) / held);
  }
}

Eigen::VectorXcd Climb::nodes(const State& state) const {
  Eigen::VectorXcd z(static_cast<Index>(n_));
  for (std::size_t k = 0; k < n_; ++k) z[static_cast<Index>(k)] = {state[k], state[n_ + k]};
  return z;
}

void Climb::rate(const State& state, State& rate) {
  rate.resize(state.size());
  flow_.solve(nodes(state), Eigen::Map<const Eigen::VectorXd>(state.data() + 2 * n_, static_cast<Index>(n_)));
  for (std::size_t k = 0; k < n_; ++k) {
    const auto i = static_cast<Index>(k);
    Complex velocity = std::conj(flow_.velocity()[i]);
    if (k + 1 == n_) {
      const Complex up = std::polar(1.0, slope_);
      velocity = up * (velocity * std::conj(up)).real();
    }
    rate[k] = moved_[i] * velocity.real();
    rate[n_ + k] = moved_[i] * velocity.imag();
    rate[2 * n_ + k] = moved_[i] * (std::norm(velocity) / 2 - (state[n_ + k] - 1));
  }
}

void Climb::require_finite() const {
  for (std::size_t k = 0; k < n_; ++k) {
    if (std::isfinite(state_[k]) && std::isfinite(state_[n_ + k]) && std::isfinite(state_[2 * n_ + k])) continue;
    throw Divergence(
        "the surface is not resolved: it overturns at this amplitude and cotangent, or has too few markers", time_,
        steps_, state_[k]);
  }
}

void Climb::filter() {
  for (std::size_t part = 0; part < 3; ++part) {
    Eigen::Map<Eigen::VectorXd> values(state_.data() + part * n_, static_cast<Index>(n_));
    values = flow_.line().filter() * values.eval();
  }
  const Complex up = std::polar(1.0, slope_);
  const Complex shore = up * (Complex(state_[n_ - 1], state_[2 * n_ - 1]) * std::conj(up)).real();
  state_[n_ - 1] = shore.real();
  state_[2 * n_ - 1] = shore.imag();
}

void Climb::step() {
  const auto system = [this](const State& state, State& rate, double /*time*/) { this->rate(state, rate); };
  before_ = state_;
  time_before_ = time_;
  stepper_.reset();  // the filter changed the state since
  while (stepper_.try_step(system, state_, time_, duration_) == odeint::fail) {
    if (duration_ > shortest) continue;
    throw Divergence(
        "steps get shorter without end: the surface overturns at this amplitude and cotangent, or has too few markers",
        time_, steps_, state_[n_ - 1]);
  }
  ++steps_;
  require_finite();
  filter();
}

void Climb::step_back() {
  state_ = before_;
  time_ = time_before_;
}

void Climb::step_to(double time) {
  if (time == time_) return;
  const auto system = [this](const State& state, State& rate, double /*time*/) { this->rate(state, rate); };
  odeint::runge_kutta_dopri5<State> pair;
  pair.do_step(system, state_, time_, time - time_);
  time_ = time;
  require_finite();
}

double Climb::shore_speed() {
  State rates;
  rate(state_, rates);
  return rates[2 * n_ - 1];
}

double Climb::energy() {
  State rates;
  rate(state_, rates);
  const Eigen::VectorXcd z = nodes(state_);
  const Eigen::VectorXcd z_s = flow_.line().differentiation() * z;
  double potential = 0;
  for (Index i = 0; i < z.size(); ++i) {
    potential += flow_.line().weights()[i] * std::pow(z[i].imag() - 1, 2) * z_s[i].real() / 2;
  }
  potential -= std::cos(slope_) / std::sin(slope_) * std::pow(shore(), 3) / 6;  // the slope's side
  return potential +
         flow_.kinetic_energy(Eigen::Map<const Eigen::VectorXd>(state_.data() + 2 * n_, static_cast<Index>(n_)));
}

double Climb::volume() const {
  const Eigen::VectorXcd z = nodes(state_);
  const Eigen::VectorXcd z_s = flow_.line().differentiation() * z;
  double sum = 0;
  for (Index i = 0; i < z.size(); ++i) sum += flow_.line().weights()[i] * (z[i].imag() - 1) * z_s[i].real();
  return sum - std::cos(slope_) / std::sin(slope_) * std::pow(shore(), 2) / 2;
}

}  // namespace seiche::exact::slope_climb
