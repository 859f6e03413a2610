/*
A round drop without gravity is stretched, $u = s x$, $v = -s y$ at the beginning. It becomes an ellipse of the same
area; its particles move on $x = a X$, $y = Y/a$ with

$$\dot a = s \sqrt{\frac{2}{1 + a^{-4}}}, \qquad a(0) = 1,$$

and the pressure is a paraboloid, positive everywhere inside.

**Set-up.** The square $|\xi|, |\eta| \le 1$ of $n$ by $n$ cells, mapped on the disc,
$x = \xi\sqrt{1 - \eta^2/2}$, $y = \eta\sqrt{1 - \xi^2/2}$. The four corner cells have a straight angle on the outline.
A step is `tau_over_h` times $h = 2/n$.

**What is compared.** The tip of the long axis, places of all nodes and the pressure in the cells with the exact ones,
the energy with that of the beginning.

**What to look at.** At $t = 1$ the drop is five times as long as wide. The mesh follows; the energy is kept to
rounding. Nodes on the outline slip along it to first order, hence order 1.5 of all places in the root mean square,
while the pressure is of second order.

**When it is no test.** A drop that rotates faster than it is strained has a pressure below that of the surroundings.
It is an exact solution too, but its surface is unstable, and any method loses it after a while.
*/
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/stretching_drop.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/case/refinement.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Order;
using evidence::Role;
using exact::StretchingDrop;
using lagrangian_mesh_2d::Flow;
using lagrangian_mesh_2d::Mesh;

const std::string source = "Dirichlet (1860); Longuet-Higgins, J. Fluid Mech. 55 (1972) 529";

Mesh disc(std::size_t n) {
  Mesh mesh = lagrangian_mesh_2d::free_patch(n, n, {-1, -1}, {1, 1});
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const double xi = mesh.x[k];
    const double eta = mesh.y[k];
    mesh.x[k] = xi * std::sqrt(1 - eta * eta / 2);
    mesh.y[k] = eta * std::sqrt(1 - xi * xi / 2);
  }
  return mesh;
}

/// Long semi-axis in time, and the largest change of the energy.
struct History {
  std::vector<double> time;
  std::vector<double> tip;
  double energy_defect = 0;
};

std::size_t tip_node(const Mesh& mesh) {
  return mesh.node(mesh.columns, mesh.rows / 2);
}

History advance_to_end(Flow& flow, double time, double tau) {
  History history;
  const double energy = flow.energy();
  const auto observe = [&] {
    history.time.push_back(flow.time());
    history.tip.push_back(flow.x()[tip_node(flow.model().mesh())]);
    history.energy_defect = std::max(history.energy_defect, std::abs(flow.energy() - energy));
  };
  observe();
  flow.advance_to(time, tau, observe);
  return history;
}

/// In the order of the quantities.
std::vector<double> errors_of(const Flow& flow, const StretchingDrop& drop) {
  const Mesh& mesh = flow.model().mesh();
  const double a = drop.semi_axis(flow.time());
  const double b = drop.other_axis(flow.time());
  double places = 0;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const double dx = flow.x()[k] - a * mesh.x[k];
    const double dy = flow.y()[k] - b * mesh.y[k];
    places += flow.model().nodes().mass()[k] * (dx * dx + dy * dy);
  }
  const double tau = flow.time() / static_cast<double>(flow.steps());
  const double central = drop.at(flow.time() - tau).central_pressure;
  const std::vector<double> pressure = flow.dynamic_pressure();
  double pressures = 0;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    Point middle;
    for (const std::size_t node : mesh.corners(cell)) {
      middle.x += 0.25 * mesh.x[node];
      middle.y += 0.25 * mesh.y[node];
    }
    const double exact = central * (1 - middle.x * middle.x - middle.y * middle.y);
    pressures += flow.model().first_areas()[cell] * std::pow(pressure[cell] - exact, 2);
  }
  const double mass = flow.model().mass();
  return {std::abs(flow.x()[tip_node(mesh)] - a), std::sqrt(places / mass), std::sqrt(pressures / mass)};
}

Refinement judged_quantities() {
  return Refinement({{"tip",
                      "tip of the long axis",
                      "",
                      std::nullopt,
                      {{8, "4.2e-2"}, {16, "1.9e-2"}, {32, "7.3e-3"}, {64, "2.4e-3"}}},
                     {"position", "places, rms", "Places of all nodes are of order 1.5 in the root mean square.",
                      Order{1.5, 0.1, "errors of first order in a layer of one cell"}},
                     {"pressure", "pressure, rms", "The pressure is of second order.",
                      Order{2, 0.15, "second order of smooth solutions; the mesh is not smooth at its four corners"}}},
                    source);
}

