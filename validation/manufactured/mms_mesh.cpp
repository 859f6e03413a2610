/*
A manufactured motion shows in which quantities a scheme is of second order, and in which not. Here the water is a free
square, $|X|, |Y| \le 1$ at $t = 0$. Two shears, one after the other, move it and keep all areas:

$$x = X + 0.3 \sin t \sin 1.3Y, \qquad y = Y + 0.2 \sin t \cos 1.1x, \qquad
p = 0.7 \cos t\,(1 - X^2)(1 - Y^2).$$

The body force that this takes follows from the equations of motion in labels; it acts on the nodes of the mesh.

**Set-up.** $n$ by $n$ cells, no gravity, all four sides free, $t = 0$ to $1$. A step is `tau_over_h` cells of width
$h = 2/n$. With `distortion` the initial mesh is curved: nodes are displaced along the square by up to that much.

**What is compared.** Places and velocities of the nodes, pressure in the cells, the distance of surface nodes from the
exact curve. Root-mean-square errors are weighted with the mass, others are the largest component. The interior is the
middle half of the square, the surface the middle three quarters of the top edge.

**What to look at.** The order is two in the interior, of the pressure, and of the surface's shape, but not of the
places of nodes on the surface. Such a node feels the pressure gradient half a cell below the surface, where the
gradient along the surface is no longer zero. The node slips along the surface,

$$\mathrm{slip}'' = \tfrac{h}{2}\,p_{XY}, \qquad \mathrm{slip} = 2hPX(1 - \cos t)\ \text{at}\ Y = 1,\ P = 0.7,$$

an error of first order, which changes no area and which nothing opposes. The second figure shows it: the slips of all
meshes, divided by $h$, lie on that line. Slips fill a layer of one cell, and the mean square of an error $h$ in a layer
$h$ is $h^3$: the root-mean-square errors are of order 1.5. At a corner the slips along two sides meet, and a few cells
are of first order in every respect.
*/
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/case/refinement.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/mesh_double_shear.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"

