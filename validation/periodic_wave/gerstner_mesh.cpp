/*
Gerstner's wave is exact at any height, with known particle paths:

$$x = a - R\sin(a - t), \qquad y = b + R\cos(a - t), \qquad R = A e^{b},$$

with wavenumber and gravity 1. Its vorticity is carried by a Lagrangian mesh without error.

**Set-up.** One wavelength of labels, $0 \le a \le 2\pi$, $-2 \le b \le 0$, in $4n$ by $2n$ cells. The nodes of both
sides and of the bottom follow their exact paths; the surface is free. A step is `tau_over_h` rows of $h = 1/n$.

**What is compared.** Positions of the free nodes, cell pressures, which depend on $b$ alone, and the shape of the
surface. The rms is taken over the components of all free nodes. Maxima, shape and pressure are evaluated in the middle
half of the wave, away from the prescribed nodes.

**What to look at.** Shape and pressure converge at second order, positions of surface nodes at first. A surface node
feels the gradient of the dynamic pressure half a cell below it and slips along the surface. For small waves

$$\mathrm{slip} = \tfrac{h}{2} A\,\bigl[\sin(a - t) - \sin a + t \cos a\bigr],$$

including a drift: the orbits of the water are closed, the orbits of surface nodes only as $h \to 0$. The second figure
shows the slip beside this estimate. At its ends slipping nodes meet prescribed ones, and the mesh zigzags within a few
cells, slightly more on finer meshes.
*/
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/gerstner.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/case/refinement.hpp"
#include "validation/instruments/each.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"

namespace seiche::validation::cases::gerstner_mesh {

using exact::GerstnerWave;
using lagrangian_mesh_2d::Flow;
using lagrangian_mesh_2d::Mesh;

constexpr double pi = std::numbers::pi;
constexpr double deepest = -2;

/// The wave with the surface's label at b = 0, as in the article.
class Wave {
 public:
  explicit Wave(double amplitude) : top_(std::log(amplitude)), wave_(2 * pi, 1, top_) {}

  [[nodiscard]] Point position(Point label, double t) const {
    const auto place = wave_.position({label.x, label.y + top_}, t);
    return {place.x, place.y - top_};
  }
  [[nodiscard]] Point velocity(Point label, double t) const {
    const auto velocity = wave_.velocity({label.x, label.y + top_}, t);
    return {velocity.u, velocity.v};
  }
  [[nodiscard]] double pressure(Point label) const { return wave_.pressure({label.x, label.y + top_}); }
  [[nodiscard]] double elevation(double x, double t) const { return wave_.elevation(x, t) - top_; }
  /// Label of the particle that is at a place at the beginning.
  [[nodiscard]] Point label_at_start(Point place) const {
    const auto label = wave_.label(place.x, place.y + top_, 0);
    return {label.a, std::min(label.b - top_, 0.0)};
  }

