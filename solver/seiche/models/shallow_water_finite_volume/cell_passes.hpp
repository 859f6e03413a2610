/// Passes over n cells, a channel's or a block's of one: what a step of every scheme does between its fluxes.
#pragma once

#include <cstddef>

#include "seiche/models/shallow_water_finite_volume/fluxes.hpp"

namespace seiche::shallow_water_finite_volume {

/// Velocity and celerity from depth and discharge.
void update_primitives(double gravity, double dry_depth, std::size_t n, const CellsView& cells);

/// U' = U - (tau/dx) (F_{i+1} - F_i) + (tau/dx) S_i.
///
/// @param ratio  tau/dx [s/m]
void apply_fluxes(double ratio, std::size_t n, const Fluxes& fluxes, const CellsView& cells);

/// Means of these cells and of an older state, in place: Heun's step after two of Euler's.
void average(const double* old_depth, const double* old_discharge, std::size_t n, const CellsView& cells);

/// Cuts negative depths. How many were below -roundoff, or not finite in depth or discharge.
///
/// @param roundoff  [m]: a cell that empties is the difference of larger numbers
long cut_negative(double roundoff, std::size_t n, const CellsView& cells);

/// q' = q/(1 + tau g n^2 |u|/h^(4/3)): implicit in the discharge, so that shallow water comes to rest and not back.
///
/// @param factor  tau g n^2
/// Returns the sum of q' - q.
double apply_friction(double factor, double dry_depth, std::size_t n, const CellsView& cells);

/// max(|u| + c) [m/s].
double fastest(std::size_t n, const CellsView& cells);

}  // namespace seiche::shallow_water_finite_volume
