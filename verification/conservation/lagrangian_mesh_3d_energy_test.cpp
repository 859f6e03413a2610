// A hump in a box of hexahedra: energy and volumes of both schemes, and the way back.
#include <cmath>
#include <string>
#include <vector>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_3d_problems.hpp"

namespace seiche::verification::lagrangian_mesh_3d_energy_test {

using namespace lagrangian_mesh_3d;
using namespace mechanics;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 4.1";

/// Largest so far, relative to the hump's energy and to a cell's volume.
struct Defects {
  double energy, volume;
};

Defects defects(Scheme scheme, Settings settings, double tau, double time) {
  HexahedralProblem problem(hump_in_box(), {}, settings);
  SchemeStepper<Model> stepper(problem.model, scheme);
  InvariantsWatch watch(problem.model, problem.start);
  const double energy = watch.ledger().entry("energy").initial;
  const double volume = problem.model.mass() / static_cast<double>(problem.model.constraints());
  for (long n = std::lround(time / tau); n > 0; --n) {
    stepper.step(problem.start, tau);
    watch.record(problem.start);
  }
  return {watch.ledger().largest_defect("energy") / energy, watch.ledger().largest_defect("volume_worst") / volume};
}

TEST_CASE("a hump in a box of hexahedra keeps energy and volumes with the conservative scheme", "[conservation]") {
  Check check("lagrangian_mesh_3d_energy", "Sloshing in three dimensions: energy and volumes",
              "A hump of 0.3 depths is released in a box of 10 x 10 depths, 20 x 20 x 2 cells, and sloshes until t = "
              "10. Volumes are cubic and the potential energy quartic along a step, so that their mean gradients are "
              "known exactly: the fully conservative scheme keeps energy and volumes to round-off.");
  const double tau = 0.1;
  const double time = 10;
  const auto keeps = [&](const std::string& id, const Defects& d, const evidence::Criterion& energy) {
    check.holds("Energy is conserved to round-off (conservative scheme, " + id + " solver).", {d.energy}, energy);
    check.holds(
        "Energy is conserved to round-off (conservative scheme, " + id + " solver: every cell's volume to round-off.",
        {d.volume},
        Roundoff{100 * 24, 10 / 0.5, "24 rounded places, up to 10 depths, per step and over a cell's side, 0.5"});
  };
  const Scheme conservative{.stepping = Stepping::conservative};
  keeps("iterative", defects(conservative, {.tolerance = 1e-13}, tau, time),
        Bound{1e-12,
              "pressures do work on the 1e-13 of the volumes' rates that the solver leaves in each of 100 steps; of "
              "either sign, it adds up as squares"});
}

TEST_CASE("energy and volumes of the one-step scheme on hexahedra err by the square of the step", "[conservation]") {
  Check check("lagrangian_mesh_3d_energy_order", "Sloshing in three dimensions: order of the one-step scheme",
              "The hump in the box, one-step scheme, t = 20: largest defects so far of the energy and of a volume. "
              "Both are bounded and shrink with $\\tau^2$.",
              source);
  std::vector<double> taus{0.4, 0.2, 0.1, 0.05}, energies, volumes;
  for (const double tau : taus) {
    const Defects d = defects({}, {.tolerance = 1e-10}, tau, 20);
    energies.push_back(d.energy);
    volumes.push_back(d.volume);
  }
  const auto order = [&](const std::string& id, const std::string& text, const std::vector<double>& errors) {
    check.that(id, text, "observed order", observed_order(taus, errors),
               Order{2, 0.3,
                     "a symmetric scheme of second order; the maximum over time is not a smooth function of the step"});
  };
  order("energy", "The largest energy defect is of second order.", energies);
  order("volume", "The largest defect of a volume is of second order.", volumes);
}

TEST_CASE("a hexahedral mesh returns when its velocities are reversed", "[conservation]") {
  Check check("lagrangian_mesh_3d_reversible", "Hexahedral mesh: time reversal",
              "The hump in the box, 100 steps of 0.1: velocities reversed, the same steps, velocities reversed. "
              "Pressures to round-off, so that nothing depends on tolerances.",
              source);
  HexahedralProblem problem(hump_in_box(), {}, {.tolerance = 1e-15});
  State state = problem.start;
  for (int turn = 0; turn < 2; ++turn) {
    SchemeStepper<Model> stepper(problem.model, {});
    for (int n = 0; n < 100; ++n) stepper.step(state, 0.1);
    for (double& u : state.u) u = -u;
  }
  check.that("returns", "The reversed run returns to its start.", "largest difference of a coordinate or a velocity",
             {.value = largest_difference(state, problem.start), .resolution = "100 steps each way"},
             Roundoff{200, 10, "each place, up to 10 depths, rounded once in a step; what is added to it is small"});
}

}  // namespace seiche::verification::lagrangian_mesh_3d_energy_test
