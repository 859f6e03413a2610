#include "seiche/mechanics/adaptive_runge_kutta.hpp"

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

}  // namespace seiche::mechanics
