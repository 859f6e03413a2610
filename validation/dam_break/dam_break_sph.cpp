/*
A water column collapses at the rear wall of an open tank, for any column, tank and setting of weakly compressible SPH.
The cases of the publications, `dam_break_sph_front`, `dam_break_sph_turbulence` and `dam_break_sph_koshizuka`, are this
case with their parameters.

**Set-up.** Column, tank, spacing and particle arrangement are parameters; so are kernel, viscosity, density filter and
walls. Initial densities are hydrostatic. Time is $T = t\sqrt{2g/a}$, $a$ the width of the column; for square columns
$t\sqrt{g/a}$, as published.

**What is compared.** The front position, the largest $x$ of particles with at least four neighbours, with a published
front (`data`): without a shift, and with one shift of the time origin, because laboratories release a column by melting
or pulling a gate. Points count until the far wall is near.

External results are scored by the same columns: `seiche score dam_break_sph` accepts a front computed with any method.
The release time is unknown, but the front speed can be evaluated: a shift and a rate are fitted together, over all
known points, or as far as the submitter's tank reaches (`scored_to`). The four points up to the wall of the default
tank do not determine the rate.

**What to look at.** The shift: 0.1 to 0.3 for Martin and Moyce, who melted a diaphragm. The Mach number: the usual
sound speed, ten times $\sqrt{gH}$ or $\sqrt{2gH}$, does not keep it below 0.1 (`sound_from=height`). A first run with
it therefore gives the maximum velocity, from which the sound speed follows.
*/
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/dam_break/column_front.hpp"
#include "validation/dam_break/sph_sound.hpp"
#include "validation/dam_break/submitted_front.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/shifted_front.hpp"
#include "validation/studies/wcsph/particle_frames.hpp"

namespace seiche::validation::cases::dam_break_sph {

SphDam dam_of(const Values& values) {
  return sph_dam({.width = values.real("column_width"),
                  .height = values.real("column_height"),
                  .tank_length = values.real("tank_length"),
                  .wall_height = values.real("wall_height"),
                  .spacing = values.real("dx"),
                  .lattice = wcsph::lattice_named(values.text("lattice")),
                  .wall_rows = static_cast<int>(values.integer("wall_rows"))},
                 values, values.real("gravity"), values.real("density"));
}

/// The published front that is compared; none: without points, and with the scale of time of a tall column.
ColumnFront data_of(const Values& values) {
  return values.text("data") == "none" ? ColumnFront{} : column_front(values.text("data"), values);
}

double unit_of(const Values& values) {
  return data_of(values).unit(values.real("gravity"), values.real("column_width"));
}

std::vector<double> frames_of(const Values& values) {
  return evenly(0, values.real("last"), static_cast<int>(values.integer("frames")));
}

struct Results {
  SphCollapse collapse;
  std::vector<wcsph::Particles> particles;  ///< at the frames
};

Results compute(const Run& run) {
  Results r;
  r.collapse = collapse_by_rule(
      dam_of(run), run, {.unit = unit_of(run), .last = run.real("last"), .samples = 200, .frames = frames_of(run)},
      [&](const wcsph::Flow& flow) { r.particles.push_back(flow.particles()); },
      [&](double done) { run.progress(done); });
  return r;
}

void claims(const Values& values, const Claims<Results>& claims) {
  claim_sound(claims.of(&Results::collapse), values);
  claims.of(&Results::collapse)
      .at(&SphCollapse::resolution)
      .check("contained", "The number of particles that leave the tank through a wall is zero.",
             "particles outside the tank at the end", &SphCollapse::lost,
             Bound{.limit = 0, .reason = "walls are impermeable"});
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const SphDam dam = dam_of(values);
  const ColumnFront data = data_of(values);
  const SphCollapse& computed = r.collapse;
  const std::string T = data.tall ? "t sqrt(2g/a)" : "t sqrt(g/a)";
  const std::vector<double> frames = frames_of(values);
  const double unit = unit_of(values);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    add_particles(exhibit, frames[k] / unit, r.particles[k], dam.settings);
  }
  measure_run(exhibit, computed);
  if (!computed.roundings.empty()) {
    evidence::Table& table = add_table(exhibit, "roundings", "Lengths adjusted to the spacing", "", {"what"});
    for (const std::string& rounding : computed.roundings) table.rows.push_back({rounding});
  }
  auto& panel = add_panel(exhibit, "front", "Position of the front",
                          fmt::format("Over the column width; {}.", computed.resolution()), {.x = T, .y = "X/a"});
  panel.line("SPH", computed.T, computed.front, Role::computed);
  if (!data.T.empty()) {
    const FrontBeside front{data, (dam.geometry.tank_length - 4 * dam.geometry.spacing) / dam.geometry.width};
    measure_shift(exhibit, front.fit(computed));
    front.draw_later(panel, computed, "SPH, ", Role::peer);
    panel.points(data.label, data.T, data.X, Role::data);
  }
  add_panel(exhibit, "energy", "Energy", "Over the initial energy, from the bottom of the tank.",
            {.x = T, .y = "E/E_0"})
      .line("SPH", computed.T, computed.energy);
}