 private:
  double top_;
  GerstnerWave wave_;
};

struct Labelled {
  Mesh mesh;
  std::vector<Point> labels;
};

Labelled mesh_of(const std::shared_ptr<const Wave>& wave, std::size_t n) {
  Labelled result;
  Mesh& mesh = result.mesh;
  mesh.columns = 4 * n;
  mesh.rows = 2 * n;
  for (std::size_t j = 0; j <= mesh.rows; ++j) {
    for (std::size_t i = 0; i <= mesh.columns; ++i) {
      const Point label{2 * pi * static_cast<double>(i) / static_cast<double>(mesh.columns),
                        deepest * static_cast<double>(mesh.rows - j) / static_cast<double>(mesh.rows)};
      const Point place = wave->position(label, 0);
      result.labels.push_back(label);
      mesh.x.push_back(place.x);
      mesh.y.push_back(place.y);
    }
  }
  const lagrangian_mesh_2d::PrescribedSide led{
      .position = [wave](Point start, double t) { return wave->position(wave->label_at_start(start), t); },
      .velocity = [wave](Point start, double t) { return wave->velocity(wave->label_at_start(start), t); }};
  mesh.sides = {.left = led, .right = led, .bottom = led, .top = lagrangian_mesh_2d::FreeSide{}};
  return result;
}

/// A mesh of the sequence at the end of the time.
struct MeshAtEnd {
  Labelled labelled;
  Flow flow;
  double spacing;
  std::vector<double> earlier_y;  ///< of the nodes before the last step, to which its pressures belong
};

MeshAtEnd computed(const Run& run, const std::shared_ptr<const Wave>& wave, long n) {
  Labelled labelled = mesh_of(wave, static_cast<std::size_t>(n));
  Flow flow(labelled.mesh, [&](Point place) { return wave->velocity(wave->label_at_start(place), 0); },
            {.stepping = mechanics::stepping_named(run.text("scheme"))});
  const double spacing = 1 / static_cast<double>(n);
  std::vector<double> y(flow.y().begin(), flow.y().end());
  std::vector<double> earlier_y;
  march(flow, run.real("time"), run.real("tau_over_h") * spacing, [&] {
    earlier_y.swap(y);
    y.assign(flow.y().begin(), flow.y().end());
  });
  return {std::move(labelled), std::move(flow), spacing, std::move(earlier_y)};
}

bool in_middle_half(std::size_t index, std::size_t count) {
  return 4 * index >= count && 4 * index <= 3 * count;
}

/// In the order of the quantities.
std::vector<double> errors_of(const MeshAtEnd& result, const Wave& wave) {
  const Flow& flow = result.flow;
  const Mesh& mesh = result.labelled.mesh;
  double squares = 0;
  Worst largest, shape;
  for (std::size_t j = 1; j <= mesh.rows; ++j) {
    for (std::size_t i = 1; i < mesh.columns; ++i) {
      const std::size_t k = mesh.node(i, j);
      const Point exact = wave.position(result.labelled.labels[k], flow.time());
      const double dx = flow.x()[k] - exact.x;
      const double dy = flow.y()[k] - exact.y;
      squares += dx * dx + dy * dy;
      if (!in_middle_half(i, mesh.columns)) continue;
      largest.add(dx);
      largest.add(dy);
      if (j == mesh.rows) shape.add(flow.y()[k] - wave.elevation(flow.x()[k], flow.time()));
    }
  }
  const std::vector<double> dynamic = flow.dynamic_pressure();
  Mean pressure;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    if (!in_middle_half(2 * (cell % mesh.columns) + 1, 2 * mesh.columns)) continue;
    const auto corners = mesh.corners(cell);
    double y = 0;
    for (const std::size_t corner : corners) y += 0.25 * result.earlier_y[corner];
    const double lower = result.labelled.labels[corners[0]].y;
    const double upper = result.labelled.labels[corners[2]].y;
    pressure.add(dynamic[cell] - y - wave.pressure({0, (lower + upper) / 2}));
  }
  return {shape.value(), pressure.rms(), std::sqrt(squares / static_cast<double>(2 * mesh.rows * (mesh.columns - 1))),
          largest.value()};
}

/// Horizontal distance of surface nodes from where they should be, in rows, by label.
struct Slip {
  std::vector<double> label, slip;
};

Slip slip_of(const MeshAtEnd& result, const Wave& wave) {
  const Mesh& mesh = result.labelled.mesh;
  Slip slips;
  for (std::size_t k = mesh.node(0, mesh.rows); k < mesh.nodes(); ++k) {
    const Point at = result.labelled.labels[k];
    const Point exact = wave.position(at, result.flow.time());
    slips.label.push_back(at.x);
    slips.slip.push_back((result.flow.x()[k] - exact.x) / result.spacing);
  }
  return slips;
}

RefinementStudy study_of(const Values& values) {
  return {
      .quantities =
          {{"shape", "shape of the surface", "The error of the surface shape converges at second order.",
            Order{2, 0.2,
                  "second order, with the remaining effect of the ends, where slipping nodes meet prescribed ones"}},
           {"pressure", "pressure, rms", "The pressure converges at second order in the cell size.",
            Order{2, 0.2, "the same"}},
           {"position", "places, rms", "The rms error of all node positions converges at order 1.5.",
            Order{1.5, 0.1, "first-order errors in a layer of one cell"}},
           {"largest", "places, largest", "The slip of surface nodes converges at first order.",
            Order{1, 0.1, "slip by the pressure gradient half a cell below; the next term is second-order"}}},
      .source = "Gerstner (1804); Lamb, Hydrodynamics (1932), section 251",
      .coarsest = values.integer("n") / 4};
}

