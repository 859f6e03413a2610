// Energy and momenta of free particles under Gauss's principle, with another space of fields at every step.
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/differences.hpp"

namespace seiche::verification::gauss_particles_invariants_test {

using namespace gauss_particles;
using namespace mechanics;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 6";

/// A vortical velocity field that is no polynomial.
Point vortical(Point r) {
  // Stream function 0.3 sin 2x cos 1.5y + 0.2 x y^2 - 0.4 (x^2 + y^2)/2 + 0.3 y.
  return {-0.45 * std::sin(2 * r.x) * std::sin(1.5 * r.y) + 0.4 * r.x * r.y - 0.4 * r.y + 0.3,
          -0.6 * std::cos(2 * r.x) * std::cos(1.5 * r.y) - 0.2 * r.y * r.y + 0.4 * r.x};
}

/// Of energy, momentum and angular momentum.
struct Sums {
  double energy = 0, momentum = 0, angular_momentum = 0;
};

/// Sums of magnitudes, which is what rounding works on.
Sums scales(const Model& model, const State& state) {
  Sums sum;
  const std::size_t n = model.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double speed = std::hypot(state.u[k], state.u[n + k]);
    const double mass = model.particles().mass[k];
    sum.energy += 0.5 * mass * speed * speed;
    sum.momentum += mass * speed;
    sum.angular_momentum += mass * speed * std::hypot(state.q[k], state.q[n + k]);
  }
  return sum;
}

/// A power of two: the same tau g is added to all velocities at every step, and where it is rounded it is rounded to
/// the same side as long as these stay between two powers of two.
constexpr double tau = 1.0 / 2048;
constexpr long steps = 1000;

struct Defects {
  Sums largest, scales;
};

/// A drop of 768 particles; impulse and torque of gravity are booked.
template <template <class> class Step>
Defects run(const LatticeAt& lattice, double gravity) {
  Model model(disc(1, 16), std::make_unique<SplineSpace>(gauss_particles::Ground{}, lattice, SplineSpace::Settings{}),
              {.gravity = gravity, .penalty = 0});
  State state = model.state(vortical);
  Step<Model> step(model);
  InvariantsWatch watch(model, state);
  const std::size_t n = model.size();
  for (long k = 0; k < steps; ++k) {
    step.step(state, tau);
    // Entries: mass, momentum along x and y, angular momentum, energy.
    double torque = 0;
    for (std::size_t i = 0; i < n; ++i) torque -= model.particles().mass[i] * gravity * model.places()[i];
    watch.ledger().book(2, -model.mass() * gravity * tau);
    watch.ledger().book(3, torque * tau);
    watch.record(state);
  }
  const InvariantsLedger& ledger = watch.ledger();
  return {{ledger.largest_defect("energy"), ledger.largest_defect("momentum"), ledger.largest_defect("angular")},
          scales(model, state)};
}

LatticeAt shifted() {
  return LatticePlan{.degree = 3, .cell_x = 0.3, .shift = true};
}

/// Another degree, another pair of cells and another place at every step.
LatticeAt anything() {
  return [](Interval when, const Bounds& water) {
    const auto step = std::lround(when.begin / tau);
    const auto part = [&](long of) { return static_cast<double>((step * 7919 + of * 104729) % 1000) / 1000; };
    return LatticePlan{.degree = 2 + static_cast<int>(step % 3),
                       .cell_x = 0.24 + 0.16 * part(1),
                       .cell_y = 0.24 + 0.16 * part(2),
                       .shift = true}(when, water);
  };
}

/// @param fall  kinetic energy that was potential energy; none: energy is not kept
void keeps(Check& check, const std::string& id, const std::string& text, const Defects& d, std::optional<double> fall) {
  const auto claim = [&](const std::string& what, double value, double scale, const std::string& reason) {
    check.that({id + "-" + what, text + ": " + what + " to round-off.", "largest error of the " + what, "1", source},
               {.value = value, .resolution = "768 particles, tau = 1/2048, 1000 steps"},
               Roundoff{steps, scale, "one rounded velocity per step; scale: " + reason});
  };
  const auto& [energy, momentum, angular_momentum] = d.scales;
  if (fall) {
    claim("energy", d.largest.energy, energy + *fall, "kinetic energy, and the potential energy that was lost");
  }
  claim("momentum", d.largest.momentum, momentum, "sum of m |u| at the end");
  claim("angular_momentum", d.largest.angular_momentum, angular_momentum, "sum of m |r| |u| at the end");
}

TEST_CASE("Gauss-principle particles conserve energy and momenta in a space that changes at every step",
          "[conservation]") {
  Check check(
      "gauss_particles_invariants", "Gauss-principle particles in changing spaces: energy and momenta",
      "A drop of 768 particles with a nonlinear, vortical velocity moves for 1000 steps. The grid of the stream "
      "functions changes at every step: shifted at random in both directions, with another degree (2, 3, 4) and other "
      "cells as well. Energy, momentum and angular momentum are constant to round-off; in a fall they change by the "
      "work, impulse and torque of gravity. Frank's projection scheme conserves both momenta and loses energy.");
  keeps(check, "any", "Another degree and other cells at every step", run<OneStep>(anything(), 0), 0);
  const double fallen = 0.5 * std::pow(tau * steps, 2);
  keeps(check, "falling", "Falling, shifted at random", run<OneStep>(shifted(), 1), 3.2 * fallen);
  keeps(check, "projection-scheme", "Frank's projection scheme", run<ProjectedStep>(shifted(), 0), {});
}

TEST_CASE("the conservative scheme of Gauss-principle particles is its own inverse", "[conservation]") {
  Check check("gauss_particles_reversal", "Gauss-principle particles: backwards in time",
              "A vortical drop moves 400 steps forwards and 400 backwards. A step backwards has the predictor of the "
              "step forwards, and therefore the same projection: positions and velocities return to round-off.");
  Model model(disc(1, 12), std::make_unique<SplineSpace>(LatticePlan{.cell_x = 0.3}), {.gravity = 0.5, .penalty = 0});
  State state = model.state(vortical);
  const State start = state;
  OneStep<Model> step(model);
  for (int k = 0; k < 400; ++k) step.substep(state, 2e-3);
  for (int k = 0; k < 400; ++k) step.substep(state, -2e-3);
  // Velocity gradients up to 1.5 over a time of 0.8 stretch a rounding by e^1.2, there and back; then by what the
  // projection hands on from particle to particle.
  const auto returns = [&](const std::string& what, double value) {
    check.holds(what + ": Backwards, the " + what + " return to their start when the run is reversed.", {value},
                Roundoff{800, 30,
                         "one rounding of numbers of order 1 per step, stretched by velocity gradients up to 1.5 over "
                         "a time of 1.6: e^2.4 = 11, and numbers up to 2.5"});
  };
  returns("places", largest_difference(state.q, start.q));
  returns("velocities", largest_difference(state.u, start.u));
}

}  // namespace seiche::verification::gauss_particles_invariants_test
