/// The W-orthogonal projection of rates on {u : J u = target}, at the linearised configuration:
///
/// @f[ A \mu = \mathrm{target} - J u^*, \qquad \tilde{u} = u^* + W J^T \mu, \qquad A = J W J^T \tag{Frank 1994, 5} @f]
///
/// mu is the impulse of the multipliers: lambda = 2 mu/tau in a step of length tau.
#pragma once

#include <algorithm>
#include <vector>

#include "seiche/mechanics/constrained_model.hpp"

namespace seiche::mechanics {

template <ConstrainedModel Model>
class Projection {
 public:
  explicit Projection(Model& model) : model_(model) {}

  /// @param u       on entry u*, on exit u~
  /// @param target  empty for zero
  /// @param mu      constraint_count(model) impulses; on entry a guess, which only iterative solvers use
  void project(Output u, Input target, Output mu) {
    if constexpr (ProjectsItself<Model>) {
      model_.project(u, target, mu);
    } else {
      defect(u, target);
      model_.solve(right_hand_side_, mu);
      model_.react(mu, u);
    }
  }

  /// One correction of u and mu towards the target with whatever factorisation the model holds: with that of another
  /// configuration the defect shrinks by a factor, with its own it vanishes. On entry u already holds the reaction to
  /// mu.
  void correct(Output u, Input target, Output mu) {
    defect(u, target);
    correction_.assign(mu.size(), 0.0);
    model_.solve(right_hand_side_, correction_);
    for (std::size_t s = 0; s < mu.size(); ++s) mu[s] += correction_[s];
    model_.react(correction_, u);
  }

 private:
  void defect(Input u, Input target) {
    right_hand_side_.resize(model_.constraints());
    model_.constraint_rates(u, right_hand_side_);
    if (target.empty()) {
      for (double& r : right_hand_side_) r = -r;
    } else {
      for (std::size_t s = 0; s < target.size(); ++s) right_hand_side_[s] = target[s] - right_hand_side_[s];
    }
  }

  Model& model_;
  std::vector<double> right_hand_side_;
  std::vector<double> correction_;
};

}  // namespace seiche::mechanics
