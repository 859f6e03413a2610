/// A flap makes two waves so high that the second one plunges: weakly compressible SPH.
#pragma once

#include <limits>
#include <vector>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "validation/case/checkpoints.hpp"

namespace seiche::validation {

struct SphPlunging {
  double depth, period, stroke, wavelength;  ///< [m], [s]; the wavelength scales the places that are looked at
  double flume;                              ///< its length in wavelengths
  long layers;                               ///< particle spacings in the depth
  wcsph::Lattice lattice = wcsph::Lattice::square;
  wcsph::Settings settings;
};

struct SphPlunged {
  double spacing = 0;
  std::size_t particles = 0;
  long steps = 0;
  long lost = 0;  ///< particles outside the flume at the end
  std::vector<wcsph::Particles> frames;
  std::vector<double> crest;  ///< highest connected water in the window at the frames [m]
  std::vector<double> speed;  ///< largest of the water at the frames [m/s]
  double hangs_over = std::numeric_limits<double>::quiet_NaN();  ///< t/T, by two spacings
  double touches = std::numeric_limits<double>::quiet_NaN();     ///< t/T, with a cavity of at least 4 dx^2
  Largest cavity;                                                ///< area of the air that is enclosed [m^2]
  std::vector<double> jet_time, jet_x, jet_z;                    ///< tip of the jet before it touches
  wcsph::Extremes extremes;
};

/// The second wave is looked for after one period, a hundred times per period, behind the first one.
/// @param frames  t/T, ascending, whole hundredths above 1; the run ends at the last one
/// @param part    of the case's run that this is
SphPlunged plunge(const SphPlunging& setup, const std::vector<double>& frames, Part part);
void exchange(Tape& tape, SphPlunged& result);

}  // namespace seiche::validation
