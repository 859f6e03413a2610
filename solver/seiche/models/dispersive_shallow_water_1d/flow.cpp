#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/models/dispersive_shallow_water_1d/integrators.hpp"
#include "seiche/require.hpp"

namespace seiche::dispersive_shallow_water_1d {

Flow::Flow(Channel channel, const Markers& initial, Scheme scheme, Forcing forcing)
    : model_(std::make_unique<Model>(std::move(channel), initial, std::move(forcing))),
      state_(model_->state_of(initial)) {
  try {
    mechanics::Start(*model_).project(state_);
  } catch (const mechanics::Infeasible& failure) {
    throw Divergence(failure.what(), 0, 0, failure.place());
  }
  stepper_ = std::make_unique<mechanics::SchemeStepper<Model>>(*model_, scheme);
  watch_ = std::make_unique<mechanics::InvariantsWatch<Model>>(*model_, state_);
}

Flow::~Flow() = default;
Flow::Flow(Flow&&) noexcept = default;
Flow& Flow::operator=(Flow&&) noexcept = default;

void Flow::advance(double tau) {
  mechanics::require_step(tau);
  const bool beyond = tau > stable_step();
  if (model_->loses()) {
    before_ = state_;
    const auto books = std::tuple(friction_, breaking_, friction_impulse_, model_->fronts());
    try {
      lose(tau / 2);
      stepper_->step(state_, tau);
      lose(tau / 2);
    } catch (const Divergence&) {
      state_ = before_;
      std::tie(friction_, breaking_, friction_impulse_, model_->fronts()) = books;
      throw;
    }
  } else {
    stepper_->step(state_, tau);
  }
  beyond_stability_ += beyond ? 1 : 0;
}

/// Half of a step's losses before it and half after it: second order, as the step itself.
void Flow::lose(double h) {
  try {
    const Losses lost = model_->lose(h, state_.q, state_.u);
    friction_.add(lost.friction);
    breaking_.add(lost.breaking);
    friction_impulse_.add(lost.friction_impulse);
  } catch (const mechanics::Infeasible& failure) {
    throw Divergence(failure.what(), state_.time, state_.steps, failure.place());
  }
}

Losses Flow::lost() const {
  return {friction_.value(), breaking_.value(), friction_impulse_.value()};
}

void Flow::advance_to(double time, double tau, const std::function<void()>& after_step, double courant) {
  mechanics::require_step(tau);
  require_positive("courant", courant);
  if (!(time >= state_.time && std::isfinite(time))) {
    throw std::invalid_argument(
        fmt::format("time = {:g}; allowed: finite, at least the present {:g}", time, state_.time));
  }
  // Equal steps: the last one is not a sliver, which would also spoil the order of the scheme.
  while (state_.time < time) {
    const double rest = time - state_.time;
    const double longest = std::min(tau, courant * stable_step());
    const double steps = std::ceil(rest / longest - 1e-9);
    if (steps <= 1) {
      advance(rest);
      state_.time = time;
    } else {
      advance(rest / steps);
    }
    if (after_step) after_step();
  }
}

double Flow::stable_step() const {
  return 2 * std::sqrt(model_->channel().alpha * model_->smallest_depth() / model_->channel().gravity);
}

long Flow::solves() const {
  return model_->solves();
}

std::vector<double> Flow::u() const {
  std::vector<double> u(model_->size());
  std::vector<double> v(model_->size());
  model_->velocities(state_.q, state_.u, u, v);
  return u;
}

std::vector<double> Flow::v() const {
  std::vector<double> u(model_->size());
  std::vector<double> v(model_->size());
  model_->velocities(state_.q, state_.u, u, v);
  return v;
}

std::vector<double> Flow::elevation_at(std::span<const double> places) const {
  const Channel& channel = model_->channel();
  const std::span<const double> xs = x();
  const std::span<const double> ys = y();
  const std::size_t n = xs.size();
  const auto between = [](double place, double x0, double y0, double x1, double y1) {
    return y0 + (y1 - y0) * (place - x0) / (x1 - x0);
  };
  std::vector<double> elevation;
  for (double place : places) {
    if (channel.periodic()) place -= channel.period * std::floor((place - xs[0]) / channel.period);
    const auto k = static_cast<std::size_t>(std::upper_bound(xs.begin(), xs.end(), place) - xs.begin());
    if (k > 0 && k < n) {
      elevation.push_back(between(place, xs[k - 1], ys[k - 1], xs[k], ys[k]));
    } else if (channel.periodic()) {
      elevation.push_back(between(place, xs[n - 1], ys[n - 1], xs[0] + channel.period, ys[0]));
    } else if (place == xs[n - 1]) {
      elevation.push_back(ys[n - 1]);
    } else if ((k == 0 ? channel.left : channel.right) == End::tip) {
      elevation.push_back(channel.bottom->elevation(place));
    } else {
      elevation.push_back(std::numeric_limits<double>::quiet_NaN());
    }
  }
  return elevation;
}

Flow::Crest Flow::crest() const {
  const std::span<const double> xs = x();
  const std::span<const double> ys = y();
  const auto k = static_cast<std::size_t>(std::max_element(ys.begin() + 1, ys.end() - 1) - ys.begin());
  const double left = xs[k - 1] - xs[k];
  const double right = xs[k + 1] - xs[k];
  const double slope_left = (ys[k - 1] - ys[k]) / left;
  const double slope_right = (ys[k + 1] - ys[k]) / right;
  const double curvature = (slope_right - slope_left) / (right - left);
  if (!(curvature < 0)) return {xs[k], ys[k]};
  const double slope = slope_left - curvature * left;  // of the parabola at marker k
  const double shift = -slope / (2 * curvature);
  return {xs[k] + shift, ys[k] + 0.5 * slope * shift};
}

double Flow::energy() const {
  return model_->kinetic_energy(state_.q, state_.u) + model_->potential_energy(state_.q);
}

void Flow::observe() {
  const Losses now = lost();
  mechanics::InvariantsLedger& ledger = watch_->ledger();
  const auto book = [&](const std::string& name, double amount) {
    ledger.book(static_cast<std::size_t>(&ledger.entry(name) - ledger.entries().data()), amount);
  };
  book("energy", booked_.friction - now.friction + booked_.breaking - now.breaking);
  book("momentum_x", booked_.friction_impulse - now.friction_impulse);
  booked_ = now;
  watch_->record(state_);
}

}  // namespace seiche::dispersive_shallow_water_1d