/// The published front that a submission is judged by, and X/a beyond which it is not: where the far wall of the
/// published column's own tank is near, or nearer where the submitter says so.
FrontBeside judged_by(const Values& values) {
  if (values.text("data") == "none") {
    throw std::invalid_argument("data = none: no reference front to score by; choose a published one");
  }
  const ColumnFront data = column_front(values.text("data"), values);
  const double whole = data.tank > 0 ? data.tank - 0.1 : largest(data.X);
  const double wanted = values.real("scored_to");
  return {data, wanted > 0 ? std::min(wanted, whole) : whole};
}

std::vector<WantedTable> wanted(const Values& values) {
  const auto [data, farthest] = judged_by(values);
  return {wanted_front(data, farthest)};
}

void judge(const Values& values, const Submitted& submitted, const SolverFacts& facts, evidence::Record& record) {
  const auto [data, farthest] = judged_by(values);
  record.reference_data.merge(std::map(values.tables_read()));
  const double cell = facts.cell.value_or(values.real("dx")) / values.real("column_width");
  judge_front(data, farthest, cell, submitted.at("front").front(), facts, record);
}

void dam_break_sph(Case& c) {
  std::vector<std::string> fronts = column_fronts();
  fronts.emplace_back("none");
  c.title = "Collapse of a water column: weakly compressible SPH";
  c.source = "R. A. Dalrymple, B. D. Rogers, Coastal Eng. 53 (2006) 141; " + literature::plunging_sph + ", section 3";
  c.parameters =
      with({real("column_width", 0.05715, "m", {1e-4, 100}, "width a of the column"),
            real("column_height", 0.1143, "m", {1e-4, 100}, "height of the column"),
            real("tank_length", 0.2286, "m", {1e-4, 1000}, "length of the tank"),
            real("wall_height", 0.200025, "m", {1e-4, 1000}, "height of its walls"),
            real("dx", {0.05715 / 20, 0.05715 / 50, 0.05715 / 100}, "m", {1e-6, 10}, "spacing of the particles"),
            choice("lattice", "square", {"square", "body_centred"}, "arrangement of the particles"),
            integer("wall_rows", 2, {2, 3}, "rows of wall particles"),
            real("gravity", 9.81, "m/s^2", {1e-6, 1e6}, "acceleration of gravity"),
            real("density", 1000.0, "kg/m^3", {1e-6, 1e6}, "density at rest"),
            real("last", 3.2, "1", {0.01, 100}, "scaled time at the end"),
            integer("frames", 9, {2, 10000}, "instants whose particles are written for ParaView"),
            choice("data", "martin_moyce_tall_wide", fronts, "published front for comparison"),
            real("scored_to", 0.0, "1", {0, 1000}, "X/a up to which a submitted front is scored; 0: all points")},
           sph_dam_parameters({.alpha = 0.3}));
  c.study = Study(claims, compute, show, "Dalrymple and Rogers (2006)");
  c.submission = {.tables = wanted, .judge = judge};
}

}  // namespace seiche::validation::cases::dam_break_sph
