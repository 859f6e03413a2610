/// A flow of the discrete dispersive shallow-water model: a channel with markers, stepped by one of the schemes.
///
///     Channel channel{.bottom = std::make_shared<LevelBottom>(1.0), .period = 60};
///     Flow flow(channel, solitary_markers(channel, 0, 60, 0.25, {.amplitude = 0.3, .crest = 20}));
///     while (flow.time() < 20) flow.advance(0.1);
///
/// The first velocities are projected on constant volumes. Throws std::invalid_argument for bad input and Divergence,
/// with time, step and place, when markers cross, the water is gone, a marker leaves the bottom profile, or a value is
/// not finite.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/mechanics/model_flow.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/model.hpp"
#include "seiche/models/dispersive_shallow_water_1d/model.hpp"

// The integrators of the model, compiled once and not in every file that steps it.
extern template class seiche::mechanics::OneStep<seiche::dispersive_shallow_water_1d::Model>;
extern template class seiche::mechanics::ConservativeStep<seiche::dispersive_shallow_water_1d::Model>;
extern template class seiche::mechanics::SchemeStepper<seiche::dispersive_shallow_water_1d::Model>;
extern template class seiche::mechanics::Start<seiche::dispersive_shallow_water_1d::Model>;
extern template class seiche::mechanics::InvariantsWatch<seiche::dispersive_shallow_water_1d::Model>;

namespace seiche::dispersive_shallow_water_1d {

using mechanics::Scheme;
using mechanics::Stepping;
using mechanics::TimeComposition;

class Flow : public mechanics::ModelFlow<Model> {
 public:
  Flow(Channel channel, const Markers& initial, Scheme scheme = {}, Forcing forcing = {});

  /// One step of length tau > 0. A throw leaves the state, what was lost and what breaks as they were.
  void advance(double tau) override;

  /// Longest stable step of the one-step scheme: 2/omega of the fastest mode, 2 sqrt(alpha H/g) with the smallest depth
  /// H (over markers that are not tips) seen in the last step. Conservative steps are stable beyond it but may not
  /// converge.
  [[nodiscard]] double stable_step() const;

  /// Tridiagonal solves so far.
  [[nodiscard]] long solves() const { return model_->solves(); }

  [[nodiscard]] std::span<const double> x() const { return {state_.q.data(), model_->size()}; }
  [[nodiscard]] std::span<const double> y() const { return {state_.q.data() + model_->size(), model_->size()}; }
  /// Rates along the bottom and normal to it.
  [[nodiscard]] std::span<const double> p() const { return {state_.u.data(), model_->size()}; }
  [[nodiscard]] std::span<const double> r() const { return {state_.u.data() + model_->size(), model_->size()}; }
  /// Velocities of the markers.
  [[nodiscard]] std::vector<double> u() const { return velocity(0); }
  [[nodiscard]] std::vector<double> v() const { return velocity(1); }
  /// Pressure multipliers of the cells at the middle of the last step [Pa], lambda = rho g y + dynamic pressure.
  [[nodiscard]] std::span<const double> multipliers() const { return state_.multipliers; }

  /// Surface elevation at places, linear between markers; the bottom beyond a tip, NaN beyond other ends.
  [[nodiscard]] std::vector<double> elevation_at(std::span<const double> places) const {
    return interpolated(y(), places);
  }
  /// The same of any other elevations at the markers.
  [[nodiscard]] std::vector<double> interpolated(std::span<const double> ys, std::span<const double> places) const;
  /// Highest point of the parabola through the highest marker and its neighbours (of markers that are not ends).
  struct Crest {
    double place = 0;
    double elevation = 0;
  };
  [[nodiscard]] Crest crest() const;

  /// What friction and breaking took since the beginning; it is booked.
  [[nodiscard]] Losses lost() const { return {friction_.value(), breaking_.value(), friction_impulse_.value()}; }

 private:
  [[nodiscard]] std::vector<double> velocity(std::size_t axis) const;
  void step_and_lose(double tau);

  std::unique_ptr<mechanics::SchemeStepper<Model>> stepper_;
  CompensatedSum friction_, breaking_, friction_impulse_;
};

using mechanics::composition_named;
using mechanics::stepping_named;

}  // namespace seiche::dispersive_shallow_water_1d
