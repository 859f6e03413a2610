/// The stepping of a model's own run, by settings: one-step or conservative, with or without composition.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "seiche/mechanics/composition.hpp"
#include "seiche/mechanics/conservative_step.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/require.hpp"

namespace seiche::mechanics {

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

/// Steps a model by the scheme asked for.
template <ConstrainedModel Model>
requires HasDiscreteGradients<Model>
class SchemeStepper {
 public:
  /// @param model  must outlive the stepper. Throws std::invalid_argument for a negative number of sweeps.
  SchemeStepper(Model& model, Scheme scheme) {
    require_not_negative("fixed_sweeps", scheme.fixed_sweeps);
    if (scheme.stepping == Stepping::conservative) {
      using Step = ConservativeStep<Model>;
      stepper_ = std::make_unique<Composed<Step>>(
          model, typename Step::Settings{.drift_feedback = scheme.drift_feedback, .fixed_sweeps = scheme.fixed_sweeps},
          scheme.composition);
    } else {
      using Step = OneStep<Model>;
      stepper_ = std::make_unique<Composed<Step>>(
          model, typename Step::Settings{.drift_feedback = scheme.stepping == Stepping::one_step_feedback},
          scheme.composition);
    }
  }

  /// One step, tau > 0, with the errors of OneStep and ConservativeStep.
  void step(State& state, double tau) { stepper_->step(state, tau); }

 private:
  class AnyStep {
   public:
    virtual ~AnyStep() = default;
    virtual void step(State& state, double tau) = 0;
  };
  template <class Base>
  class Composed final : public AnyStep {
   public:
    Composed(Model& model, typename Base::Settings settings, TimeComposition composition) : base_(model, settings) {
      if (composition == TimeComposition::triple_jump) composed_.emplace(base_, triple_jump_weights());
      if (composition == TimeComposition::suzuki) composed_.emplace(base_, suzuki_weights());
    }
    void step(State& state, double tau) override {
      if (composed_) {
        composed_->step(state, tau);
      } else {
        base_.step(state, tau);
      }
    }

   private:
    Base base_;
    std::optional<Composition<Base>> composed_;
  };

  std::unique_ptr<AnyStep> stepper_;
};

}  // namespace seiche::mechanics
