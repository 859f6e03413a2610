/*
A basin of sides $\pi$ whose columns of water follow a motion that is prescribed in labels,

$$x = X + A \sin X \cos Y \cos(\omega t + \tfrac12), \qquad
y = Y + A\,\bigl(\tfrac7{10} \cos X \sin Y \cos(\omega t + 1) + \tfrac3{10} \cos 2X \sin 2Y \sin \omega t\bigr),$$

with $A = 0.15$, $\omega = 1.3$; depth, gravity and $\alpha = 1/3$ make the depth $H = 1/(x_X y_Y - x_Y y_X)$ and, by
the Green-Naghdi equations, the body force that sustains the motion. It acts on the columns of the 2DH model (Frank
1994, section 4.2).

**Set-up.** $n \times n$ cells with equally spaced labels, exact places, elevations and velocities at $t = 0$, the
latter made to keep the volumes. Steps of a cell's width over `steps_per_cell`, until $t = 2$.

**What is compared.** Errors of places, elevations and horizontal velocities, in the $L_2$ norm over the labels.

**What to look at.** All are of second order. Elevations have the largest errors, for they are derivatives of places.
The volumes of the cells err by the time step alone; with the conservative scheme they do not err at all.
*/
#include <cmath>

#include "validation/case/case.hpp"
#include "validation/case/refinement.hpp"
#include "validation/instruments/plan_manufactured_flow.hpp"

namespace seiche::validation::cases::mms_2dh {
namespace {

PlanManufacturedRun run_of(const Values& values, long n) {
  return {.n = static_cast<std::size_t>(n),
          .steps_per_cell = values.integer("steps_per_cell"),
          .scheme = {.stepping = mechanics::stepping_named(values.text("scheme"))}};
}

/// From a quarter of n to n.
std::vector<long> lattices_up_to(long n) {
  std::vector<long> lattices;
  for (const double part : {0.25, 0.375, 0.5, 0.75, 1.0})
    lattices.push_back(std::lround(part * static_cast<double>(n)));
  return lattices;
}

RefinementStudy study_of(const Values& values) {
  const Order second{2, 0.05, "second order of smooth solutions"};
  return {.quantities =
              {{"position", "places, L2", "Node positions converge at second order in the cell size.", second},
               {"elevation", "elevations, L2", "Surface elevations converge at second order in the cell size.", second},
               {"velocity", "velocities, L2", "Node velocities converge at second order in the cell size.", second},
               {"volume", "volumes, largest"}},
          .source = "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4",
          .coarsest = lattices_up_to(values.integer("n"))[1]};
}

void claims(const Values& values, const Claims<Refinement>& claims) {
  study_of(values).claim_orders(claims);
}

Refinement compute(const Run& run) {
  Refinement refinement;
  const std::vector<long> lattices = lattices_up_to(run.integer("n"));
  for (const long n : lattices) {
    const PlanManufacturedErrors errors = plan_manufactured_errors(run_of(run, n));
    refinement.add(n, {errors.position, errors.elevation, errors.velocity, errors.volume});
    run.progress(std::pow(static_cast<double>(n) / static_cast<double>(lattices.back()), 3));
  }
  return refinement;
}

void show(const Refinement& refinement, const Values& values, evidence::Exhibit& exhibit) {
  const RefinementStudy study = study_of(values);
  study.draw(refinement, exhibit
                             .figure("convergence", "Errors under refinement",
                                     "Against the number of cells across; grey lines have slopes 1 and 2.")
                             .panel({.x = "cells n", .y = "error", .log_x = true, .log_y = true}));
  study.tabulate(refinement, exhibit);
  auto& figure = exhibit.figure("motion", "The lattice in its basin at the beginning",
                                "Elevation of the surface at t = 0 over the places of the columns, seen from above and "
                                "in perspective: the columns are not where their labels are.");
  const auto flow = plan_manufactured_flow(run_of(values, study.coarsest));
  const evidence::Lattice lattice{
      .columns = flow.shape().columns, .rows = flow.shape().rows, .x = flow.x(), .y = flow.y(), .z = flow.z()};
  figure.panel({.x = "x", .y = "y", .z = "elevation"}).plan("t = 0", lattice);
  figure.panel({.x = "x", .y = "y", .z = "elevation"}).surface("t = 0", lattice);
}

}  // namespace

Case mms_2dh() {
  Case c;
  c.title = "A manufactured motion of a basin: orders of the 2DH model";
  c.source = "P. J. Roache, J. Fluids Eng. 124 (2002) 4; model: A. M. Frank, doctoral thesis (1994), section 4.2";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      integer("n", {32, 64, 128}, {16, 512}, "cells across on the finest of five lattices"),
      integer("steps_per_cell", 4, {1, 100}, "time step: a cell's width over this"),
      choice("scheme", std::string("one_step"), {"one_step", "one_step_feedback", "conservative"}, "time stepping"),
  };
  c.study = Study(claims, compute, show);
  c.former_names = {"mms_plan"};
  return c;
}

}  // namespace seiche::validation::cases::mms_2dh
