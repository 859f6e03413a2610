// What water on meshes and in columns keeps to round-off, as ledgers of runs say: momenta without walls, energy and
// volumes with the fully conservative scheme.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/dispersive_2dh_problems.hpp"
#include "verification/conservation/lagrangian_mesh_3d_problems.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"

namespace seiche::verification::conserved_to_roundoff_test {

using namespace mechanics;
using linear::SolverMethod;

constexpr Scheme conservative{.stepping = Stepping::conservative};

Roundoff places(double operations, double scale) {
  return {operations, scale,
          "a rounded position, up to the water's length, for each coordinate of a cell per step or stage and over a "
          "cell's side"};
}

TEST_CASE("sloshing water on a Lagrangian mesh conserves energy and areas with the conservative scheme",
          "[conservation]") {
  Check check("lagrangian_mesh_energy", "Sloshing on a Lagrangian mesh: energy and areas",
              "Water is released with a surface of $0.1\\cos(\\pi x/6)$ and sloshes until t = 8: in a box, against an "
              "inclined wall, with a fixed toe and with one rounded over 0.25 to either side, over a bump along which "
              "the bottom's nodes slide. The fully conservative scheme takes the mean of the cubic potential's "
              "gradient over a step, the Jacobian at its middle and, on curves, chords: energy and areas are exact. "
              "Its compositions to fourth order inherit both.");
  auto all = basins();
  // Nodes that may slide around the toe need the hourglass potential, or the last cells tangle.
  all.emplace_back("an inclined wall, around whose rounded toe nodes slide, with the hourglass potential", [] {
    return MeshProblem(lagrangian_mesh_2d::layer_mesh_with_slope(
                           {.end = 6, .columns = 24, .rows = 4, .elevation = cosine_elevation}, 1, 0, 0.25),
                       {}, {.hourglass = 0.3});
  });
  for (const auto& [basin, make] : all) {
    for (const bool composed : {false, true}) {
      const double stages = composed ? 6 * 80 : 160;
      MeshProblem problem = make();
      conserves(check, basin + (composed ? ", to fourth order" : ""),
                watched_run(problem,
                            {.stepping = Stepping::conservative,
                             .composition = composed ? TimeComposition::triple_jump : TimeComposition::none},
                            composed ? 0.1 : 0.05, composed ? 80 : 160),
                {{"energy", Roundoff{stages, 1, "one rounded energy per step or stage"}, wave_energy},
                 {"volume_worst", places(stages, 6 / 0.25), problem.cell()}});
    }
  }
}

/// Rounding of the momenta of all nodes. The forces of the cells change them by small parts, whose own rounding does
/// not count.
Roundoff of_nodes(const HexahedralProblem& problem, double largest_arm) {
  const auto& mass = problem.model.nodes().mass();
  double squares = 0;
  for (std::size_t i = 0; i < 3 * mass.size(); ++i) squares += std::pow(mass[i % mass.size()] * problem.start.u[i], 2);
  return {2.0 * 100, std::sqrt(squares) * largest_arm,
          "each velocity is rounded twice in each of 100 steps, at their middle and at their end; the roundings of all "
          "nodes' momenta (times their largest distance from the axis) add up as squares"};
}

TEST_CASE("hexahedra conserve momenta without walls, energy and volumes with the conservative scheme",
          "[conservation]") {
  Check check(
      "lagrangian_mesh_3d_invariants", "Hexahedra: momenta, energy and volumes",
      "A free body of 6 x 5 x 4 cells, perturbed at random from a cube, without gravity, and water of 12 x 12 x 2 "
      "cells under gravity without sides, 100 steps of 0.01: momenta are conserved for any multipliers, so that the "
      "solver's tolerance is 1e-6 in one run and 1e-13 in the other; kinetic energy changes by the multipliers times "
      "the solver's residual of the rates of volumes, and is assessed with the tight tolerance. A hump of a/h = 0.3 in "
      "a box of 20 x 20 x 2 cells until t = 10, and one of 0.1 over a bottom bent along both axes, 12 x 8 x 3 cells, "
      "beside an oblique wall until t = 6: volumes are cubic and the potential energy quartic along a step, so that "
      "the conservative scheme has their mean gradients exactly. A node on the bottom is one more constraint.");
  for (const double tolerance : {1e-6, 1e-13}) {
    const std::string solver = tolerance == 1e-6 ? ", loose solver" : ", tight solver";
    HexahedralProblem body = moving_body({.tolerance = tolerance}), water = spreading_water({.tolerance = tolerance});
    std::vector<Kept> kept{{"momentum", of_nodes(body, 1)}, {"angular_momentum", of_nodes(body, 6)}};
    if (tolerance < 1e-6) kept.push_back({"energy", of_nodes(body, 1)});
    conserves(check, "Free body" + solver, watched_run(body, {}, 0.01, 100), kept);
    conserves(check, "Water without walls" + solver, watched_run(water, {}, 0.01, 100),
              {{"momentum_x", of_nodes(water, 1)},
               {"momentum_y", of_nodes(water, 1)},
               {"angular_momentum_z", of_nodes(water, 12)}});
  }
  HexahedralProblem body = moving_body({.tolerance = 1e-13});
  conserves(check, "Free body, conservative", watched_run(body, conservative, 0.01, 100),
            {{"momentum", of_nodes(body, 1)}, {"energy", of_nodes(body, 1)}, {"volume_worst", of_nodes(body, 1)}});
  HexahedralProblem box(hump_in_box(), {}, {.tolerance = 1e-13});
  conserves(check, "Hump in a box", watched_run(box, conservative, 0.1, 100),
            {{"energy",
              Bound{1e-12,
                    "pressures do work on the 1e-13 of the volumes' rates that the solver leaves in each of 100 steps; "
                    "of either sign, it adds up as squares"},
              box.model.potential_energy(box.start.q)},
             {"volume_worst", places(100 * 24, 10 / 0.5), box.cell()}});
  HexahedralProblem hump(hump_over_bottom(), {}, {.tolerance = 1e-15});
  OffTheBottom off(hump);
  conserves(check, "Hump over an uneven bottom", watched_run(hump, conservative, 0.1, 60, off),
            {{"energy",
              Roundoff{2 + 64 * 60 / 3.0, 1,
                       "some 64 roundings in each of 60 steps of the energy's part at a node; squares add up, so that "
                       "it counts over how many nodes the energy is spread: three at the beginning, (sum e)^2/sum e^2 "
                       "for e = exp(-1.2 r^2), 2.6 square depths"},
              hump.model.potential_energy(hump.start.q)},
             {"volume_worst", places(60 * 24, 6 / 0.2), hump.cell()}});
  check.holds(
      "The distance of bed nodes from the bed is zero to round-off.", {off.bottom.value()},
      Roundoff{60 * 3, 6,
               "three rounded positions, up to 6 h, per step; the bottom is of degree three, and Gauss's rule exact"});
  check.holds("The distance of sliding bed nodes from the oblique wall is zero to round-off.", {off.wall.value()},
              Roundoff{60 * 2, 6, "two rounded positions, up to 6 h, per step"});
}

/// Rounding of the momenta of all nodes, each of which changes by the forces of four cells in a step.
Roundoff of_columns(const PlanProblem& problem, double arm) {
  const std::size_t n = problem.model.nodes();
  const double largest =
      worst_of(3 * n, [&](std::size_t i) { return problem.model.node_masses()[i % n] * problem.start.u[i]; });
  return {32.0 * 100 * static_cast<double>(n), largest * arm,
          "a node's momentum (times its largest distance from the axis) is rounded some 32 times in each of 100 steps"};
}

/// @param nodes  over so many the energy is spread, never fewer than at the beginning
Roundoff of_energies(double steps, double nodes) {
  return {
      2 + 100 * steps / nodes, 1,
      "some 100 roundings in a step of the energy's part at a node; squares add up, so that it counts over how many "
      "nodes the energy is spread; and of the energies themselves"};
}

TEST_CASE("water in 2DH conserves momenta without sides, energy and volumes over any bottom", "[conservation]") {
  Check check(
      "dispersive_2dh_invariants", "Two-dimensional horizontal model: momenta, energy and volumes",
      "24 x 24 cells of width h/2, perturbed at random from squares, sheared and stirred at random, without walls, 100 "
      "steps of 0.03: momenta are conserved for any multipliers, with the solver's tolerance 1e-6 and 1e-13. The blob "
      "stands on its bottom as an isolated body, or lies in still water: elevations count from its level, and a side "
      "without a wall feels that water's pressure. Without gravity, a swirl and its squeezing in a box conserve their "
      "kinetic energy. A hump is released in a box and sloshes until t = 5, over a level bottom, over a polynomial of "
      "degree four and over a bump. Volumes and potential energy are polynomials along a step, so that Simpson's mean "
      "of their gradients is exact; the bottom's contribution to volumes is made exact along the step. Over uneven "
      "bottoms velocities turn with the bottom's tangent plane, which changes no energy. The energy of improved "
      "dispersion, which is no polynomial, has a discrete gradient in closed form.");
  for (const bool stands : {true, false}) {
    const std::string where = stands ? "Standing" : "In still water";
    for (const double tolerance : {1e-6, 1e-13}) {
      PlanProblem blob = free_blob(stands, {.solver = SolverMethod::iterative, .tolerance = tolerance});
      conserves(check, where + (tolerance == 1e-6 ? ", loose solver" : ", tight solver"),
                watched_run(blob, {}, 0.03, 100),
                {{"momentum_x", of_columns(blob, 1)},
                 {"momentum_y", of_columns(blob, 1)},
                 {"angular_momentum_z", of_columns(blob, 12)}});
    }
    PlanProblem blob = free_blob(stands, {.solver = SolverMethod::banded});
    const auto ledger = watched_run(blob, conservative, 0.03, 100);
    conserves(check, where + ", conservative", ledger,
              {{"momentum_x", of_columns(blob, 1)},
               {"momentum_y", of_columns(blob, 1)},
               {"energy", of_energies(100, 625), std::abs(ledger.entry("energy").initial)},
               {"volume_worst", places(100 * 12, 6 / 0.5), blob.cell()}});
  }
  const auto swirl = [](double x, double y) {
    const double k = std::numbers::pi / 10;
    return dispersive_shallow_water_2d::Velocity{0.3 * std::sin(k * x) * std::cos(k * y) + 0.1 * std::sin(2 * k * x),
                                                 -0.3 * std::cos(k * x) * std::sin(k * y), 0};
  };
  const auto weightless = watched_run(
      PlanProblem(plan_hump_in_box(), swirl, {.gravity = 0, .solver = SolverMethod::iterative, .tolerance = 1e-13}), {},
      0.03, 100);
  conserves(check, "Without gravity", weightless,
            {{"energy", of_energies(100, 441), weightless.entry("energy").initial}});
  // (integral of e)^2/(integral of e^2) of the energy e = exp(-0.6 r^2), over cells of 0.25; a quarter in a corner.
  const double whole = 2 * std::numbers::pi / 0.6 / 0.25;
  const dispersive_shallow_water_2d::Settings plain{.tolerance = 1e-13},
      improved{.inertia = 0.4, .gamma = 1.0 / 15, .tolerance = 1e-13};
  // spread: over so many nodes is the energy spread at the beginning
  for (const auto& [text, lattice, spread, settings] :
       {std::tuple{std::string("A level bottom"), plan_hump_in_box(), whole / 4, plain},
        {"A polynomial bottom", plan_hump_in_box(quartic_bottom()), whole / 4, plain},
        {"A bump that is no polynomial", hump_over_bump(), whole, plain},
        {"A bump, with improved dispersion", hump_over_bump(), whole, improved}}) {
    for (const int steps : {50, 20}) {
      PlanProblem problem(lattice, {}, settings);
      const auto ledger = watched_run(problem, conservative, 5.0 / steps, steps);
      conserves(check, text + (steps == 50 ? ", short steps" : ", long steps"), ledger,
                {{"energy", of_energies(steps, spread), ledger.entry("energy").initial},
                 {"volume_worst", places(12 * steps, lattice.x.back() / 0.5), problem.cell()}});
    }
  }
}

/// The ledger of the free patch, and the largest change of V_s(r) - (tau^2/4) V_s(u).
std::pair<InvariantsLedger, double> drift(Stepping stepping, double tau, int steps) {
  MeshProblem patch = moving_patch();
  std::vector<double> area(patch.model.constraints()), bending(area), first;
  Largest modified;
  const auto look = [&](const State& state) {
    patch.model.constraint_values(state.q, area);
    patch.model.curvature(state.u, state.u, bending);
    for (std::size_t s = 0; s < area.size(); ++s) area[s] -= tau * tau / 8 * bending[s];
    if (first.empty()) first = area;
    modified.add(largest_difference(Input(area), first));
  };
  look(patch.start);
  const InvariantsLedger ledger = watched_run(patch, {.stepping = stepping}, tau, steps, look);
  return {ledger, modified.value()};
}

TEST_CASE("a free patch of fluid conserves energy, momenta and areas", "[conservation]") {
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
    const auto [ledger, modified] = drift(Stepping::one_step, tau, steps);
    keeps("Energy is conserved to round-off (one-step scheme).", ledger.largest_defect("energy"), steps);
    keeps("Momentum is conserved to round-off (one-step scheme).", ledger.largest_defect("momentum"), steps);
    keeps("Angular momentum is conserved to round-off (one-step scheme).", ledger.largest_defect("angular_momentum"),
          steps);
    keeps_areas("The modified area V_s(r) - (tau^2/4) V_s(u) is conserved to round-off (one-step scheme).", modified,
                steps);
  }
  const InvariantsLedger implicit = drift(Stepping::conservative, 0.02, 50).first;
  keeps("Energy is conserved to round-off (fully conservative scheme).", implicit.largest_defect("energy"), 50);
  keeps_areas("Areas are conserved to round-off (fully conservative scheme).", implicit.largest_defect("volume_worst"),
              50);
  keeps("Momenta are conserved to round-off (fully conservative scheme).",
        worst(std::array{implicit.largest_defect("momentum"), implicit.largest_defect("angular_momentum")}), 50);
}

}  // namespace seiche::verification::conserved_to_roundoff_test
