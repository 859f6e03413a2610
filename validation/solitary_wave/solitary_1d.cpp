/*
Serre's solitary wave,

$$\eta = a\,\mathrm{sech}^2 K(x - ct), \quad c^2 = 1 + a, \quad K^2 = \frac{a}{4\alpha(1+a)}, \quad
u = \frac{c\,\eta}{1 + \eta},$$

is exact for the equations that Frank's (1994, chapter 3) discrete shallow water tends to as its cells shrink. Lengths
are in depths, times in $\sqrt{\text{depth}/g}$. The channel is level and periodic, the cells are of equal volume, `h`
wide when at rest. The wave starts at a third of the channel.

**What is compared.** After the time `time`: elevation and velocity at the markers with the exact ones, and the place of
the crest. Three refinements: cells and steps together, cells alone, steps alone. In time also against the limit of
small steps on the same cells, which shows the orders of the compositions. During the run: crest, energy, momentum, cell
volumes.

Schemes: **one-step** (Frank's, one solve per step), **one-step with feedback** (volumes do not drift),
**conservative** (implicit, a few solves). Compositions raise them to fourth order in time.

**What to look at.** Coarse cells make the wave slow. Long steps make it fast with the one-step scheme, slow with the
conservative one. So the errors of the former cancel in part, and its error is a third of the latter's at equal cells
and steps. What the latter buys is in the histories: energy and every cell's volume to round-off.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "reports/evidence/slope_guide.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/solitary_wave/serre_history.hpp"
#include "validation/solitary_wave/serre_wave.hpp"

namespace seiche::validation::cases::solitary_1d {
namespace {

using dispersive_shallow_water_1d::Flow;
using dispersive_shallow_water_1d::Scheme;
using dispersive_shallow_water_1d::Stepping;
using dispersive_shallow_water_1d::TimeComposition;

const std::string source = "Serre (1953); Frank (1994), chapter 3";
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Scheme one_step{};
const Scheme conservative{.stepping = Stepping::conservative};

SerreWave wave_of(const Values& values) {
  return {.amplitude = values.real("amplitude"),
          .alpha = values.real("alpha"),
          .end = values.real("length"),
          .crest = values.real("length") / 3,
          .time = values.real("time")};
}

/// Errors of one scheme on a sequence of resolutions.
struct Refinement {
  std::vector<double> size;
  std::vector<double> l2, largest, velocity, phase;

  void add(double resolution, const SerreErrors& errors) {
    size.push_back(resolution);
    l2.push_back(errors.l2);
    largest.push_back(errors.largest);
    velocity.push_back(errors.velocity);
    phase.push_back(errors.phase);
  }
};

std::vector<double> fractions(double first, long count) {
  std::vector<double> values;
  for (long k = 0; k < count; ++k) values.push_back(first / static_cast<double>(1L << k));
  return values;
}

void claim_second_order(const Claims<Refinement>& claims, const std::string& id, const std::string& what,
                        std::vector<double> Refinement::*errors) {
  claims.check(
      "order-" + id, what + " converges at second order.", "observed order",
      [errors](const Refinement& r) { return evidence::observed_order(r.size, r.*errors); },
      Order{2, 0.1, "smooth wave; the coarsest cells still deviate by a few per cent of the order"});
}

/// The run that the parameters describe.
struct OwnRun {
  Flow flow;
  SerreHistory history;
  SerreErrors errors;
};

struct Results {
  SerreWave wave;
  OwnRun own;
  std::vector<SerreHistory> histories;        ///< of all steppings
  std::array<Refinement, 2> together, steps;  ///< of the plain schemes
  Refinement cells;                           ///< alone, at very short steps
  std::vector<double> tau;                    ///< steps, against the limit of small ones
  std::vector<std::vector<double>> in_time;   ///< largest error of a marker, of the schemes in time
  std::vector<double> halved, energy;         ///< ever smaller steps, and the one-step scheme's energy defect

  [[nodiscard]] double energy_ratio(std::size_t k) const { return energy[k] / energy[k + 1]; }
};

const std::array plain{one_step, conservative};
constexpr std::array<const char*, 2> plain_ids{"one-step", "conservative"};
constexpr std::array steppings{Stepping::one_step, Stepping::one_step_feedback, Stepping::conservative};
const std::array schemes_in_time{one_step, conservative, Scheme{.composition = TimeComposition::triple_jump},
                                 Scheme{.composition = TimeComposition::suzuki},
                                 Scheme{.stepping = Stepping::conservative, .composition = TimeComposition::suzuki}};

bool composed(Scheme scheme) {
  return scheme.composition != TimeComposition::none;
}

Scheme scheme_of(const Values& values) {
  return {.stepping = dispersive_shallow_water_1d::stepping_named(values.text("scheme")),
          .composition = dispersive_shallow_water_1d::composition_named(values.text("composition"))};
}

std::string resolution(const Values& values) {
  return fmt::format("{}, h = {:g}, tau = {:g}", title(scheme_of(values)), values.real("h"), values.real("tau"));
}

/// Everything is kept that the scheme should keep, in the run of the parameters.
void claim_kept(const Claims<OwnRun>& claims, const Values& values) {
  const double h = values.real("h");
  const auto claim = [&](const Claims<OwnRun>& applies, const std::string& id, const std::string& text,
                         std::vector<double> SerreHistory::*defect, double scale, const std::string& reason) {
    applies.check(
        id, text, "largest relative defect",
        [defect](const OwnRun& own) -> Measurement {
          return {.value = (own.history.*defect).back(),
                  .told = {.operations = static_cast<double>(own.flow.solves())}};
        },
        // Steps are no shorter than a quarter of a cell takes, and take less than a hundred solves.
        Roundoff{.operations = Amount::told_by_run(100 * values.real("time") / std::min(values.real("tau"), 0.25 * h)),
                 .scale = scale,
                 .reason = reason + ", once per solve"});
  };
  claim(claims, "momentum", "Momentum is kept: the bottom is level.", &SerreHistory::momentum, 1,
        "the rounded momentum");
  const auto kept = claims.only_if(scheme_of(values).stepping == Stepping::conservative,
                                   "only the conservative scheme keeps it to round-off");
  claim(kept, "energy", "Energy of the solitary wave is conserved to round-off.", &SerreHistory::energy, 1,
        "the rounded energy");
  claim(kept, "volume", "The volume of every cell is conserved to round-off.", &SerreHistory::volume,
        values.real("length") / h, "a rounded coordinate, up to the channel's length, over the width of a cell");
}

void claim_orders(const Claims<Results>& claims) {
  for (std::size_t k = 0; k < plain.size(); ++k) {
    const auto together = claims.of([k](const Results& r) -> const Refinement& { return r.together.at(k); });
    const std::string id = plain_ids.at(k);
    const std::string name = title(plain.at(k));
    claim_second_order(together, id + "-l2", "The elevation, " + name + ",", &Refinement::l2);
    claim_second_order(together, id + "-max", "The largest error of the elevation, " + name + ",",
                       &Refinement::largest);
    claim_second_order(together, id + "-velocity", "The velocity, " + name + ",", &Refinement::velocity);
  }
  claim_second_order(claims.of(&Results::cells), "cells", "The elevation with the cells alone refined",
                     &Refinement::l2);
  for (std::size_t k = 0; k < schemes_in_time.size(); ++k) {
    const std::string name = title(schemes_in_time.at(k));
    const bool fourth = composed(schemes_in_time.at(k));
    std::string id = name;
    std::erase(id, ',');
    std::replace(id.begin(), id.end(), ' ', '-');
    claims.from(fourth ? "Yoshida (1990), Suzuki (1990)" : source)
        .check(
            "time-" + id, fmt::format("The error in time of {} is of order {}.", name, fourth ? 4 : 2),
            "observed order of the largest error of a marker",
            [k](const Results& r) { return evidence::observed_order(r.tau, r.in_time.at(k), 1e-12); },
            Order{fourth ? 4.0 : 2.0, fourth ? 0.2 : 0.1,
                  "smooth motion; below 1e-12 the rounding of coordinates up to 60 counts"});
  }
}

void claims(const Values& values, const Claims<Results>& claims) {
  claim_kept(claims.at(resolution(values)).of(&Results::own), values);
  claim_orders(claims);
  for (std::size_t k = 0; k < plain.size(); ++k) {
    claims.at(fmt::format("tau = {:g}", 4 * values.real("tau")))
        .from("discrete dispersion: sin and tan of half the phase advanced per step, Frank (1994), formula 13")
        .check(
            fmt::format("phase-{}", plain_ids.at(k)),
            k == 0 ? "Long steps make the one-step wave lead."
                   : "The crest lags the exact crest with long steps (conservative scheme).",
            "crest ahead of the exact one",
            [k](const Results& r) {
              const double phase = r.steps.at(k).phase.front();
              return std::isnan(phase) ? nan : phase > 0 ? 1.0 : 0.0;
            },
            Qualitative{.detector = "sign of the crest's phase error, cells eight times finer",
                        .reason = "the one-step scheme raises frequencies, the conservative one lowers them",
                        .expected = k == 0});
  }
  const std::vector<double> halved = fractions(values.real("tau") / 2, 4);
  claims.at(fmt::format("tau = {:g} .. {:g}", halved.front(), halved.back()))
      .from("Frank (1994), chapter 1: second order")
      .check(
          "energy-ratio", "The energy error falls by four with each halving of the step (one-step scheme).",
          "ratio farthest from four",
          [](const Results& r) {
            Worst off;
            for (std::size_t k = 0; k + 1 < r.energy.size(); ++k) {
              off.add(r.energy_ratio(k) - 4, static_cast<double>(k));
            }
            return r.energy_ratio(static_cast<std::size_t>(off.where()));
          },
          Bound{.limit = 1,
                .reason = "steps up to h/5; of longer ones the fourth-order part, of opposite sign, takes off more",
                .expected = 4});
}

OwnRun follow_one(const Values& values, const SerreWave& wave) {
  OwnRun own{.flow = start(wave, values.real("h"), scheme_of(values)), .history = {}, .errors = {}};
  own.history = follow(own.flow, wave, values.real("h"), values.real("tau"));
  own.errors = errors_of(own.flow, wave);
  return own;
}

Results compute(const Run& run) {
  const SerreWave wave = wave_of(run);
  const double h = run.real("h");
  const double tau = run.real("tau");
  const auto errors = [&](double spacing, double step, Scheme scheme) {
    return errors_of(followed(wave, spacing, step, scheme), wave);
  };
  Results r{.wave = wave, .own = follow_one(run, wave)};
  run.progress(0.05);
  for (const Stepping stepping : steppings) {
    Flow flow = start(wave, h, {.stepping = stepping});
    r.histories.push_back(follow(flow, wave, h, tau));
  }
  run.progress(0.1);
  for (std::size_t k = 0; k < plain.size(); ++k) {
    for (const double spacing : fractions(2 * h, run.integer("levels"))) {
      r.together.at(k).add(spacing, errors(spacing, tau * spacing / h, plain.at(k)));
    }
  }
  run.progress(0.5);
  for (const double spacing : fractions(2 * h, 4)) r.cells.add(spacing, errors(spacing, tau / 20, one_step));
  for (std::size_t k = 0; k < plain.size(); ++k) {
    for (const double step : fractions(4 * tau, 3)) r.steps.at(k).add(step, errors(h / 8, step, plain.at(k)));
  }
  run.progress(0.7);
  r.tau = fractions(4 * tau, 4);
  const Flow limit = followed(wave, h, r.tau.back() / 5, {.composition = TimeComposition::suzuki});
  for (const Scheme scheme : schemes_in_time) {
    auto& error = r.in_time.emplace_back();
    for (const double step : r.tau) error.push_back(largest_shift(followed(wave, h, step, scheme), limit));
  }
  r.halved = fractions(tau / 2, 4);
  for (const double step : r.halved) {
    Flow flow = start(wave, h, one_step);
    r.energy.push_back(follow(flow, wave, h, step).energy.back());
  }
  return r;
}

void draw_together(evidence::Exhibit& exhibit, const Results& r, const Values& values) {
  auto& panel = exhibit
                    .figure("refined_together", "Cells and steps refined together",
                            "Relative L2 error of the elevation at the end.")
                    .panel({.x = "h, tau in proportion", .y = "relative L2 error", .log_x = true, .log_y = true});
  evidence::Table table{.id = "refinement",
                        .title = "Cells and steps refined together",
                        .caption = "Errors at the end of the run.",
                        .columns = table_columns({"scheme", "h [1]", "tau [1]", "L2, elevation [1]",
                                                  "max, elevation [1]", "L2, velocity [1]", "phase [1]"})};
  for (std::size_t k = 0; k < plain.size(); ++k) {
    const Refinement& e = r.together.at(k);
    for (std::size_t i = 0; i < e.size.size(); ++i) {
      table.rows.push_back({title(plain.at(k)), e.size[i], values.real("tau") * e.size[i] / values.real("h"), e.l2[i],
                            e.largest[i], e.velocity[i], e.phase[i]});
    }
    panel.points(title(plain.at(k)), e.size, e.l2, Role::computed);
  }
  slope_guide(panel, 2, r.together.back().size, 1.5 * r.together.back().l2.back());
  exhibit.table(std::move(table));
}

void draw_alone(evidence::Exhibit& exhibit, const Results& r) {
  auto& panel = exhibit
                    .figure("refined_alone", "Cells alone, steps alone",
                            "Relative L2 error of the elevation; the other of h and tau is small.")
                    .panel({.x = "h or tau", .y = "relative L2 error", .log_x = true, .log_y = true});
  panel.points("cells alone", r.cells.size, r.cells.l2, Role::computed);
  for (std::size_t k = 0; k < plain.size(); ++k) {
    panel.points("steps alone, " + title(plain.at(k)), r.steps.at(k).size, r.steps.at(k).l2, Role::computed);
  }
  slope_guide(panel, 2, r.cells.size, 0.6 * r.cells.l2.back());
}

void draw_orders_in_time(evidence::Exhibit& exhibit, const Results& r) {
  auto& panel = exhibit
                    .figure("orders_in_time", "Orders in time",
                            "Largest error of a marker against the limit of small steps on the same cells.")
                    .panel({.x = "tau", .y = "largest error of a marker", .log_x = true, .log_y = true});
  for (std::size_t k = 0; k < schemes_in_time.size(); ++k) {
    panel.points(title(schemes_in_time.at(k)), r.tau, r.in_time[k], Role::computed);
  }
  slope_guide(panel, 2, r.tau, 0.2 * r.in_time[1].back());
  slope_guide(panel, 4, r.tau, 0.5 * r.in_time.back().back());
}

void draw_histories(evidence::Exhibit& exhibit, const Results& r) {
  auto& figure = exhibit.figure("histories", "What is kept during the run",
                                "Crest over the amplitude, its phase, and the largest defects so far.");
  auto& crest = figure.panel({.x = "t", .y = "crest/a"});
  auto& phase = figure.panel({.x = "t", .y = "crest less exact crest"});
  auto& energy = figure.panel({.x = "t", .y = "relative energy defect", .log_y = true});
  auto& volume = figure.panel({.x = "t", .y = "relative volume defect of a cell", .log_y = true});
  for (std::size_t k = 0; k < steppings.size(); ++k) {
    const std::string name = title(Scheme{.stepping = steppings.at(k)});
    const SerreHistory& h = r.histories[k];
    crest.line(name, h.time, h.crest, Role::computed);
    phase.line(name, h.time, h.phase, Role::computed);
    draw_defects(energy, name, h, &SerreHistory::energy);
    draw_defects(volume, name, h, &SerreHistory::volume);
  }
}

void draw_wave(evidence::Exhibit& exhibit, const Results& r, const Values& values) {
  const SerreWave& wave = r.wave;
  const Flow& flow = r.own.flow;
  auto& figure =
      exhibit.figure("wave", "The wave at the end", "Surface and its error at the markers: " + resolution(values));
  auto& surface = figure.panel({.x = "x - c t", .y = "elevation"});
  auto& error = figure.panel({.x = "x - c t", .y = "error of the elevation"});
  const exact::SerreSolitary exact = wave.exact();
  const double reach = std::min(wave.length() / 2, 12.0);
  const std::vector<double> fine = evenly(-reach, reach, 241);
  std::vector<double> elevation;
  for (const double s : fine) elevation.push_back(exact.elevation(s));
  surface.line("exact", fine, elevation, Role::exact);
  std::vector<double> place, height, difference;
  for (std::size_t i = 0; i < flow.x().size(); ++i) {
    const double s = std::remainder(flow.x()[i] - wave.crest - exact.speed() * flow.time(), wave.length());
    if (std::abs(s) > reach) continue;
    place.push_back(s);
    height.push_back(flow.y()[i]);
    difference.push_back(flow.y()[i] - exact.elevation(s));
  }
  const std::string name = title(scheme_of(values));
  surface.points(name, place, height, Role::computed);
  error.points(name, place, difference, Role::computed);
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const OwnRun& own = r.own;
  exhibit.measure("l2_eta", own.errors.l2);
  exhibit.measure("max_eta", own.errors.largest);
  exhibit.measure("l2_velocity", own.errors.velocity);
  exhibit.measure("phase_error", own.errors.phase);
  exhibit.measure("crest", own.errors.crest);
  exhibit.measure("energy_defect", own.history.energy.back());
  exhibit.measure("momentum_defect", own.history.momentum.back());
  exhibit.measure("volume_defect", own.history.volume.back());
  exhibit.measure("solves_per_step", static_cast<double>(own.flow.solves()) / static_cast<double>(own.flow.steps()));
  for (std::size_t k = 0; k + 1 < r.energy.size(); ++k) {
    exhibit.measure(fmt::format("energy_ratio_{}", k + 1), r.energy_ratio(k));
  }
  draw_wave(exhibit, r, values);
  draw_histories(exhibit, r);
  draw_together(exhibit, r, values);
  draw_alone(exhibit, r);
  draw_orders_in_time(exhibit, r);
}

}  // namespace

Case solitary_1d() {
  Case c;
  c.title = "Serre's solitary wave in the discrete shallow-water model";
  c.source =
      "F. Serre, La Houille Blanche 8 (1953) 374; A. M. Frank, Discrete models of incompressible fluid, doctoral "
      "thesis (1994), chapter 3";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("amplitude", 0.2, "depth", {1e-4, 1}, "crest above still water"),
      real("h", 0.25, "depth", {0.01, 1}, "width of the cells at rest; refined from 2h"),
      real("tau", 0.1, "sqrt(depth/g)", {1e-3, 0.4}, "step; varied with h and alone"),
      choice("scheme", std::string("one_step"), {"one_step", "one_step_feedback", "conservative"},
             "of the run whose measures are kept"),
      choice("composition", std::string("none"), {"none", "triple_jump", "suzuki"}, "of that scheme in time"),
      real("length", 60.0, "depth", {20, 1000}, "period of the channel"),
      real("time", 20.0, "sqrt(depth/g)", {0.1, 1000}, "how long the wave is followed"),
      real("alpha", 1.0 / 3, "1", {0.1, 1}, "factor of the vertical kinetic energy"),
      integer("levels", {5, 6, 7}, {4, 9}, "refinements of cells and steps together"),
  };
  c.study = Study(claims, compute, show, source);
  return c;
}

}  // namespace seiche::validation::cases::solitary_1d
