#include <cmath>

#include "seiche/models/shallow_water_finite_volume/fluxes.hpp"
#include "seiche/models/shallow_water_finite_volume/roe_average.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::shallow_water_finite_volume {

SEICHE_SIMD_CLONES
void lax_friedrichs_fluxes(double gravity, double viscosity, double ratio, const CellsView& cells, std::size_t n,
                           Fluxes& fluxes) {
  const double* h = cells.depth;
  const double* q = cells.discharge;
  const double* u = cells.velocity;
  double* __restrict mass = fluxes.mass.data();
  double* __restrict momentum = fluxes.momentum.data();
  const double diffusion = 0.5 * viscosity / ratio;
  const auto faces = static_cast<std::ptrdiff_t>(n + 1);
#pragma GCC ivdep
  for (std::ptrdiff_t k = 0; k < faces; ++k) {
    const std::ptrdiff_t l = k - 1;
    mass[k] = 0.5 * (q[l] + q[k]) - diffusion * (h[k] - h[l]);
    momentum[k] = 0.5 * ((q[l] * u[l] + 0.5 * gravity * h[l] * h[l]) + (q[k] * u[k] + 0.5 * gravity * h[k] * h[k])) -
                  diffusion * (q[k] - q[l]);
  }
}

SEICHE_SIMD_CLONES
void MacCormackFluxes::operator()(double gravity, double ratio, const CellsView& cells, std::size_t n, Fluxes& fluxes) {
  const double* h = cells.depth;
  const double* q = cells.discharge;
  const double* u = cells.velocity;
  const double* c = cells.celerity;
  double* __restrict mass = fluxes.mass.data();
  double* __restrict momentum = fluxes.momentum.data();
  double* __restrict predicted_mass = predicted_mass_.data();
  double* __restrict predicted_momentum = predicted_momentum_.data();
  const auto faces = static_cast<std::ptrdiff_t>(n + 1);

  // Step 1: forward predictor of the cell left of each face, and its flux. Division without a guard, as the scheme is
  // written: on a dry bed it breaks down, and that is its property.
#pragma GCC ivdep
  for (std::ptrdiff_t k = 0; k < faces; ++k) {
    const std::ptrdiff_t l = k - 1;
    const double thrust_l = q[l] * u[l] + 0.5 * gravity * h[l] * h[l];
    const double thrust_r = q[k] * u[k] + 0.5 * gravity * h[k] * h[k];
    const double depth = h[l] - ratio * (q[k] - q[l]);
    const double discharge = q[l] - ratio * (thrust_r - thrust_l);
    predicted_mass[k] = discharge;
    predicted_momentum[k] = discharge * discharge / depth + 0.5 * gravity * depth * depth;
  }
  // Step 2: backward corrector, as a flux, and the entropy term.
#pragma GCC ivdep
  for (std::ptrdiff_t k = 0; k < faces; ++k) {
    const std::ptrdiff_t l = k - 1;
    const WaveSum excess = roe_waves<true>(gravity, h[l], q[l], u[l], c[l], h[k], q[k], u[k], c[k]);
    mass[k] = 0.5 * (q[k] + predicted_mass[k]) - 0.5 * excess.mass;
    momentum[k] = 0.5 * (q[k] * u[k] + 0.5 * gravity * h[k] * h[k] + predicted_momentum[k]) - 0.5 * excess.momentum;
  }
}

SEICHE_SIMD_CLONES
void roe_fluxes(double gravity, const CellsView& cells, std::size_t n, Fluxes& fluxes) {
  const double* h = cells.depth;
  const double* q = cells.discharge;
  const double* u = cells.velocity;
  const double* c = cells.celerity;
  double* __restrict mass = fluxes.mass.data();
  double* __restrict momentum = fluxes.momentum.data();
  const auto faces = static_cast<std::ptrdiff_t>(n + 1);
#pragma GCC ivdep
  for (std::ptrdiff_t k = 0; k < faces; ++k) {
    const std::ptrdiff_t l = k - 1;
    const WaveSum waves = roe_waves<false>(gravity, h[l], q[l], u[l], c[l], h[k], q[k], u[k], c[k]);
    mass[k] = 0.5 * (q[l] + q[k]) - 0.5 * waves.mass;
    momentum[k] = 0.5 * ((q[l] * u[l] + 0.5 * gravity * h[l] * h[l]) + (q[k] * u[k] + 0.5 * gravity * h[k] * h[k])) -
                  0.5 * waves.momentum;
  }
}

}  // namespace seiche::shallow_water_finite_volume
