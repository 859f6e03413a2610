/// Every integrator of constant step by name, for comparisons: one call that hides what it is made of.
///
/// When not to use it: in a model's own run, which names its integrator's type and keeps its settings.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string_view>

#include "seiche/mechanics/composition.hpp"
#include "seiche/mechanics/conservative_step.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/reference_integrators.hpp"

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

using StepFunction = std::function<void(State& state, double tau)>;

/// One step, with the errors of the integrator it stands for. @param model  must outlive the result
template <ConstrainedModel Model>
StepFunction make_integrator(Integrator integrator, Model& model) {
  const auto plain = [](auto stepper) -> StepFunction {
    return [stepper](State& state, double tau) { stepper->step(state, tau); };
  };
  const auto composed = [](auto base, std::vector<double> weights) -> StepFunction {
    const auto stepper =
        std::make_shared<Composition<typename decltype(base)::element_type>>(*base, std::move(weights));
    return [base, stepper](State& state, double tau) { stepper->step(state, tau); };
  };
  const auto one_step = [&] { return std::make_shared<OneStep<Model>>(model); };
  const auto conservative = [&] { return std::make_shared<ConservativeStep<Model>>(model); };
  switch (integrator) {
    case Integrator::triple_jump:
      return composed(one_step(), triple_jump_weights());
    case Integrator::suzuki:
      return composed(one_step(), suzuki_weights());
    case Integrator::conservative:
      return plain(conservative());
    case Integrator::conservative_suzuki:
      return composed(conservative(), suzuki_weights());
    case Integrator::runge_kutta_2:
      return plain(std::make_shared<RungeKutta2<Model>>(model));
    case Integrator::runge_kutta_4:
      return plain(std::make_shared<RungeKutta4<Model>>(model));
    case Integrator::rattle:
      return plain(std::make_shared<Rattle<Model>>(model));
    case Integrator::one_step:
      break;
  }
  return plain(one_step());
}

}  // namespace seiche::mechanics
