/// The water's surface in channels with improved dispersion.
///
/// The energies of gamma are those of Green and Naghdi's water, to the order of their own error, for another variable:
/// with the surface
///
/// @f[ \zeta = y - \frac{\gamma}{2} (H^2 y_x)_x @f]
///
/// of the water, its potential energy (g/2) zeta^2 is (g/2) (y^2 + gamma H^2 y_x^2) but for terms of gamma^2, and its
/// kinetic energy with alpha = 1/3 becomes that of the markers with alpha = 1/3 + gamma. So the markers carry y, and
/// zeta is what a gauge sees. Both hold the same water.
///
/// It matters as soon as waves are short somewhere. Over slopes the flux of energy stays,
/// (g/2) a^2 (1 + gamma (kH)^2) c_g of an amplitude a of y: read from y a wave that comes to kH = 3.6 is a third too
/// low, and from zeta it is the wave of Airy's but for c_g. In water of one depth the second harmonic bound to a wave
/// of y with amplitude a and frequency omega = c k is, H = g = 1 and s the depth_power,
///
/// @f[ a_2 = a^2 \frac{c^2 + (\alpha c^2 + \gamma s) k^2}{4 (1 - c^2)}
///         = \frac{3 a^2}{4 k^2} \left(1 + (\alpha + \gamma + \gamma s) k^2 + \dots\right), @f]
///
/// and zeta's is Stokes's, 3/(4 k^2) (1 + 2 k^2/3 + ...), if gamma (3 + s) = 1/3: for s = 2 that is gamma = 1/15, the
/// value that Airy's law has to the fourth order.
///
/// Here zeta = sqrt(1 + gamma K) y as (1 + gamma K/4) zeta = (1 + 3 gamma K/4) y, K = -(H^2 .')' in the differences
/// of the energy: exact energy to the order gamma^2 K^2, and at most three times y for waves as short as the markers'
/// distance. Nothing happens at the ends: no K flows through them.
///
/// When not to use it: to move water. gamma = 0: zeta = y.
#pragma once

#include <span>
#include <vector>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"

namespace seiche::dispersive_shallow_water_1d {

/// Of markers at x, y with the water V of the cells between them (one less, or as many if there is a period).
std::vector<double> water_surface(const Channel& channel, std::span<const double> x, std::span<const double> y,
                                  std::span<const double> volume);

/// At the markers of a flow, with the weight of its energy.
std::vector<double> water_surface(const Flow& flow);

/// At places, linear between markers; beyond the ends as Flow::elevation_at.
std::vector<double> water_surface_at(const Flow& flow, std::span<const double> places);

}  // namespace seiche::dispersive_shallow_water_1d
