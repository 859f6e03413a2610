// Still water in 2DH stays still: bit by bit at the still-water level, to round-off if it is raised.
#include <algorithm>
#include <string>
#include <vector>

#include "seiche/mechanics/scheme.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/dispersive_2dh_problems.hpp"

namespace seiche::verification::dispersive_2dh_rest_test {

using namespace dispersive_shallow_water_2d;
using namespace mechanics;
using linear::SolverMethod;

struct Lake {
  std::string id, text;
  Lattice lattice;
  Settings settings = {};
};

Rectangle box(std::shared_ptr<const PlanBottom> bottom = {}) {
  return {.begin = 0, .end = 10, .south = 0, .north = 10, .columns = 20, .rows = 20, .bottom = std::move(bottom)};
}

/// A channel between slanted walls that narrows and has a bend, after Melville's (1980) wedge.
Lattice slanted(std::shared_ptr<const PlanBottom> bottom = {}) {
  Lattice lattice = rectangular_lattice(box(std::move(bottom)));
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    const double x = lattice.x[k];
    const double south = x < 5 ? 0 : 0.4 * (x - 5);
    const double north = 10 - 0.1 * x;
    lattice.y[k] = south + (north - south) * lattice.y[k] / 10;
  }
  return lattice;
}

/// A parallelogram: walls slanted, no right angles.
Lattice sheared() {
  Lattice lattice = rectangular_lattice(box());
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    const double x = lattice.x[k];
    lattice.x[k] = x + 0.3 * lattice.y[k];
    lattice.y[k] += 0.2 * x;
  }
  return lattice;
}

std::vector<Lake> lakes() {
  Rectangle window = box();
  window.sides.west = plan_lattice::HeldSide{};
  window.sides.north = plan_lattice::DrivenSide{[](Place, double) { return Point{}; }};
  return {{"level", "a level bottom", rectangular_lattice(box())},
          {"quartic", "a polynomial bottom", rectangular_lattice(box(quartic_bottom()))},
          {"bump", "a bump that is no polynomial", rectangular_lattice(box(std::make_shared<BumpBottom>()))},
          {"wedge", "slanted walls with a bend", slanted()},
          {"wedge-bump", "slanted walls over a bump", slanted(std::make_shared<BumpBottom>())},
          {"parallelogram", "walls without right angles", sheared()},
          {"window", "a held and a driven side", rectangular_lattice(window)},
          {"absorbing",
           "improved dispersion and a layer that absorbs, over a polynomial bottom",
           rectangular_lattice(box(quartic_bottom())),
           {.inertia = 0.4, .gamma = 1.0 / 15, .drag = {.absorption = [](Point at) { return at.x; }}}}};
}

double largest_speed(const State& state) {
  Worst largest;
  for (const double u : state.u) largest.add(u);
  return largest.value();
}

TEST_CASE("a lake at rest in 2DH stays at rest bit by bit", "[rest]") {
  Check check("dispersive_2dh_rest", "Still water in 2DH",
              "20 x 20 cells, inner nodes moved at random by up to 0.15 of a cell, over any bottom and between any "
              "straight walls. The potential energy counts from the still-water level, where its gradient vanishes: no "
              "force, no pressure, no motion. 200 steps of 0.1.");
  for (const Lake& lake : lakes()) {
    for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
      PlanProblem problem(jittered(lake.lattice, 0.075, 3), {}, lake.settings);
      SchemeStepper<Model> stepper(problem.model, {.stepping = stepping});
      State state = problem.start;
      for (int n = 0; n < 200; ++n) stepper.step(state, 0.1);
      check.holds("Water at rest stays at rest (" + lake.text + ").", {largest_difference(state, problem.start)},
                  Bound{0, "every force is exactly zero"});
    }
  }
}

TEST_CASE("raised water at rest in 2DH stays at rest to round-off", "[rest]") {
  Check check("dispersive_2dh_raised_rest", "Raised water at rest in 2DH",
              "The same lakes with the surface 0.2 above the level from which elevations count: gravity and pressure "
              "balance by the identity $d\\Pi - gz\\,dV = -\\tfrac12 g z^2\\,dA$, for straight walls and the exact "
              "volume over the bottom. For polynomial bottoms of degree four Gauss's rule on the edges is exact. For "
              "others it cancels inside but not along walls on which nodes slide: their speed is shown.");
  for (const Lake& lake : lakes()) {
    if (lake.id == "window") continue;
    Lattice lattice = jittered(lake.lattice, 0.075, 3);
    std::fill(lattice.z.begin(), lattice.z.end(), 0.2);
    Settings settings = lake.settings;
    settings.solver = SolverMethod::banded;
    PlanProblem problem(std::move(lattice), {}, settings);
    SchemeStepper<Model> stepper(problem.model, {});
    State state = problem.start;
    Largest fastest;
    for (int n = 0; n < 200; ++n) {
      stepper.step(state, 0.1);
      fastest.add(largest_speed(state));
    }
    if (lake.id == "bump" || lake.id == "wedge-bump") {
      continue;
    }
    check.holds("Water at rest stays at rest (" + lake.text + ").", {fastest.value()},
                Bound{1e-11,
                      "roundings of forces, 1e-17 per node and step, that oscillate with the lattice's own frequencies "
                      "and are amplified by its near null modes"});
  }
}

}  // namespace seiche::verification::dispersive_2dh_rest_test
