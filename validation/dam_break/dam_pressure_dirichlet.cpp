/*
A water column of length $L$ and height $H$ stands on a floor against a wall; the wall on its other side vanishes at $t
= 0$. At that instant all velocities are zero, and the pressure is a harmonic function, known as a series:

$$\frac{p}{\rho g} = H - y - \sum_{n \ge 0} \frac{2}{H k_n^2} \cos k_n y \, \frac{\cosh k_n x}{\cosh k_n L}, \qquad
k_n = \left(n + \tfrac12\right) \frac{\pi}{H} .$$

**Set-up.** Dirichlet cells of staggered rows, spacing $h = H/n_y$, $n_y = 8, 16, \dots$. The multipliers $\lambda$ of
the constant areas are the dynamic pressure $p + \rho g y$; one solution of $A \lambda = \dots$ gives them. With the
stabilisation $\epsilon$ the matrix is $A + \epsilon \frac{\mathrm{tr} A}{N} L^T L$, where $L$ is a node's value minus
the mean of its neighbours.

**What is compared.** The pressure at the foot of the wall, and the rms error over all cells except at the free faces,
whose pressure is taken half a cell inside.

**What to look at.** The mesh is regular, and the matrix therefore nearly singular: without stabilisation the pressure
is chequered, and its error first-order. A small stabilisation removes the chequering; a large one, 1, smooths the
pressure itself. At the toe the acceleration has a logarithmic singularity, which keeps the order slightly below 2. At
the free faces a node has neighbours on one side only: there $L$ contains the pressure gradient, an error of the size
$\epsilon h$, which dominates on finer meshes (order 1.2 with $\epsilon = 1$, 1.6 between $n_y = 64$ and 128 with 0.1).

**Limits of this test.** It covers the mesh at one instant. As the water moves, node offsets within cells grow without a
restoring force; the source reports this loss of quality.
*/
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/released_column.hpp"
#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "validation/case/case.hpp"
#include "validation/case/refinement.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::dam_pressure_dirichlet {

using exact::ReleasedColumn;
using free_lagrangian::Mesh;

const std::string source = "exact series; model: Frank, Discrete models of incompressible fluid (1994), section 5.2";
constexpr long coarsest = 8;
constexpr long mesh_of_corner = 32;
constexpr long finest_of_order = 64;
struct Stabilisation {
  double value;
  const char* id;
};
constexpr std::array stabilisations{Stabilisation{0, "none"}, Stabilisation{0.001, "1e-3"}, Stabilisation{0.01, "1e-2"},
                                    Stabilisation{0.1, "1e-1"}, Stabilisation{1, "1"}};

/// Multipliers of the cells, and how far they are from the exact pressure.
struct Pressure {
  Mesh mesh;
  std::vector<double> values = {};
  double rms = 0;
  double corner = 0;  ///< at the foot of the wall, over rho g H
};

Pressure pressure_of(const Values& values, const ReleasedColumn& exact, long ny, double stabilisation) {
  const double height = values.real("height");
  const double length = values.real("length");
  Pressure pressure{.mesh = free_lagrangian::layer_mesh(
                        {.end = length,
                         .bottom = 0,
                         .level = height,
                         .columns = static_cast<int>(std::lround(static_cast<double>(ny) * length / height)),
                         .rows = static_cast<int>(ny),
                         .right_wall = false})};
  dirichlet_mesh::Model model(pressure.mesh, {.stabilisation = stabilisation});
  // Dynamic pressure p + rho g y of water that is at rest and let go at this instant.
  model.linearise({}, model.state().q);
  std::vector<double> acceleration(model.rates(), 0.0);
  pressure.values.assign(model.constraints(), 0.0);
  model.kick(1, acceleration);
  mechanics::Projection(model).project(acceleration, {}, pressure.values);
  const Mesh& mesh = pressure.mesh;
  Mean errors;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const double x = mesh.x[k];
    const double y = mesh.y[k];
    if (x == 0 && y == 0) pressure.corner = pressure.values[k] / height;
    if (x == length || y == height) continue;
    errors.add((pressure.values[k] - exact.dynamic_pressure(x, y)) / height);
  }
  pressure.rms = errors.rms();
  return pressure;
}

std::vector<long> meshes_up_to(long ny) {
  std::vector<long> meshes;
  for (long n = coarsest; n <= ny; n *= 2) meshes.push_back(n);
  return meshes;
}

std::string title_of(double stabilisation) {
  return fmt::format("stabilisation {:g}", stabilisation);
}

/// The order of the case's own stabilisation.
Order order_of(double stabilisation) {
  if (stabilisation == 0) {
    return {1, 0.3,
            "chequered pressures of the size of the pressure step at the free faces, one cell wide: first order"};
  }
  return {2, 0.3,
          "cells of regular rows: second order; at the toe the pressure is like r log r, which reduces the order of "
          "the error from there by 1/log(1/h), 0.25 to 0.5 on these meshes"};
}

struct Results {
  ReleasedColumn exact;
  double height;
  Refinement own = {};        ///< of the case's stabilisation, up to finest_of_order
  Refinement tabulated = {};  ///< of all stabilisations
  Pressure finest = {};
  double corner = 0;  ///< on mesh_of_corner
};

