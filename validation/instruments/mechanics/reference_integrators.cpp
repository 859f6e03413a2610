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

const IntegratorFacts& facts_of(Integrator integrator) {
  static constexpr std::array<IntegratorFacts, all_integrators.size()> facts{
      {{"one_step", "one-step scheme", 2, true},
       {"triple_jump", "its triple jump", 4, true},
       {"suzuki", "its Suzuki composition", 4, true},
       {"conservative", "fully conservative", 2, true},
       {"conservative_suzuki", "Suzuki of the fully conservative", 4, true},
       {"runge_kutta_2", "RK2", 2, false},
       {"runge_kutta_4", "RK4", 4, false},
       {"rattle", "RATTLE", 2, false}}};
  return facts[static_cast<std::size_t>(integrator)];
}

}  // namespace seiche::mechanics
