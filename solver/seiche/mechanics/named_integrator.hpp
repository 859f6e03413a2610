/// Every integrator of constant step by name, for comparisons: one call that hides what it is made of.
///
/// When not to use it: in a model's own run, which names its integrator's type and keeps its settings.
#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "seiche/mechanics/reference_integrators.hpp"
#include "seiche/mechanics/scheme.hpp"

namespace seiche::mechanics {

enum class Integrator {
  one_step,
  triple_jump,
  suzuki,
  conservative,
  conservative_suzuki,
  runge_kutta_2,
  runge_kutta_4,
  rattle
};

inline constexpr std::array all_integrators{Integrator::one_step,
                                            Integrator::triple_jump,
                                            Integrator::suzuki,
                                            Integrator::conservative,
                                            Integrator::conservative_suzuki,
                                            Integrator::runge_kutta_2,
                                            Integrator::runge_kutta_4,
                                            Integrator::rattle};

std::string_view name(Integrator integrator);   ///< "one_step", ...
std::string_view title(Integrator integrator);  ///< for figures: "its Suzuki composition", ...
int order(Integrator integrator);
/// Whether it keeps the energy to round-off for a linear potential.
bool keeps_energy(Integrator integrator);
/// Steps of second order that one step is composed of.
std::size_t stages(Integrator integrator);

/// One step, with the errors of the integrator it stands for. @param model  must outlive the result
template <ConstrainedModel Model>
StepFunction make_integrator(Integrator integrator, Model& model) {
  using enum TimeComposition;
  const auto reference = [](auto stepper) -> StepFunction {
    return [stepper](State& state, double tau) { stepper->step(state, tau); };
  };
  switch (integrator) {
    case Integrator::triple_jump:
      return composed<OneStep<Model>>(model, {}, triple_jump);
    case Integrator::suzuki:
      return composed<OneStep<Model>>(model, {}, suzuki);
    case Integrator::conservative:
      return composed<ConservativeStep<Model>>(model, {}, none);
    case Integrator::conservative_suzuki:
      return composed<ConservativeStep<Model>>(model, {}, suzuki);
    case Integrator::runge_kutta_2:
      return reference(std::make_shared<RungeKutta2<Model>>(model));
    case Integrator::runge_kutta_4:
      return reference(std::make_shared<RungeKutta4<Model>>(model));
    case Integrator::rattle:
      return reference(std::make_shared<Rattle<Model>>(model));
    case Integrator::one_step:
      break;
  }
  return composed<OneStep<Model>>(model, {}, none);
}

}  // namespace seiche::mechanics