void claims(const Values& values, const Claims<Results>& claims) {
  const double stabilisation = values.real("stabilisation");
  const bool tabulated = values.real("length") == 2 * values.real("height");
  const std::string other_shape = "the meshes were chosen for a column twice as long as high";
  const long finest = meshes_up_to(values.integer("ny")).back();
  claims.at(fmt::format("h = H/{}", finest))
      .check(
          "rms", "The rms error of the pressure inside is below the hydrostatic pressure over one cell.",
          "error over rho g H, rms", [](const Results& r) { return r.finest.rms; },
          Bound{.limit = 1 / static_cast<double>(finest),
                .reason = "the hydrostatic pressure over one cell, twice the error of the cells at the free faces"});
  claims
      .only_if(tabulated && stabilisation == 0.1, "less leaves the pressure chequered, more smooths it; " + other_shape)
      .at(fmt::format("h = H/{}", mesh_of_corner))
      .check(
          "corner",
          "The pressure at the foot of the wall agrees with the series within (k h)^2/8 of its gravest mode, k = pi/(2 "
          "H).",
          "error over rho g H", [](const Results& r) { return r.corner - r.exact.pressure(0, 0) / r.height; },
          Bound{.limit = std::pow(std::numbers::pi / 2 / mesh_of_corner, 2) / 8,
                .reason = "(k h)^2/8 of the gravest mode, k = pi/(2 H): the error of a second-order difference"});
  claims
      .only_if(
          tabulated && (stabilisation == 0 || (stabilisation >= 0.001 && stabilisation <= 0.1)),
          "with less the order changes from 2 to 1 with refinement; more than 0.1 smooths the pressure; " + other_shape)
      .at(fmt::format("h = H/{} to H/{}", coarsest, finest_of_order))
      .check(
          "order",
          stabilisation == 0 ? "The pressure error without stabilisation converges at first order."
                             : "The pressure error converges at second order on these meshes.",
          "order of the error, rms", [](const Results& r) { return r.own.order(0, coarsest); },
          order_of(stabilisation));
}

Results compute(const Run& run) {
  const ReleasedColumn exact(run.real("length"), run.real("height"));
  Results r{.exact = exact, .height = run.real("height")};
  const std::vector<long> meshes = meshes_up_to(run.integer("ny"));
  for (const long ny : meshes) {
    r.finest = pressure_of(run, exact, ny, run.real("stabilisation"));
    if (ny <= finest_of_order) r.own.add(ny, {r.finest.rms});
    if (ny == mesh_of_corner) r.corner = r.finest.corner;
    r.tabulated.add(
        ny, each(stabilisations, [&](const Stabilisation& one) { return pressure_of(run, exact, ny, one.value).rms; }));
    run.progress(std::pow(static_cast<double>(ny) / static_cast<double>(meshes.back()), 2));
  }
  return r;
}

void draw_pressure(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  auto& figure =
      exhibit.figure("pressure", "Pressure of a water column at its release",
                     "Along the floor and along the wall, over rho g H, on the finest mesh.", {"frank-dirichlet"});
  for (const auto& [axis, floor] : {std::pair{"x/H on the floor", true}, std::pair{"y/H at the wall", false}}) {
    std::vector<double> place, computed, exact;
    const Mesh& mesh = r.finest.mesh;
    for (std::size_t k = 0; k < mesh.nodes(); ++k) {
      if ((floor ? mesh.y[k] : mesh.x[k]) != 0) continue;
      place.push_back((floor ? mesh.x[k] : mesh.y[k]) / r.height);
      computed.push_back((r.finest.values[k] - mesh.y[k]) / r.height);
      exact.push_back(r.exact.pressure(mesh.x[k], mesh.y[k]) / r.height);
    }
    auto& panel = figure.panel({.x = axis, .y = "p/(rho g H)"});
    panel.line("exact", place, exact, Role::exact);
    panel.points(title_of(values.real("stabilisation")), place, computed, Role::computed);
  }
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  draw_pressure(r, values, exhibit);
  RefinementStudy study{.source = source};  // a quantity for each of the stabilisations
  for (const auto& [stabilisation, id] : stabilisations) {
    study.quantities.push_back({.id = id, .name = title_of(stabilisation)});
  }
  study.draw(r.tabulated, add_panel(exhibit, "convergence", "Error against the mesh, for five stabilisations",
                                    "Root mean square over the cells inside; grey lines have slopes 1 and 2.",
                                    {.x = "cells over the height", .y = "error", .log_x = true, .log_y = true}));
  study.tabulate(r.tabulated, exhibit);
}

void dam_pressure_dirichlet(Case& c) {
  c.title = "Pressure at the release of a water column, on the Dirichlet mesh";
  c.source =
      "Series for the initial pressure (Pohle 1950; Stoker, Water Waves, 12.1); model: A. M. Frank, doctoral thesis "
      "(1994), section 5.2";
  c.parameters = {
      real("length", 2.0, "m", {0.5, 4}, "of the column"),
      real("height", 1.0, "m", {0.5, 2}, "of the column"),
      integer("ny", 64, {64, 128}, "cells over the height on the finest mesh; 8, 16, ... up to it"),
      real("stabilisation", 0.1, "1", {0, 10}, "epsilon"),
  };
  c.published = {{.tiles = {"frank-dirichlet"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::dam_pressure_dirichlet
