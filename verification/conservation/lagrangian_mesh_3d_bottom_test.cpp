// A hump over an uneven bottom between walls of which one is oblique: energy, volumes, nodes on the bottom.
#include <cmath>
#include <string>
#include <vector>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_3d_problems.hpp"

namespace seiche::verification::lagrangian_mesh_3d_bottom_test {

using namespace lagrangian_mesh_3d;
using namespace mechanics;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 4.1";
constexpr double duration = 6;

/// Largest so far.
struct Defects {
  double energy;   ///< over the hump's energy
  double volume;   ///< over a cell's volume
  double bottom;   ///< distance of a node from the bottom
  double oblique;  ///< and of one on the oblique wall from that wall
};

Defects defects(Scheme scheme, double tau) {
  HexahedralProblem problem(hump_over_bottom(), {}, {.tolerance = 1e-15});
  SchemeStepper<Model> stepper(problem.model, scheme);
  State& state = problem.start;
  InvariantsWatch watch(problem.model, state);
  const auto bottom = uneven_bottom();
  const std::size_t n = problem.model.nodes().size();
  const Shape plan = problem.model.mesh().plan;
  Worst off, wall;
  for (long step = std::lround(duration / tau); step > 0; --step) {
    stepper.step(state, tau);
    watch.record(state);
    for (std::size_t k = 0; k < plan.nodes(); ++k) {
      off.add(state.q[2 * n + k] - bottom->slope(state.q[k], state.q[n + k]).elevation);
      if (k <= plan.columns) wall.add(state.q[n + k] - 0.1 * state.q[k]);
    }
  }
  const auto& ledger = watch.ledger();
  const double volume = problem.model.mass() / static_cast<double>(problem.model.constraints());
  return {.energy = ledger.largest_defect("energy") / ledger.entry("energy").initial,
          .volume = ledger.largest_defect("volume_worst") / volume,
          .bottom = off.value(),
          .oblique = wall.value()};
}

TEST_CASE("hexahedra over an uneven bottom keep what they keep over a level one", "[conservation]") {
  Check check("lagrangian_mesh_3d_bottom", "A hump over an uneven bottom: energy, volumes, the bottom",
              "A hump of a tenth of the depth spreads over a bottom bent along both axes, 1 to 0.5 deep, between three "
              "walls along the axes and an oblique one, 12 x 8 x 3 cells, until t = 6. A node on the bottom is one "
              "more constraint: the conservative scheme takes mean gradients of it too, the one-step scheme keeps it "
              "within the square of the step.",
              source);
  const Defects kept = defects({.stepping = Stepping::conservative}, 0.1);
  const auto roundoff = [&](const std::string& id, const std::string& text, double value, double operations,
                            double scale, const std::string& reason) {
    check.holds("conservative-" + id + ": " + text, {value}, Roundoff{operations, scale, reason});
  };
  roundoff("energy", "The conservative scheme keeps the energy to round-off.", kept.energy, 2 + 64 * 60 / 3.0, 1,
           "some 64 roundings in each of 60 steps of the energy's part at a node; squares add up, so that it counts "
           "over how many nodes the energy is spread: three at the beginning, (sum e)^2/sum e^2 for e = exp(-1.2 r^2), "
           "2.6 square depths");
  roundoff("volume", "The conservative scheme keeps every cell's volume to round-off.", kept.volume, 60 * 24, 6 / 0.2,
           "24 rounded places, up to 6 depths, per step and over the smallest height of a cell, 0.2");
  roundoff("bottom", "The conservative scheme keeps the nodes on the bottom to round-off.", kept.bottom, 60 * 3, 6,
           "three rounded places, up to 6 depths, per step; the bottom is of degree three, and Gauss's rule exact");
  roundoff("oblique", "Nodes on the bottom that slide along the oblique wall stay at it.", kept.oblique, 60 * 2, 6,
           "two rounded places, up to 6 depths, per step");
  const std::vector<double> taus{0.2, 0.1, 0.05, 0.025};
  std::vector<double> energies, volumes, bottoms;
  for (const double tau : taus) {
    const Defects d = defects({}, tau);
    energies.push_back(d.energy);
    volumes.push_back(d.volume);
    bottoms.push_back(d.bottom);
  }
  const auto order = [&](const std::string& id, const std::string& text, const std::vector<double>& errors) {
    check.that("order-" + id, text, "observed order", observed_order(taus, errors),
               Order{2, 0.3,
                     "a symmetric scheme of second order; the maximum over time is not a smooth function of the step"});
  };
  order("energy", "The largest energy error is second-order in the step (one-step scheme).", energies);
  order("volume", "The largest error of a volume is second-order in the step (one-step scheme).", volumes);
  order("bottom", "The largest distance of bed nodes from the bottom is second-order in the step (one-step scheme).",
        bottoms);
}

TEST_CASE("hexahedra over an uneven bottom return when their velocities are reversed", "[conservation]") {
  Check check("lagrangian_mesh_3d_bottom_reversible", "Hexahedra over an uneven bottom: time reversal",
              "The hump over the uneven bottom, 60 steps of 0.1: velocities reversed, the same steps, velocities "
              "reversed. Pressures to round-off, so that nothing depends on tolerances.",
              source);
  HexahedralProblem problem(hump_over_bottom(), {}, {.tolerance = 1e-15});
  State state = problem.start;
  for (int turn = 0; turn < 2; ++turn) {
    SchemeStepper<Model> stepper(problem.model, {});
    for (int n = 0; n < 60; ++n) stepper.step(state, 0.1);
    for (double& u : state.u) u = -u;
  }
  check.that("returns", "The reversed run returns to its start to round-off.",
             "largest difference of a coordinate or a velocity",
             {.value = largest_difference(state, problem.start), .resolution = "60 steps each way"},
             Roundoff{120, 6, "each place, up to 6 depths, rounded once in a step; what is added to it is small"});
}

}  // namespace seiche::verification::lagrangian_mesh_3d_bottom_test
