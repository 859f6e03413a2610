/// A solitary wave around the conical island of Briggs, Synolakis, Harkins and Green (1995).
///
/// Base of 7.2 m, top of 2.2 m, 0.625 m high, slope 1:4, in water 0.32 m or 0.42 m deep; the island's middle is the
/// origin, the wave comes along x. Half the basin is enough: y = 0 is a line of symmetry. The lattice goes around the
/// island, columns from its front (180 degrees) to its back, rows from the shoreline to the walls of the basin.
///
/// The bottom is the bicubic spline through the elevations on a raster, as for a surveyed coast.
///
/// Reference: M. J. Briggs, C. E. Synolakis, G. S. Harkins, D. R. Green, Laboratory experiments of tsunami runup on a
/// circular island, Pure Appl. Geophys. 144 (1995) 569.
#pragma once

#include <cmath>

#include <memory>
#include <vector>

#include "seiche/exact/model_waves.hpp"
#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/plan/rezoned_flow.hpp"

namespace seiche::validation {

class ConicalIsland {
 public:
  static constexpr double base_radius = 3.6;  ///< [m]
  static constexpr double top_radius = 1.1;
  static constexpr double slope = 0.25;
  static constexpr double side_wall = 13.8;  ///< distance of the side walls
  static constexpr double rear_wall = 12;
  static constexpr double gravity = 9.81;

  struct Settings {
    double height = 0.096;  ///< of the wave over the depth
    double depth = 0.32;    ///< [m]
    double spacing = 0.4;   ///< of the columns along the walls of the basin [m]
    double raster = 0.1;    ///< spacing of the elevations [m]
    dispersive_shallow_water_2d::Scheme scheme = {};
    /// Smooth concrete; the edge of the water keeps to what is beside it within a tenth of a second; what is steeper
    /// than 30 degrees breaks, as in one dimension (Tissier et al. 2012).
    dispersive_shallow_water_2d::DragSettings drag = {.manning = 0.012, .shore_rate = 10, .breaking_slope = 0.577};
  };

  /// Throws std::invalid_argument.
  explicit ConicalIsland(Settings settings);

  /// Elevation of the bottom of the experiment above still water.
  [[nodiscard]] double bottom(double x, double y) const;
  /// x of the crest at the beginning, so far away that the shoreline is at rest.
  [[nodiscard]] double crest() const { return -base_radius - reach_; }
  [[nodiscard]] const exact::SerreSolitary& wave() const { return wave_; }
  [[nodiscard]] dispersive_shallow_water_2d::Flow flow() const;
  /// The same on a lattice that is rezoned: the wave passes the island where the other tangles.
  [[nodiscard]] RezonedFlow rezoned_flow() const;
  /// What the flows are made of.
  [[nodiscard]] dispersive_shallow_water_2d::Lattice lattice() const;
  [[nodiscard]] dispersive_shallow_water_2d::Velocity velocity(double x, double y) const;
  [[nodiscard]] dispersive_shallow_water_2d::Settings model_settings() const;
  /// The crest passes the middle of the island where it is not held up.
  [[nodiscard]] double passage() const { return -crest() / wave_.speed(); }
  /// About half of what a long wave in the deep water needs for the rows near the shore.
  [[nodiscard]] double step() const { return 0.18 * settings_.spacing / std::sqrt(gravity * settings_.depth); }

 private:
  [[nodiscard]] std::vector<Point> outer_places() const;

  Settings settings_;
  exact::SerreSolitary wave_;
  double reach_;  ///< distance at which the wave is a thousandth of its height
  std::shared_ptr<const SplineBottom> bottom_;
};

/// Highest elevation of the shoreline by the angle from the front of the island, 0 to 180 degrees: of the lines between
/// its markers, at the angles that these have at the beginning.
class RunupEnvelope {
 public:
  explicit RunupEnvelope(const dispersive_shallow_water_2d::Flow& flow);
  /// @param time  since the beginning [s]
  void observe(const dispersive_shallow_water_2d::Flow& flow, double time);
  void observe(const dispersive_shallow_water_2d::Flow& flow) { observe(flow, flow.time()); }
  [[nodiscard]] const std::vector<double>& angle() const { return angle_; }
  [[nodiscard]] std::vector<double> runup() const;
  /// When the water was highest at one of the angles.
  [[nodiscard]] double time(std::size_t number) const { return highest_.at(number).where(); }
  /// Between them.
  [[nodiscard]] double at(double angle) const;

 private:
  [[nodiscard]] static std::vector<double> angles(const dispersive_shallow_water_2d::Flow& flow);

  std::vector<double> angle_;
  std::vector<Largest> highest_;
};

}  // namespace seiche::validation
