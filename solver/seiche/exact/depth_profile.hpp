/// How a wave of wavenumber k fades with depth, for any depth h, infinity included: no hyperbolic function of k h
/// itself, which overflows.
#pragma once

#include <cmath>

namespace seiche::exact {

/// cosh(k (y + h))/cosh(k h): 1 at y = 0; exp(k y) over infinite depth.
inline double cosh_profile(double k, double y, double depth) {
  return std::exp(k * y) * (1 + std::exp(-2 * k * (y + depth))) / (1 + std::exp(-2 * k * depth));
}

/// sinh(k (y + h))/cosh(k h): tanh(k h) at y = 0, 0 on the bottom.
inline double sinh_profile(double k, double y, double depth) {
  return -std::exp(k * y) * std::expm1(-2 * k * (y + depth)) / (1 + std::exp(-2 * k * depth));
}

}  // namespace seiche::exact
