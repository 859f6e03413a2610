/*
A steep wave turns over and plunges, by weakly compressible SPH, beside the exact potential flow from the same start:
what a plunging breaker by particles is worth, as a number.

**Set-up.** One wavelength $L$ of a periodic layer of depth $d = 0.13 L$ over a level bottom. The surface begins as a
cosine of height $H = 0.13 L$, far too high to travel on. The velocities of the beginning are those of linear theory,
which are an exact potential flow under any surface, and so are the pressures, from a harmonic series that makes them
zero at the surface: nothing is left to settle. Lengths are in metres, $L = 1$ m; the scheme knows no other length than
the spacing.

**What is compared.** The surface, where the share of water is one half, with that of the boundary-integral computation
(`overturning_wave`) at several times up to a developed jet: root mean square and largest distance of the two curves, on
four lattices. When the front first hangs over by a hundredth of the wavelength. Energy, mean level, touch-down.

A table compares schemes of the same kind: without viscosity, with the stress of unresolved eddies, with other walls,
with fewer neighbours, as in the publications of the scheme ($h = 1.3\,dx$, cubic spline).

**What to look at.** Until the front is steep the surface is right to a few tenths of a spacing, with a developed jet to
about half a spacing; the distance falls in proportion to the spacing, and the tip of the jet is what arrives last. What
particles lose is mostly potential energy, for the layer settles on its bottom by a part of a spacing; the kinetic
energy is within a few per cent of that of potential flow.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/dispersion.hpp"
#include "validation/case/case.hpp"
#include "reports/evidence/slope_guide.hpp"
#include "validation/breaking/sph_overturning.hpp"
#include "validation/studies/wcsph/particle_frames.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"
#include "validation/studies/wcsph/speed_field.hpp"
#include "validation/studies/wcsph/spacing_ladder.hpp"
#include "validation/instruments/sph_steep_wave.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Bound;
using evidence::Role;

const std::string source = "Longuet-Higgins and Cokelet (1976); Baker, Meiron and Orszag (1982)";
constexpr double gravity = 9.81;
constexpr double wavelength = 1;
constexpr double overhang = 0.01 * wavelength;

SteepWave wave_of(const Run& run) {
  return {
      .amplitude = 0.5 * run.real("height"), .wavelength = wavelength, .depth = run.real("depth"), .gravity = gravity};
}

wcsph::Settings settings_of(const Run& run, const SteepWave& wave) {
  return sph_settings(run.values(), gravity, 1000, std::sqrt(gravity * wave.depth));
}

double period_of(const SteepWave& wave) {
  return 2 * std::numbers::pi /
         exact::AiryDispersion(wave.gravity, wave.depth).frequency(2 * std::numbers::pi / wave.wavelength);
}

/// Instants of comparison with their names: halfway, steep, vertical, and with a developed jet.
struct Instants {
  std::vector<double> times;
  std::vector<std::string> names;
};

Instants instants_of(const exact::OverturningWave& wave) {
  const double vertical = wave.vertical_tangent_time().value_or(wave.end_time());
  const double jet = std::min(wave.well_resolved_until(), wave.end_time());
  return {{0.5 * vertical, 0.8 * vertical, vertical, 0.5 * (vertical + jet), jet},
          {"half", "steep", "vertical", "turning", "jet"}};
}

/// Another scheme of the same kind, on the lattice of half as many columns.
struct Variant {
  std::string name;
  void (*change)(wcsph::Settings&);
};
const std::array variants{
    Variant{"as set", [](wcsph::Settings&) {}},
    Variant{"no viscosity", [](wcsph::Settings& s) { s.viscosity = wcsph::Inviscid{}; }},
    Variant{"unresolved eddies", [](wcsph::Settings& s) { s.viscosity = wcsph::LaminarSps{}; }},
    Variant{"walls extrapolated", [](wcsph::Settings& s) { s.walls = wcsph::WallPressure::extrapolated; }},
    Variant{"cubic spline, h = 1.3 dx",
            [](wcsph::Settings& s) {
              s.kernel = wcsph::KernelName::cubic_spline;
              s.smoothing = 1.3;
            }},
};

constexpr std::size_t lattices = 4;
constexpr std::size_t halved = 1;  ///< the lattice of half as many columns: each is finer by sqrt(2)

struct Study {
  exact::OverturningWave exact;
  Instants instants;
  std::vector<SphOverturned> runs;
  std::vector<SphOverturned> others;
  std::vector<std::vector<PolylineDistance>> distances;  ///< [instant][run]
};

Study compute(Running& run) {
  const SteepWave wave = wave_of(run);
  Study study{.exact = exact::OverturningWave({.amplitude = wave.amplitude,
                                               .wavelength = wave.wavelength,
                                               .depth = wave.depth,
                                               .gravity = wave.gravity,
                                               .markers = 256,
                                               .last_time = 0.6 * period_of(wave)})};
  study.instants = instants_of(study.exact);
  study.runs.resize(lattices);
  study.others.resize(variants.size());
  // Beyond the last comparison until the jet has landed.
  std::vector<double> until_landed = study.instants.times;
  until_landed.push_back(
      std::max(until_landed.back(), 1.06 * study.exact.touch_down_time().value_or(study.exact.end_time())));
  const wcsph::Settings settings = settings_of(run, wave);
  const auto columns = [&](std::size_t lattice) {
    return std::lround(static_cast<double>(run.integer("columns")) *
                       std::pow(0.5, 0.5 * static_cast<double>(lattices - 1 - lattice)));
  };
  climb(run, lattices + variants.size(), [&](std::size_t k) {
    if (k >= variants.size()) {
      const std::size_t lattice = k - variants.size();
      study.runs[lattice] =
          overturn({.wave = wave, .columns = columns(lattice), .settings = settings}, until_landed, overhang, 150);
    } else {
      wcsph::Settings changed = settings;
      variants[k].change(changed);
      study.others[k] = overturn({.wave = wave, .columns = columns(halved), .settings = changed}, study.instants.times,
                                 overhang, 100);
    }
  });
  for (std::size_t i = 0; i < study.instants.times.size(); ++i) {
    const Polylines truth = exact_surface(study.exact, study.instants.times[i]);
    auto& row = study.distances.emplace_back();
    for (const SphOverturned& one : study.runs) {
      row.push_back(polyline_distance(one.surfaces[i], truth, wave.wavelength));
    }
  }
  return study;
}

void tabulate_variants(evidence::Record& record, const Study& study) {
  evidence::Table table{.id = "variants",
                        .title = "Schemes of the same kind",
                        .caption = fmt::format("With dx = L/{:.0f}: rms distance of the surfaces in spacings, and the "
                                               "kinetic energy with a developed jet over that of potential flow.",
                                               wavelength / study.runs[halved].spacing),
                        .columns = {{"", ""}}};
  for (const std::string& name : study.instants.names) table.columns.emplace_back(name, "dx");
  table.columns.emplace_back("kinetic energy", "");
  for (std::size_t k = 0; k < variants.size(); ++k) {
    const SphOverturned& one = study.others[k];
    auto& row = table.rows.emplace_back();
    row.emplace_back(variants[k].name);
    for (std::size_t i = 0; i < study.instants.times.size(); ++i) {
      const Polylines truth = exact_surface(study.exact, study.instants.times[i]);
      row.emplace_back(polyline_distance(one.surfaces[i], truth, wavelength).rms / one.spacing);
    }
    row.emplace_back(one.kinetic.back() / study.exact.integrals(one.times.back()).kinetic_energy);
  }
  record.table(std::move(table));
}

std::vector<double> of_all(const std::vector<PolylineDistance>& row, double PolylineDistance::*member) {
  std::vector<double> values;
  for (const PolylineDistance& distance : row) values.push_back(distance.*member);
  return values;
}

/// @param judge_orders  or only measure them, where the coarsest lattices do not resolve the jet at all
void claim_distances(evidence::Record& record, const Study& study, const std::vector<double>& sizes,
                     bool judge_orders) {
  const SphOverturned& finest = study.runs.back();
  const std::string resolution = sph_resolution(finest.spacing, finest.particles);
  // Before, what water of a finite sound speed differs by, about d g/c_0^2 of its depth, is no smaller than what the
  // lattice adds.
  const double vertical = study.exact.vertical_tangent_time().value_or(0);
  for (std::size_t i = 0; i < study.instants.times.size(); ++i) {
    const std::string& name = study.instants.names[i];
    const std::vector<double> rms = of_all(study.distances[i], &PolylineDistance::rms);
    record.measure("rms_distance_" + name, rms.back());
    record.measure("largest_distance_" + name, study.distances[i].back().largest);
    const evidence::ObservedOrder order = evidence::observed_order(sizes, rms);
    record.measure("order_" + name, order.order);
    record.check({.id = "distance-" + name,
                  .text = fmt::format("At t = {:.3f} s the surface is that of potential flow to one spacing.",
                                      study.instants.times[i]),
                  .quantity = "rms distance of the surfaces",
                  .unit = "m",
                  .source = source},
                 {.value = rms.back(), .resolution = resolution},
                 Bound{.limit = finest.spacing,
                       .reason = "one spacing of the particles: no surface of theirs is known better than to a part "
                                 "of it"});
    if (!judge_orders || study.instants.times[i] < vertical) continue;
    record.check({.id = "order-" + name,
                  .text = fmt::format("At t = {:.3f} s the distance falls with the spacing.", study.instants.times[i]),
                  .quantity = "observed order of the rms distance",
                  .source = source},
                 order,
                 evidence::Order{.theory = 1,
                                 .tolerance = 0.75,
                                 .reason = "first order, for the surface is known to a part of the spacing and the "
                                           "viscosity is in proportion to it; not far from half an order, nor from one "
                                           "and a half"});
  }
}

void claim_events(evidence::Record& record, const Study& study, double period) {
  const SphOverturned& finest = study.runs.back();
  const std::size_t last = study.instants.times.size() - 1;
  const std::string resolution = sph_resolution(finest.spacing, finest.particles);
  const double known = exact_overhang_time(study.exact, overhang, study.instants.times.back());
  record.measure("exact_overhang_time", known);
  record.measure("overhang_time", finest.hangs_over);
  record.measure("exact_vertical_time", study.exact.vertical_tangent_time().value_or(0));
  record.measure("exact_touch_down_time", study.exact.touch_down_time().value_or(0));
  record.measure("touch_down_time", finest.touches);
  record.check({.id = "overturns", .text = "The wave turns over.", .quantity = "it does", .source = source},
               {.value = std::isnan(finest.hangs_over) ? 0.0 : 1.0, .resolution = resolution},
               evidence::Qualitative{.detector = "the surface hangs over by a hundredth of the wavelength",
                                     .reason = "potential flow from the same start does"});
  record.check({.id = "overhang-time",
                .text = "The front hangs over when that of potential flow does.",
                .quantity = "when it hangs over by a hundredth of the wavelength",
                .unit = "s",
                .source = source},
               {.value = finest.hangs_over, .resolution = resolution},
               Bound{.limit = 0.05 * period,
                     .reason = "5 % of the period: the tip of the jet, about two spacings thick when it begins, is "
                               "what particles form last",
                     .expected = known});
  const double kinetic = finest.kinetic[last] / study.exact.integrals(study.instants.times[last]).kinetic_energy;
  record.check({.id = "kinetic-energy",
                .text = "With a developed jet the water has the kinetic energy of potential flow.",
                .quantity = "over that of potential flow",
                .source = source},
               {.value = kinetic, .resolution = resolution},
               Bound{.limit = 0.05,
                     .reason = "5 %: the surface is off by half a spacing or so, the depth of the trough has ten",
                     .expected = 1});
  record.measure("largest_mach_number", finest.extremes.mach);
  record.measure("steps", static_cast<double>(finest.steps));
  for (std::size_t i = 0; i < study.instants.names.size(); ++i) {
    record.measure("energy_" + study.instants.names[i], finest.energy[i]);
    record.measure("level_" + study.instants.names[i], finest.level[i]);
    record.measure("speed_" + study.instants.names[i], finest.speed[i]);
  }
}

void draw(evidence::Record& record, const Study& study, const std::vector<double>& sizes) {
  auto& profiles = record.figure("profiles", "From a cosine to a plunging jet",
                                 "Surfaces of the particles on two lattices and of potential flow, equal scales.");
  const SphOverturned& finest = study.runs.back();
  const SphOverturned& coarser = study.runs[halved];
  for (std::size_t i = 1; i < study.instants.times.size(); ++i) {
    const Polylines truth = exact_surface(study.exact, study.instants.times[i]);
    const Polyline& surface = finest.surfaces[i].front();
    auto& panel = profiles.panel({.x = "x [m]",
                                  .y = "z [m]",
                                  .title = fmt::format("t = {:.3f} s", study.instants.times[i]),
                                  .equal_aspect = true,
                                  .x_min = surface.x.front(),
                                  .x_max = surface.x.back()});
    const auto shifted = [&](const Polyline& curve, double by) {
      std::vector<double> x = curve.x;
      for (double& place : x) place += by;
      return x;
    };
    for (const double image : {-wavelength, 0.0, wavelength}) {
      panel.line("potential flow", shifted(truth.front(), image), truth.front().y, Role::exact);
    }
    panel.line(fmt::format("SPH, L/{:.0f}", wavelength / coarser.spacing), coarser.surfaces[i].front().x,
               coarser.surfaces[i].front().y, Role::peer);
    panel.line(fmt::format("SPH, L/{:.0f}", wavelength / finest.spacing), surface.x, surface.y, Role::computed);
  }
  auto& speeds = record.figure("speed", "Speed of the water",
                               fmt::format("With a developed jet, and after it has landed; {}.",
                                           sph_resolution(finest.spacing, finest.particles)));
  for (std::size_t i = study.instants.times.size() - 1; i < finest.times.size(); ++i) {
    draw_speed(speeds, finest.snapshots[i], finest.spacing,
               {.title = fmt::format("t = {:.3f} s", finest.times[i]), .frame = {0, wavelength, 0, 0.3 * wavelength}});
  }
  auto& study_figure = record.figure("convergence", "Distance of the surfaces",
                                     "Root mean square (left) and largest (right), over the wavelength.");
  for (const auto& [member, name] : {std::pair{&PolylineDistance::rms, "rms distance/L"},
                                     std::pair{&PolylineDistance::largest, "largest distance/L"}}) {
    auto& panel = study_figure.panel({.x = "dx/L", .y = name, .log_x = true, .log_y = true});
    for (std::size_t i = 0; i < study.instants.times.size(); ++i) {
      panel.points(study.instants.names[i], sizes, of_all(study.distances[i], member),
                   i + 1 == study.instants.times.size() ? Role::computed : Role::peer);
    }
    slope_guide(panel, 1, sizes, 0.6 * of_all(study.distances[0], member).back());
  }
}

void run(Running& run) {
  const SteepWave wave = wave_of(run);
  const Study study = compute(run);
  std::vector<double> sizes;
  for (const SphOverturned& one : study.runs) sizes.push_back(one.spacing);
  run.record.measure("pressure_defect_of_start",
                     SteepWaveStart(wave.amplitude, wave.wavelength, wave.depth, gravity).surface_defect());
  claim_distances(run.record, study, sizes, run.tier() != Tier::quick);
  claim_events(run.record, study, period_of(wave));
  tabulate_variants(run.record, study);
  draw(run.record, study, sizes);
  const SphOverturned& finest = study.runs.back();
  for (std::size_t i = 0; i < finest.times.size(); ++i) {
    add_particles(run.record, finest.times[i], finest.snapshots[i], settings_of(run, wave));
  }
}

}  // namespace

Case overturning_sph() {
  Case c;
  c.title = "A wave overturns and plunges: weakly compressible SPH beside potential flow";
  c.source =
      "M. S. Longuet-Higgins, E. D. Cokelet, Proc. R. Soc. Lond. A 350 (1976) 1; G. R. Baker, D. I. Meiron, S. A. "
      "Orszag, J. Fluid Mech. 123 (1982) 477";
  c.tiers = {Tier::quick, Tier::full, Tier::paper};
  c.parameters =
      with({real("height", 0.13, "L", {0.02, 0.14}, "height H of the cosine it begins with"),
            real("depth", 0.13, "L", {0.05, 1}, "depth of the water at rest"),
            integer("columns", {140, 400, 800}, {40, 4000}, "particle spacings in a wavelength, finest")},
           sph_parameters({.kernel = std::string("wendland_c2"), .smoothing = 2.0, .alpha = 0.01}, "sqrt(g d)"));
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
