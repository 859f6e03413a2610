/// Front and height of a collapsing column, from the particles themselves. Spray does not count: only fluid particles
/// with several others within the support 2h.
#pragma once

#include "seiche/models/wcsph/particles.hpp"

namespace seiche::wcsph {

/// Largest x of fluid particles with at least `neighbours` other fluid particles within 2h [m]. NaN when there is none.
double front_position(const Particles& particles, double smoothing_length, int neighbours = 4);

/// Largest z of such particles with left <= x <= right [m]. Particles that wet a wall stay there while the column
/// falls: the strip should begin about three spacings from it. NaN when there is none.
double column_height(const Particles& particles, double smoothing_length, double left, double right,
                     int neighbours = 4);

}  // namespace seiche::wcsph
