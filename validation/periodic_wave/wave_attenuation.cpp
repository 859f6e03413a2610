/*
How much wave height does a solver lose per wavelength, and how large is its error in phase? A swell crosses a basin
before it reaches the structure of interest; height lost on the way is missing there.

**Set-up.** Depth, gravity and density are 1. An exact periodic wave of the Euler equations (`seiche exact stokes`), $L
= 2\pi$, travels in a periodic box of one wavelength over a flat frictionless bed; the suite's models run at H/h = 0.05,
0.1 and 0.2. Gauss-principle particles, the dispersive model and SPH follow it for ten periods. The Lagrangian mesh is
not periodic: it follows one wave of a longer chain, for fewer periods. The dispersive model starts from the exact wave
of its own equations with the same height and length.

**What is compared.** At intervals of three quarters of a period, the fundamental of the surface: its amplitude over the
exact amplitude, and its phase. (After whole periods a wave that is stationary or runs the other way would look
correct.) The change per wavelength is the slope of a straight line through the instants, so that a wrong initial value
does not count. It is shown as a function of the cells over the wave height and of the processor time per wavelength.

**For any solver.** `seiche score wave_attenuation --template` prints the points, the surface at the same instants.
Start from the exact surface and velocities (`seiche exact stokes --write` writes them for several solvers) with a crest
at $x = 0$, in a periodic box; `--set height=0.05` sets a lower wave. A solver without periodic boxes runs the wave in a
flume: `--set tank=flume` asks for gauges three quarters of a wavelength apart, over four periods once the waves are
settled, and counts wavelengths travelled instead of periods. Histories of volume, energy and momentum are scored where
submitted. The limits are a loss of 0.5 % of the height per wavelength, and 0.5 % of a wavelength in phase: after ten
wavelengths the 5 % that tsunami benchmarks allow.

**What to look at.** Gauss-principle particles conserve the height on any grid, and lag by their time-step error. The
mesh loses 0.1 % of the height per wavelength with ten rows, and less of lower waves. SPH with twelve particles over the
depth loses a tenth of the height per wavelength by its artificial viscosity, $\nu = \alpha h c/8$: a rate of $2 \nu
k^2$ in the water, and twice as much, $k \sqrt{\nu \omega/2}/\sinh 2kd$, at the bed, to which its particles stick. The
loss falls with the spacing, to a twentieth at 24 particles over the depth: do not use it to propagate waves over ten
wavelengths. The dispersive model conserves the height and lags by the celerity deficit of its equations, 1 % of a
wavelength per wavelength at any resolution; for longer waves the deficit is smaller.

**Limits of this test.** Breaking, walls, shores, wind and friction are not covered.
*/
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/on_threads.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/periodic_wave/attenuation.hpp"
#include "validation/periodic_wave/surface_fit.hpp"
#include "validation/periodic_wave/travelling_models.hpp"

namespace seiche::validation::cases::wave_attenuation {

using exact::SerreCnoidal;
using exact::StokesWave;

/// One computation.
struct Course {
  std::string model;
  double height = 0;  ///< of the wave
  double size = 0;
  double seconds = 0;                      ///< for one wavelength of water and of way
  std::vector<double> way = {};            ///< in wavelengths
  std::vector<Fundamental> stations = {};  ///< the beginning is not among them
  Rates rates = {};
  double energy_change = 0;  ///< at the end

