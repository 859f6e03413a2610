/// Order of particles in the plane: tiles of strips of bins; internal to Flow.
///
/// A strip is a few particle spacings high, a bin one spacing wide. Within a strip particles go by x, in every second
/// strip backwards, so that consecutive ones stay near each other across its ends; strips are cut into tiles, so that
/// neighbours above and below stay in cache however long the tank. What lies outside the box counts to its edge:
/// neighbouring places stay neighbours.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "seiche/models/wcsph/lattice.hpp"

namespace seiche::wcsph {

class TileGrid {
 public:
  TileGrid() = default;
  TileGrid(const Box& box, double spacing);

  [[nodiscard]] std::int32_t size() const { return tiles_ * strips_ * bins_per_tile; }
  [[nodiscard]] std::int32_t bin(double x, double z) const;
  /// Whether particles of this bin go by decreasing x.
  [[nodiscard]] bool backwards(std::int32_t bin) const { return (bin / bins_per_tile) % strips_ % 2 != 0; }

  /// Calls visit(first, last) with the bins that the box touches, as few runs of consecutive ones.
  template <class Visit>
  void visit_runs(const Box& box, Visit visit) const {
    const std::int32_t left = column(box.left);
    const std::int32_t right = column(box.right);
    const std::int32_t bottom = strip(box.bottom);
    const std::int32_t top = strip(box.top);
    for (std::int32_t tile = left / bins_per_tile; tile <= right / bins_per_tile; ++tile) {
      const std::int32_t begin = tile * bins_per_tile;
      const std::int32_t low = left > begin ? left - begin : 0;
      const std::int32_t high = right - begin < bins_per_tile ? right - begin : bins_per_tile - 1;
      for (std::int32_t k = bottom; k <= top; ++k) {
        const std::int32_t base = (tile * strips_ + k) * bins_per_tile;
        if (k % 2 == 0) {
          visit(base + low, base + high);
        } else {
          visit(base + bins_per_tile - 1 - high, base + bins_per_tile - 1 - low);
        }
      }
    }
  }

 private:
  static constexpr std::int32_t bins_per_tile = 64;
  /// In spacings: eight particles fill about a square.
  static constexpr double strip_height = 3;

  [[nodiscard]] std::int32_t column(double x) const;
  [[nodiscard]] std::int32_t strip(double z) const;

  double left_ = 0;
  double bottom_ = 0;
  double per_bin_ = 0;
  double per_strip_ = 0;
  std::int32_t tiles_ = 0;
  std::int32_t strips_ = 0;
};

/// Where each bin begins among particles of one kind in the order of a grid.
class BinnedOrder {
 public:
  /// Writes the members in their new order. Stable: particles in the same place keep theirs.
  void sort(const TileGrid& grid, std::span<const double> x, std::span<const double> z,
            std::span<const std::int32_t> members, std::span<std::int32_t> order);
  /// Place in the order of the first particle of a bin.
  [[nodiscard]] std::int32_t begin(std::int32_t bin) const { return begin_[static_cast<std::size_t>(bin)]; }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Gives back the memory of the bins, of which an empty tank has many, until the next sorting.
  void release() { std::vector<std::int32_t>().swap(begin_); }

 private:
  std::size_t size_ = 0;
  std::vector<std::int32_t> begin_;
};

}  // namespace seiche::wcsph
