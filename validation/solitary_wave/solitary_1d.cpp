/*
Serre's solitary wave,

$$\eta = a\,\mathrm{sech}^2 K(x - ct), \quad c^2 = 1 + a, \quad K^2 = \frac{a}{4\alpha(1+a)}, \quad
u = \frac{c\,\eta}{1 + \eta},$$

is exact for the equations that Frank's (1994, chapter 3) discrete shallow water tends to as its cells shrink. Lengths
are in depths, times in $\sqrt{\text{depth}/g}$. The channel is level and periodic, the cells are of equal volume, `h`
wide when at rest. The wave starts at a third of the channel.

**What is compared.** After the time `time`: elevation and velocity at the markers with the exact ones, and the place of
the crest, cells and steps refined together. During the run: crest, energy, cell volumes.

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
#include <string>
#include <vector>

#include <fmt/format.h>

#include "reports/evidence/figure.hpp"
#include "reports/evidence/slope_guide.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/solitary_wave/serre_wave.hpp"

namespace seiche::validation::cases::solitary_1d {
namespace {

using dispersive_shallow_water_1d::Flow;
using dispersive_shallow_water_1d::Scheme;
using dispersive_shallow_water_1d::Stepping;

// What happens to Serre's wave on its way: crest, and the largest defects of what should be kept.

/// One entry per step. Defects are the largest so far, relative to the wave's energy and to a cell at rest.
struct SerreHistory {
  std::vector<double> time;
  std::vector<double> crest;  ///< over the amplitude
  std::vector<double> phase;  ///< crest less the exact crest [m]
  std::vector<double> energy, volume;
};

/// Follows the flow until wave.time by steps of at most tau.
SerreHistory follow(dispersive_shallow_water_1d::Flow& flow, const SerreWave& wave, double spacing, double tau) {
  SerreHistory history;
  const double energy = flow.energy();
  const auto defect = [&](const std::string& name, double scale) {
    return flow.ledger().entry(name).largest_defect / scale;
  };
  flow.advance_to(wave.time, tau, [&] {
    flow.observe();
    const SerreErrors errors = errors_of(flow, wave);
    history.time.push_back(flow.time());
    history.crest.push_back(errors.crest / wave.amplitude);
    history.phase.push_back(errors.phase);
    history.energy.push_back(defect("energy", energy));
    history.volume.push_back(defect("volume_worst", wave.depth * spacing));
  });
  return history;
}

/// A line without the entries that are exactly zero, which a logarithmic axis cannot show.
void draw_defects(evidence::Panel& panel, const std::string& label, const SerreHistory& history,
                  std::vector<double> SerreHistory::*quantity) {
  std::vector<double> time, defect;
  for (std::size_t k = 0; k < history.time.size(); ++k) {
    if ((history.*quantity)[k] <= 0) continue;
    time.push_back(history.time[k]);
    defect.push_back((history.*quantity)[k]);
  }
  panel.line(label, time, defect, evidence::Role::computed);
}

const std::string source = "Serre (1953); Frank (1994), chapter 3";
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
  SerreErrors errors;
};

struct Results {
  SerreWave wave;
  OwnRun own;
  std::vector<SerreHistory> histories;  ///< of all steppings
  std::array<Refinement, 2> together;   ///< of the plain schemes
};

const std::array plain{one_step, conservative};
constexpr std::array<const char*, 2> plain_ids{"one-step", "conservative"};
constexpr std::array steppings{Stepping::one_step, Stepping::one_step_feedback, Stepping::conservative};

Scheme scheme_of(const Values& values) {
  return {.stepping = dispersive_shallow_water_1d::stepping_named(values.text("scheme")),
          .composition = dispersive_shallow_water_1d::composition_named(values.text("composition"))};
}

std::string resolution(const Values& values) {
  return fmt::format("{}, h = {:g}, tau = {:g}", title(scheme_of(values)), values.real("h"), values.real("tau"));
}

void claims(const Values& /*values*/, const Claims<Results>& claims) {
  for (std::size_t k = 0; k < plain.size(); ++k) {
    const auto together = claims.of([k](const Results& r) -> const Refinement& { return r.together.at(k); });
    const std::string id = plain_ids.at(k);
    const std::string name = title(plain.at(k));
    claim_second_order(together, id + "-l2", "The elevation, " + name + ",", &Refinement::l2);
    claim_second_order(together, id + "-max", "The largest error of the elevation, " + name + ",",
                       &Refinement::largest);
    claim_second_order(together, id + "-velocity", "The velocity, " + name + ",", &Refinement::velocity);
  }
}

Results compute(const Run& run) {
  const SerreWave wave = wave_of(run);
  const double h = run.real("h");
  const double tau = run.real("tau");
  const auto errors = [&](double spacing, double step, Scheme scheme) {
    return errors_of(followed(wave, spacing, step, scheme), wave);
  };
  Flow own = start(wave, h, scheme_of(run));
  own.advance_to(wave.time, tau);
  const SerreErrors own_errors = errors_of(own, wave);
  Results r{.wave = wave, .own = {std::move(own), own_errors}};
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
  return r;
}

void draw_together(evidence::Exhibit& exhibit, const Results& r, const Values& values) {
  auto& panel = exhibit
                    .figure("refined_together", "Cells and steps refined together",
                            "Relative L2 error of the elevation at the end.")
                    .panel({.x = "h, tau in proportion", .y = "relative L2 error", .log_x = true, .log_y = true});
  evidence::Table& table = add_table(
      exhibit, "refinement", "Cells and steps refined together", "Errors at the end of the run.",
      {"scheme", "h [1]", "tau [1]", "L2, elevation [1]", "max, elevation [1]", "L2, velocity [1]", "phase [1]"});
  for (std::size_t k = 0; k < plain.size(); ++k) {
    const Refinement& e = r.together.at(k);
    for (std::size_t i = 0; i < e.size.size(); ++i) {
      table.rows.push_back({title(plain.at(k)), e.size[i], values.real("tau") * e.size[i] / values.real("h"), e.l2[i],
                            e.largest[i], e.velocity[i], e.phase[i]});
    }
    panel.points(title(plain.at(k)), e.size, e.l2, Role::computed);
  }
  slope_guide(panel, 2, r.together.back().size, 1.5 * r.together.back().l2.back());
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
  const std::vector<double> elevation = each(fine, [&](const double s) { return exact.elevation(s); });
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
  exhibit.measure("solves_per_step", static_cast<double>(own.flow.solves()) / static_cast<double>(own.flow.steps()));
  draw_wave(exhibit, r, values);
  draw_histories(exhibit, r);
  draw_together(exhibit, r, values);
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
      real("tau", 0.1, "sqrt(depth/g)", {1e-3, 0.4}, "step; varied with h"),
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
