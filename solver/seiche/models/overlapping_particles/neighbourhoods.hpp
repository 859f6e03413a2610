/// For every particle the control volumes that it or one of its images lies in: itself first, then its neighbours.
///
/// The lists hold neighbours up to a little beyond the reach, and stay as they are while they hold all within it: what
/// is analysed for them, the pattern of a matrix, then serves for some steps. Whether they do is found out each time,
/// by counting the pairs in reach in the lists and on a cell grid.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "seiche/geometry/curve.hpp"
#include "seiche/models/overlapping_particles/particles.hpp"

namespace seiche::overlapping_particles {

/// Particles sorted into the cells of a uniform grid, to find those near a place.
///
/// Cells are as wide as the reach of a search, which then visits three by three of them; wider where that would make
/// many more cells than particles. Sorted by counting; particles of a cell keep their order.
class CellGrid {
 public:
  /// @param reach  of searches, positive. Places must be finite.
  void sort(std::span<const double> x, std::span<const double> y, double reach);

  /// Calls visit(k) for every particle k in the cells that a circle of the reach about `place` may touch: all that are
  /// nearer, and others.
  template <class Visit>
  void near(Point place, Visit&& visit) const {
    const long column = column_of(place.x);
    const long row = row_of(place.y);
    for (long j = std::max(0L, row - 1); j <= std::min(rows_ - 1, row + 1); ++j) {
      // The cells of a row follow each other.
      const long left = j * columns_ + std::max(0L, column - 1);
      const long right = j * columns_ + std::min(columns_ - 1, column + 1);
      for (int e = begin_[static_cast<std::size_t>(left)]; e < begin_[static_cast<std::size_t>(right) + 1]; ++e) {
        visit(particle_[static_cast<std::size_t>(e)]);
      }
    }
  }

 private:
  /// Places beyond the grid count as in its outermost cells: nothing is further out.
  [[nodiscard]] long column_of(double x) const;
  [[nodiscard]] long row_of(double y) const;

  double x0_ = 0, y0_ = 0;
  double cell_ = 1;
  long columns_ = 0, rows_ = 0;
  std::vector<int> begin_;  // of the cells, among the particles in their order
  std::vector<int> particle_;
  std::vector<long> cell_of_;
};

class Neighbourhoods {
 public:
  /// @param reach  of control volumes, S
  explicit Neighbourhoods(double reach) : reach_(reach) {}

  /// Looks at these places. Returns whether the lists had to be made anew.
  bool update(std::span<const double> x, std::span<const double> y, const Walls& walls);

  /// Members begin()[k] to begin()[k + 1] - 1 are those of particle k: k itself, then neighbours in rising order.
  [[nodiscard]] std::span<const int> begin() const { return begin_; }
  [[nodiscard]] std::span<const int> members() const { return member_; }

 private:
  [[nodiscard]] bool complete(std::span<const double> x, std::span<const double> y, const Walls& walls) const;
  void list(std::span<const double> x, std::span<const double> y, const Walls& walls);

  double reach_;
  CellGrid grid_;
  std::vector<int> begin_, member_;
};

}  // namespace seiche::overlapping_particles
