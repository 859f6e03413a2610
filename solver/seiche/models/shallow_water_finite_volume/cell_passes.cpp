#include "seiche/models/shallow_water_finite_volume/cell_passes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "seiche/simd_clones.hpp"

namespace seiche::shallow_water_finite_volume {

SEICHE_SIMD_CLONES
void update_primitives(double gravity, double dry_depth, std::size_t n, const CellsView& cells) {
  const double* h = cells.depth;
  const double* q = cells.discharge;
  double* __restrict u = cells.velocity;
  double* __restrict c = cells.celerity;
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) {
    // q/infinity = 0 in a dry cell: a select that vectorises, unlike a division under a condition.
    u[i] = q[i] / (h[i] > dry_depth ? h[i] : std::numeric_limits<double>::infinity());
    c[i] = std::sqrt(gravity * h[i]);
  }
}

SEICHE_SIMD_CLONES
void apply_fluxes(double ratio, std::size_t n, const Fluxes& fluxes, const CellsView& cells) {
  double* __restrict h = cells.depth;
  double* __restrict q = cells.discharge;
  const double* mass = fluxes.mass.data();
  const double* on_left = fluxes.momentum.data();
  if (fluxes.source.empty()) {
    for (std::size_t i = 0; i < n; ++i) {
      h[i] -= ratio * (mass[i + 1] - mass[i]);
      q[i] -= ratio * (on_left[i + 1] - on_left[i]);
    }
    return;
  }
  const double* on_right = fluxes.momentum_right.data();
  const double* source = fluxes.source.data();
  for (std::size_t i = 0; i < n; ++i) {
    h[i] -= ratio * (mass[i + 1] - mass[i]);
    q[i] -= ratio * (on_left[i + 1] - on_right[i] - source[i]);
  }
}

SEICHE_SIMD_CLONES
void average(const double* old_depth, const double* old_discharge, std::size_t n, const CellsView& cells) {
  double* __restrict h = cells.depth;
  double* __restrict q = cells.discharge;
  for (std::size_t i = 0; i < n; ++i) {
    h[i] = 0.5 * (old_depth[i] + h[i]);
    q[i] = 0.5 * (old_discharge[i] + q[i]);
  }
}

SEICHE_SIMD_CLONES
long cut_negative(double roundoff, std::size_t n, const CellsView& cells) {
  double* __restrict h = cells.depth;
  const double* q = cells.discharge;
  long bad = 0;
  for (std::size_t i = 0; i < n; ++i) {
    // x - x is 0 for finite numbers only; comparisons with NaN are false.
    const double probe = (h[i] - h[i]) + (q[i] - q[i]);
    bad += static_cast<long>(h[i] < -roundoff) + static_cast<long>(!(probe == 0));
    h[i] = h[i] < 0 ? 0.0 : h[i];
  }
  return bad;
}

double apply_friction(double factor, double dry_depth, std::size_t n, const CellsView& cells) {
  double lost = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double h = cells.depth[i];
    if (h <= dry_depth) continue;
    const double before = cells.discharge[i];
    cells.discharge[i] = before / (1 + factor * std::abs(cells.velocity[i]) / (h * std::cbrt(h)));
    cells.velocity[i] = cells.discharge[i] / h;
    lost += cells.discharge[i] - before;
  }
  return lost;
}

SEICHE_SIMD_CLONES
double fastest(std::size_t n, const CellsView& cells) {
  const double* u = cells.velocity;
  const double* c = cells.celerity;
  // Independent maxima, one per lane: a single one would have to be found one cell after the other.
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> most{};
  std::size_t i = 0;
  for (; i + lanes <= n; i += lanes) {
    for (std::size_t k = 0; k < lanes; ++k) {
      const double speed = std::abs(u[i + k]) + c[i + k];
      most[k] = speed > most[k] ? speed : most[k];
    }
  }
  for (; i < n; ++i) most[0] = std::max(most[0], std::abs(u[i]) + c[i]);
  return *std::max_element(most.begin(), most.end());
}

}  // namespace seiche::shallow_water_finite_volume
