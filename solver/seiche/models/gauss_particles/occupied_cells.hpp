/// Particles sorted by the cell of the lattice they are in.
///
/// Cells follow each other along y within x; the particles of a cell keep their order and stand in places of their own,
/// a multiple of `lanes` of them, so that vectors never straddle two cells. Places without a particle have no mass.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seiche/models/gauss_particles/lattice.hpp"

namespace seiche::gauss_particles {

class OccupiedCells {
 public:
  static constexpr std::size_t lanes = 8;
  static constexpr std::size_t nobody = static_cast<std::size_t>(-1);

  struct Cell {
    long x = 0;              ///< column
    long y = 0;              ///< row
    std::size_t begin = 0;   ///< its first place
    std::size_t places = 0;  ///< a multiple of lanes
    std::size_t count = 0;   ///< particles
    double mass = 0;         ///< [kg/m]
  };

  /// Takes the heights of particles over the ground and returns the rectangle they are in. Throws mechanics::Infeasible
  /// for places that are not finite.
  Bounds survey(const Ground& ground, std::span<const double> x, std::span<const double> y);
  /// Sorts the particles of the last survey; those without mass are markers. A particle beyond a wall counts as on it.
  /// Throws mechanics::Infeasible for a particle nearer than free_margin cells to a free end of the lattice.
  void sort(const Lattice& lattice, std::span<const double> x, std::span<const double> mass);

  [[nodiscard]] std::span<const Cell> cells() const { return cells_; }
  /// Places in the cell, from its middle, in cells: within [-1/2, 1/2].
  [[nodiscard]] const double* across() const { return across_.data(); }
  [[nodiscard]] const double* up() const { return up_.data(); }
  [[nodiscard]] const double* mass() const { return mass_.data(); }  ///< [kg/m]; 0 where there is no particle
  /// b' under the particle; empty over level ground.
  [[nodiscard]] const double* slope() const { return slope_.empty() ? nullptr : slope_.data(); }
  /// The particle of a place, or nobody.
  [[nodiscard]] std::span<const std::size_t> particle() const { return particle_; }

 private:
  void sample(const BottomProfile& profile, std::span<const double> x);
  void locate(const Lattice& lattice, std::span<const double> x);

  std::vector<Cell> cells_;
  std::vector<double> across_, up_, mass_, slope_;
  std::vector<std::size_t> particle_;

  std::vector<double> height_, ground_slope_;     // of particles; no slopes over level ground
  std::vector<double> column_place_, row_place_;  // in cells from the lattice's corner
  std::vector<std::size_t> cell_of_;
  std::vector<std::size_t> count_;  // of a cell of the lattice; then its next place
};

}  // namespace seiche::gauss_particles
