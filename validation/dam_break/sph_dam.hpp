/// A column of water collapses in an open tank: weakly compressible SPH, its front and frames.
#pragma once

#include <functional>
#include <vector>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "validation/case/case.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"

namespace seiche::validation {

struct SphDam {
  wcsph::DamBreak geometry;
  wcsph::Settings settings;

  /// The same with another spacing; the smoothing length goes with it.
  [[nodiscard]] SphDam with_spacing(double spacing) const;
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

}  // namespace seiche::validation
