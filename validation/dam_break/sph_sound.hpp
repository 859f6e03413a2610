/// A collapsing column of SPH particles, with the sound speed by the source's rule: ten times the largest speed, which
/// a first run tells that has ten times the speed of a free fall through the column's height. What is fastest is the
/// splash at the far wall.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "validation/case/case.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"

namespace seiche::validation {

struct SphDam {
  wcsph::DamBreak geometry;
  wcsph::Settings settings;
};

/// Against t sqrt(2 g/a) (tall columns) or t sqrt(g/a), as the measurements are scaled.
struct SphCollapse {
  double spacing = 0;
  double sound_speed = 0;     ///< [m/s]
  std::size_t particles = 0;  ///< walls included
  std::vector<double> T;
  std::vector<double> front;   ///< X/a, from the effective rear wall
  std::vector<double> height;  ///< of the column 3 to 6 spacings from the rear wall, over a
  std::vector<double> energy;  ///< over that of the beginning
  double reaches_wall = 0;     ///< T at which the front is two smoothing lengths from the far wall; NaN if it is not
  long lost = 0;               ///< particles that left the domain
  long steps = 0;
  wcsph::Extremes extremes;
  std::vector<std::string> roundings;  ///< of lengths that are not whole numbers of spacings
  [[nodiscard]] std::string resolution() const { return sph_resolution(spacing, particles); }
  [[nodiscard]] Curve front_curve() const { return {T, front}; }
  /// Before the far wall is felt.
  [[nodiscard]] Curve free_front() const;
  /// Of any particle of water at any time [m/s].
  [[nodiscard]] double largest_speed() const { return extremes.mach * sound_speed; }
};

/// How long, and when, a collapse is looked at.
struct Watch {
  double unit;   ///< [1/s], T = unit t
  double last;   ///< T at the end
  long samples;  ///< of the series, equally spaced
};

/// @param frames  T of frames, ascending; on_frame(k, flow) is called there
SphCollapse collapse(const SphDam& dam, const Watch& watch, const std::vector<double>& frames = {},
                     const std::function<void(std::size_t, const wcsph::Flow&)>& on_frame = {},
                     const std::function<void(double)>& progress = {});

void exchange(Tape& tape, SphCollapse& series);

/// Mach number, densities, rebuilds, lost particles: what a reader of the record wants to know of any run.
void measure_run(evidence::Exhibit& exhibit, const SphCollapse& run);

/// sound_from: largest_speed, by the rule, or `given`, by the parameter sound.
Parameter sound_rule(const std::string& given);
bool by_sound_rule(const Values& values);

/// @param largest_speed  of the water in a run with the settings [m/s]
wcsph::Settings with_sound_for(wcsph::Settings settings, double largest_speed);

/// sph_parameters, with a sound speed of the first run of ten times sqrt(2 g times the column's height), and the choice
/// between the rule and a sound speed that is given.
std::vector<Parameter> sph_dam_parameters(SphDefaults defaults);

struct SphCollapses {
  std::optional<SphCollapse> first = {};  ///< that told the largest speed; none with a given sound speed
  SphCollapse run = {};
};

void exchange(Tape& tape, SphCollapses& runs);

/// @param on_frame  is called in the last run only
SphCollapses collapse_by_rule(const SphDam& dam, const Values& values, const Watch& watch,
                              const std::vector<double>& frames = {},
                              const std::function<void(std::size_t, const wcsph::Flow&)>& on_frame = {},
                              const std::function<void(double)>& progress = {});

/// The rule holds; not claimed of a sound speed that is given.
void claim_sound(const Claims<SphCollapses>& claims, const Values& values);

/// The largest speed that the first run told, and Mach numbers.
void measure_sound(evidence::Exhibit& exhibit, const SphCollapses& runs);

}  // namespace seiche::validation
