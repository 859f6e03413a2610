#include "validation/dam_break/sph_sound.hpp"

#include <cmath>
#include <numbers>

#include "validation/studies/wcsph/sound_rule.hpp"

namespace seiche::validation {

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
  if (!by_sound_rule(values)) return {.first = {}, .run = collapse(dam, watch, frames, on_frame, part(0, 1))};
  // The steps of the second run are shorter, as its sound is faster.
  constexpr double share = 0.3;
  SphCollapses runs{.first = collapse(dam, watch, {}, {}, part(0, share)), .run = {}};
  SphDam second = dam;
  second.settings = with_sound_for(dam.settings, runs.first->largest_speed());
  runs.run = collapse(second, watch, frames, on_frame, part(share, 1));
  return runs;
}

void claim_sound(const Claims<SphCollapses>& claims, const Values& values) {
  claims.only_if(by_sound_rule(values), "the sound speed is given, not taken from the largest speed")
      .from("Monaghan (1994)")
      .check(
          "mach", "Speeds stay below a tenth of the sound speed.", "largest Mach number",
          [](const SphCollapses& runs) -> Measurement {
            return {.value = runs.run.extremes.mach, .resolution = runs.run.resolution()};
          },
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
