// A free patch of fluid: energy, momenta and areas to round-off, with first values known from elsewhere.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/reference_integrators.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"

namespace lagrangian_mesh_invariants_test {

using namespace seiche::mechanics;
using namespace seiche::verification;
using seiche::Largest;
using seiche::worst;
using seiche::lagrangian_mesh_2d::Model;

const std::string digits = "regression: computed once by an earlier program for the same equations";

struct Drift {
  double energy, momentum, angular_momentum, area;
  double modified_area = 0;  ///< largest change of V_s(r) - (tau^2/4) V_s(u)
};

Drift drift(Integrator integrator, double tau, int steps) {
  auto [patch, state] = moving_patch();
  const StepFunction step = make_integrator(integrator, patch);
  InvariantsWatch watch(patch, state);
  std::vector<double> area(patch.constraints());
  std::vector<double> bending(patch.constraints());
  std::vector<double> first;
  Largest modified;
  for (int n = 0; n <= steps; ++n) {
    if (n > 0) {
      step(state, tau);
      watch.record(state);
    }
    patch.constraint_values(state.q, area);
    patch.curvature(state.u, state.u, bending);
    for (std::size_t s = 0; s < area.size(); ++s) area[s] -= tau * tau / 8 * bending[s];
    if (n == 0) first = area;
    modified.add(largest_difference(area, first));
  }
  const InvariantsLedger& ledger = watch.ledger();
  return {ledger.largest_defect("energy"), ledger.largest_defect("momentum"), ledger.largest_defect("angular_momentum"),
          ledger.largest_defect("volume_worst"), modified.value()};
}

TEST_CASE("a free patch of fluid keeps energy, momenta and areas", "[conservation]") {
  Check check(
      "lagrangian_mesh_invariants", "Free patch of fluid: invariants",
      "Square of 8 x 8 cells of constant area, no potential, sheared and bent by its initial velocity, to t = 1. "
      "Areas are bilinear: $V_s(r) - (\\tau^2/4)V_s(u)$ is exactly constant with the one-step scheme, and $V_s$ "
      "itself with the fully conservative one.");
  const auto [patch, start] = moving_patch();
  constexpr double coordinates = 162;
  const Roundoff initial{.operations = coordinates + 64 / coordinates,
                         .scale = 1,
                         .reason =
                             "sums over 162 coordinates, each rounded 64 times by the projection, that is 1/162 "
                             "of the sum"};
  Roundoff energy = initial;
  energy.expected = 0.884486280096849;
  check.that({.id = "initial-energy",
              .text = "Kinetic energy of the projected velocity.",
              .quantity = "energy",
              .source = digits + " to 15 digits"},
             {.value = patch.kinetic_energy(start.q, start.u)}, energy);
  Roundoff angular = initial;
  angular.expected = 1.47566381695791;
  check.that({.id = "initial-angular-momentum",
              .text = "Angular momentum of the projected velocity.",
              .quantity = "angular momentum",
              .source = digits + " to 15 digits"},
             {.value = patch.angular_momentum(start.q, start.u)[0]}, angular);
  const auto keeps = [&](const std::string& id, const std::string& text, double value, int steps) {
    check.holds(id + ": " + text, {value},
                Roundoff{2 * coordinates + 10 * steps / coordinates, 1,
                         "two sums over 162 coordinates, of order 1; a step rounds a rate some ten times, that "
                         "is 1/162 of the sum"});
  };
  const auto keeps_areas = [&](const std::string& id, const std::string& text, double value, int steps) {
    check.holds(id + ": " + text, {value},
                Roundoff{8.0 * (steps + 2), 0.125,
                         "each step rounds the eight coordinates of a cell, of order 1, which move its area by "
                         "half a side; as do the two areas"});
  };
  struct Case {
    std::string id, resolution;
    double tau;
    int steps;
  };
  for (const Case& c : {Case{"fine", "tau = 1e-5", 1e-5, 100000}, Case{"coarse", "tau = 1e-3", 1e-3, 1000}}) {
    const Drift d = drift(Integrator::one_step, c.tau, c.steps);
    keeps(c.id + "-energy", "Energy is conserved to round-off (one-step scheme).", d.energy, c.steps);
    keeps(c.id + "-momentum", "Momentum is conserved to round-off (one-step scheme).", d.momentum, c.steps);
    keeps(c.id + "-angular-momentum", "Angular momentum is conserved to round-off (one-step scheme).",
          d.angular_momentum, c.steps);
    keeps_areas(c.id + "-modified-area",
                "The modified area V_s(r) - (tau^2/4) V_s(u) is conserved to round-off (one-step scheme).",
                d.modified_area, c.steps);
    if (c.steps == 1000) {
      check.that({.id = "area",
                  .text = "The area error of the one-step scheme, O(tau^2), has the two digits expected.",
                  .quantity = "largest change of a cell's area",
                  .source = digits},
                 {.value = d.area, .resolution = c.resolution},
                 Bound{0.05e-9, "half a unit of the last of two digits", 5.3e-9});
    }
  }
  const Drift implicit = drift(Integrator::conservative, 0.02, 50);
  keeps("conservative-energy", "Energy is conserved to round-off (fully conservative scheme).", implicit.energy, 50);
  keeps_areas("conservative-area", "Areas are conserved to round-off (fully conservative scheme).", implicit.area, 50);
  keeps("conservative-momentum", "Momenta are conserved to round-off (fully conservative scheme).",
        worst(std::array{implicit.momentum, implicit.angular_momentum}), 50);
}

}  // namespace lagrangian_mesh_invariants_test
