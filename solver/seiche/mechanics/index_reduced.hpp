/// The index-reduced form of the constrained equations: constraints differentiated twice, multipliers eliminated.
///
/// @f[ A(q) \, \lambda = -(J W F + B(u, u)), \qquad \dot{u} = W (F + J^T \lambda), \qquad
///     B(u, v) = \left( \frac{\partial J}{\partial q} \cdot S u \right) v @f]
///
/// What Runge-Kutta methods integrate, and the acceleration that the corrected start needs. Not for prescribed nodes:
/// their accelerations are not part of the model's interface.
///
/// Reference: Hairer & Wanner, Solving Ordinary Differential Equations II, 2nd ed. (1996), VII.1.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "seiche/mechanics/constrained_model.hpp"

namespace seiche::mechanics {

template <ConstrainedModel Model>
requires HasMultipliers<Model>
class IndexReduced {
 public:
  explicit IndexReduced(Model& model) : model_(model) {}

  /// u' at (time, q, u). Leaves the model linearised at q.
  void acceleration(double time, Input q, Input u, Output result) {
    curvature(time, q, u, u);
    std::fill(result.begin(), result.end(), 0.0);
    kick(u, result);
    rates_.resize(model_.constraints());
    model_.constraint_rates(result, rates_);
    for (std::size_t s = 0; s < rates_.size(); ++s) rates_[s] = -(rates_[s] + curvature_[s]);
    multipliers_.assign(rates_.size(), 0.0);
    model_.solve(rates_, multipliers_);
    model_.react(multipliers_, result);
  }

  /// B(u, v) at (time, q). Leaves the model linearised at q. Without the model's own Hessians: central difference of J
  /// along u, exact but for round-off if J is linear in q.
  Input curvature(double time, Input q, Input u, Input v) {
    if constexpr (HasCurvature<Model>) {
      model_.linearise({time, 0}, q);
      curvature_.resize(model_.constraints());
      model_.curvature(u, v, curvature_);
    } else {
      difference(time, q, u, v);
      model_.linearise({time, 0}, q);
    }
    return curvature_;
  }

  [[nodiscard]] Input multipliers() const { return multipliers_; }
  [[nodiscard]] Model& model() { return model_; }

 private:
  /// In which the fastest coordinate goes a small part of a cell, of models that say what a cell is; else of 1.
  double short_time(Input u) const {
    double speed = 0;
    for (const double rate : u) speed = std::max(speed, std::abs(rate));
    double length = relative_step;
    if constexpr (requires { model_.cell_size(); }) length *= model_.cell_size();
    return speed > 0 ? length / speed : length;
  }

  /// By the forces alone: what drags take of velocities that start from zero does not count over a short time.
  void kick(Input u, Output result) const {
    if constexpr (requires { model_.cell_size(); }) {
      const double h = short_time(u);
      model_.kick(h, result);
      for (double& rate : result) rate /= h;
    } else {
      model_.kick(1, result);
    }
  }

  void difference(double time, Input q, Input u, Input v) {
    const double h = short_time(u);
    moved_.resize(q.size());
    // The first linearisation at q fixes S there, so that advance moves along S(q) u in both directions.
    model_.linearise({time, 0}, q);
    ahead_.resize(q.size());
    model_.advance(q, u, h, ahead_);
    model_.advance(q, u, -h, moved_);
    model_.linearise({time, 0}, ahead_);
    curvature_.resize(model_.constraints());
    model_.constraint_rates(v, curvature_);
    model_.linearise({time, 0}, moved_);
    rates_.resize(model_.constraints());
    model_.constraint_rates(v, rates_);
    for (std::size_t s = 0; s < rates_.size(); ++s) curvature_[s] = (curvature_[s] - rates_[s]) / (2 * h);
  }

  static constexpr double relative_step = 6e-6;  // cube root of the machine precision

  Model& model_;
  std::vector<double> curvature_, rates_, multipliers_, moved_, ahead_;
};

}  // namespace seiche::mechanics
