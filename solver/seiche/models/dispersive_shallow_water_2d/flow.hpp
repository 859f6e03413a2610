/// A flow of the plan model: a lattice of water columns, stepped by one of the schemes.
///
///     Flow flow(rectangular_lattice({.begin = 0, .end = 40, .south = 0, .north = 20, .columns = 80, .rows = 40,
///                                    .elevation = [](double x, double y) { return 0.1 * std::exp(-x * x - y * y);
///                                    }}));
///     while (flow.time() < 20) flow.advance(0.2);
///
/// The first velocities are projected on constant volumes. Throws std::invalid_argument for bad input and Divergence,
/// with time, step and place, when a cell tangles, a marker touches the bottom or leaves it, a solver fails or a value
/// is not finite.
#pragma once

#include "seiche/models/dispersive_shallow_water_2d/model.hpp"
#include "seiche/plan_lattice/lattice_flow.hpp"

namespace seiche::dispersive_shallow_water_2d {

using mechanics::Scheme;
using mechanics::Stepping;
using mechanics::TimeComposition;
using plan_lattice::Window;

/// Energies and pressures are per unit density.
class Flow : public plan_lattice::LatticeFlow<Model> {
 public:
  /// @param velocity  at the beginning
  /// @param smooth_start  the first velocities of the one-step scheme get the part outside the constraints that keeps
  ///                      its multipliers from alternating (mechanics/start.hpp); not with driven sides or compositions
  explicit Flow(Lattice lattice, const InitialVelocity& velocity = {}, Scheme scheme = {}, Settings settings = {},
                Forcing forcing = {}, Window window = {}, bool smooth_start = true);

  /// Fronts that broke in another flow, of a lattice of this shape, break on.
  void continue_breaking(const Flow& before) { model_->continue_breaking(before.model()); }
};

}  // namespace seiche::dispersive_shallow_water_2d

/// Compiled once, in flow.cpp.
extern template class seiche::plan_lattice::LatticeFlow<seiche::dispersive_shallow_water_2d::Model>;
