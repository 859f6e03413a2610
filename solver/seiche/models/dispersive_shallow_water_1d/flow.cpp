#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/composition.hpp"
#include "seiche/mechanics/conservative_step.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/require.hpp"

namespace seiche::dispersive_shallow_water_1d {

class Flow::Stepper {
 public:
  virtual ~Stepper() = default;
  virtual void step(mechanics::State& state, double tau) = 0;
};

template <class Base>
class Flow::StepperOf final : public Flow::Stepper {
 public:
  StepperOf(Model& model, typename Base::Settings settings, TimeComposition composition) : base_(model, settings) {
    if (composition == TimeComposition::triple_jump) composed_.emplace(base_, mechanics::triple_jump_weights());
    if (composition == TimeComposition::suzuki) composed_.emplace(base_, mechanics::suzuki_weights());
  }
  void step(mechanics::State& state, double tau) override {
    if (composed_) {
      composed_->step(state, tau);
    } else {
      base_.step(state, tau);
    }
  }

 private:
  Base base_;
  std::optional<mechanics::Composition<Base>> composed_;
};

Flow::Flow(Channel channel, const Markers& initial, Scheme scheme, Forcing forcing)
    : model_(std::make_unique<Model>(std::move(channel), initial, std::move(forcing))),
      state_(model_->state_of(initial)) {
  require_not_negative("fixed_sweeps", scheme.fixed_sweeps);
  try {
    mechanics::Start(*model_).project(state_);
  } catch (const mechanics::Infeasible& failure) {
    throw Divergence(failure.what(), 0, 0, failure.place());
  }
  if (scheme.stepping == Stepping::conservative) {
    using Step = mechanics::ConservativeStep<Model>;
    stepper_ = std::make_unique<StepperOf<Step>>(
        *model_, Step::Settings{.drift_feedback = scheme.drift_feedback, .fixed_sweeps = scheme.fixed_sweeps},
        scheme.composition);
  } else {
    using Step = mechanics::OneStep<Model>;
    stepper_ = std::make_unique<StepperOf<Step>>(
        *model_, Step::Settings{.drift_feedback = scheme.stepping == Stepping::one_step_feedback}, scheme.composition);
  }
  watch_ = std::make_unique<mechanics::InvariantsWatch<Model>>(*model_, state_);
}

Flow::~Flow() = default;
Flow::Flow(Flow&&) noexcept = default;
Flow& Flow::operator=(Flow&&) noexcept = default;

void Flow::advance(double tau) {
  mechanics::require_step(tau);
  if (tau > stable_step()) ++beyond_stability_;
  stepper_->step(state_, tau);
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
  watch_->record(state_);
}

Stepping stepping_named(std::string_view name) {
  if (name == "one_step") return Stepping::one_step;
  if (name == "one_step_feedback") return Stepping::one_step_feedback;
  if (name == "conservative") return Stepping::conservative;
  throw std::invalid_argument(fmt::format("scheme = \"{}\"; allowed: one_step, one_step_feedback, conservative", name));
}

TimeComposition composition_named(std::string_view name) {
  if (name == "none") return TimeComposition::none;
  if (name == "triple_jump") return TimeComposition::triple_jump;
  if (name == "suzuki") return TimeComposition::suzuki;
  throw std::invalid_argument(fmt::format("composition = \"{}\"; allowed: none, triple_jump, suzuki", name));
}

}  // namespace seiche::dispersive_shallow_water_1d
