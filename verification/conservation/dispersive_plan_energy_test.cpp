// Energy and volumes of the plan model over level and uneven bottoms: to round-off with the conservative scheme, to
// second order with the one-step scheme.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "verification/check.hpp"
#include "verification/conservation/dispersive_plan_problems.hpp"

namespace seiche::verification::dispersive_plan_energy_test {

using namespace dispersive_shallow_water_2d;
using namespace mechanics;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1, 3 and 4.2";

/// Largest so far, relative to the energy at the beginning and to a cell's mean volume, and the history of the former.
struct Defects {
  double energy = 0, volume = 0;
  double first_half = 0;  ///< largest energy defect in the first half of the run
  std::vector<double> times, energies;
};

Defects defects(Scheme scheme, const Lattice& lattice, Settings settings, double tau, double time) {
  PlanProblem problem(lattice, {}, settings);
  SchemeStepper<Model> stepper(problem.model, scheme);
  InvariantsWatch watch(problem.model, problem.start);
  const double energy = watch.ledger().entry("energy").initial;
  const double volume = problem.model.mass() / static_cast<double>(problem.model.constraints());
  Defects result;
  const long steps = std::lround(time / tau);
  for (long n = 1; n <= steps; ++n) {
    stepper.step(problem.start, tau);
    watch.record(problem.start);
    result.times.push_back(problem.start.time);
    result.energies.push_back(watch.ledger().entry("energy").defect / energy);
    if (n == steps / 2) result.first_half = watch.ledger().largest_defect("energy") / energy;
  }
  result.energy = watch.ledger().largest_defect("energy") / energy;
  result.volume = watch.ledger().largest_defect("volume_worst") / volume;
  return result;
}

struct Basin {
  std::string id, text;
  Lattice lattice;
  double spread;  ///< over so many nodes is the energy spread at the beginning
  Settings settings = {.tolerance = 1e-13};
};

std::vector<Basin> basins() {
  // (integral of e)^2/(integral of e^2) of the energy e = exp(-0.6 r^2), over cells of 0.25; a quarter in a corner.
  const double whole = 2 * std::numbers::pi / 0.6 / 0.25;
  return {{"level", "a level bottom", plan_hump_in_box(), whole / 4},
          {"quartic", "a polynomial bottom", plan_hump_in_box(quartic_bottom()), whole / 4},
          {"bump", "a bump that is no polynomial", hump_over_bump(), whole},
          {"improved",
           "a bump, with improved dispersion",
           hump_over_bump(),
           whole,
           {.inertia = 0.4, .gamma = 1.0 / 15, .tolerance = 1e-13}}};
}

TEST_CASE("the conservative scheme keeps energy and volumes in plan over any bottom", "[conservation]") {
  Check check("dispersive_plan_energy", "Two-dimensional horizontal model: energy and volumes to round-off",
              "A hump is released in a box and sloshes until t = 5, over a level bottom, over a polynomial of degree "
              "four and over a bump. Volumes and potential energy are polynomials along a step, so that Simpson's mean "
              "of their gradients is exact; what the bottom adds to volumes is made exact along the step. Over uneven "
              "bottoms velocities turn with the bottom's tangent plane, which changes no energy. The energy of "
              "improved dispersion, which is no polynomial, has a discrete gradient in closed form.");
  const Scheme conservative{.stepping = Stepping::conservative};
  for (const Basin& basin : basins()) {
    for (const double tau : {0.1, 0.25}) {
      const Defects d = defects(conservative, basin.lattice, basin.settings, tau, 5);
      const std::string id = fmt::format("{}-{}", basin.id, tau == 0.1 ? "short" : "long");
      const double steps = 5 / tau;
      check.holds(
          id + "-energy: Energy to round-off over " + basin.text + ".", {d.energy},
          Roundoff{
              2 + 100 * steps / basin.spread, 1,
              "some 100 roundings in a step of the energy's part at a node; squares add up, so that it counts over how "
              "many nodes the energy is spread, never fewer than at the beginning; and of the energies themselves"});
      check.holds(id + "-volume: Every cell's volume to round-off over " + basin.text + ".", {d.volume},
                  Roundoff{12 * steps, basin.lattice.x.back() / 0.5,
                           "12 rounded places, up to the box's length, per step and over a cell's side, 0.5"});
    }
  }
}

TEST_CASE("energy and volumes of the one-step scheme in plan err by the square of the step", "[conservation][full]") {
  Check check("dispersive_plan_energy_order", "Two-dimensional horizontal model: energy of the one-step scheme",
              "A hump of 0.3 in a box until t = 200 over a level bottom, and a hump of 0.15 beside a bump until t = "
              "30. The energy errs by a bounded amount that shrinks with $\\tau^2$, and does not drift; so do the "
              "volumes of the cells. Over the bump this holds because velocities are carried along with the bottom's "
              "tangent plane to second order.",
              source);
  const auto judge = [&](const std::string& id, const Lattice& lattice, double time, const std::vector<double>& taus) {
    auto& figure =
        check.figure(id, "Energy of the one-step scheme", "Relative defect of the energy, four steps (" + id + ").");
    auto& panel = figure.panel({.x = "t sqrt(g/H)", .y = "energy defect"});
    std::vector<double> energies, volumes;
    for (const double tau : taus) {
      const Defects d = defects({}, lattice, {.tolerance = 1e-10}, tau, time);
      panel.line(fmt::format("tau = {:g}", tau), d.times, d.energies);
      energies.push_back(d.energy);
      volumes.push_back(d.volume);
      if (tau != taus.back()) continue;
      check.holds(id + "-no-drift: The energy does not drift.", {d.energy / d.first_half},
                  Bound{0.5, "a drift would double it", 1});
    }
    const auto order = [&](const std::string& what, const std::vector<double>& errors) {
      check.that(
          id + "-order-" + what, "The largest defect of " + what + " is of second order.", "observed order",
          observed_order(taus, errors),
          Order{2, 0.3,
                "a symmetric scheme of second order; the maximum over time is not a smooth function of the step"});
    };
    order("energy", energies);
    order("volumes", volumes);
  };
  judge("level", plan_hump_in_box(), 200, {0.4, 0.2, 0.1, 0.05});
  judge("bump", hump_over_bump(), 30, {0.2, 0.1, 0.05, 0.025});
}

}  // namespace seiche::verification::dispersive_plan_energy_test
