#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/require.hpp"

namespace seiche::dispersive_shallow_water_1d {

Flow::Flow(Channel channel, const Markers& initial, Scheme scheme, Forcing forcing) {
  auto model = std::make_unique<Model>(std::move(channel), initial, std::move(forcing));
  mechanics::State state = model->state_of(initial);
  begin_at_first(std::move(model), std::move(state));
  stepper_ = std::make_unique<mechanics::SchemeStepper<Model>>(*model_, scheme);
}

void Flow::advance(double tau) {
  mechanics::require_step(tau);
  if (model_->loses()) {
    step_and_lose(tau);
  } else {
    stepper_->step(state_, tau);
  }
}

/// Half of a step's losses before it and half after it: second order, as the step itself.
void Flow::step_and_lose(double tau) {
  const std::optional<BreakingFronts> fronts = model_->fronts();
  mechanics::State next = state_;
  std::array<Losses, 2> losses;
  try {
    mechanics::StepParts<Model>::guarded(state_, [&] {
      losses[0] = model_->lose(tau / 2, next.q, next.u);
      stepper_->step(next, tau);
      losses[1] = model_->lose(tau / 2, next.q, next.u);
    });
  } catch (...) {
    model_->take_back(fronts);
    throw;
  }
  std::swap(state_, next);
  for (const Losses& lost : losses) {
    friction_.add(lost.friction);
    breaking_.add(lost.breaking);
    friction_impulse_.add(lost.friction_impulse);
    watch_->ledger().book("energy", -lost.friction - lost.breaking);
    watch_->ledger().book("momentum_x", -lost.friction_impulse);
  }
}

double Flow::stable_step() const {
  return 2 * std::sqrt(model_->channel().alpha * model_->smallest_depth() / model_->channel().gravity);
}

std::vector<double> Flow::velocity(std::size_t axis) const {
  std::array<std::vector<double>, 2> uv;
  for (std::vector<double>& component : uv) component.resize(model_->size());
  model_->velocities(state_.q, state_.u, uv[0], uv[1]);
  return uv[axis];
}

std::vector<double> Flow::interpolated(std::span<const double> ys, std::span<const double> places) const {
  const Channel& channel = model_->channel();
  const std::span<const double> xs = x();
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

}  // namespace seiche::dispersive_shallow_water_1d

template class seiche::mechanics::OneStep<seiche::dispersive_shallow_water_1d::Model>;
template class seiche::mechanics::ConservativeStep<seiche::dispersive_shallow_water_1d::Model>;
template class seiche::mechanics::SchemeStepper<seiche::dispersive_shallow_water_1d::Model>;
template class seiche::mechanics::Start<seiche::dispersive_shallow_water_1d::Model>;
template class seiche::mechanics::InvariantsWatch<seiche::dispersive_shallow_water_1d::Model>;
