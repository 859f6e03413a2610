/*
The exact solitary wave of the Euler equations travels over a flat bottom through particles of variable mass (Frank
1994, section 5.3). Depth, gravity and density are 1.

**Set-up.** A channel between vertical walls, staggered rows of height $1/n_y$. Surface and velocities are the exact
ones, made to change no area. Nodes follow the water and are drawn back at the rate `rate` to where they were, lifted
with the surface above them (`mapped`), or keep their $x$ (`fixed_x`); nodes of the surface slide along it. What the
stabilisation of the pressure takes from the water is booked.

**What is compared.** Speed and height of the crest: the speed with that of the exact wave of the height that was
measured, and the shape about the crest with that of the wave of the beginning. Energy with what was booked, and mass.

**What to look at.** The wave keeps its height to a thousandth on four rows of cells. Nodes slide along the surface, and
neither volume nor energy notices: without the two corrections of the sliding the wave would grow. The crest's height
converges with the second order to the finest mesh; the error of the profile falls to a ten-thousandth of the height,
and from twelve rows on hardly any more.
*/
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "seiche/free_lagrangian/mesh.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/straight_line.hpp"
#include "validation/studies/variable_mass/solitary_run.hpp"

namespace seiche::validation::cases::solitary_variable_mass {
namespace {

using exact::SolitaryWave;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 5.3; exact wave";
constexpr double start = 14;
constexpr double settled = 2;  // when the wave has become that of the mesh
constexpr double reach = 6;    // of the profile, from the crest
constexpr std::array ladder{4L, 6L, 8L, 12L, 16L};

std::vector<long> meshes(const Values& values) {
  return rows_up_to(values.integer("ny"), ladder);
}

struct Travel {
  SolitaryRun run;
  std::vector<double> place, height;  ///< of the crest, at the times of the run
  double speed = 0;
  double speed_error = 0;  ///< relative, with the exact wave of this height
  double crest = 0;        ///< mean height from `settled` on
  double profile = 0;      ///< largest error about the crest at the end
};

struct Results {
  SolitaryWave wave;
  std::vector<Travel> travels;
  [[nodiscard]] const Travel& own() const { return travels.back(); }
};

double wavenumber(const Values& values) {
  return SolitaryWave(values.real("amplitude")).decay_rate();
}

double step(const Values& values, long rows) {
  return values.real("courant") / static_cast<double>(rows);
}

Travel travel(const Run& run, const SolitaryWave& wave, long rows) {
  const double length = run.real("length");
  const free_lagrangian::Mesh rest =
      free_lagrangian::layer_mesh({.begin = 0,
                                   .end = length,
                                   .columns = static_cast<int>(std::lround(length * static_cast<double>(rows))),
                                   .rows = static_cast<int>(rows)});
  variable_mass::Flow flow(rest, solitary_start(wave, start),
                           {.kind = variable_mass::control_named(run.text("control")),
                            .rate = run.real("rate"),
                            .surface_rate = run.real("surface_rate")},
                           {.stabilisation = run.real("stabilisation")});
  Travel t{.run = follow_solitary(flow, rest, rows, run.real("time"), step(run, rows), 0.5), .place = {}, .height = {}};
  std::vector<double> late_time;
  std::vector<double> late_place;
  Mean late_height;
  for (const SurfaceLine& line : t.run.surfaces) {
    const CurveCrest crest = line.highest(3, length - 3);
    t.place.push_back(crest.place);
    t.height.push_back(crest.height);
    if (line.time < settled) continue;
    late_time.push_back(line.time);
    late_place.push_back(crest.place);
    late_height.add(crest.height);
  }
  t.speed = straight_line(late_time, late_place).slope;
  t.crest = late_height.value();
  t.speed_error = t.speed / SolitaryWave(t.crest).speed() - 1;
  Worst error;
  const SurfaceLine& last = t.run.last();
  for (std::size_t k = 0; k < last.x.size(); ++k) {
    const double from_crest = last.x[k] - t.place.back();
    if (std::abs(from_crest) <= reach) error.add((last.y[k] - wave.elevation(from_crest)) / wave.amplitude());
  }
  t.profile = std::abs(error.value());
  return t;
}

void claims(const Values& values, const Claims<Results>& claims) {
  const long rows = values.integer("ny");
  const double k = wavenumber(values);
  const double kh = k / static_cast<double>(rows);
  const double tau = step(values, rows);
  const double speed = SolitaryWave(values.real("amplitude")).speed();
  const bool controlled = values.text("control") == "mapped" || values.text("control") == "fixed_x";
  const auto own = claims.of(&Results::own).at(fmt::format("{} rows, tau = {:.3g}", rows, tau));
  own.check(
      "speed", "The crest travels with the speed of the exact wave of its height.",
      "speed over that of the exact wave, less 1", &Travel::speed_error,
      Bound{.limit = kh * kh / 6,
            .reason = "(k h)^2/6, k the rate of decay of the wave's tails: the error of differences of second order"});
  own.check(
      "height", "The crest height stays constant over the run.", "mean height over that of the beginning, less 1",
      [a = values.real("amplitude")](const Travel& t) { return t.crest / a - 1; },
      Bound{.limit = kh * kh, .reason = "(k h)^2: the exact wave is the mesh's wave but for terms of second order"});
  own.only_if(controlled, "nodes that drift apart leave cells that are larger")
      .check("profile", "The surface about the crest keeps the shape of the exact wave.",
             "largest error of the surface about the crest, over the amplitude", &Travel::profile,
             Bound{.limit = 2 * kh * kh, .reason = "twice (k h)^2: of the height and of the width"});
  own.check(
      "energy", "Energy with what was booked is kept.", "largest change, over the kinetic energy",
      [](const Travel& t) { return t.run.energy_defect; },
      Bound{.limit = std::pow(k * speed * tau, 2) / 8,
            .reason = "(omega tau)^2/8, omega = k c: by that the energy of the one-step scheme oscillates"});
  own.check(
      "dissipation", "The stabilisation hardly touches the wave.", "what it takes, over the kinetic energy",
      [](const Travel& t) { return t.run.dissipated.back(); },
      Bound{.limit = std::max(values.real("stabilisation"), 1e-12) * kh * kh,
            .reason = "smooth pressures are touched to epsilon (k h)^2"});
  const double steps = values.real("time") / tau;
  own.check(
      "mass", "Mass is handed on, never lost.", "largest change of the whole",
      [](const Travel& t) { return t.run.mass_defect; },
      Roundoff{.operations = 8 * steps * values.real("length") * std::pow(rows, 2),
               .scale = std::pow(rows, -2),
               .reason = "in a step some eight exchanges of each node, which rounds its mass, 1/ny^2"});
  claims.only_if(meshes(values).size() >= 4, "an order needs four meshes: ny of 12 or more")
      .at(fmt::format("{} to {} rows", ladder.front(), rows))
      .check(
          "order", "The height of the crest is of second order.", "order of the crest's error",
          [a = values.real("amplitude")](const Results& r) {
            std::vector<double> sizes =
                each(r.travels, [](const Travel& t) { return 1 / static_cast<double>(t.run.rows); });
            std::vector<double> errors = each(r.travels, [&](const Travel& t) { return t.crest / a - 1; });
            return evidence::observed_order(sizes, errors);
          },
          Order{2, 0.5, "cells of regular rows: second order; the coarsest mesh has four rows"});
}

Results compute(const Run& run) {
  Results r{.wave = SolitaryWave(run.real("amplitude")), .travels = {}};
  const std::vector<long> rows = meshes(run);
  for (const long n : rows) {
    r.travels.push_back(travel(run, r.wave, n));
    run.progress(std::pow(static_cast<double>(n) / static_cast<double>(rows.back()), 3));
  }
  return r;
}

void draw_crest(const Results& r, evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure("crest", "Way and height of the crest",
                                "Crest less that of the exact wave, and height over that of the beginning.");
  auto& way = figure.panel({.x = "t [sqrt(depth/g)]", .y = "crest less exact crest [depth]"});
  auto& height = figure.panel({.x = "t [sqrt(depth/g)]", .y = "height/a"});
  for (const Travel& t : r.travels) {
    std::vector<double> phase;
    std::vector<double> relative;
    for (std::size_t k = 0; k < t.place.size(); ++k) {
      phase.push_back(t.place[k] - start - r.wave.speed() * t.run.time[k]);
      relative.push_back(t.height[k] / r.wave.amplitude());
    }
    const std::string label = fmt::format("{} rows", t.run.rows);
    way.line(label, t.run.time, phase);
    height.line(label, t.run.time, relative);
  }
}

void draw_profile(const Results& r, evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure("profile", "The wave at the end of its way", "About the computed crest.");
  auto& panel = figure.panel({.x = "x - crest [depth]", .y = "elevation [depth]", .x_min = -10, .x_max = 10});
  const std::vector<double> x = evenly(-10, 10, 201);
  std::vector<double> exact = each(x, [&](const double at) { return r.wave.elevation(at); });
  panel.line("exact", x, exact, Role::exact);
  const SurfaceLine& last = r.own().run.last();
  std::vector<double> from;
  std::vector<double> height;
  for (std::size_t k = 0; k < last.x.size(); ++k) {
    if (std::abs(last.x[k] - r.own().place.back()) > 10) continue;
    from.push_back(last.x[k] - r.own().place.back());
    height.push_back(last.y[k]);
  }
  panel.points("computed", from, height, Role::computed);
}

void show(const Results& r, const Values&, evidence::Exhibit& exhibit) {
  draw_crest(r, exhibit);
  draw_profile(r, exhibit);
  evidence::Table table{
      .id = "meshes",
      .title = "The wave on finer meshes",
      .caption = "Speed from t = 2 on; energies over the kinetic energy of the beginning.",
      .columns = table_columns({"rows [1]", "speed [sqrt(g depth)]", "speed error [1]", "crest [depth]",
                                "profile error [1]", "energy with booked [1]", "dissipated [1]", "mass [1]"})};
  for (const Travel& t : r.travels) {
    table.rows.push_back({static_cast<double>(t.run.rows), t.speed, t.speed_error, t.crest, t.profile,
                          t.run.energy_defect, t.run.dissipated.back(), t.run.mass_defect});
  }
  exhibit.table(table);
  exhibit.measure("speed", r.own().speed);
  exhibit.measure("exact_speed", SolitaryWave(r.own().crest).speed());
  exhibit.measure("crest", r.own().crest);
  exhibit.measure("profile_error", r.own().profile);
  exhibit.measure("energy_defect", r.own().run.energy_defect);
  exhibit.measure("dissipated", r.own().run.dissipated.back());
  exhibit.measure("mass_defect", r.own().run.mass_defect);
  exhibit.measure("drift", r.own().run.drift);
}

}  // namespace

Case solitary_variable_mass() {
  Case c;
  c.title = "A solitary wave of the Euler equations in particles of variable mass";
  c.source =
      "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), section 5.3; D. Dutykh, D. "
      "Clamond, Wave Motion 51 (2014) 86";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("amplitude", 0.1, "depth", {0.02, 0.5}, "crest above still water"),
      integer("ny", {8, 16, 16}, {4, 32}, "rows of cells over the depth on the finest mesh"),
      real("courant", 0.4, "1", {0.05, 0.6}, "step over the height of a row, in sqrt(depth/g) and depths"),
      real("length", 40.0, "depth", {30, 200}, "of the channel; the crest starts at 14"),
      real("time", 12.0, "sqrt(depth/g)", {4, 150}, "of the run"),
      choice("control", std::string("mapped"), {"none", "centroid", "mapped", "fixed_x"}, "of the nodes"),
      real("rate", 1.0, "sqrt(g/depth)", {0, 10}, "of the control"),
      real("surface_rate", 0.5, "sqrt(g/depth)", {0, 10}, "at which nodes of the surface slide back"),
      real("stabilisation", 0.1, "1", {0, 10}, "epsilon"),
  };
  c.study = Study(claims, compute, show, source);
  return c;
}

}  // namespace seiche::validation::cases::solitary_variable_mass