struct Results {
  std::shared_ptr<const Wave> wave;
  Refinement refinement = {};
  std::vector<Slip> slips = {};  ///< on each mesh
  std::vector<Flow> flows = {};  ///< at the end, on the mesh that is drawn
};

void claims(const Values& values, const Claims<Results>& claims) {
  study_of(values).claim_orders(claims.of(&Results::refinement));
}

Results compute(const Run& run) {
  Results r{.wave = std::make_shared<const Wave>(run.real("amplitude"))};
  const long finest = run.integer("n");
  for (const long n : {finest / 8, finest / 4, 3 * finest / 8, finest / 2, 3 * finest / 4, finest}) {
    MeshAtEnd result = computed(run, r.wave, n);
    r.refinement.add(n, errors_of(result, *r.wave));
    r.slips.push_back(slip_of(result, *r.wave));
    if (n == finest / 4) r.flows.push_back(std::move(result.flow));
    run.progress(std::pow(static_cast<double>(n) / static_cast<double>(finest), 3));
  }
  return r;
}

void draw_slips(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const double amplitude = values.real("amplitude");
  const double time = values.real("time");
  auto& panel = add_panel(exhibit, "slip", "Slip of surface nodes",
                          "Horizontal error of surface node positions, in row heights.", {.x = "a", .y = "slip/h"});
  for (std::size_t m = 0; m < r.slips.size(); ++m) {
    panel.line(fmt::format("n = {:g}", r.refinement.n()[m]), r.slips[m].label, r.slips[m].slip);
  }
  const std::vector<double> labels = evenly(0, 2 * pi, 201);
  std::vector<double> estimate = each(
      labels, [&](const double a) { return amplitude / 2 * (std::sin(a - time) - std::sin(a) + time * std::cos(a)); });
  panel.line("estimate for small waves", labels, estimate, Role::guide);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const RefinementStudy study = study_of(values);
  study.draw(r.refinement, add_panel(exhibit, "convergence", "Errors under refinement",
                                     "Against the number of rows per unit depth; grey lines have slopes 1 and 2.",
                                     {.x = "n", .y = "error", .log_x = true, .log_y = true}));
  draw_slips(r, values, exhibit);
  const Flow& flow = r.flows.front();
  auto& panel = add_panel(exhibit, "mesh", "The mesh at the end", "Computed, and the exact surface.",
                          {.x = "x", .y = "y", .equal_aspect = true});
  draw_mesh(panel, "mesh", flow);
  const std::vector<double> x = evenly(flow.surface_x().front(), flow.surface_x().back(), 201);
  panel.line("exact surface", x, each(x, [&](double at) { return r.wave->elevation(at, flow.time()); }), Role::exact);
  study.tabulate(r.refinement, exhibit);
}

void gerstner_mesh(Case& c) {
  c.former_names = {"gerstner_2d"};
  c.title = "Gerstner's wave on the two-dimensional Lagrangian mesh";
  c.source = "F. J. Gerstner (1804); model: A. M. Frank, doctoral thesis (1994), chapter 2";
  c.parameters = {
      real("amplitude", 0.3, "1/k", {1e-3, 0.8}, "radius A of the surface's orbits"),
      integer("n", {32, 64, 128}, {32, 256}, "rows in a unit of depth on the finest of four meshes"),
      real("tau_over_h", 0.8, "1/sqrt(g k)", {1e-2, 2}, "time step over the height of a row"),
      real("time", 2.4, "1/sqrt(g k)", {0.1, 50}, "end of the run; a period is 2 pi"),
      choice("scheme", "one_step", {"one_step", "conservative"}, "time stepping"),
  };
  c.study = Study(claims, compute, show);
}

}  // namespace seiche::validation::cases::gerstner_mesh
