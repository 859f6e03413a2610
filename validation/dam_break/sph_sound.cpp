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

Curve SphCollapse::free_front() const {
  const auto count = std::isnan(reaches_wall)
                         ? T.size()
                         : static_cast<std::size_t>(std::lower_bound(T.begin(), T.end(), reaches_wall) - T.begin());
  return {std::span(T).first(count), std::span(front).first(count)};
}

SphCollapse collapse(const SphDam& dam, const Watch& watch, const std::vector<double>& frames,
                     const std::function<void(std::size_t, const wcsph::Flow&)>& on_frame,
                     const std::function<void(double)>& progress) {
  wcsph::Scene scene = wcsph::dam_break(dam.geometry, dam.settings);
  wcsph::Flow flow(std::move(scene.particles), scene.spacing, dam.settings);
  const auto [unit, last, samples] = watch;
  SphCollapse result{.spacing = scene.spacing,
                     .sound_speed = dam.settings.sound_speed,
                     .particles = flow.particles().size(),
                     .reaches_wall = nan};
  const double a = dam.geometry.width;
  const double first_energy = flow.totals().energy();
  const double h = flow.smoothing_length();
  std::size_t next = 0;
  for (long n = 0; n <= samples; ++n) {
    const double T = last * static_cast<double>(n) / static_cast<double>(samples);
    for (; next < frames.size() && frames[next] <= T; ++next) {
      march(flow, frames[next] / unit);
      if (on_frame) on_frame(next, flow);
    }
    march(flow, T / unit);
    result.T.push_back(T);
    result.front.push_back((wcsph::front_position(flow.particles(), h) - scene.rear_wall) / a);
    result.height.push_back((wcsph::column_height(flow.particles(), h, scene.rear_wall + 3 * scene.spacing,
                                                  scene.rear_wall + 6 * scene.spacing) -
                             scene.bottom) /
                            a);
    result.energy.push_back(flow.totals().energy() / first_energy);
    if (std::isnan(result.reaches_wall) && result.front.back() * a > scene.far_wall - 2 * h) result.reaches_wall = T;
    if (progress) progress(static_cast<double>(n) / static_cast<double>(samples));
  }
  result.lost =
      flow.outside(scene.extents.left, scene.extents.right, scene.extents.bottom, std::numeric_limits<double>::max());
  result.steps = flow.steps();
  result.extremes = flow.extremes();
  result.roundings = scene.warnings;
  return result;
}

void exchange(Tape& tape, SphCollapse& s) {
  tape(s.spacing, s.sound_speed, s.particles, s.T, s.front, s.height, s.energy, s.reaches_wall, s.lost, s.steps,
       s.extremes, s.roundings);
}

void measure_run(evidence::Exhibit& exhibit, const SphCollapse& run) {
  exhibit.measure("particles", static_cast<double>(run.particles));
  exhibit.measure("steps", static_cast<double>(run.steps));
  exhibit.measure("lowest_density", run.extremes.lowest_density);
  exhibit.measure("highest_density", run.extremes.highest_density);
  exhibit.measure("rebuilds", static_cast<double>(run.extremes.rebuilds));
  exhibit.measure("particles_lost", static_cast<double>(run.lost));
}
namespace {

/// Sound speed of the second run over the largest speed of the first.
constexpr double enough = 12.5;

}  // namespace

Parameter sound_rule(const std::string& given) {
  return choice("sound_from", "largest_speed", {"largest_speed", given},
                fmt::format("largest_speed: 12.5 times the largest speed of a first run with the sound speed of {0}; "
                            "{0}: given by the parameter sound",
                            given));
}

bool by_sound_rule(const Values& values) {
  return values.text("sound_from") == "largest_speed";
}

wcsph::Settings with_sound_for(wcsph::Settings settings, double largest_speed) {
  const double before = settings.sound_speed;
  settings.sound_speed = enough * largest_speed;
  if (auto* artificial = std::get_if<wcsph::ArtificialViscosity>(&settings.viscosity)) {
    artificial->alpha *= before / settings.sound_speed;
  }
  return settings;
}

std::vector<Parameter> sph_dam_parameters(SphDefaults defaults) {
  defaults.sound = 10 * std::numbers::sqrt2;
  return with({sound_rule("height")}, sph_parameters(defaults, "sqrt(g times the height of the column)"));
}

void exchange(Tape& tape, SphCollapses& runs) {
  tape(runs.first, runs.run);
}

SphCollapses collapse_by_rule(const SphDam& dam, const Values& values, const Watch& watch,
                              const std::vector<double>& frames,
                              const std::function<void(std::size_t, const wcsph::Flow&)>& on_frame,
                              const std::function<void(double)>& progress) {
  const auto part = [&](double from, double to) {
    return [=](double done) {
      if (progress) progress(from + (to - from) * done);
    };
  };
  if (!by_sound_rule(values)) return {.run = collapse(dam, watch, frames, on_frame, part(0, 1))};
  // The steps of the second run are shorter, as its sound is faster.
  constexpr double share = 0.3;
  SphCollapses runs{.first = collapse(dam, watch, {}, {}, part(0, share))};
  SphDam second = dam;
  second.settings = with_sound_for(dam.settings, runs.first->largest_speed());
  runs.run = collapse(second, watch, frames, on_frame, part(share, 1));
  return runs;
}

void claim_sound(const Claims<SphCollapses>& claims, const Values& values) {
  claims.only_if(by_sound_rule(values), "the sound speed is given, not taken from the largest speed")
      .from("Monaghan (1994)")
      .of(&SphCollapses::run)
      .at(&SphCollapse::resolution)
      .check(
          "mach", "Speeds stay below a tenth of the sound speed.", "largest Mach number",
          [](const SphCollapse& run) { return run.extremes.mach; },
          Bound{.limit = 0.1, .reason = "the rule by which the sound speed is chosen"});
}

void measure_sound(evidence::Exhibit& exhibit, const SphCollapses& runs) {
  exhibit.measure("sound_speed", runs.run.sound_speed);
  if (!runs.first) return;
  exhibit.measure("sound_speed_of_first_run", runs.first->sound_speed);
  exhibit.measure("largest_mach_number_of_first_run", runs.first->extremes.mach);
  exhibit.measure("steps_of_first_run", static_cast<double>(runs.first->steps));
}

}  // namespace seiche::validation
