/// The solitary wave of the Green-Naghdi equations on the models of waves in three dimensions, travelling along x.
///
/// Columns hold equal volumes of still water, so that they stand closer under the crest; depth and gravity are 1.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/straight_line.hpp"

namespace seiche::validation {

struct PlanSolitonRun {
  double amplitude = 0.3;
  double spacing = 0.5;  ///< h of still water, along and across
  double tau = 0.2;
  double time = 100;
  double settled = 20;  ///< when the wave has become that of the lattice
  std::size_t rows = 1;
  dispersive_shallow_water_2d::Scheme scheme = {};
  double tolerance = 1e-9;
};

dispersive_shallow_water_2d::Flow plan_soliton_flow(const PlanSolitonRun& run);
lagrangian_mesh_3d::Flow layered_soliton_flow(const PlanSolitonRun& run, std::size_t layers);

/// What becomes of the crest; of its row on the south wall, by the parabola through the highest node and its
/// neighbours.
struct SolitonTravel {
  std::vector<double> time, place, height;
  double settled = 0;
  double energy_defect = 0;  ///< largest, over the energy
  double volume_defect = 0;  ///< largest of a cell, over a cell's volume

  // From the time on when the wave has settled.
  [[nodiscard]] double mean_height() const;
  [[nodiscard]] double lowest() const { return smallest(from_then(height)); }
  [[nodiscard]] double highest() const { return largest(from_then(height)); }
  /// Of the least-squares line through the places.
  [[nodiscard]] double speed() const { return straight_line(from_then(time), from_then(place)).slope; }

 private:
  /// Values from then on.
  [[nodiscard]] std::span<const double> from_then(const std::vector<double>& values) const;
};

SolitonTravel travel(dispersive_shallow_water_2d::Flow& flow, const PlanSolitonRun& run);
SolitonTravel travel(lagrangian_mesh_3d::Flow& flow, const PlanSolitonRun& run);

}  // namespace seiche::validation
