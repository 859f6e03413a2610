// Dirichlet cells: rest on any mesh, and what is kept to second order.
#include <cmath>
#include <string>
#include <vector>

#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/jittered_mesh.hpp"

namespace dirichlet_mesh_test {

using namespace seiche;
using namespace seiche::dirichlet_mesh;
using namespace seiche::free_lagrangian;
using namespace seiche::verification;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 5.2";

/// A free rectangle of 153 nodes without gravity, sheared, turned and bent by its first velocity.
Flow moving_patch(double stabilisation) {
  const auto velocity = [](Point r) {
    return Point{0.4 * r.x - 0.7 * r.y + 0.1 * std::sin(2 * r.y) + 0.3,
                 0.5 * r.x - 0.4 * r.y + 0.1 * std::cos(3 * r.x) - 0.2};
  };
  return Flow(jittered(free_patch(16, 8, {-1, -0.5}, {1, 0.5}), 0.2, 1), velocity,
              {.gravity = 0, .stabilisation = stabilisation});
}

TEST_CASE("water at rest in Dirichlet cells stays at rest on any mesh", "[conservation]") {
  Check check(
      "dirichlet_mesh_rest", "Still water on jittered Dirichlet meshes",
      "24 x 8 cells in a box 3 x 1, nodes inside moved at random by up to a fifth of the spacing, those of the "
      "walls along them; 200 steps of 0.05, without stabilisation. With the surface at y = 0 the gradient of "
      "the potential energy of the polygon of water is zero. At y = 1 gravity and the pressure rho g balance to "
      "rounding: the areas of all cells together are the polygon.");
  for (const auto& [level, id] : {std::pair{0.0, std::string("level-0")}, {1.0, "level-1"}}) {
    const Layer layer{.begin = 0, .end = 3, .bottom = level - 1, .level = level, .columns = 24, .rows = 8};
    Worst speed;
    Worst pressure;
    long flips = 0;
    for (const unsigned long seed : {1UL, 2UL, 3UL}) {
      Flow flow(jittered(layer_mesh(layer), 0.2, seed), {}, {.stabilisation = 0});
      for (int k = 0; k < 200; ++k) {
        flow.advance(0.05);
        for (const double u : flow.state().u) speed.add(u, flow.time());
        for (const double lambda : flow.state().multipliers) pressure.add(lambda - level, flow.time());
      }
      flips += flow.flips();
    }
    check.holds(id + "-flips: No edge is flipped.", {static_cast<double>(flips)},
                Bound{0, "nothing moves further than rounding"});
    if (level == 0) {
      check.holds(id + ": Nothing moves, bit by bit.", {speed.value()}, Bound{0, "every force is exactly zero"});
      check.holds(id + "-pressure: There is no dynamic pressure.", {pressure.value()},
                  Bound{0, "every force is exactly zero"});
      continue;
    }
    const Roundoff kicks{.operations = 200 * 20,
                         .scale = 0.4,
                         .reason =
                             "200 kicks of tau times the acceleration g/h = 8, that of the pressure and of "
                             "gravity, sums of some twenty terms"};
    check.holds(id + ": Nothing moves beyond rounding.", {speed.value()}, kicks);
    check.holds(id + "-pressure: The dynamic pressure is rho g.", {pressure.value()},
                Roundoff{200 * 20, 8,
                         "the rounding of a velocity is taken out within half a step: over tau/2 = 1/40, and "
                         "half a spacing"});
  }
}

TEST_CASE("areas of Dirichlet cells drift by the square of the step, as does energy under gravity", "[conservation]") {
  Check check("dirichlet_mesh_drift", "What Dirichlet cells keep to second order only",
              "The free patch until t = 0.2 without stabilisation: the largest change of a cell's area. Water in a box "
              "that sloshes under gravity until t = 1, stabilisation 0.01: kinetic and potential energy with what the "
              "stabilisation took. Steps halved four times.");
  std::vector<double> steps;
  std::vector<double> drifts;
  std::vector<double> energies;
  for (const int n : {10, 20, 40, 80, 160}) {
    Flow patch = moving_patch(0);
    patch.advance_to(0.2, 0.2 / n);
    steps.push_back(1.0 / n);
    drifts.push_back(patch.largest_drift());
    Flow water(layer_mesh({.begin = 0, .end = 3, .columns = 12, .rows = 4}),
               [](Point r) {
                 const double k = 3.141592653589793 / 3;
                 return Point{0.05 * std::sin(k * r.x) * std::cosh(k * (r.y + 1)),
                              -0.05 * std::cos(k * r.x) * std::sinh(k * (r.y + 1))};
               },
               {.stabilisation = 0.01});
    const double energy = water.energy();
    water.advance_to(1, 1.0 / n);
    energies.push_back(std::abs(water.energy() + water.stabilisation_loss() - energy));
  }
  const Order second{2, 0.2, "second order of the one-step scheme"};
  check.that({.id = "areas",
              .text = "The drift of cell areas is second-order in the step.",
              .quantity = "order of the largest drift",
              .source = source},
             observed_order(steps, drifts), second);
  check.that({.id = "energy",
              .text = "Energy under gravity, with what was booked: order 2.",
              .quantity = "order of the energy's defect",
              .source = source},
             observed_order(steps, energies), second);
}

}  // namespace dirichlet_mesh_test
