#include <algorithm>
#include <cmath>

#include "seiche/models/shallow_water_finite_volume/fluxes.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::shallow_water_finite_volume {
namespace {

/// Half the generalised minmod slope (limited_slope.hpp) without a branch, so that the loop vectorises.
SEICHE_INLINE double half_slope(double before, double here, double after, double theta) {
  const double backward = here - before;
  const double forward = after - here;
  const double one_sided = theta * std::min(std::abs(backward), std::abs(forward));
  const double magnitude = std::min(one_sided, 0.5 * std::abs(after - before));
  // Half the sum of the signs is 0 at an extremum.
  return 0.5 * magnitude * (std::copysign(0.5, backward) + std::copysign(0.5, forward));
}

struct Flux {
  double mass = 0;
  double momentum = 0;
};

/// HLL flux with Einfeldt's two-rarefaction speeds. A dry side takes the speed of the dry front of the other.
SEICHE_INLINE Flux hll(double gravity, double hl, double ul, double hr, double ur) {
  const double cl = std::sqrt(gravity * hl);
  const double cr = std::sqrt(gravity * hr);
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
  const double thrust_l = ql * ul + 0.5 * gravity * hl * hl;
  const double thrust_r = qr * ur + 0.5 * gravity * hr * hr;
  return {(sr * ql - sl * qr + sl * sr * (hr - hl)) * inverse,
          (sr * thrust_l - sl * thrust_r + sl * sr * (qr - ql)) * inverse};
}

}  // namespace

MusclHllFluxes::MusclHllFluxes(std::size_t most, bool uneven)
    : depth_left_(most + 2),
      depth_right_(most + 2),
      velocity_left_(most + 2),
      velocity_right_(most + 2),
      bed_left_(uneven ? most + 2 : 0),
      bed_right_(uneven ? most + 2 : 0) {}

SEICHE_SIMD_CLONES
void MusclHllFluxes::operator()(double gravity, double theta, const CellsView& cells, const double* bed, std::size_t n,
                                Fluxes& fluxes) {
  // Step 1: values at the edges of each cell. Entry j of the edge arrays is cell j - 1.
  const double* h = cells.depth - 1;
  const double* u = cells.velocity - 1;
  double* __restrict hl = depth_left_.data();
  double* __restrict hr = depth_right_.data();
  double* __restrict ul = velocity_left_.data();
  double* __restrict ur = velocity_right_.data();
  const auto entries = static_cast<std::ptrdiff_t>(n + 2);
#pragma GCC ivdep
  for (std::ptrdiff_t j = 0; j < entries; ++j) {
    const double dh = half_slope(h[j - 1], h[j], h[j + 1], theta);
    const double du = half_slope(u[j - 1], u[j], u[j + 1], theta);
    // The limiter keeps h - |dh| >= 0 for theta <= 2 but for its last bit.
    hl[j] = std::max(h[j] - dh, 0.0);
    hr[j] = std::max(h[j] + dh, 0.0);
    // Weighted so that the two edges carry the cell's momentum: (hl ul + hr ur)/2 = h u. 1e-300: a dry cell divides 0
    // by it.
    const double inverse = 1 / std::max(h[j], 1e-300);
    ul[j] = u[j] - du * hr[j] * inverse;
    ur[j] = u[j] + du * hl[j] * inverse;
  }
  if (bed == nullptr) {
    flat(gravity, n, fluxes);
    return;
  }
  const double* z = bed - 1;
  double* __restrict zl = bed_left_.data();
  double* __restrict zr = bed_right_.data();
#pragma GCC ivdep
  for (std::ptrdiff_t j = 0; j < entries; ++j) {
    const double surface = h[j] + z[j];
    const double de = half_slope(h[j - 1] + z[j - 1], surface, h[j + 1] + z[j + 1], theta);
    zl[j] = (surface - de) - hl[j];
    zr[j] = (surface + de) - hr[j];
  }
  uneven(gravity, n, fluxes);
}

// Step 2 on a flat bed: one flux per face.
SEICHE_SIMD_CLONES
void MusclHllFluxes::flat(double gravity, std::size_t n, Fluxes& fluxes) const {
  const double* hl = depth_left_.data();
  const double* hr = depth_right_.data();
  const double* ul = velocity_left_.data();
  const double* ur = velocity_right_.data();
  double* __restrict mass = fluxes.mass.data();
  double* __restrict momentum = fluxes.momentum.data();
  const std::size_t faces = n + 1;
#pragma GCC ivdep
  for (std::size_t k = 0; k < faces; ++k) {
    const Flux flux = hll(gravity, hr[k], ur[k], hl[k + 1], ul[k + 1]);
    mass[k] = flux.mass;
    momentum[k] = flux.momentum;
  }
}

// Step 2 on an uneven bed: depths above the higher of the two beds, thrust of the step added to either side
// (Audusse et al. 2004, formulas 2.9-2.14), and the centred source of the second-order scheme (formula 4.6).
SEICHE_SIMD_CLONES
void MusclHllFluxes::uneven(double gravity, std::size_t n, Fluxes& fluxes) const {
  const double* hl = depth_left_.data();
  const double* hr = depth_right_.data();
  const double* ul = velocity_left_.data();
  const double* ur = velocity_right_.data();
  const double* zl = bed_left_.data();
  const double* zr = bed_right_.data();
  double* __restrict mass = fluxes.mass.data();
  double* __restrict on_left = fluxes.momentum.data();
  double* __restrict on_right = fluxes.momentum_right.data();
  double* __restrict source = fluxes.source.data();
  const std::size_t faces = n + 1;
#pragma GCC ivdep
  for (std::size_t k = 0; k < faces; ++k) {
    const double step = std::max(zr[k], zl[k + 1]);
    const double left = std::max(0.0, hr[k] + zr[k] - step);
    const double right = std::max(0.0, hl[k + 1] + zl[k + 1] - step);
    const Flux flux = hll(gravity, left, ur[k], right, ul[k + 1]);
    mass[k] = flux.mass;
    on_left[k] = flux.momentum + 0.5 * gravity * (hr[k] - left) * (hr[k] + left);
    on_right[k] = flux.momentum + 0.5 * gravity * (hl[k + 1] - right) * (hl[k + 1] + right);
  }
#pragma GCC ivdep
  for (std::size_t i = 0; i + 1 < faces; ++i) {
    source[i] = -0.5 * gravity * (hl[i + 1] + hr[i + 1]) * (zr[i + 1] - zl[i + 1]);
  }
}

}  // namespace seiche::shallow_water_finite_volume
