/// For every particle the control volumes that it or one of its images lies in: itself first, then its neighbours.
///
/// The lists hold neighbours up to a little beyond the reach, and stay as they are while they hold all within it: what
/// is analysed for them, the pattern of a matrix, then serves for some steps. Whether they do is found out each time,
/// by counting the pairs in reach in the lists and on a cell grid.
#pragma once

#include <span>
#include <vector>

#include "seiche/models/overlapping_particles/cell_grid.hpp"
#include "seiche/models/overlapping_particles/walls.hpp"

namespace seiche::overlapping_particles {

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
  [[nodiscard]] long listed_pairs(std::span<const double> x, std::span<const double> y, const Walls& walls) const;
  [[nodiscard]] long pairs_on_grid(std::span<const double> x, std::span<const double> y, const Walls& walls) const;
  void list(std::span<const double> x, std::span<const double> y, const Walls& walls);

  double reach_;
  CellGrid grid_;
  std::vector<int> begin_, member_;
};

}  // namespace seiche::overlapping_particles
