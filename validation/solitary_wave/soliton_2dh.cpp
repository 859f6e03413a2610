/*
A solitary wave on a coarse grid retains amplitude, energy and speed: with this test Frank (1994, section 4.3)
introduces both his models of waves in three dimensions, two-dimensional horizontal (2DH) dispersive shallow water and
the hexahedral Lagrangian mesh. Depth and gravity are 1.

**Set-up.** The solitary wave of the Green-Naghdi equations, $\eta = a\,\mathrm{sech}^2\sqrt{3a/(4(1+a))}\,(x - ct)$, $c
= \sqrt{1 + a}$, starts on columns of equal volume and runs along $x$, over a distance of more than 100, with time steps
of $0.4\,h$. Cells are $h$ long and $h$ wide; the hexahedral mesh has one to three layers.

**What is compared.** Crest elevation and its variation, crest speed, and energy, once the wave has become a wave of the
grid: after the first fifth of the run in the 2DH model, after half of it on the hexahedral mesh, whose own wave differs
more from the initial one. The reference at the measured crest elevation is the speed of the Green-Naghdi equations for
the 2DH model, the speed of the exact solitary wave for the hexahedral mesh.

**What to look at.** The 2DH model retains the height to 0.5 % even on cells of one depth, when the wave is six cells
long. The hexahedral mesh with one layer has a solitary wave of its own, a tenth lower and slower, which it retains as
well after shedding the excess; this takes a distance of 100, and its run lasts twice as long. With three layers the
wave is near the exact one. Where the wave started, surface nodes continue to slide slowly over those below, because the
exact velocities are not quite a potential flow of the mesh: the mesh would tangle there long after the wave has left,
and the runs with two and three layers end at $t = 100$.
*/
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/model_waves.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/plan/plan_soliton.hpp"

namespace seiche::validation::cases::soliton_2dh {

const std::string frank = "Frank (1994), section 4.3";

constexpr double intact = 100;    // sqrt(H/g), as long as meshes of all layers run without a tangle
constexpr double shedding = 100;  // sqrt(H/g)

/// A wave on one of the lattices.
struct Travel {
  std::string id, name;
  PlanSolitonRun run;
  std::size_t layers = 0;  ///< of the hexahedral mesh; 0: the 2DH model
  SolitonTravel found = {};
  double speed = 0;  ///< that a wave as high as the crest should have

