#include "seiche/models/wcsph/tile_grid.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::wcsph {
namespace {

/// Beyond it the rest counts to the edge; keeps indices within 32 bits.
constexpr double most_bins_across = 20000;

std::int32_t clamped(double place, std::int32_t count) {
  return static_cast<std::int32_t>(std::clamp(place, 0.0, static_cast<double>(count - 1)));
}

}  // namespace

TileGrid::TileGrid(const Box& box, double spacing)
    : left_(box.left), bottom_(box.bottom), per_bin_(1 / spacing), per_strip_(1 / (strip_height * spacing)) {
  const double columns = std::min((box.right - box.left) * per_bin_, most_bins_across);
  const double rows = std::min((box.top - box.bottom) * per_strip_, most_bins_across);
  tiles_ = 1 + static_cast<std::int32_t>(columns) / bins_per_tile;
  strips_ = 1 + static_cast<std::int32_t>(rows);
}

std::int32_t TileGrid::column(double x) const {
  return clamped((x - left_) * per_bin_, tiles_ * bins_per_tile);
}

std::int32_t TileGrid::strip(double z) const {
  return clamped((z - bottom_) * per_strip_, strips_);
}

std::int32_t TileGrid::bin(double x, double z) const {
  const std::int32_t c = column(x);
  const std::int32_t k = strip(z);
  const std::int32_t tile = c / bins_per_tile;
  const std::int32_t within = c - tile * bins_per_tile;
  return (tile * strips_ + k) * bins_per_tile + (k % 2 == 0 ? within : bins_per_tile - 1 - within);
}

void BinnedOrder::sort(const TileGrid& grid, std::span<const double> x, std::span<const double> z,
                       std::span<const std::int32_t> members, std::span<std::int32_t> order) {
  size_ = members.size();
  begin_.clear();
  if (size_ == 0) return;
  begin_.assign(static_cast<std::size_t>(grid.size()) + 1, 0);
  std::vector<std::int32_t> bins(size_);
  for (std::size_t k = 0; k < size_; ++k) {
    const auto i = static_cast<std::size_t>(members[k]);
    bins[k] = grid.bin(x[i], z[i]);
    ++begin_[static_cast<std::size_t>(bins[k])];
  }
  // Ends of bins; placing from the back turns them into beginnings.
  std::int32_t total = 0;
  for (std::int32_t& bin : begin_) bin = total += bin;
  for (std::size_t k = size_; k-- > 0;) {
    order[static_cast<std::size_t>(--begin_[static_cast<std::size_t>(bins[k])])] = members[k];
  }
  for (std::int32_t bin = 0; bin < grid.size(); ++bin) {
    const auto first = begin_[static_cast<std::size_t>(bin)];
    const auto last = begin_[static_cast<std::size_t>(bin) + 1];
    if (last - first < 2) continue;
    const double sign = grid.backwards(bin) ? -1 : 1;
    for (std::int32_t k = first + 1; k < last; ++k) {
      const std::int32_t moving = order[static_cast<std::size_t>(k)];
      const double place = sign * x[static_cast<std::size_t>(moving)];
      std::int32_t to = k;
      for (; to > first; --to) {
        const std::int32_t before = order[static_cast<std::size_t>(to - 1)];
        if (!(place < sign * x[static_cast<std::size_t>(before)])) break;
        order[static_cast<std::size_t>(to)] = before;
      }
      order[static_cast<std::size_t>(to)] = moving;
    }
  }
}

}  // namespace seiche::wcsph
