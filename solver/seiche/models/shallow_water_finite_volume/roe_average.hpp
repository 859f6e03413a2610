#pragma once

#include <algorithm>
#include <cmath>

#include "seiche/simd_clones.hpp"

namespace seiche::shallow_water_finite_volume {

/// Change of the flux across a face by the two waves of Roe's linearisation.
struct WaveSum {
  double mass = 0;
  double momentum = 0;
};

/// Sum of weight(lam_k) alpha_k r_k over the two waves: u~ = (sqrt(hL) uL + sqrt(hR) uR)/(sqrt(hL) + sqrt(hR)),
/// c~ = sqrt(g (hL + hR)/2), alpha_1 = (lam_2 dh - dq)/(2 c~), alpha_2 = (dq - lam_1 dh)/(2 c~).
///
/// psi(lam) = (lam^2/delta + delta)/2 for |lam| < delta, |lam| otherwise, with Harten and Hyman's
/// delta = max(0, lam - lam_L, lam_R - lam). With `excess_only` the weight is psi(lam) - |lam|: zero except where the
/// entropy correction activates.
template <bool excess_only>
SEICHE_INLINE WaveSum roe_waves(double gravity, double hl, double ql, double ul, double cl, double hr, double qr,
                                double ur, double cr) {
  // The celerities are sqrt(g h), and the factor sqrt(g) cancels from the average. 1e-300: two dry cells give 0/0.
  const double u = (cl * ul + cr * ur) / std::max(cl + cr, 1e-300);
  const double c = std::sqrt(0.5 * gravity * (hl + hr));
  const double lam1 = u - c;
  const double lam2 = u + c;
  const auto weight = [](double lam, double lam_left, double lam_right) {
    const double delta = std::max(0.0, std::max(lam - lam_left, lam_right - lam));
    const double magnitude = std::abs(lam);
    const double smooth = 0.5 * (lam * lam / std::max(delta, 1e-300) + delta);
    const double psi = magnitude < delta ? smooth : magnitude;
    return excess_only ? psi - magnitude : psi;
  };
  const double half = 0.5 / std::max(c, 1e-300);
  const double a1 = weight(lam1, ul - cl, ur - cr) * (lam2 * (hr - hl) - (qr - ql)) * half;
  const double a2 = weight(lam2, ul + cl, ur + cr) * ((qr - ql) - lam1 * (hr - hl)) * half;
  return {a1 + a2, a1 * lam1 + a2 * lam2};
}

}  // namespace seiche::shallow_water_finite_volume
