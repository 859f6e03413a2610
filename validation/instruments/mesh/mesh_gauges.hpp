/// Gauges in a flow of the two-dimensional Lagrangian mesh: the load of a wall, and the surface at fixed places.
#pragma once

#include <algorithm>
#include <limits>
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
  [[nodiscard]] double pressure_at(double elevation) const {
    if (!(elevation <= contact)) return std::numeric_limits<double>::quiet_NaN();
    const std::size_t n = y.size();
    const auto between = [&](double y0, double p0, double y1, double p1) {
      return p0 + (p1 - p0) * (elevation - y0) / (y1 - y0);
    };
    if (elevation >= y[n - 1] || n == 1) return between(y[n - 1], pressure[n - 1], contact, 0);
    const auto above = std::upper_bound(y.begin() + 1, y.end() - 1, elevation);
    const auto k = static_cast<std::size_t>(above - y.begin());
    return between(y[k - 1], pressure[k - 1], y[k], pressure[k]);
  }
};

/// Reads the load of the right wall after every step: multipliers of single steps alternate, the mean of two steps'
/// belongs to the nodes' places between them.
class WallGauge {
 public:
  /// To be called after every step, of equal length and without composition: the load at the beginning of the last one;
  /// none where no two have been made since the beginning or the last rezoning.
  std::optional<WallLoad> read(const lagrangian_mesh_2d::Flow& flow) {
    const lagrangian_mesh_2d::Mesh& mesh = flow.model().mesh();
    const mechanics::State& state = flow.state();
    std::optional<WallLoad> load;
    if (!y_.empty() && !state.multipliers.empty() && !state.earlier_multipliers.empty()) {
      load = WallLoad{.time = time_, .contact = y_[mesh.rows], .y = {}, .pressure = {}};
      const double weight = flow.model().settings().density * flow.model().settings().gravity;
      for (std::size_t j = 0; j < mesh.rows; ++j) {
        const std::size_t cell = (j + 1) * mesh.columns - 1;
        const double dynamic = 0.5 * (state.multipliers[cell] + state.earlier_multipliers[cell]);
        const double middle = 0.5 * (y_[j] + y_[j + 1]);
        load->y.push_back(middle);
        load->pressure.push_back(dynamic - weight * middle);
        // Hydrostatic pressure is linear in y: its integral over a cell is exact.
        load->force += (dynamic - weight * middle) * (y_[j + 1] - y_[j]);
      }
    }
    time_ = flow.time();
    y_.clear();
    for (std::size_t j = 0; j <= mesh.rows; ++j) y_.push_back(flow.y()[mesh.node(mesh.columns, j)]);
    return load;
  }

 private:
  double time_ = 0;  // of the last reading
  std::vector<double> y_;
};

/// Surface elevation at places, linear between nodes; NaN beyond the surface's ends.
inline std::vector<double> elevation_at(const lagrangian_mesh_2d::Flow& flow, std::span<const double> places) {
  const auto xs = flow.surface_x();
  const auto ys = flow.surface_y();
  std::vector<double> elevation;
  for (const double place : places) {
    const auto k = static_cast<std::size_t>(std::upper_bound(xs.begin(), xs.end(), place) - xs.begin());
    if (k > 0 && k < xs.size()) {
      elevation.push_back(ys[k - 1] + (ys[k] - ys[k - 1]) * (place - xs[k - 1]) / (xs[k] - xs[k - 1]));
    } else if (place == xs.back()) {
      elevation.push_back(ys.back());
    } else {
      elevation.push_back(std::numeric_limits<double>::quiet_NaN());
    }
  }
  return elevation;
}

}  // namespace seiche::validation
