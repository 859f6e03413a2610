/// A solitary wave of the Euler equations climbs a plane slope or a wall, by free particles under Gauss's principle.
///
/// Units: depth and gravity are 1, y counts from still water. The tank begins at x = 0. Wave, room behind it and way to
/// the toe or the wall: at toe and end less than 0.4 % of the wave's height is cut off.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/samples.hpp"

namespace seiche::validation {

struct GaussClimb {
  exact::SolitaryWave wave;
  double cot_slope = 0;  ///< 0: a vertical wall
  long cells = 4;        ///< to a depth
  long per_cell = 12;    ///< particles to a cell's side

  [[nodiscard]] double spacing() const { return 1 / static_cast<double>(cells); }
  [[nodiscard]] double crest() const;  ///< place at the start
  [[nodiscard]] double toe() const { return 2 * crest(); }
  /// b(x), with the corner at the toe rounded over a quarter of the depth on either side, so that b'' is continuous.
  [[nodiscard]] double bottom(double x) const;
  [[nodiscard]] double bottom_slope(double x) const;
  [[nodiscard]] double tau() const;
  [[nodiscard]] gauss_particles::Flow start() const;
  /// "4 cells to a depth, 12 particles to a side".
  [[nodiscard]] std::string resolution() const;
};

/// Water near the shore at one time.
struct GaussFrame {
  double time = 0;
  std::vector<double> x, y, u, v;      ///< particles
  std::vector<double> line_x, line_y;  ///< markers
};
void add_frame(evidence::Exhibit& exhibit, const GaussFrame& frame);

struct GaussClimbRun {
  double highest = 0;  ///< marker beyond the toe, or at the wall
  double time = 0;     ///< since the start
  bool fell = false;   ///< the water fell after that: it was the maximum
  std::vector<double> times, levels;
  GaussFrame at_highest, at_end;
  double wave_energy = 1;     ///< that the run began with
  double energy_defect = 0;   ///< largest after booking what the penalty took, over the wave's energy
  double penalty_loss = 0;    ///< over the wave's energy
  double beyond = 0;          ///< farthest place of a particle behind bottom and walls, after any step
  double free_particles = 0;  ///< most of them in any step
  double particles = 0;
  long steps = 0;

  /// NaN unless the water fell after its highest.
  [[nodiscard]] double runup() const { return fell ? highest : std::numeric_limits<double>::quiet_NaN(); }
};

/// Runs until the edge has fallen by 2 % of its highest.
GaussClimbRun climb(const GaussClimb& climb);

}  // namespace seiche::validation
