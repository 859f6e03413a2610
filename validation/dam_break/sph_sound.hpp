/// A collapsing column of SPH particles, with the sound speed by the source's rule: ten times the largest speed, which
/// a first run tells that has ten times the speed of a free fall through the column's height. What is fastest is the
/// splash at the far wall.
#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "validation/case/case.hpp"
#include "validation/dam_break/column_front.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/instruments/each.hpp"
#include "validation/studies/wcsph/spacing_ladder.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"

namespace seiche::validation {

struct SphDam {
  wcsph::DamBreak geometry;
  wcsph::Settings settings;
};
/// With the settings of the parameters; their unit of the sound speed is sqrt(g times the height of the column).
SphDam sph_dam(const wcsph::DamBreak& geometry, const Values& values, double gravity = 9.81, double density = 1000);

/// Against t sqrt(2 g/a) (tall columns) or t sqrt(g/a), as the measurements are scaled.
struct SphCollapse {
  /// Of a run before, which told the largest speed; without steps where the sound speed was given.
  struct First {
    double sound_speed = 0, mach = 0;
    long steps = 0;
  };

  double spacing = 0;
  double sound_speed = 0;     ///< [m/s]
  std::size_t particles = 0;  ///< walls included
  std::vector<double> T;
  std::vector<double> front;   ///< X/a, from the effective rear wall
  std::vector<double> energy;  ///< over that of the beginning
  double reaches_wall = nan;   ///< T at which the front is two smoothing lengths from the far wall; NaN if it is not
  long lost = 0;               ///< particles that left the domain
  long steps = 0;
  wcsph::Extremes extremes;
  std::vector<std::string> roundings;  ///< of lengths that are not whole numbers of spacings
  First first = {};

  [[nodiscard]] std::string resolution() const { return sph_resolution(spacing, particles); }
  [[nodiscard]] Curve front_curve() const { return {T, front}; }
  /// Before the far wall is felt.
  [[nodiscard]] Curve free_front() const;
};
void exchange(Tape& tape, SphCollapse& series);

/// How long, and when, a collapse is looked at.
struct Watch {
  double unit;                      ///< [1/s], T = unit t
  double last;                      ///< T at the end
  long samples;                     ///< of the series, equally spaced
  std::vector<double> frames = {};  ///< T, ascending
};

/// sph_parameters, with a sound speed of the first run of ten times sqrt(2 g times the column's height), and the choice
/// between the rule and a sound speed that is given.
std::vector<Parameter> sph_dam_parameters(SphDefaults defaults);

/// @param on_frame  is called at the frames, in the last run only
SphCollapse collapse_by_rule(
    const SphDam& dam, const Values& values, const Watch& watch,
    const std::function<void(const wcsph::Flow&)>& on_frame = [](const wcsph::Flow&) {},
    const Run::Progress& progress = [](double) {});

/// What compute(cells) gives for the numbers of spacings in the width of the column that the tier affords, ascending.
template <class Compute>
auto on_ladder(const Run& run, Compute compute) {
  const std::vector<long> ladder = sph_ladder(run.tier(), run.integer("cells"), 5);
  std::vector<std::invoke_result_t<Compute, long>> runs(ladder.size());
  climb(run, ladder.size(), [&](std::size_t size) { runs[size] = compute(ladder[size]); });
  return runs;
}

/// The rule holds; not claimed of a sound speed that is given.
void claim_sound(const Claims<SphCollapse>& claims, const Values& values);

/// Mach number, densities, rebuilds, lost particles: what a reader of the record wants to know of any run. The largest
/// speed that the first run told, and Mach numbers.
void measure_run(evidence::Exhibit& exhibit, const SphCollapse& run);

/// A published front, and how ours agree with it.
struct FrontBeside {
  ColumnFront data;
  double farthest;  ///< X/a of the points that are compared

  [[nodiscard]] ShiftedFront fit(const SphCollapse& run) const {
    return shifted_front(run.free_front(), data.curve(), farthest);
  }
  /// A number of the fit, as a measure of a run.
  [[nodiscard]] auto fitted(double ShiftedFront::*member) const {
    return [*this, member](const SphCollapse& run) { return fit(run).*member; };
  }
  /// How shift and difference converge on a ladder; names end with `suffix`.
  template <class Runs>
  void measure_convergence(evidence::Exhibit& exhibit, const Runs& runs, const std::string& suffix = "") const {
    const std::vector<double> spacings = each(runs, &SphCollapse::spacing);
    validation::measure_convergence(exhibit, "shift" + suffix, spacings, each(runs, fitted(&ShiftedFront::shift)));
    validation::measure_convergence(exhibit, "rms" + suffix, spacings, each(runs, fitted(&ShiftedFront::rms)));
  }
  /// Of a run, with the one shift that fits.
  void draw_later(evidence::Panel& panel, const SphCollapse& run, const std::string& label, Role role) const;
};

}  // namespace seiche::validation
