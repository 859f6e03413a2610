/// The way of a crest over a two-dimensional Lagrangian mesh: its place and height after every step.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"

namespace seiche::validation {

struct CrestTrack {
  std::vector<double> time, place, elevation;
  double worst_corner = 0;                 ///< smallest shape of a corner of the mesh on the way
  std::optional<Divergence> tangled = {};  ///< why the run ended before its time

  /// Of the least-squares line through the places from a time on [m/s].
  [[nodiscard]] double speed(double from) const;
  /// Mean height from a time on [m].
  [[nodiscard]] double mean_elevation(double from) const;
};

/// Advances the flow to a time, or until its mesh tangles.
CrestTrack follow_crest(lagrangian_mesh_2d::Flow& flow, double time, double tau,
                        const std::function<void()>& after_step = {});

/// Largest distance of surface nodes, up to `reach` from a crest, from a profile whose own crest is put there.
double largest_profile_error(const lagrangian_mesh_2d::Flow& flow, double crest, double reach,
                             const std::function<double(double)>& profile);

}  // namespace seiche::validation
