// What integrators are put together from: weights of compositions, lengths of steps, tolerances.
#include <cmath>
#include <vector>

#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/reference_integrators.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/all_hold.hpp"
#include "verification/check.hpp"
#include "verification/timed_steps.hpp"

namespace seiche::verification::integrator_parts_test {

using namespace mechanics;
using rigid_chain::RigidChain;

double sum_of_powers(const std::vector<double>& weights, int power) {
  Mean mean;
  for (const double weight : weights) mean.add(std::pow(weight, power));
  return mean.sum();
}

/// Largest difference of the weights read forwards and backwards.
double asymmetry(const std::vector<double>& weights) {
  Worst worst;
  for (std::size_t k = 0; k < weights.size(); ++k) worst.add(weights[k] - weights[weights.size() - 1 - k]);
  return worst.value();
}

/// Error of x'' = -x after a time of 20, in tolerances per step.
double oscillator_error(AdaptiveMethod method, double tolerance) {
  std::vector<double> x = {1, 0};
  const long evaluations = integrate_adaptive(
      method,
      [](Input at, Output slope, double) {
        slope[0] = at[1];
        slope[1] = -at[0];
      },
      x, 0, 20, tolerance);
  const long in_a_step = method == AdaptiveMethod::dormand_prince_5 ? 6 : 13;
  const double steps = static_cast<double>(evaluations) / static_cast<double>(in_a_step);
  return std::hypot(x[0] - std::cos(20.0), x[1] + std::sin(20.0)) / (tolerance * steps);
}

TEST_CASE("weights of compositions meet the conditions of order four", "[mechanics]") {
  Check check("composition_weights", "Weights of compositions",
              "A symmetric composition of a symmetric step of order two is of order four when its weights add up to "
              "one and their cubes to zero. An error in the last digits of a weight shows in no observed order.");
  // The cubes of the halves of a pair are an eighth of the stage's each: a quarter of nothing.
  for (const auto& [name, weights] :
       {std::pair{"the triple jump", triple_jump_weights()}, std::pair{"Suzuki's composition", suzuki_weights()}}) {
    all_hold(check, Roundoff{10, 5, "at most ten rounded weights, their cubes up to 5"},
             {{fmt::format("The weights of {} add up to one.", name), sum_of_powers(weights, 1), 1},
              {fmt::format("The cubes of the weights of {} add up to zero.", name), sum_of_powers(weights, 3)},
              {fmt::format("The weights of {} are symmetric.", name), asymmetry(weights)}});
  }
}

TEST_CASE("equal steps are no longer than asked for and end at the time", "[mechanics]") {
  Check check("equal_step_lengths", "Steps of equal length",
              "From 0.5 to 2 by steps of at most 0.4: four steps of 0.375.");
  State state;
  state.time = 0.5;
  std::vector<double> lengths;
  TimedSteps flow{state, [&](double length) { lengths.push_back(length); }};
  march(flow, 2, 0.4);
  const Roundoff rounding{.operations = 4, .scale = 2, .reason = "a rounded time per step"};
  all_hold(check, rounding,
           {{"The number of steps is the smallest that fits.", static_cast<double>(lengths.size()), 4},
            {"The longest is the time over their number.", largest(lengths), 0.375},
            {"The shortest step equals the time over the number of steps.", smallest(lengths), 0.375},
            {"The last step ends exactly at the end time.", state.time, 2}});
  state.time = 0.5;
  lengths.clear();
  march(flow, 2, 0.3);
  all_hold(check, rounding,
           {{"A time of five whole steps is divided into five.", static_cast<double>(lengths.size()), 5}});
}

TEST_CASE("errors of adaptive methods stay within their tolerance", "[mechanics]") {
  Check check("adaptive_tolerances", "Tolerances of the adaptive methods",
              "A harmonic oscillator over three periods, which carries the errors of the steps on without growth.");
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    for (const AdaptiveMethod method : {AdaptiveMethod::dormand_prince_5, AdaptiveMethod::fehlberg_78}) {
      const bool fifth = method == AdaptiveMethod::dormand_prince_5;
      check.holds(fifth ? "Dormand and Prince's method holds its error to the tolerance over all steps."
                        : "Fehlberg's method of order seven holds its error to the tolerance over all steps.",
                  {oscillator_error(method, tolerance)},
                  Bound{3 * std::sqrt(2.0),
                        "of each of two numbers a step errs by the tolerance times one and their magnitudes and "
                        "changes, each at most one"});
    }
  }
}

TEST_CASE("RATTLE satisfies the constraints in positions and velocities", "[mechanics]") {
  Check check("rattle_constraints", "Constraints under RATTLE",
              "Spherical double pendulum, unit links, 1000 steps of 0.01; constraints of positions and of velocities "
              "after each step.");
  RigidChain chain = rigid_chain::double_pendulum();
  State state = rigid_chain::spiral_start(chain);
  Rattle<RigidChain> rattle(chain);
  std::vector<double> values(chain.constraints());
  Worst positions, velocities;
  for (int n = 0; n < 1000; ++n) {
    rattle.step(state, 0.01);
    chain.constraint_values(state.q, values);
    positions.add(worst(values));
    chain.linearise({state.time, 0}, state.q);
    chain.constraint_rates(state.u, values);
    velocities.add(worst(values));
  }
  const auto claim = [&](const std::string& text, double value, const std::string& reason) {
    check.holds(text, {value}, Roundoff{10, 10, reason});
  };
  claim("Link lengths are constant to round-off in each step.", positions.value(),
        "products of coordinates up to 2 and of their differences, ten to a link; roundings do not accumulate");
  claim("Velocities along the links vanish to round-off.", velocities.value(),
        "products of velocities up to 3 with differences up to 2, ten to a link; roundings do not accumulate");
}

}  // namespace seiche::verification::integrator_parts_test
