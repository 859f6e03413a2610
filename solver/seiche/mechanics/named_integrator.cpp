#include "seiche/mechanics/named_integrator.hpp"

namespace seiche::mechanics {

namespace {

struct Description {
  std::string_view name;
  std::string_view title;
  int order;
  bool keeps_energy;
  std::size_t stages;
};

Description describe(Integrator integrator) {
  switch (integrator) {
    case Integrator::triple_jump:
      return {"triple_jump", "its triple jump", 4, true, 6};
    case Integrator::suzuki:
      return {"suzuki", "its Suzuki composition", 4, true, 10};
    case Integrator::conservative:
      return {"conservative", "fully conservative", 2, true, 1};
    case Integrator::conservative_suzuki:
      return {"conservative_suzuki", "Suzuki of the fully conservative", 4, true, 10};
    case Integrator::runge_kutta_2:
      return {"runge_kutta_2", "RK2", 2, false, 1};
    case Integrator::runge_kutta_4:
      return {"runge_kutta_4", "RK4", 4, false, 1};
    case Integrator::rattle:
      return {"rattle", "RATTLE", 2, false, 1};
    case Integrator::one_step:
      break;
  }
  return {"one_step", "one-step scheme", 2, true, 1};
}

}  // namespace

std::string_view name(Integrator integrator) {
  return describe(integrator).name;
}

std::string_view title(Integrator integrator) {
  return describe(integrator).title;
}

int order(Integrator integrator) {
  return describe(integrator).order;
}

bool keeps_energy(Integrator integrator) {
  return describe(integrator).keeps_energy;
}

std::size_t stages(Integrator integrator) {
  return describe(integrator).stages;
}

}  // namespace seiche::mechanics
