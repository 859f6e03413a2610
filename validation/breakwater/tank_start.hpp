/// How far a tank has settled in linear theory: the wave of a piston that starts softly, at a distance, analysed over
/// the same periods as the run's (harmonic.hpp), over the settled wave.
///
/// The piston's motion up to the end of the run is taken apart into frequencies; each travels as Airy's wave of its
/// wavenumber, with Havelock's height per stroke. Waves that decay with the distance from the paddle are left out.
///
/// When not to use it: within two depths of the paddle; distances that a part of the motion has not left behind.
#pragma once

#include <complex>
#include <vector>

#include "validation/breakwater/incident_waves.hpp"

namespace seiche::validation {

class TankStart {
 public:
  explicit TankStart(const IncidentWaves& waves);

  /// Amplitude at a distance from the piston over that of the settled wave, its phase taken out: 1 when settled, 0
  /// before anything arrives.
  [[nodiscard]] std::complex<double> settled_share(double distance) const;

 private:
  struct Part {
    double wavenumber;
    std::complex<double> forward, backward;  // weights of the wave and of its conjugate
  };
  double wavenumber_;
  std::vector<Part> parts_;
};

}  // namespace seiche::validation
