/// The stepping of a model's own run, by settings: one-step or conservative, with or without composition.
#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "seiche/mechanics/conservative_step.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/require.hpp"

namespace seiche::mechanics {

// Symmetric compositions: a step of order four from steps of order two, with every invariant that each of them keeps.
//
//     triple jump   w = g, 1 - 2g, g         g = 1/(2 - 2^(1/3))
//     Suzuki        w = g, g, 1 - 4g, g, g   g = 1/(4 - 4^(1/3)), error about 60 times smaller
//
// For tau -> 0 one step of the constrained scheme is a reflection, not the identity: each stage is a pair of half
// steps, which is near the identity for any initial velocity.
//
// References: Yoshida, Construction of higher order symplectic integrators, Phys. Lett. A 150 (1990) 262; Suzuki,
// Fractal decomposition of exponential operators, Phys. Lett. A 146 (1990) 319; Hairer, Lubich & Wanner, Geometric
// Numerical Integration, 2nd ed. (2006), II.4.

template <class Step>
concept Stepper = requires(Step& stepper, State& state, double tau) {
  stepper.substep(state, tau);
};

/// Lengths of the half stages in units of the step; their sum is 1.
std::vector<double> triple_jump_weights();
std::vector<double> suzuki_weights();

template <Stepper Step>
class Composition {
 public:
  /// @param base  must outlive the composition
  Composition(Step& base, std::vector<double> weights) : base_(base), weights_(std::move(weights)) {}

  /// Throws what the base throws; the state is then as before the step.
  void step(State& state, double tau) {
    require_step(tau);
    next_ = state;
    for (const double weight : weights_) base_.substep(next_, weight * tau);
    next_.time = state.time + tau;
    ++next_.steps;
    std::swap(state, next_);
  }

 private:
  Step& base_;
  std::vector<double> weights_;
  State next_;
};

/// one_step: Frank's scheme, one solve per step. one_step_feedback: constraints do not drift. conservative: energy and
/// constraints to round-off, several solves per step.
enum class Stepping { one_step, one_step_feedback, conservative };
/// Of order four in time from the stepping of order two.
enum class TimeComposition { none, triple_jump, suzuki };

/// Throw std::invalid_argument listing the names there are.
Stepping stepping_named(std::string_view name);
TimeComposition composition_named(std::string_view name);

struct Scheme {
  Stepping stepping = Stepping::one_step;
  TimeComposition composition = TimeComposition::none;
  int fixed_sweeps = 0;         ///< of the conservative stepping; 0: until they no longer change
  bool drift_feedback = false;  ///< in the conservative stepping: removes the round-off drift of the constraints too
};

using StepFunction = std::function<void(State& state, double tau)>;

/// Steps of Base, or of a composition of it. @param model  must outlive the result
template <Stepper Base, ConstrainedModel Model>
StepFunction composed(Model& model, typename Base::Settings settings, TimeComposition composition) {
  const auto base = std::make_shared<Base>(model, settings);
  if (composition == TimeComposition::none) return [base](State& state, double tau) { base->step(state, tau); };
  const bool jump = composition == TimeComposition::triple_jump;
  const auto whole = std::make_shared<Composition<Base>>(*base, jump ? triple_jump_weights() : suzuki_weights());
  return [base, whole](State& state, double tau) { whole->step(state, tau); };
}

/// Steps a model by the scheme asked for.
template <ConstrainedModel Model>
requires HasDiscreteGradients<Model>
class SchemeStepper {
 public:
  /// @param model  must outlive the stepper. Throws std::invalid_argument for a negative number of sweeps.
  SchemeStepper(Model& model, Scheme scheme) {
    require_not_negative("fixed_sweeps", scheme.fixed_sweeps);
    if (scheme.stepping == Stepping::conservative) {
      step_ = composed<ConservativeStep<Model>>(
          model, {.drift_feedback = scheme.drift_feedback, .fixed_sweeps = scheme.fixed_sweeps}, scheme.composition);
    } else {
      step_ = composed<OneStep<Model>>(model, {.drift_feedback = scheme.stepping == Stepping::one_step_feedback},
                                       scheme.composition);
    }
  }

  /// One step, tau > 0, with the errors of OneStep and ConservativeStep.
  void step(State& state, double tau) { step_(state, tau); }

 private:
  StepFunction step_;
};

}  // namespace seiche::mechanics