namespace seiche::validation::cases::mms_mesh {
namespace {

using lagrangian_mesh_2d::Flow;

DoubleShearRun run_of(const Values& values, long n) {
  return {.n = static_cast<std::size_t>(n),
          .tau_over_h = values.real("tau_over_h"),
          .scheme = {.stepping = mechanics::stepping_named(values.text("scheme"))},
          .distortion = values.real("distortion")};
}

/// From a quarter of n to n, multiples of eight: then nodes lie on the borders of interior and judged edge.
std::vector<long> meshes_up_to(long n) {
  std::vector<long> meshes;
  for (const double part : {0.25, 0.375, 0.5, 0.75, 1.0}) {
    const long cells = 8 * std::lround(static_cast<double>(n) * part / 8);
    if (meshes.empty() || cells > meshes.back()) meshes.push_back(cells);
  }
  return meshes;
}

RefinementStudy study_of_orders() {
  const Order layer{1.5, 0.1, "errors of first order in a layer of one cell"};
  return {
      .quantities =
          {{"interior", "places in the interior", "Nodes in the interior are where they should be to second order.",
            Order{2, 0.15, "second order; coarse meshes' interiors still feel the layer at the edges"}},
           {"pressure", "pressure, rms", "The pressure is of second order.",
            Order{2, 0.1, "second order of smooth solutions"}},
           {"shape", "shape of the surface, rms", "The shape of the surface is of second order.",
            Order{2, 0.2, "second order, and first order at the corners, whose influence decays along the edge"}},
           {"position", "places, rms", "Places of all nodes are of order 1.5 in the root mean square.", layer},
           {"velocity", "velocities, rms", "Velocities of all nodes are of order 1.5 in the root mean square.", layer},
           {"slip", "slip along the surface", "Surface nodes slip along the surface to first order.",
            Order{1, 0.1, "slip of half a cell's pressure gradient; the next term is of second order"}},
           {"largest", "places, largest", "At the corners places are of first order.",
            Order{1, 0.15,
                  "slips along two sides meet within a few cells, fewer of them in the square on coarse meshes"}}},
      .source = "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4"};
}
constexpr std::size_t slip_quantity = 5;

struct Results {
  Refinement refinement;
  std::vector<EdgeSlip> slips;  ///< over the width of a cell, on each mesh
  Flow coarsest;                ///< at the end
};

void claims(const Values& values, const Claims<Results>& claims) {
  const RefinementStudy study = study_of_orders();
  study.claim_orders(claims.of(&Results::refinement));
  const DoubleShearRun finest = run_of(values, meshes_up_to(values.integer("n")).back());
  claims.at(fmt::format("n = {}", finest.n))
      .only_if(finest.distortion == 0, "the estimate is for equal cells")
      .check(
          "slip", "The slip agrees with the pressure gradient half a cell below the surface.",
          "slip along the surface over its estimate 2 h P X (1 - cos t), X = 3/4",
          [finest](const Results& r) {
            return r.refinement.finest(slip_quantity) / expected_slip(finest, judged_edge);
          },
          Bound{.limit = finest.spacing(), .reason = "the next term is smaller by a factor h", .expected = 1});
}

Results compute(const Run& run) {
  Refinement refinement;
  std::vector<EdgeSlip> slips;
  std::optional<Flow> coarsest;
  const std::vector<long> meshes = meshes_up_to(run.integer("n"));
  for (const long n : meshes) {
    const DoubleShearRun shear = run_of(run, n);
    Flow flow = double_shear_flow(shear);
    advance_to_end(flow, shear);
    const DoubleShearErrors errors = errors_at_end(flow, shear);
    refinement.add(n, {errors.interior, errors.rms_lambda, errors.shape, errors.rms_position, errors.rms_velocity,
                       errors.slip, errors.position});
    slips.push_back(edge_slip(flow, shear));
    for (double& value : slips.back().slip) value /= shear.spacing();
    if (!coarsest) coarsest = std::move(flow);
    run.progress(std::pow(static_cast<double>(n) / static_cast<double>(meshes.back()), 3));
  }
  return {std::move(refinement), std::move(slips), std::move(*coarsest)};
}

void draw_mesh_at_end(const Flow& flow, const DoubleShearRun& shear, evidence::Exhibit& exhibit) {
  auto& panel = exhibit
                    .figure("mesh", "The mesh at the end",
                            "Computed, and where the nodes should be. They differ at the edges, along them.")
                    .panel({.x = "x", .y = "y", .equal_aspect = true});
  const lagrangian_mesh_2d::Mesh& mesh = flow.model().mesh();
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const auto place = shear.motion.at(mesh.x[k], mesh.y[k], flow.time());
    x.push_back(place.x);
    y.push_back(place.y);
  }
  draw_mesh(panel, "exact", mesh, x, y, {}, Role::exact);
  draw_mesh(panel, "computed", flow);
}

void draw_slips(const Results& r, const DoubleShearRun& finest, evidence::Exhibit& exhibit) {
  auto& panel = exhibit
                    .figure("slip", "Slip of surface nodes along the surface",
                            "At the top edge, divided by the width of a cell, over the nodes' labels.")
                    .panel({.x = "X", .y = "slip/h"});
  for (std::size_t m = 0; m < r.slips.size(); ++m) {
    panel.line(fmt::format("n = {:g}", r.refinement.n()[m]), r.slips[m].label, r.slips[m].slip);
  }
  const std::vector<double> labels = evenly(-1, 1, 2);
  std::vector<double> expected =
      each(labels, [&](const double label) { return expected_slip(finest, label) / finest.spacing(); });
  panel.line("estimate", labels, expected, Role::guide);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const RefinementStudy study = study_of_orders();
  const std::vector<long> meshes = meshes_up_to(values.integer("n"));
  study.draw(r.refinement, exhibit
                               .figure("convergence", "Errors under refinement",
                                       "Against the number of cells across; grey lines have slopes 1 and 2.")
                               .panel({.x = "cells n", .y = "error", .log_x = true, .log_y = true}));
  draw_slips(r, run_of(values, meshes.back()), exhibit);
  draw_mesh_at_end(r.coarsest, run_of(values, meshes.front()), exhibit);
  study.tabulate(r.refinement, exhibit);
}

}  // namespace

Case mms_mesh() {
  Case c;
  c.former_names = {"mms_2d"};
  c.title = "A manufactured motion of a free square: orders of the two-dimensional Lagrangian mesh";
  c.source = "P. J. Roache, J. Fluids Eng. 124 (2002) 4; model: A. M. Frank, doctoral thesis (1994), chapter 2";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      integer("n", {64, 128, 192}, {32, 512}, "cells across on the finest of five meshes"),
      real("tau_over_h", 0.2, "1", {1e-3, 1}, "time step over the width of a cell"),
      choice("scheme", std::string("one_step"), {"one_step", "conservative"}, "time stepping"),
      real("distortion", 0.0, "1", {0, 0.2}, "amplitude of the initial mesh's displacement"),
  };
  c.study = Study(claims, compute, show, "momentum of a surface node; see the article");
  return c;
}

}  // namespace seiche::validation::cases::mms_mesh
