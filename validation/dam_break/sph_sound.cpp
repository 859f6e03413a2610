#include "validation/dam_break/sph_sound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "validation/instruments/particles/sph_front.hpp"

namespace seiche::validation {
namespace {

/// Sound speed of the second run over the largest speed of the first.
constexpr double enough = 12.5;

bool by_rule(const Values& values) {
  return values.text("sound_from") == "largest_speed";
}

/// @param largest_speed  of the water in a run with the settings [m/s]
wcsph::Settings with_sound_for(wcsph::Settings settings, double largest_speed) {
  const double before = settings.sound_speed;
  settings.sound_speed = enough * largest_speed;
  if (auto* artificial = std::get_if<wcsph::ArtificialViscosity>(&settings.viscosity)) {
    artificial->alpha *= before / settings.sound_speed;
  }
  return settings;
}

SphCollapse collapse(const SphDam& dam, const Watch& watch, const std::function<void(const wcsph::Flow&)>& on_frame,
                     const Run::Progress& progress) {
  wcsph::Scene scene = wcsph::dam_break(dam.geometry, dam.settings);
  wcsph::Flow flow(std::move(scene.particles), scene.spacing, dam.settings);
  const auto& [unit, last, samples, frames] = watch;
  SphCollapse result{.spacing = scene.spacing,
                     .sound_speed = dam.settings.sound_speed,
                     .particles = flow.particles().size(),
                     .roundings = scene.warnings};
  const double a = dam.geometry.width;
  const double first_energy = flow.totals().energy();
  const double h = flow.smoothing_length();
  std::size_t next = 0;
  for (long n = 0; n <= samples; ++n) {
    const double T = last * static_cast<double>(n) / static_cast<double>(samples);
    for (; next < frames.size() && frames[next] <= T; ++next) {
      march(flow, frames[next] / unit);
      on_frame(flow);
    }
    march(flow, T / unit);
    result.T.push_back(T);
    result.front.push_back((wcsph::front_position(flow.particles(), h) - scene.rear_wall) / a);
    result.energy.push_back(flow.totals().energy() / first_energy);
    if (std::isnan(result.reaches_wall) && result.front.back() * a > scene.far_wall - 2 * h) result.reaches_wall = T;
    progress(static_cast<double>(n) / static_cast<double>(samples));
  }
  result.lost =
      flow.outside(scene.extents.left, scene.extents.right, scene.extents.bottom, std::numeric_limits<double>::max());
  result.steps = flow.steps();
  result.extremes = flow.extremes();
  return result;
}

}  // namespace

SphDam sph_dam(const wcsph::DamBreak& geometry, const Values& values, double gravity, double density) {
  return {geometry, sph_settings(values, gravity, density, std::sqrt(gravity * geometry.height))};
}

Curve SphCollapse::free_front() const {
  const auto count = std::isnan(reaches_wall)
                         ? T.size()
                         : static_cast<std::size_t>(std::lower_bound(T.begin(), T.end(), reaches_wall) - T.begin());
  return {std::span(T).first(count), std::span(front).first(count)};
}

void exchange(Tape& tape, SphCollapse& s) {
  tape(s.spacing, s.sound_speed, s.particles, s.T, s.front, s.energy, s.reaches_wall, s.lost, s.steps, s.extremes,
       s.roundings, s.first);
}

std::vector<Parameter> sph_dam_parameters(SphDefaults defaults) {
  defaults.sound = 10 * std::numbers::sqrt2;
  return with({choice("sound_from", "largest_speed", {"largest_speed", "height"},
                      "largest_speed: 12.5 times the largest speed of a first run with the sound speed of height; "
                      "height: given by the parameter sound")},
              sph_parameters(defaults, "sqrt(g times the height of the column)"));
}

SphCollapse collapse_by_rule(const SphDam& dam, const Values& values, const Watch& watch,
                             const std::function<void(const wcsph::Flow&)>& on_frame, const Run::Progress& progress) {
  if (!by_rule(values)) return collapse(dam, watch, on_frame, progress);
  // The steps of the second run are shorter, as its sound is faster.
  constexpr double share = 0.3;
  const SphCollapse first =
      collapse(dam, {watch.unit, watch.last, watch.samples}, {}, [&](double done) { progress(share * done); });
  SphCollapse second = collapse({dam.geometry, with_sound_for(dam.settings, first.extremes.mach * first.sound_speed)},
                                watch, on_frame, [&](double done) { progress(share + (1 - share) * done); });
  second.first = {first.sound_speed, first.extremes.mach, first.steps};
  return second;
}

void claim_sound(const Claims<SphCollapse>& claims, const Values& values) {
  claims.only_if(by_rule(values), "the sound speed is given, not taken from the largest speed")
      .from("Monaghan (1994)")
      .at(&SphCollapse::resolution)
      .check(
          "mach", "Speeds stay below a tenth of the sound speed.", "largest Mach number",
          [](const SphCollapse& run) { return run.extremes.mach; },
          Bound{.limit = 0.1, .reason = "the rule by which the sound speed is chosen"});
}

void measure_run(evidence::Exhibit& exhibit, const SphCollapse& run) {
  exhibit.measure("particles", static_cast<double>(run.particles));
  exhibit.measure("steps", static_cast<double>(run.steps));
  exhibit.measure("lowest_density", run.extremes.lowest_density);
  exhibit.measure("highest_density", run.extremes.highest_density);
  exhibit.measure("rebuilds", static_cast<double>(run.extremes.rebuilds));
  exhibit.measure("particles_lost", static_cast<double>(run.lost));
  exhibit.measure("sound_speed", run.sound_speed);
  if (run.first.steps == 0) return;
  exhibit.measure("sound_speed_of_first_run", run.first.sound_speed);
  exhibit.measure("largest_mach_number_of_first_run", run.first.mach);
  exhibit.measure("steps_of_first_run", static_cast<double>(run.first.steps));
}

void FrontBeside::draw_later(evidence::Panel& panel, const SphCollapse& run, const std::string& label,
                             Role role) const {
  const double shift = fit(run).shift;
  panel.line(fmt::format("{}{:.2f} later", label, shift), each(run.T, [&](double T) { return T + shift; }), run.front,
             role);
}

}  // namespace seiche::validation
