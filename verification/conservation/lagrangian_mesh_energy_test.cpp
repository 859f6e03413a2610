// Energy and areas of water under gravity between walls of all kinds, to round-off with the fully conservative scheme.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"

namespace seiche::verification::lagrangian_mesh_energy_test {

using namespace lagrangian_mesh_2d;
using namespace mechanics;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 2";

struct Basin {
  std::string id, text;
  MeshProblem (*make)();
};

std::vector<Basin> basins() {
  const auto inclined = [] {
    return MeshProblem(
        layer_mesh_with_slope({.begin = 0, .end = 6, .columns = 24, .rows = 4, .elevation = cosine_elevation}, 1));
  };
  const auto curved = [] { return MeshProblem(layer_mesh_over(bump(), 0, 6, 24, 4, cosine_elevation)); };
  return {{"box", "vertical walls, level bottom", [] { return sloshing(); }},
          {"inclined", "an inclined wall", inclined},
          {"bump", "a bump on the bottom", curved},
          {"hourglass", "vertical walls, with the hourglass potential", [] { return sloshing({.hourglass = 0.3}); }}};
}

constexpr double wave_energy = 0.015;  ///< of a surface 0.1 cos(kx) over 6 depths, (1/4) 0.1^2 6

/// Largest so far, relative to the wave's energy and to the cells' mean area.
struct Defects {
  double energy, area;
};

Defects defects(const Basin& basin, Scheme scheme, double tau, double time) {
  MeshProblem problem = basin.make();
  SchemeStepper<Model> stepper(problem.model, scheme);
  State& state = problem.start;
  InvariantsWatch watch(problem.model, state);
  const double area = problem.model.mass() / static_cast<double>(problem.model.constraints());
  const long steps = std::lround(time / tau);
  for (long n = 0; n < steps; ++n) {
    stepper.step(state, tau);
    watch.record(state);
  }
  return {watch.ledger().largest_defect("energy") / wave_energy, watch.ledger().largest_defect("volume_worst") / area};
}

TEST_CASE("water between walls keeps energy and areas with the conservative scheme", "[conservation]") {
  Check check("lagrangian_mesh_energy", "Sloshing on a Lagrangian mesh: energy and areas",
              "Water is released with a surface of $0.1\\cos(\\pi x/6)$ and sloshes until t = 8: in a box, against an "
              "inclined wall, with a toe that stays and one that is rounded over 0.25 to either side, over a bump "
              "along which the bottom's nodes slide. The fully conservative scheme takes the mean of the cubic "
              "potential's gradient over a step, the Jacobian at its middle and, on curves, chords: energy and areas "
              "are exact. Its compositions to fourth order inherit both.");
  const auto keeps = [&](const std::string& id, const std::string& text, const Defects& d, double stages) {
    check.holds(id + "-energy: " + text + ": energy to round-off.", {d.energy},
                Roundoff{stages, 1, "one rounded energy per step or stage"});
    check.holds(id + "-area: " + text + ": every cell's area to round-off.", {d.area},
                Roundoff{stages, 6 / 0.25,
                         "a rounded place, up to 6 depths, per step or stage and over a cell's side, at least 0.25"});
  };
  std::vector<Basin> all = basins();
  // Nodes that may slide around the toe need the hourglass potential, or the last cells fold.
  all.push_back({"rounded", "an inclined wall, around whose rounded toe nodes slide, with the hourglass potential", [] {
                   return MeshProblem(
                       layer_mesh_with_slope(
                           {.begin = 0, .end = 6, .columns = 24, .rows = 4, .elevation = cosine_elevation}, 1, 0, 0.25),
                       {}, {.hourglass = 0.3});
                 }});
  for (const Basin& basin : all) {
    keeps(basin.id, "Conservative, " + basin.text, defects(basin, {.stepping = Stepping::conservative}, 0.05, 8), 160);
    keeps(basin.id + "-composed", "Conservative to fourth order, " + basin.text,
          defects(basin, {.stepping = Stepping::conservative, .composition = TimeComposition::triple_jump}, 0.1, 8),
          6 * 80);
  }
}

TEST_CASE("energy and areas err by a bounded O(tau^2) with the one-step scheme under gravity", "[conservation]") {
  Check check("lagrangian_mesh_bounded_energy", "Sloshing on a Lagrangian mesh: the one-step scheme's bounded errors",
              "The same basins with the one-step scheme. The potential is cubic: the energy errs by O(tau^2), as do "
              "the areas. Neither drifts: with the hourglass potential, which keeps the mesh from folding, the errors "
              "up to t = 400 are those of the first few periods.",
              source);
  auto& figure = check.figure("bounded", "Errors of energy and areas", "Largest up to t = 8 against the step.");
  auto& energy_panel = figure.panel({.x = "tau", .y = "energy defect / wave energy", .log_x = true, .log_y = true});
  auto& area_panel = figure.panel({.x = "tau", .y = "area defect / mean area", .log_x = true, .log_y = true});
  for (const Basin& basin : basins()) {
    const std::vector<double> tau{0.1, 0.05, 0.025, 0.0125};
    std::vector<double> energy, area;
    for (const double step : tau) {
      const Defects d = defects(basin, {}, step, 8);
      energy.push_back(d.energy);
      area.push_back(d.area);
    }
    const auto second_order = [&](const std::string& what, const std::vector<double>& error) {
      check.that(basin.id + "-" + what, "The error of the " + what + " is O(tau^2): " + basin.text + ".",
                 "order of the largest " + what + " defect", observed_order(tau, error),
                 Order{2, 0.01,
                       "a symmetric scheme errs in even powers of the step: the next term is (2 omega tau)^2 = 0.01 of "
                       "the first at the largest step, squares of a wave of omega = 0.5 oscillating twice as fast"});
    };
    second_order("energy", energy);
    second_order("area", area);
    energy_panel.line(basin.text, tau, energy, Role::computed);
    area_panel.line(basin.text, tau, area, Role::computed);
  }
  const Basin held = basins().back();
  const Defects early = defects(held, {}, 0.05, 40);
  const Defects late = defects(held, {}, 0.05, 400);
  const auto bounded = [&](const std::string& what, double ratio) {
    check.holds(
        "long-" + what + ": The " + what + " error does not drift over ten times the time.", {ratio},
        Bound{1.25, "a drift would multiply it by 10, a random walk by 3; more crests find a few per cent more"});
  };
  bounded("energy", late.energy / early.energy);
  bounded("area", late.area / early.area);
}

}  // namespace seiche::verification::lagrangian_mesh_energy_test
