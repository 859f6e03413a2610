/// Surfaces to start from, in units of 1/k and sqrt(1/(g k)); labels uniform in x.
#pragma once

#include <functional>

#include "seiche/exact/overturning/surface.hpp"

namespace seiche::exact::overturning {

/// Elevation A cos x with the potential of the linear wave of that amplitude at the surface itself,
///
///     phi = (A/w) cosh(y + h)/cosh(h) sin x,  w = sqrt(tanh h)   (A e^y sin x in infinitely deep water).
///
/// Its kinetic energy is (pi/2) A^2 I_0(2A) at any depth. Steep enough, it overturns towards +x.
State sinusoidal_wave(std::size_t markers, double amplitude, double depth);

/// Any elevation and surface potential of period 2 pi.
State from_functions(std::size_t markers, const std::function<double(double)>& elevation,
                     const std::function<double(double)>& potential);

}  // namespace seiche::exact::overturning
