/// Gauges in a flow of the two-dimensional Lagrangian mesh: the load of a wall, and the surface at fixed places.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"

namespace seiche::validation {

/// The water at a wall, at one moment.
struct WallLoad {
  double time = 0;
  double contact = 0;            ///< elevation of the contact point [m]
  std::vector<double> y;         ///< middles of the wall's cells, from the bottom up [m]
  std::vector<double> pressure;  ///< there [Pa]
  /// Horizontal force on the wall towards the outside, hydrostatic pressure included [N/m].
  double force = 0;

  /// Linear between the middles, 0 at the contact point; extrapolated to the bottom. NaN above the contact point.
  [[nodiscard]] double pressure_at(double elevation) const;
};

/// Reads the load of the right wall after every step: multipliers of single steps alternate, the mean of two steps'
/// belongs to the nodes' places between them.
class WallGauge {
 public:
  /// To be called after every step, of equal length and without composition: the load at the beginning of the last one;
  /// none where no two have been made since the beginning or the last rezoning.
  std::optional<WallLoad> read(const lagrangian_mesh_2d::Flow& flow);

 private:
  double time_ = 0;  // of the last reading
  std::vector<double> y_;
};

/// Surface elevation at places, linear between nodes; NaN beyond the surface's ends.
std::vector<double> elevation_at(const lagrangian_mesh_2d::Flow& flow, std::span<const double> places);

}  // namespace seiche::validation
