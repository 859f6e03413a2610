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
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/affine_drop.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/case/refinement.hpp"
#include "validation/drop/round_patch.hpp"
#include "validation/instruments/each.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"

namespace seiche::validation::cases::free_ellipse_mesh {
namespace {

using exact::StretchingDrop;
using lagrangian_mesh_2d::Flow;
using lagrangian_mesh_2d::Mesh;

const std::string source = "Dirichlet (1860); Longuet-Higgins, J. Fluid Mech. 55 (1972) 529";

Mesh disc(std::size_t n) {
  Mesh mesh = lagrangian_mesh_2d::free_patch(n, n, {-1, -1}, {1, 1});
  make_round(mesh.x, mesh.y);
  return mesh;
}

/// Long semi-axis in time, and the largest change of the energy.
struct History {
  std::vector<double> time;
  std::vector<double> tip;
  Worst energy_defect;
  double nodes = 0;
  /// Of the energy: one per step, and those of a sum over the nodes.
  [[nodiscard]] double roundings() const { return static_cast<double>(time.size() - 1) + nodes; }
};

std::size_t tip_node(const Mesh& mesh) {
  return mesh.node(mesh.columns, mesh.rows / 2);
}

History advance_to_end(Flow& flow, double time, double tau) {
  History history{.nodes = static_cast<double>(flow.x().size())};
  const double energy = flow.energy();
  const auto observe = [&] {
    history.time.push_back(flow.time());
    history.tip.push_back(flow.x()[tip_node(flow.model().mesh())]);
    history.energy_defect.add(flow.energy() - energy, flow.time());
  };
  observe();
  march(flow, time, tau, observe);
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
    pressures += flow.model().first_volumes()[cell] * std::pow(pressure[cell] - exact, 2);
  }
  const double mass = flow.model().mass();
  return {std::abs(flow.x()[tip_node(mesh)] - a), std::sqrt(places / mass), std::sqrt(pressures / mass)};
}

/// From an eighth of n to n, even: the tip is a node.
std::vector<long> meshes_up_to(long n) {
  std::vector<long> meshes;
  for (const long part : {8, 4, 2, 1}) meshes.push_back(2 * (n / (2 * part)));
  return meshes;
}

double step_on(const Values& values, long n) {
  return values.real("tau_over_h") * 2 / static_cast<double>(n);
}

RefinementStudy study_of_orders() {
  return {
      .quantities = {{"tip", "tip of the long axis"},
                     {"position", "places, rms", "Places of all nodes are of order 1.5 in the root mean square.",
                      Order{1.5, 0.1, "errors of first order in a layer of one cell"}},
                     {"pressure", "pressure, rms", "The pressure is of second order.",
                      Order{2, 0.15, "second order of smooth solutions; the mesh is not smooth at its four corners"}}},
      .source = source};
}

struct Results {
  StretchingDrop drop;
  Refinement refinement;
  std::vector<History> histories;  ///< on each mesh
  std::vector<Flow> flows;         ///< at the end
};

/// On the mesh where it is largest beside what the number of its roundings explains.
Measurement energy_defect(const Results& r) {
  Worst beside;
  for (std::size_t m = 0; m < r.histories.size(); ++m) {
    beside.add(r.histories[m].energy_defect.value() / std::sqrt(r.histories[m].roundings()), static_cast<double>(m));
  }
  const auto m = static_cast<std::size_t>(beside.where());
  const History& worst = r.histories[m];
  return {.value = worst.energy_defect.value(),
          .resolution = fmt::format("n = {:g}", r.refinement.n()[m]),
          .where = fmt::format("t = {:.3g}", worst.energy_defect.where()),
          .told = {.operations = worst.roundings()}};
}

void claims(const Values& values, const Claims<Results>& claims) {
  const RefinementStudy study = study_of_orders();
  const long finest = meshes_up_to(values.integer("n")).back();
  claims.check("energy", "The kinetic energy is kept on all meshes.", "largest defect", energy_defect,
               Roundoff{.operations = Amount::told_by_run(values.real("time") / step_on(values, finest) + 1 +
                                                          std::pow(static_cast<double>(finest + 1), 2)),
                        .scale = std::numbers::pi / 4 * std::pow(values.real("strain_rate"), 2),
                        .reason = "rounding of the energy of the exact motion, pi s^2/4: in a sum over the nodes, and "
                                  "once per step; each mesh by its own nodes and steps"});
  study.claim_orders(claims.of(&Results::refinement));
}

Results compute(const Run& run) {
  const double rate = run.real("strain_rate");
  Results r{.drop = StretchingDrop(1, 1, rate), .refinement = {}, .histories = {}, .flows = {}};
  const std::vector<long> meshes = meshes_up_to(run.integer("n"));
  for (const long n : meshes) {
    Flow& flow = r.flows.emplace_back(
        disc(static_cast<std::size_t>(n)),
        [&](Point at) {
          return Point{rate * at.x, -rate * at.y};
        },
        lagrangian_mesh_2d::Scheme{.stepping = mechanics::stepping_named(run.text("scheme"))},
        lagrangian_mesh_2d::Settings{.gravity = 0}, lagrangian_mesh_2d::Forcing{}, false);
    r.histories.push_back(advance_to_end(flow, run.real("time"), step_on(run, n)));
    r.refinement.add(n, errors_of(flow, r.drop));
    run.progress(std::pow(static_cast<double>(n) / static_cast<double>(meshes.back()), 3));
  }
  return r;
}

void draw_mesh_at_end(const Flow& flow, const StretchingDrop& drop, evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure("mesh", "The drop at the beginning and at the end", "Its mesh; the exact outline.");
  const Mesh& mesh = flow.model().mesh();
  const auto panel = [&](const std::string& title, std::span<const double> x, std::span<const double> y, double t) {
    auto& one = figure.panel({.x = "x", .y = "y", .title = title, .equal_aspect = true});
    draw_mesh(one, "mesh", mesh, x, y);
    std::vector<double> outline_x = each(evenly(0, 2 * std::numbers::pi, 201),
                                         [&](const double angle) { return drop.semi_axis(t) * std::cos(angle); });
    std::vector<double> outline_y = each(evenly(0, 2 * std::numbers::pi, 201),
                                         [&](const double angle) { return drop.other_axis(t) * std::sin(angle); });
    one.line("exact", outline_x, outline_y, Role::exact);
  };
  panel("t = 0", mesh.x, mesh.y, 0);
  panel(fmt::format("t = {:g}", flow.time()), flow.x(), flow.y(), flow.time());
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const RefinementStudy study = study_of_orders();
  auto& figure = exhibit.figure("convergence", "Errors under refinement, and the long semi-axis",
                                "Errors against the number of cells across; grey lines have slopes 1 and 2.");
  study.draw(r.refinement, figure.panel({.x = "cells n", .y = "error", .log_x = true, .log_y = true}));
  auto& axis = figure.panel({.x = "t", .y = "a"});
  const std::vector<double> times = evenly(0, values.real("time"), 101);
  std::vector<double> exact = each(times, [&](const double t) { return r.drop.semi_axis(t); });
  axis.line("exact", times, exact, Role::exact);
  for (const std::size_t m : {0, 1}) {
    axis.line(fmt::format("n = {:g}", r.refinement.n()[m]), r.histories[m].time, r.histories[m].tip);
  }
  draw_mesh_at_end(r.flows[1], r.drop, exhibit);
  Worst energy_defect;
  for (const History& history : r.histories) energy_defect.add(history.energy_defect);
  exhibit.measure("energy_defect", energy_defect.value());
  exhibit.measure("tip_error", r.refinement.finest(0));
  exhibit.measure("semi_axis_exact", r.drop.semi_axis(values.real("time")));
  study.tabulate(r.refinement, exhibit);
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
  c.study = Study(claims, compute, show, "Frank, Discrete models of incompressible fluid (1994), chapter 1");
  return c;
}

}  // namespace seiche::validation::cases::free_ellipse_mesh