void claim_energy(Running& run, const Flow& flow, const History& history, long n) {
  run.record.check({.id = "energy",
                    .text = "The kinetic energy is kept on all meshes.",
                    .quantity = "largest defect",
                    .source = "Frank, Discrete models of incompressible fluid (1994), chapter 1"},
                   {.value = history.energy_defect, .resolution = fmt::format("n = {}", n)},
                   evidence::Roundoff{.operations = static_cast<double>(flow.steps() + 16),
                                      .scale = flow.energy(),
                                      .reason = "rounding of the energy, once per step"});
}

void draw_mesh_at_end(Running& run, const Flow& flow, const StretchingDrop& drop) {
  auto& figure = run.record.figure("mesh", "The drop at the beginning and at the end", "Its mesh; the exact outline.");
  const Mesh& mesh = flow.model().mesh();
  const auto panel = [&](const std::string& title, std::span<const double> x, std::span<const double> y, double t) {
    auto& one = figure.panel({.x = "x", .y = "y", .title = title, .equal_aspect = true});
    draw_mesh(one, "mesh", mesh, x, y);
    std::vector<double> outline_x;
    std::vector<double> outline_y;
    for (const double angle : evenly(0, 2 * std::numbers::pi, 201)) {
      outline_x.push_back(drop.semi_axis(t) * std::cos(angle));
      outline_y.push_back(drop.other_axis(t) * std::sin(angle));
    }
    one.line("exact", outline_x, outline_y, Role::exact);
  };
  panel("t = 0", mesh.x, mesh.y, 0);
  panel(fmt::format("t = {:g}", flow.time()), flow.x(), flow.y(), flow.time());
}

void run(Running& run) {
  const StretchingDrop drop(1, 1, run.real("strain_rate"));
  Refinement refinement = judged_quantities();
  auto& figure = run.record.figure("convergence", "Errors under refinement, and the long semi-axis",
                                   "Errors against the number of cells across; grey lines have slopes 1 and 2.");
  auto& errors = figure.panel({.x = "cells n", .y = "error", .log_x = true, .log_y = true});
  auto& axis = figure.panel({.x = "t", .y = "a"});
  const std::vector<double> times = evenly(0, run.real("time"), 101);
  std::vector<double> exact;
  for (const double t : times) exact.push_back(drop.semi_axis(t));
  axis.line("exact", times, exact, Role::exact);
  const long finest = run.integer("n");
  double energy_defect = 0;
  for (const long part : {8, 4, 2, 1}) {
    const long n = 2 * (finest / (2 * part));  // the tip is a node
    Flow flow(
        disc(static_cast<std::size_t>(n)),
        [&](Point r) {
          return Point{run.real("strain_rate") * r.x, -run.real("strain_rate") * r.y};
        },
        {.stepping = mechanics::stepping_named(run.text("scheme"))}, {.gravity = 0}, {}, false);
    const History history = advance_to_end(flow, run.real("time"), run.real("tau_over_h") * 2 / static_cast<double>(n));
    refinement.add(n, errors_of(flow, drop));
    claim_energy(run, flow, history, n);
    energy_defect = std::max(energy_defect, history.energy_defect);
    if (part > 2) axis.line(fmt::format("n = {}", n), history.time, history.tip);
    if (part == 4) draw_mesh_at_end(run, flow, drop);
    run.progress(1 / static_cast<double>(part * part * part));
  }
  run.record.measure("energy_defect", energy_defect);
  run.record.measure("tip_error", refinement.finest(0));
  run.record.measure("semi_axis_exact", drop.semi_axis(run.real("time")));
  refinement.draw(errors);
  refinement.tabulate(run.record);
  refinement.claim_orders(run.record);
  if (run.as_published()) refinement.claim_digits(run.record);
}

}  // namespace

Case free_ellipse_mesh() {
  Case c;
  c.former_names = {"free_ellipse_2d"};
  c.title = "A liquid drop is stretched, on the two-dimensional Lagrangian mesh";
  c.source =
      "P. G. L. Dirichlet, Abh. Kgl. Ges. Wiss. Goettingen 8 (1860) 3; M. S. Longuet-Higgins, J. Fluid Mech. 55 (1972) "
      "529; model: A. M. Frank, doctoral thesis (1994), chapter 2";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      integer("n", {64, 128, 192}, {32, 512}, "cells across on the finest of four meshes"),
      real("tau_over_h", 0.2, "1", {1e-3, 1}, "time step over the width 2/n"),
      real("strain_rate", 1.0, "1", {1e-2, 10}, "s, at the beginning"),
      real("time", 1.0, "1", {1e-2, 10}, "end of the run"),
      choice("scheme", std::string("one_step"), {"one_step", "conservative"}, "time stepping"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