  [[nodiscard]] double band() const { return (found.highest() - found.lowest()) / found.mean_height(); }
  [[nodiscard]] double speed_error() const { return found.speed() / speed - 1; }
};

/// Where the nodes of a row are about the crest.
struct Row {
  double time;
  std::vector<double> x, z;
};

struct Results {
  std::vector<Travel> travels;
  std::vector<Row> rows;  ///< on the coarsest cells, at the beginning and at the end
};

/// All travels, not yet travelled.
std::vector<Travel> travels_of(const Values& values) {
  PlanSolitonRun run{.amplitude = values.real("amplitude"),
                     .time = values.real("time"),
                     .settled = 0.2 * values.real("time"),
                     .rows = values.count("rows"),
                     .scheme = {.stepping = mechanics::stepping_named(values.text("scheme"))}};
  std::vector<double> spacings{1, 0.7, 0.5};
  if (values.real("finest") < 0.495) spacings.push_back(values.real("finest"));
  std::vector<Travel> all;
  const PlanSolitonRun mesh = run;
  for (const double h : spacings) {
    run.spacing = h;
    run.tau = 0.4 * h;
    all.push_back({.id = fmt::format("2dh-h{:.0f}", 100 * h), .name = fmt::format("2DH, h = {:g}", h), .run = run});
  }
  for (std::size_t layers = 1; layers <= 3; ++layers) {
    run = mesh;
    run.time = (layers == 1 ? 2 : 1) * (mesh.time < intact ? mesh.time : intact);
    run.settled = 0.5 * run.time;  // its own wave is farther from the one it starts with
    all.push_back({.id = fmt::format("mesh-{}-layers", layers),
                   .name = fmt::format("hexahedra, {} {}", layers, layers > 1 ? "layers" : "layer"),
                   .run = run,
                   .layers = layers});
  }
  return all;
}

/// Of the energy. omega = sqrt(3a) = 2 kappa c is the rate of the wave's tails; a wave that kept its shape would keep
/// the difference of the energy from what the scheme conserves.
Bound energy_bound(const Travel& travel) {
  const double a = travel.run.amplitude;
  const double h = travel.run.spacing;
  const double missed = 3 * a * travel.run.tau * travel.run.tau / 8;
  const double columns = 3 * a / (1 + a) * h * h / 12;
  const std::string reason =
      "(omega tau)^2/8, the difference of energy from the conserved quantity of the scheme, times the relative change "
      "of the wave as it becomes a wave of the grid: (2 kappa h)^2/12, the error of differences";
  if (travel.layers == 0) return {missed * columns, reason};
  const auto layers = static_cast<double>(travel.layers);
  return {
      missed * (columns + 0.5 / (layers * layers)),
      reason + ", and half over the square of the number of layers, the increase of vertical inertia by nodal masses"};
}

void claim_travel(const Claims<Travel>& claims, const Travel& travel) {
  const auto claim = [&](const std::string& what, const std::string& text, const std::string& quantity) {
    return evidence::Claim{travel.id + "-" + what, fmt::format("{} ({}).", text, travel.name), quantity, "1", frank};
  };
  const PlanSolitonRun& run = travel.run;
  const Bound unseen = travel.layers == 0
                           ? Bound{0.01 * run.spacing * run.spacing,
                                   "1 %, invisible in a plot of the wave, on cells one depth long; second order in h"}
                           : Bound{0.01, "1 %, invisible in a plot of the wave"};
  const evidence::Claim height =
      claim("height", "The wave height is constant within 1 %", "variation of the height over its mean");
  claims
      .only_if(
          travel.layers != 1 || run.settled >= shedding,
          fmt::format("the wave of one layer, a tenth lower than the initial one, sheds the excess for {:g} sqrt(H/g)",
                      shedding))
      .check(height, &Travel::band, unseen);
  claims.check(
      claim("energy", "The energy is conserved within the swing of the one-step scheme",
            "largest relative energy error"),
      [](const Travel& t) { return t.found.energy_defect; }, energy_bound(travel));
  claims.check(claim("speed", "The wave speed agrees with the exact wave within 1 %", "relative error of the speed"),
               &Travel::speed_error,
               travel.layers == 0
                   ? Bound{1e-3 * run.spacing * run.spacing,
                           "second order in h and tau, with a factor that longer waves make smaller"}
                   : Bound{0.01, "Frank gives no number: 1 % of the speed of the exact wave of this height"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  const std::vector<Travel> travels = travels_of(values);
  for (std::size_t k = 0; k < travels.size(); ++k) {
    claim_travel(claims.at(fmt::format("h = {:g}, tau = {:g}", travels[k].run.spacing, travels[k].run.tau))
                     .of(&Results::travels)
                     .entry(k),
                 travels[k]);
  }
}

Row row_of(const dispersive_shallow_water_2d::Flow& flow, double crest) {
  Row row{.time = flow.time()};
  for (std::size_t i = 0; i <= flow.shape().columns; ++i) {
    if (std::abs(flow.x()[i] - crest) > 12) continue;
    row.x.push_back(flow.x()[i] - crest);
    row.z.push_back(flow.z()[i]);
  }
  return row;
}

Results compute(const Run& run) {
  Results r{.travels = travels_of(run)};
  for (Travel& travel : r.travels) {
    if (travel.layers == 0) {
      auto flow = plan_soliton_flow(travel.run);
      const Row beginning = row_of(flow, 0);
      travel.found = validation::travel(flow, travel.run);
      travel.speed = std::sqrt(1 + travel.found.mean_height());
      if (r.rows.empty()) r.rows = {beginning, row_of(flow, travel.found.place.back())};
    } else {
      auto flow = layered_soliton_flow(travel.run, travel.layers);
      travel.found = validation::travel(flow, travel.run);
      travel.speed = exact::SolitaryWave(travel.found.mean_height()).speed();
    }
    run.progress(static_cast<double>(&travel - r.travels.data() + 1) / static_cast<double>(r.travels.size()));
  }
  return r;
}

void draw_waves(evidence::Exhibit& exhibit, const Results& r) {
  const PlanSolitonRun& coarsest = r.travels.front().run;
  auto& panel = add_panel(exhibit, "waves", "Initial and final wave",
                          fmt::format("2DH model, h = {:g}: nodes of one row about the crest, and the exact wave "
                                      "of the equations moved to the crest.",
                                      coarsest.spacing),
                          {.x = "x - crest", .y = "elevation"}, {"frank-soliton-plan"});
  for (const Row& row : r.rows) {
    panel.points(fmt::format("t = {:g}", row.time), row.x, row.z, row.time == 0 ? Role::peer : Role::computed);
  }
  const exact::SerreSolitary wave(coarsest.amplitude);
  const std::vector<double> x = evenly(-12, 12, 241);
  panel.line("Green-Naghdi", x, each(x, [&](double at) { return wave.elevation(at); }), Role::exact);
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  auto& figure =
      exhibit.figure("crests", "Crest of a solitary wave on coarse grids",
                     "Height of the crest in time: 2DH model, and hexahedral mesh of h = 0.5.", {"frank-soliton-plan"});
  auto& plan = figure.panel({.x = "t sqrt(g/H)", .y = "crest / H", .title = "2DH model"});
  auto& mesh = figure.panel({.x = "t sqrt(g/H)", .y = "crest / H", .title = "Hexahedral mesh"});
  evidence::Table& table = add_table(exhibit, "travels", "Solitary waves on coarse grids",
                                     "Mean height, its variation and speed of the settled wave; speed against the "
                                     "equations at this height; largest relative energy error.",
                                     {"model", "h [depth]", "height [depth]", "lowest [depth]", "highest [depth]",
                                      "speed [sqrt(gH)]", "speed error", "energy defect"});
  for (const Travel& travel : r.travels) {
    const SolitonTravel& found = travel.found;
    (travel.layers == 0 ? plan : mesh).line(travel.name, found.time, found.height);
    table.rows.push_back({travel.name, travel.run.spacing, fmt::format("{:.5f}", found.mean_height()),
                          fmt::format("{:.5f}", found.lowest()), fmt::format("{:.5f}", found.highest()),
                          fmt::format("{:.6f}", found.speed()), travel.speed_error(), found.energy_defect});
  }
  draw_waves(exhibit, r);
}

void soliton_2dh(Case& c) {
  c.title = "A solitary wave on a coarse grid: 2DH model and hexahedral mesh";
  c.source = literature::frank + ", section 4.3";
  c.parameters = {
      real("amplitude", 0.3, "H", {0.02, 0.5}, "of the initial wave"),
      real("time", 100, "sqrt(H/g)", {20, 2000},
           "length of the runs of the 2DH model, and of the mesh up to 100; twice as long with one layer"),
      real("finest", {0.5, 0.25, 0.125}, "H", {0.05, 0.5}, "finest cells of the 2DH model, beside 1, 0.7 and 0.5"),
      integer("rows", 1, {1, 16}, "cells across the wave direction"),
      choice("scheme", "one_step", {"one_step", "one_step_feedback", "conservative"}, "time stepping"),
  };
  c.published = {{.tiles = {"frank-soliton-plan"}, .stated = {"scheme"}}};
  c.study = Study(claims, compute, show);
  c.former_names = {"soliton_plan"};
}

}  // namespace seiche::validation::cases::soliton_2dh
