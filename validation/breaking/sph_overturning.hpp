/// A steep wave turns over in a periodic box of particles: from the same surface, velocities and pressures as
/// exact::OverturningWave, judged by the distance of its surface from that one's.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "seiche/exact/overturning/overturning_wave.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/particles.hpp"
#include "validation/case/checkpoints.hpp"
#include "validation/instruments/particles/sph_free_surface.hpp"
#include "validation/instruments/polyline_distance.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"

namespace seiche::validation {

struct SteepWave {
  double amplitude, wavelength, depth, gravity;  ///< [m], [m/s^2]

  [[nodiscard]] double period() const;  ///< of the linear wave
  /// @param last_phase  of that period, as far as potential flow is computed
  [[nodiscard]] exact::OverturningWave exact(std::size_t markers, double last_phase) const;
};

/// When surfaces are compared: from halfway to a vertical front to a developed jet.
struct Instant {
  std::string id;
  std::string when;  ///< begins a sentence
};
extern const std::array<Instant, 5> overturning_instants;
std::vector<double> times_of(const exact::OverturningWave& wave);

struct SphOverturning {
  SteepWave wave;
  long columns;  ///< particle spacings in a wavelength
  wcsph::Settings settings;

  [[nodiscard]] double spacing() const { return wave.wavelength / static_cast<double>(columns); }
};

/// What one computation left: surfaces, elevations above the level at rest, and when things happened.
struct SphOverturned {
  double spacing = 0;
  std::size_t particles = 0;
  long steps = 0;
  std::vector<double> times;
  std::vector<Polylines> surfaces;          ///< the main one at these times
  std::vector<double> speed;                ///< largest of the fluid there [m/s]
  std::vector<wcsph::Particles> snapshots;  ///< there
  std::vector<double> kinetic;              ///< there, kinetic energy over the density [m^4/s^2]
  std::vector<double> energy;               ///< there, over that of the beginning; counted from still water
  std::vector<double> level;                ///< there, mean elevation [m]: 0 for water that keeps its volume
  double hangs_over = nan;                  ///< first time with the overhang asked for [s]
  double touches = nan;                     ///< first time with a closed cavity [s]
  double cavity = nan;                      ///< area of the air in it then [m^2]
  double breaks_up = nan;                   ///< time of a divergence before the jet touched [s]
  wcsph::Extremes extremes;

  [[nodiscard]] std::string resolution() const { return sph_resolution(spacing, particles); }
};

/// @param times     ascending; the run ends at the last one
/// @param overhang  [m] by which the front must hang over to count
/// @param watched   instants in between at which overhang and cavity are looked for
/// @param part      of the case's run that this is
/// @param landed    whether the run goes on to the last of the times after the jet has touched; if not, it ends there,
///                  or where it diverges after the last time but one, which is kept as breaks_up
SphOverturned overturn(const SphOverturning& setup, const std::vector<double>& times, double overhang, long watched,
                       Part part, bool landed = true);
void exchange(Tape& tape, SphOverturned& result);
void exchange(Tape& tape, Polyline& line);

/// The exact surface at a time as one curve of the box [0, L].
Polylines exact_surface(const exact::OverturningWave& wave, double time, std::size_t points = 1601);
/// A curve that is farther along x.
Polyline moved(Polyline curve, double by);
/// A panel as wide as the surface, 1 m, with the exact one and its images a wavelength to either side.
evidence::Panel& draw_beside_images(evidence::Figure& figure, const std::string& title, const Polyline& exact,
                                    const Polyline& surface);
/// First time at which the exact surface hangs over by as much [s]; NaN if it does not before `end`.
double exact_overhang_time(const exact::OverturningWave& wave, double overhang, double end);

}  // namespace seiche::validation
