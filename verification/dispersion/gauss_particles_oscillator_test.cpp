// The linear law of the conservative scheme of free particles: leapfrog's, with its limit of stability.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/gauss_particles/field_space.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::gauss_particles_oscillator_test {

using namespace gauss_particles;
using namespace mechanics;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 6";

/// The one field of the stream function (x^2 - 1) y: along walls at x = -1, 1 and a bottom at y = 0.
Point mode(Point r) {
  return {r.x * r.x - 1, -2 * r.x * r.y};
}

/// Water in [-1, 1] x [0, 1] that can only slosh in this mode.
class Slosh {
 public:
  Slosh()
      : model_(layer(water()), std::make_unique<PolynomialSpace>(std::vector<StreamFunction>{{{1, 2, 1}, {-1, 0, 1}}}),
               {.gravity = 1, .penalty = 0}) {
    const Particles& at = model_.particles();
    double stiffness = 0;
    for (std::size_t k = 0; k < at.size(); ++k) {
      const Point v = mode({at.x[k], at.y[k]});
      inertia_ += at.mass[k] * (v.x * v.x + v.y * v.y);
      // m g times the derivative of the mode's vertical velocity along the mode.
      stiffness += at.mass[k] * 2 * at.y[k] * (1 + at.x[k] * at.x[k]);
    }
    frequency_ = std::sqrt(stiffness / inertia_);
  }

  [[nodiscard]] double frequency() const { return frequency_; }

  /// Amplitudes of the velocity over that of the beginning, after each of so many steps.
  std::vector<double> amplitudes(double tau, int steps) {
    State state = model_.state([](Point r) { return amplitude * mode(r); });
    OneStep<Model> step(model_);
    std::vector<double> result;
    const Particles& at = model_.particles();
    for (int n = 0; n < steps; ++n) {
      step.step(state, tau);
      double sum = 0;
      for (std::size_t k = 0; k < at.size(); ++k) {
        const Point v = mode({at.x[k], at.y[k]});
        sum += at.mass[k] * (state.u[k] * v.x + state.u[at.size() + k] * v.y);
      }
      result.push_back(sum / (inertia_ * amplitude));
    }
    return result;
  }

  static constexpr double amplitude = 1e-6;

 private:
  static Layer water() {
    Layer box{.begin = -1, .end = 1, .columns = 16, .rows = 8, .end_corrected = false};
    box.surface = [](double) { return 1.0; };
    box.bottom = [](double) { return 0.0; };
    return box;
  }
  Model model_;
  double inertia_ = 0, frequency_ = 0;
};

TEST_CASE("a mode of Gauss-principle particles oscillates at the leapfrog frequency", "[dispersion]") {
  Check check("gauss_particles_oscillator", "Gauss-principle particles: phase and stability of one mode",
              "Water that can only slosh by the stream function (x^2 - 1) y has one frequency omega_0, which follows "
              "from sums over its particles. With steps of length tau it oscillates with $\\sin(\\omega\\tau/2) = "
              "\\omega_0\\tau/2$; beyond omega_0 tau = 2 it grows, by leapfrog's rate.",
              source);
  Slosh water;
  for (const double phase : {0.2, 1.0, 1.9}) {
    const double omega_tau = 2 * std::asin(phase / 2);
    Worst difference;
    const std::vector<double> found = water.amplitudes(phase / water.frequency(), 100);
    for (std::size_t n = 0; n < found.size(); ++n) {
      difference.add(found[n] - std::cos(omega_tau * static_cast<double>(n + 1)));
    }
    check.holds(fmt::format("The amplitude is cos(n omega tau) with omega_0 tau = {:g}.", phase), {difference.value()},
                Bound{1e-7,
                      "100 steps of roundings of 1e-16 of velocities g tau, over an amplitude of 1e-6: 1e-8; terms of "
                      "the square of the amplitude: 1e-10. A law of another coefficient errs by 1e-2."});
  }
  check.at("128 particles, amplitude 1e-6");
  check.that("stable", "The amplitude at omega_0 tau = 1.99 is bounded.", "largest amplitude over 2000 steps",
             {worst(water.amplitudes(1.99 / water.frequency(), 2000))},
             Bound{1 + 2e-6,
                   "the law gives 1; 2000 steps of roundings of 1e-10 of it, which near the limit are magnified by "
                   "1/sqrt(1 - (omega_0 tau/2)^2) = 10"});
  const double unstable = 2.01, rate = std::acosh(unstable * unstable / 2 - 1);
  check.that("unstable", "The amplitude at omega_0 tau = 2.01 grows at the rate of leapfrog.",
             "amplitude after 30 steps", {water.amplitudes(unstable / water.frequency(), 30).back()},
             Bound{1e-6,
                   "the square of the largest amplitude, 2e-4, over the 25 steps or so in which it is as large; "
                   "roundings of 1e-10 over 30 steps are less",
                   std::cosh(30 * rate), true});
}

}  // namespace seiche::verification::gauss_particles_oscillator_test
