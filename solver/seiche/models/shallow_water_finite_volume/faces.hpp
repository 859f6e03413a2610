/// What passes a face of a finite-volume grid: the schemes' fluxes of the water left and right of it.
#pragma once

#include <algorithm>
#include <cmath>

#include "seiche/simd_clones.hpp"

namespace seiche::shallow_water_finite_volume {

/// Beside a face: depth, discharge, velocity and celerity.
struct Water {
  double h, q, u, c;
};
struct Flux {
  double mass, thrust;  ///< [m^2/s], [m^3/s^2]
};

SEICHE_INLINE double thrust(double g, const Water& w) {
  return w.q * w.u + 0.5 * g * w.h * w.h;
}

struct LaxFriedrichs {
  double g, diffusion;  ///< nu dx/(2 tau)
  SEICHE_INLINE Flux operator()(const Water& l, const Water& r) const {
    return {0.5 * (l.q + r.q) - diffusion * (r.h - l.h), 0.5 * (thrust(g, l) + thrust(g, r)) - diffusion * (r.q - l.q)};
  }
};

/// Sum of weight(lam_k) alpha_k r_k over the two waves of Roe's linearisation: u~ = (sqrt(hL) uL + sqrt(hR) uR)/
/// (sqrt(hL) + sqrt(hR)), c~ = sqrt(g (hL + hR)/2), alpha_1 = (lam_2 dh - dq)/(2 c~), alpha_2 = (dq - lam_1 dh)/(2 c~).
///
/// psi(lam) = (lam^2/delta + delta)/2 for |lam| < delta, |lam| otherwise, with Harten and Hyman's
/// delta = max(0, lam - lam_L, lam_R - lam). With `excess_only` the weight is psi(lam) - |lam|: zero except where the
/// entropy correction activates.
template <bool excess_only>
SEICHE_INLINE Flux roe_waves(double g, const Water& l, const Water& r) {
  // The celerities are sqrt(g h), and the factor sqrt(g) cancels from the average. 1e-300: two dry cells give 0/0.
  const double u = (l.c * l.u + r.c * r.u) / std::max(l.c + r.c, 1e-300);
  const double c = std::sqrt(0.5 * g * (l.h + r.h));
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
  const double a1 = weight(lam1, l.u - l.c, r.u - r.c) * (lam2 * (r.h - l.h) - (r.q - l.q)) * half;
  const double a2 = weight(lam2, l.u + l.c, r.u + r.c) * ((r.q - l.q) - lam1 * (r.h - l.h)) * half;
  return {a1 + a2, a1 * lam1 + a2 * lam2};
}

struct Roe {
  double g;
  SEICHE_INLINE Flux operator()(const Water& l, const Water& r) const {
    const Flux waves = roe_waves<false>(g, l, r);
    return {0.5 * (l.q + r.q) - 0.5 * waves.mass, 0.5 * (thrust(g, l) + thrust(g, r)) - 0.5 * waves.thrust};
  }
};

/// Forward predictor of the left cell, backward corrector, as a flux. Division without a guard, as the scheme is
/// written: on a dry bed it breaks down, and that is its property.
struct MacCormack {
  double g, ratio;  ///< tau/dx
  SEICHE_INLINE Flux operator()(const Water& l, const Water& r) const {
    const double h = l.h - ratio * (r.q - l.q);
    const double q = l.q - ratio * (thrust(g, r) - thrust(g, l));
    const double predicted = q * q / h + 0.5 * g * h * h;
    const Flux excess = roe_waves<true>(g, l, r);
    return {0.5 * (r.q + q) - 0.5 * excess.mass, 0.5 * (thrust(g, r) + predicted) - 0.5 * excess.thrust};
  }
};

/// HLL flux with Einfeldt's two-rarefaction speeds. A dry side takes the speed of the dry front of the other.
SEICHE_INLINE Flux hll(double g, double hl, double ul, double hr, double ur) {
  const double cl = std::sqrt(g * hl);
  const double cr = std::sqrt(g * hr);
  const double um = 0.5 * (ul + ur) + cl - cr;
  const double cm = 0.5 * (cl + cr) + 0.25 * (ul - ur);
  const double wet_left = std::min(ul - cl, um - cm);
  const double wet_right = std::max(ur + cr, um + cm);
  const double left = hl > 0 ? (hr > 0 ? wet_left : ul - cl) : ur - 2 * cr;
  const double right = hr > 0 ? (hl > 0 ? wet_right : ur + cr) : ul + 2 * cl;
  const double sl = std::min(left, 0.0);
  const double sr = std::max(right, 0.0);
  const double ql = hl * ul;
  const double qr = hr * ur;
  // 1e-300: water at rest on neither side gives 0/0, whose flux is 0.
  const double inverse = 1 / std::max(sr - sl, 1e-300);
  const double thrust_l = ql * ul + 0.5 * g * hl * hl;
  const double thrust_r = qr * ur + 0.5 * g * hr * hr;
  return {(sr * ql - sl * qr + sl * sr * (hr - hl)) * inverse,
          (sr * thrust_l - sl * thrust_r + sl * sr * (qr - ql)) * inverse};
}

/// Half the generalised minmod slope (relations.hpp) without a branch, so that loops vectorise.
SEICHE_INLINE double half_slope(double before, double here, double after, double theta) {
  const double backward = here - before;
  const double forward = after - here;
  const double one_sided = theta * std::min(std::abs(backward), std::abs(forward));
  const double magnitude = std::min(one_sided, 0.5 * std::abs(after - before));
  // Half the sum of the signs is 0 at an extremum.
  return 0.5 * magnitude * (std::copysign(0.5, backward) + std::copysign(0.5, forward));
}

}  // namespace seiche::shallow_water_finite_volume
