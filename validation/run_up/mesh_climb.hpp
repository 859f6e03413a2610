/// A solitary wave of the Euler equations climbs a vertical wall or a plane slope on the two-dimensional Lagrangian
/// mesh.
///
/// Units: depth and gravity are 1, y counts from still water. A wall is at x = 0; its tank ends at x = -24, and the
/// crest starts in its middle. The tank before a slope begins at x = 0.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "seiche/exact/solitary_wave.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/case/parameter.hpp"
#include "validation/instruments/mesh/mesh_gauges.hpp"

namespace seiche::validation {

struct MeshClimb {
  static constexpr double distance = 12;  ///< of the crest from a wall at the start

  exact::SolitaryWave wave;
  double tan_slope = 0;   ///< 0: a vertical wall
  double spacing = 0.25;  ///< of columns
  long rows = 8;
  double tau = 0.025;
  mechanics::Stepping stepping = mechanics::Stepping::one_step;
  lagrangian_mesh_2d::Settings settings = {};
  /// Farthest that nodes may be from upright columns, in cells, before the mesh is rezoned; 0: never.
  double rezone = 0;

  /// At a wall: width of the columns there over the spacing; the change is spread over two depths.
  double wall_columns = 1;
  /// At a wall: starts by an impulse at the surface (impulsive_start.hpp), not with the wave's velocities at the nodes.
  bool surface_impulse = false;

  double crest = 12;  ///< before a slope, at the start
  double toe = 24;    ///< of a slope
  /// Length of bottom and of slope that an arc at the toe replaces, over the columns' width; 0: the toe's node stays.
  double rounding = 0;
  /// On a slope: go on when cells tangle. Their areas stay right, and the bottom's nodes may pass the toe.
  bool beyond_tangling = true;

  /// h1 = 2 h2 and tau = h1/10, as Frank has it.
  static MeshClimb with_rows(const exact::SolitaryWave& wave, long rows);
  /// The same with `times` as many rows, columns and steps.
  [[nodiscard]] MeshClimb refined(double times) const;
  [[nodiscard]] bool wall() const { return tan_slope == 0; }
  [[nodiscard]] lagrangian_mesh_2d::Flow start() const;
  /// "h1 = 0.25, 8 rows, tau = 0.025".
  [[nodiscard]] std::string resolution() const;
};

/// Largest values, between steps from the parabola through three; the loads of a wall while the wave is there.
struct ClimbMaxima {
  double level = std::numeric_limits<double>::quiet_NaN();   ///< of the contact point
  double still = std::numeric_limits<double>::quiet_NaN();   ///< pressure at y = 0
  double bottom = std::numeric_limits<double>::quiet_NaN();  ///< pressure at y = -1
  double force = std::numeric_limits<double>::quiet_NaN();   ///< per unit width, hydrostatic pressure included
};

/// The loads, with their columns in the table of exact values.
struct LoadMaximum {
  std::string id, column, name, unit;
  double ClimbMaxima::*of;
  bool converges;  ///< by a power of the mesh
};
inline const std::vector<LoadMaximum> load_maxima{
    {"still", "p_still", "pressure at y = 0", "rho g depth", &ClimbMaxima::still, false},
    {"bottom", "p_bottom", "pressure at the bottom", "rho g depth", &ClimbMaxima::bottom, true},
    {"force", "F", "force", "rho g depth^2", &ClimbMaxima::force, true}};

struct MeshRun {
  lagrangian_mesh_2d::Flow flow;                ///< at the end, or before the step in which the mesh tangled at a wall
  std::vector<double> times = {}, levels = {};  ///< of the contact point, after every step
  std::vector<WallLoad> loads = {};             ///< of a wall, step by step
  ClimbMaxima highest = {};
  double time_of_highest = 0;          ///< level
  bool fell = false;                   ///< the water fell after that: it was the maximum
  std::vector<double> x = {}, y = {};  ///< nodes, after the step in which the contact point was highest
  Worst energy_defect;                 ///< largest change over the wave's energy until then, with its time
  Smallest worst_shape;                ///< of the mesh's corners (Flow::worst_corner) until then
  struct Tangle {
    double time = 0;
    double place = 0;

    /// "t = 12.34, x = -0.10".
    [[nodiscard]] std::string where() const;
  };
  std::optional<Tangle> tangle = {};  ///< the first

  /// NaN unless the water fell after its highest.
  [[nodiscard]] ClimbMaxima reached() const { return fell ? highest : ClimbMaxima{}; }
  [[nodiscard]] double runup() const { return reached().level; }
};

/// At a wall until the crest would be as far behind it as half its distance at the start, or until the mesh tangles; on
/// a slope until the contact point has fallen to 0.98 of its highest. Throws Divergence on a slope.
MeshRun climb_on_mesh(const MeshClimb& climb,
                      const std::function<void(const lagrangian_mesh_2d::Flow&)>& after_step = {});

/// h1, rows, tau, and those of the method.
std::vector<Parameter> mesh_parameters(ByTier<double> spacing, ByTier<long> rows, ByTier<double> tau);
/// scheme, hourglass.
std::vector<Parameter> mesh_method_parameters();
MeshClimb mesh_climb_from(const Values& values, const exact::SolitaryWave& wave);

}  // namespace seiche::validation
