#include "validation/instruments/mechanics/reference_integrators.hpp"

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "seiche/require.hpp"

namespace seiche::mechanics {

long integrate_adaptive(AdaptiveMethod method, const std::function<void(Input x, Output slope, double time)>& slope,
                        std::vector<double>& x, double begin, double end, double tolerance) {
  namespace odeint = boost::numeric::odeint;
  using Vector = std::vector<double>;
  require_positive("end - begin", end - begin);
  require_positive("tolerance", tolerance);
  long evaluations = 0;
  const auto system = [&](const Vector& at, Vector& result, double time) {
    ++evaluations;
    slope(at, result, time);
  };
  const double first = (end - begin) / 100;
  if (method == AdaptiveMethod::dormand_prince_5) {
    odeint::integrate_adaptive(odeint::make_controlled<odeint::runge_kutta_dopri5<Vector>>(tolerance, tolerance),
                               system, x, begin, end, first);
  } else {
    odeint::integrate_adaptive(odeint::make_controlled<odeint::runge_kutta_fehlberg78<Vector>>(tolerance, tolerance),
                               system, x, begin, end, first);
  }
  return evaluations;
}

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
