/// Linear reconstruction in a particle and its prediction to the middle of a step.
///
/// Source: van Leer (1979) for the limited reconstruction; the half-step predictor is MUSCL-Hancock, see Toro (2001).
#pragma once

#include <algorithm>
#include <cmath>

#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/shallow_water/limited_slope.hpp"

namespace seiche::shallow_water_particles {

/// Depth and velocity at both edges of every particle.
struct EdgeValues {
  Array left_depth;
  Array right_depth;
  Array left_velocity;
  Array right_velocity;

  void resize(std::size_t count) {
    for (Array* a : {&left_depth, &right_depth, &left_velocity, &right_velocity}) a->resize(count);
  }
};

/// The same for one particle.
struct EdgePair {
  double h_left, h_right, u_left, u_right;
};

/// Slope limited by the differences to both neighbours, which lie at distances `back` and `ahead`.
inline double slope(double before, double own, double after, double back, double ahead, double theta) {
  return shallow_water::limited_slope((own - before) / back, (after - before) / (back + ahead), (after - own) / ahead,
                                      theta);
}

/// Depth difference from centre to edge, kept so that neither edge falls below a tenth of the mean depth.
inline double wet_half_difference(double half, double depth) {
  const double most = 0.9 * depth;
  return std::clamp(half, -most, most);
}

/// Edge values after half a step [tau/2] of a particle on a flat bed: depths follow the width, velocities the pressure
/// difference and the acceleration. A width that would change by more than a factor 5 is left alone.
inline EdgePair predict(double gravity, EdgePair now, double width, double inv_mass, double half_step,
                        double acceleration) {
  const double stretched = width + half_step * (now.u_right - now.u_left);
  const bool sane = stretched > 0.2 * width && stretched < 5 * width;
  const double ratio = sane ? width / stretched : 1.0;
  const double kick =
      half_step * (inv_mass * 0.5 * gravity * (now.h_left - now.h_right) * (now.h_left + now.h_right) + acceleration);
  return {now.h_left * ratio, now.h_right * ratio, now.u_left + kick, now.u_right + kick};
}

}  // namespace seiche::shallow_water_particles
