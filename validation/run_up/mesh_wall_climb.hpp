/// A solitary wave of the Euler equations climbs a vertical wall on the two-dimensional Lagrangian mesh.
///
/// Units: depth and gravity are 1, y counts from still water. The wall is at x = 0; the tank ends at x = -24, and the
/// crest starts in its middle.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "seiche/exact/solitary_wave.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/case/parameter.hpp"

namespace seiche::validation {

struct MeshWallClimb {
  static constexpr double distance = 12;  ///< of the crest from the wall at the start

  exact::SolitaryWave wave;
  double spacing = 0.25;  ///< of columns
  long rows = 8;
  double tau = 0.025;
  mechanics::Stepping stepping = mechanics::Stepping::one_step;
  lagrangian_mesh_2d::Settings settings = {};
  /// Width of the columns at the wall over the spacing; the change is spread over two depths.
  double wall_columns = 1;
  /// Farthest that nodes may be from upright columns, in cells, before the mesh is rezoned; 0: never.
  double rezone = 0;
  /// Starts by an impulse at the surface (impulsive_start.hpp), not with the wave's velocities at the nodes.
  bool surface_impulse = false;

  /// h1 = 2 h2 and tau = h1/10, as Frank has it.
  static MeshWallClimb with_rows(const exact::SolitaryWave& wave, long rows);
  /// The same with `times` as many rows, columns and steps.
  [[nodiscard]] MeshWallClimb refined(double times) const;
  [[nodiscard]] lagrangian_mesh_2d::Flow start() const;
  /// When the crest would be as far behind the wall as half its distance at the start.
  [[nodiscard]] double end() const { return 1.5 * distance / wave.speed(); }
  /// "h1 = 0.25, 8 rows, tau = 0.025".
  [[nodiscard]] std::string resolution() const;
};

/// The largest values while the wave is at the wall, between steps from the parabola through three.
struct MeshWallRun {
  lagrangian_mesh_2d::Flow flow;  ///< at the end, or before the step in which the mesh tangled
  double highest = 0;             ///< the contact point
  double time_of_runup = 0;
  bool fell = false;           ///< the water fell after that: it was the maximum
  double pressure_still = 0;   ///< at y = 0
  double pressure_bottom = 0;  ///< at y = -1
  double force = 0;            ///< per unit width, hydrostatic pressure included
  Smallest worst_shape;        ///< of the mesh's corners (Flow::worst_corner) up to the largest run-up
  Worst energy_defect;         ///< largest change over the wave's energy, with its time
  Worst climb_energy_defect;   ///< up to the largest run-up
  struct Tangle {
    double time = 0;
    double place = 0;
    std::string what;
  };
  std::optional<Tangle> tangle = {};

  /// NaN unless the water fell after its highest.
  [[nodiscard]] double runup() const { return fell ? highest : std::numeric_limits<double>::quiet_NaN(); }
};

/// Runs until the crest would be as far behind the wall as half its distance at the start, or until the mesh tangles.
MeshWallRun climb_wall(const MeshWallClimb& climb,
                       const std::function<void(const lagrangian_mesh_2d::Flow&)>& after_step = {});

/// h1, rows, tau, scheme, hourglass.
std::vector<Parameter> mesh_parameters(ByTier<double> spacing, ByTier<long> rows, ByTier<double> tau);
MeshWallClimb mesh_climb_from(const Values& values, const exact::SolitaryWave& wave);

}  // namespace seiche::validation
