// Dirichlet cells: rest on any mesh, what a free patch keeps, and what is booked.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace dirichlet_mesh_test {

using namespace seiche;
using namespace seiche::dirichlet_mesh;
using namespace seiche::free_lagrangian;
using namespace seiche::verification;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 5.2";

/// A free rectangle of 153 nodes without gravity, sheared, turned and bent by its first velocity.
Flow moving_patch(double stabilisation, double drift_feedback = 0) {
  const auto velocity = [](Point r) {
    return Point{0.4 * r.x - 0.7 * r.y + 0.1 * std::sin(2 * r.y) + 0.3,
                 0.5 * r.x - 0.4 * r.y + 0.1 * std::cos(3 * r.x) - 0.2};
  };
  return Flow(jittered(free_patch(16, 8, {-1, -0.5}, {1, 0.5}), 0.2, 1), velocity,
              {.gravity = 0, .stabilisation = stabilisation}, drift_feedback);
}

/// Its ledger after t = 0.6, and the flow.
Flow run(Flow flow, double tau) {
  flow.advance_to(0.6, tau, [&] { flow.observe(); });
  return flow;
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

TEST_CASE("a free patch of Dirichlet cells keeps mass, momenta and energy over flips", "[conservation]") {
  Check check("dirichlet_mesh_invariants", "Free patch of Dirichlet cells: invariants",
              "153 nodes of a rectangle 2 x 1, no gravity, sheared, turned and bent by their first velocity until t = "
              "0.6, over some twenty flips. Energy is kept without stabilisation; with it, and with the feedback of "
              "the drift, what they did is booked to the last digit. The areas are not kept: they drift by "
              "O(tau^2), and with stabilisation at a rate of its own.");
  constexpr double coordinates = 306;
  const auto keeps = [&](const std::string& id, const std::string& text, double value, double steps) {
    check.holds(id + ": " + text, {value},
                Roundoff{2 * coordinates + 10 * steps, 1,
                         "two sums over 306 coordinates, of order 1 at most; a step rounds the sums some ten "
                         "times"});
  };
  struct Patch {
    std::string id, what;
    double stabilisation, feedback, tau;
  };
  for (const Patch& p :
       {Patch{"plain", "without stabilisation", 0, 0, 0.01}, Patch{"stabilised", "stabilised", 0.1, 0, 0.01},
        Patch{"fed-back", "stabilised, drift fed back", 0.1, 0.2, 0.01}}) {
    const Flow flow = run(moving_patch(p.stabilisation, p.feedback), p.tau);
    const auto& ledger = flow.ledger();
    const auto steps = static_cast<double>(flow.steps());
    keeps(p.id + "-mass", p.what + ": mass.", ledger.largest_defect("mass"), steps);
    keeps(p.id + "-momentum", p.what + ": linear momentum.", ledger.largest_defect("momentum"), steps);
    keeps(p.id + "-angular-momentum", p.what + ": angular momentum.", ledger.largest_defect("angular_momentum"), steps);
    keeps(p.id + "-energy", p.what + ": energy and what was booked.", ledger.largest_defect("energy"), steps);
    keeps(
        p.id + "-area", p.what + ": the sum of the cells is the area of the polygon.",
        [&] {
          std::vector<double> drift(flow.model().constraints());
          flow.model().constraint_values(flow.state().q, drift);
          CompensatedSum cells;
          for (std::size_t k = 0; k < drift.size(); ++k) cells.add(drift[k] + flow.model().masses()[k]);
          const auto nodes = flow.model().triangulation().nodes();
          CompensatedSum polygon;
          const auto outline = flow.model().outline();
          for (std::size_t e = 0; e < outline.size(); ++e) {
            const Point a = nodes[outline[e]];
            const Point b = nodes[outline[(e + 1) % outline.size()]];
            polygon.add(0.5 * (a.x * b.y - a.y * b.x));
          }
          return cells.value() - polygon.value();
        }(),
        steps);
    if (p.stabilisation == 0) {
      check.that({.id = "rearranged", .text = "Edges were flipped on the way.", .quantity = "flips", .source = source},
                 {.value = flow.flips() >= 20 ? 1.0 : 0.0},
                 Qualitative{"at least 20 flips", "otherwise nothing is shown of rearrangements"});
    } else {
      check.holds(p.what + ": the stabilisation takes energy, and some of it.",
                  {flow.stabilisation_loss() > 1e-6 * flow.energy() ? 1.0 : 0.0},
                  Qualitative{"more than a millionth", "otherwise the balance would show nothing"});
    }
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