  [[nodiscard]] double decay() const { return rates.decay; }
  [[nodiscard]] double lead() const { return rates.lead; }
};

Course course_of(const std::string& model, const StokesWave& wave, const Followed& followed) {
  Course course{.model = model,
                .height = 2 * wave.amplitude(),
                .size = followed.size,
                .seconds = followed.seconds * period_of(wave) / followed.last().time};
  const Elevation exact = [&](double x) { return wave.elevation(x); };
  for (const Station& station : followed.stations) {
    std::vector<Point> surface = station.surface;
    std::ranges::sort(surface, {}, &Point::x);
    course.way.push_back(station.time / period_of(wave));
    course.stations.push_back(
        surface_fundamental(exact, wave.wavelength(), surface, wave.phase_speed() * station.time));
  }
  course.rates = rates_of(course.way, course.stations);
  course.energy_change = followed.last().energy_change;
  return course;
}

using Results = std::vector<Course>;

/// Resolutions of a model, from coarse to fine.
std::vector<long> ladder(Tier tier, long finest) {
  if (tier == Tier::quick) return {std::lround(0.5 * static_cast<double>(finest)), finest};
  return {std::lround(0.5 * static_cast<double>(finest)), std::lround(0.7 * static_cast<double>(finest)), finest};
}

Results compute(const Run& run) {
  const double length = run.real("length");
  const std::vector<double> instants = ways(run.integer("periods"));
  const std::vector<double> mesh_instants = ways(run.integer("mesh_periods"));
  Results results;
  std::vector<std::function<void()>> work;
  const auto later = [&](const std::string& model, const std::string& finest, const StokesWave& wave, auto follow) {
    for (const long n : ladder(run.tier(), run.integer(finest))) {
      work.emplace_back([=, &results] { results.push_back(course_of(model, wave, follow(n))); });
    }
  };
  const double highest = run.real("height");
  for (const double height : {highest / 4, highest / 2, highest}) {
    const StokesWave wave = wave_of(height, length);
    later("particles", "cells", wave, [=](long n) { return follow_particles(wave, n, instants); });
    later("dispersive", "markers", wave,
          [=](long n) { return follow_dispersive(SerreCnoidal(height, length, 1, 1), period_of(wave), n, instants); });
    later("mesh", "rows", wave, [=](long n) { return follow_mesh(wave, n, mesh_instants); });
  }
  const StokesWave steepest = wave_of(highest, length);
  later("sph", "sph_rows", steepest, [=](long n) { return follow_sph(steepest, n, instants); });
  one_by_one(run, work);
  return results;
}

/// The finest of a model for the highest wave.
const Course& finest(const Results& results, const std::string& model) {
  const Course* found = nullptr;
  for (const Course& one : results) {
    if (one.model != model) continue;
    if (!found || std::pair(-one.height, one.size) < std::pair(-found->height, found->size)) found = &one;
  }
  if (!found) throw std::logic_error("no course of " + model);
  return *found;
}

/// The worst of the finest courses of a model over the waves.
template <class Number>
Measurement worst_over_heights(const Results& results, const std::string& model, Number number) {
  Worst worst;
  for (const Course& one : results) {
    if (one.model != model || one.size > finest(results, model).size) continue;
    worst.add(std::invoke(number, one), one.height);
  }
  return {.value = worst.value(), .where = fmt::format("H = {:g}", worst.where())};
}

/// Of the dispersive model's own wave, over that of the Euler equations, less 1.
double own_lead(double height, double length) {
  return SerreCnoidal(height, length, 1, 1).phase_speed() / wave_of(height, length).phase_speed() - 1;
}

/// What a viscosity takes from the height in a period: 2 nu k^2 per unit of time in the water (Lamb), and in the layer
/// at a floor that water sticks to k sqrt(nu omega/2)/sinh(2 k d) (Dean and Dalrymple 1991). That of the particles is
/// nu = alpha h c/8 in two dimensions (Monaghan 2005), and those of the floor stand still.
double viscous_decay(const StokesWave& wave, double spacing) {
  const double nu = sph_viscosity * sph_smoothing * spacing * sph_sound / 8;
  const double k = wave.wavenumber();
  const double omega = k * wave.phase_speed();
  return (2 * nu * k * k + k * std::sqrt(nu * omega / 2) / std::sinh(2 * k)) * period_of(wave);
}

void claim_height(const Claims<Results>& claims, const std::string& model, const std::string& text) {
  claims.from(attenuation_source)
      .check(
          model + "-height", text, "height lost per wavelength, largest of three waves",
          [model](const Results& r) { return worst_over_heights(r, model, &Course::decay); },
          Bound{.limit = per_wavelength, .reason = per_wavelength_reason});
}

void claim_particles(const Claims<Results>& claims, const Values& values) {
  const long cells = values.integer("cells");
  const StokesWave steepest = wave_of(values.real("height"), values.real("length"));
  const double steps = std::ceil(apart * static_cast<double>(cells) / particles_courant) / apart;
  const double turn = 2 * std::numbers::pi / steps;
  claim_height(claims, "particles",
               "The decay of the wave height with Gauss-principle particles is at most 0.5 % per wavelength.");
  claims.check(
      "particles-phase",
      "The phase lag of Gauss-principle particles agrees with the lag of their steps, (omega tau)^2/12, within 2 % of "
      "the nonlinear excess speed.",
      "phase lead per wavelength, largest deviation from the expected lead of three waves [wavelengths]",
      [turn](const Results& r) {
        return worst_over_heights(r, "particles", [&](const Course& one) { return one.rates.lead + turn * turn / 12; });
      },
      Bound{.limit = 0.02 * excess_speed(steepest),
            .reason = "2 % of the nonlinear excess celerity of the highest wave; expected: -(omega tau)^2/12, the lag "
                      "of the discrete gradient"});
  claims.from("Frank (1994), chapter 6; exact for every space and step")
      .check(
          "particles-energy", "The energy of Gauss-principle particles is conserved to round-off over all periods.",
          "change over the kinetic energy", [](const Results& r) { return finest(r, "particles").energy_change; },
          Roundoff{.operations = steps * values.number("periods"),
                   .scale = 2,
                   .reason = "one rounding per step of the kinetic and of the potential energy"});
}

void claim_sph(const Claims<Results>& claims, const Values& values) {
  const double length = values.real("length");
  const double spacing = length / std::round(length * values.number("sph_rows"));
  const double viscous = viscous_decay(wave_of(values.real("height"), length), spacing);
  const auto decay = [](const Results& r) { return finest(r, "sph").rates.decay; };
  claims.from(attenuation_source)
      .fails({.value = 0.08,
              .width = 0.05,
              .reason = "artificial viscosity, necessary for stability, dissipates more than that in the water and at "
                        "the bed: sph-viscous"})
      .check("sph-height", "The decay of the highest wave in SPH is at most 0.5 % per wavelength.",
             "height lost per wavelength by the highest wave", decay,
             Bound{.limit = per_wavelength, .reason = per_wavelength_reason});
  claims
      .from(
          "Monaghan, Rep. Prog. Phys. 68 (2005) 1703; Lamb, Hydrodynamics, article 348; Dean and Dalrymple, Water Wave "
          "Mechanics (1991), ch. 9")
      .check("sph-viscous",
             "The SPH wave-height decay agrees with linear viscous theory for its artificial viscosity, bulk plus bed "
             "layer.",
             "height lost per wavelength by the highest wave", decay,
             Bound{.limit = 0.3,
                   .reason = "viscosity alpha h c/8 of a continuum, 2 nu k^2 and k sqrt(nu omega/2)/sinh(2 k d); the "
                             "bed layer is at most one spacing thick: a third is allowed for that",
                   .expected = viscous,
                   .relative = true});
}

void claims(const Values& values, const Claims<Results>& all) {
  claim_particles(all.at(fmt::format("{} cells per wavelength", values.integer("cells"))), values);
  const Claims<Results> mesh = all.at(fmt::format("{} rows", values.integer("rows")));
  claim_height(mesh, "mesh", "The decay of the wave height on the Lagrangian mesh is at most 0.5 % per wavelength.");
  mesh.from(attenuation_source)
      .check(
          "mesh-phase", "The phase error of the Lagrangian mesh is below 0.5 % of a wavelength per wavelength.",
          "phase lead per wavelength, largest of three waves [wavelengths]",
          [](const Results& r) { return worst_over_heights(r, "mesh", &Course::lead); },
          Bound{.limit = per_wavelength, .reason = per_wavelength_reason});
  const Claims<Results> dispersive = all.at(fmt::format("{} nodes per wavelength", values.integer("markers")));
  claim_height(dispersive, "dispersive",
               "The decay of the wave height in the dispersive model is at most 0.5 % per wavelength.");
  dispersive.from("Serre (1953); Schwartz (1974)")
      .check(
          "dispersive-phase",
          "The phase lag of the dispersive model agrees with the celerity deficit of its equations within 10 %, at "
          "every height.",
          "relative difference, largest of three waves",
          [length = values.real("length")](const Results& r) {
            return worst_over_heights(
                r, "dispersive", [&](const Course& one) { return one.rates.lead / own_lead(one.height, length) - 1; });
          },
          Bound{.limit = 0.1,
                .reason =
                    "both exact waves are known to round-off; a tenth of their difference is allowed for the spacing"});
  claim_sph(all.at(fmt::format("{} rows", values.integer("sph_rows"))), values);
}

struct Shown {
  std::string id, name;
  Role role;
};
const std::vector<Shown> shown_models{{"particles", "Gauss particles", Role::computed},
                                      {"mesh", "Lagrangian mesh", Role::peer},
                                      {"dispersive", "dispersive shallow water", Role::data},
                                      {"sph", "SPH", Role::guide}};

void show(const Results& results, const Values& /*values*/, evidence::Exhibit& exhibit) {
  auto& figure =
      exhibit.figure("rates", "Change per wavelength",
                     "Magnitudes, against the cells over the wave height; three heights, two or three resolutions.");
  auto& decay = figure.panel({.x = "cells over the height", .y = "decay of the height", .log_x = true, .log_y = true});
  auto& phase = figure.panel({.x = "cells over the height", .y = "phase [wavelengths]", .log_x = true, .log_y = true});
  auto& cost = add_panel(exhibit, "cost", "The larger of both against processor time",
                         "processor time per wavelength of water and wavelength travelled.",
                         {.x = "processor time [s]", .y = "decay or phase", .log_x = true, .log_y = true});
  evidence::Table& table = add_table(exhibit, "rates", "Change per wavelength",
                                     "Decay of the fundamental and its phase lead per wavelength travelled.",
                                     {"model", "height [depth]", "size [depth]", "cells over the height", "decay [1]",
                                      "lead [wavelengths]", "time [s]"});
  for (const Shown& model : shown_models) {
    std::vector<double> cells, decays, phases, seconds, larger;
    for (const Course& one : results) {
      if (one.model != model.id) continue;
      cells.push_back(one.height / one.size);
      decays.push_back(std::abs(one.decay()));
      phases.push_back(std::abs(one.lead()));
      seconds.push_back(one.seconds);
      larger.push_back(std::max(decays.back(), phases.back()));
      table.rows.push_back({model.name, one.height, one.size, cells.back(), one.decay(), one.lead(), one.seconds});
    }
    decay.points(model.name, cells, decays, model.role);
    phase.points(model.name, cells, phases, model.role);
    cost.points(model.name, seconds, larger, model.role);
  }
  auto& course = exhibit.figure("course", "Height of the highest wave with distance",
                                "Fundamental at the finest resolution of each model.");
  auto& height = course.panel({.x = "t/T", .y = "height over the exact wave's"});
  auto& lead = course.panel({.x = "t/T", .y = "lead [wavelengths]"});
  for (const Shown& model : shown_models) {
    const Course& one = finest(results, model.id);
    height.line(model.name, one.way, each(one.stations, &Fundamental::height), model.role);
    lead.line(model.name, one.way, each(one.stations, &Fundamental::lead), model.role);
  }
}

void wave_attenuation(Case& c) {
  c.title = "Attenuation and phase lag of waves over many wavelengths";
  c.source = "L. W. Schwartz, J. Fluid Mech. 62 (1974) 553; " + literature::frank;
  c.parameters = {
      real("height", 0.2, "depth", {0.02, 0.4},
           "from trough to crest: of the highest computed wave, or of the submitted one"),
      real("length", 2 * std::numbers::pi, "depth", {4, 15}, "of the wave"),
      choice("tank", "box", {"box", "flume"}, "domain of a submitted wave: a periodic box, or a flume with gauges"),
      integer("periods", 10, {2, 100}, "length of the run"),
      integer("mesh_periods", {3, 10, 10}, {2, 100}, "length of the run on the mesh, which is not periodic"),
      integer("cells", {20, 42, 56}, {20, 140}, "cells of the Gauss-principle particles per wavelength, finest"),
      integer("rows", {10, 16, 24}, {6, 96}, "of the mesh, finest"),
      integer("markers", {80, 160, 320}, {40, 2560}, "nodes of the dispersive model per wavelength, finest"),
      integer("sph_rows", {10, 24, 36}, {8, 96}, "of SPH particles, finest"),
      tolerance_parameter(),
  };
  c.study = Study(claims, compute, show, "Frank (1994), chapter 6");
  c.submission = {.tables = wanted_waves, .judge = judge_waves};
}

}  // namespace seiche::validation::cases::wave_attenuation
