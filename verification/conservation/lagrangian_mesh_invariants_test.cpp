// A free patch of fluid: energy, momenta and areas to round-off.
#include <array>
#include <string>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/reference_integrators.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"

namespace seiche::verification::lagrangian_mesh_invariants_test {

using namespace mechanics;

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
  Check check("lagrangian_mesh_invariants", "Free patch of fluid: invariants",
              "Square of 8 x 8 cells of constant area, no potential, sheared and bent by its initial velocity, to t = "
              "1. Areas are bilinear: $V_s(r) - (\\tau^2/4)V_s(u)$ is exactly constant with the one-step scheme, and "
              "$V_s$ itself with the fully conservative one.");
  constexpr double coordinates = 162;
  const auto keeps = [&](const std::string& text, double value, int steps) {
    check.holds(text, {value},
                Roundoff{2 * coordinates + 10 * steps / coordinates, 1,
                         "two sums over 162 coordinates, of order 1; a step rounds a rate some ten times, that is "
                         "1/162 of the sum"});
  };
  const auto keeps_areas = [&](const std::string& text, double value, int steps) {
    check.holds(text, {value},
                Roundoff{8.0 * (steps + 2), 0.125,
                         "each step rounds the eight coordinates of a cell, of order 1, which move its area by half a "
                         "side; as do the two areas"});
  };
  for (const auto& [tau, steps] : {std::pair{1e-5, 100000}, {1e-3, 1000}}) {
    const Drift d = drift(Integrator::one_step, tau, steps);
    keeps("Energy is conserved to round-off (one-step scheme).", d.energy, steps);
    keeps("Momentum is conserved to round-off (one-step scheme).", d.momentum, steps);
    keeps("Angular momentum is conserved to round-off (one-step scheme).", d.angular_momentum, steps);
    keeps_areas("The modified area V_s(r) - (tau^2/4) V_s(u) is conserved to round-off (one-step scheme).",
                d.modified_area, steps);
  }
  const Drift implicit = drift(Integrator::conservative, 0.02, 50);
  keeps("Energy is conserved to round-off (fully conservative scheme).", implicit.energy, 50);
  keeps_areas("Areas are conserved to round-off (fully conservative scheme).", implicit.area, 50);
  keeps("Momenta are conserved to round-off (fully conservative scheme).",
        worst(std::array{implicit.momentum, implicit.angular_momentum}), 50);
}

}  // namespace seiche::verification::lagrangian_mesh_invariants_test
