#include "seiche/models/overlapping_particles/neighbourhoods.hpp"

#include <algorithm>

namespace seiche::overlapping_particles {

namespace {

/// Of the reach, beyond it: more makes the matrix fuller, less the lists shorter-lived.
constexpr double margin = 0.1;

}  // namespace

bool Neighbourhoods::update(std::span<const double> x, std::span<const double> y, const Walls& walls) {
  if (!begin_.empty()) {
    grid_.sort(x, y, reach_);
    if (listed_pairs(x, y, walls) == pairs_on_grid(x, y, walls)) return false;
  }
  list(x, y, walls);
  return true;
}

long Neighbourhoods::listed_pairs(std::span<const double> x, std::span<const double> y, const Walls& walls) const {
  const double square = reach_ * reach_;
  long pairs = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    each_image({x[k], y[k]}, walls, reach_, [&](Point r) {
      for (auto e = static_cast<std::size_t>(begin_[k]); e < static_cast<std::size_t>(begin_[k + 1]); ++e) {
        const auto s = static_cast<std::size_t>(member_[e]);
        const double dx = r.x - x[s];
        const double dy = r.y - y[s];
        pairs += dx * dx + dy * dy < square ? 1 : 0;
      }
    });
  }
  return pairs;
}

long Neighbourhoods::pairs_on_grid(std::span<const double> x, std::span<const double> y, const Walls& walls) const {
  const double square = reach_ * reach_;
  long pairs = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    each_image({x[k], y[k]}, walls, reach_, [&](Point r) {
      grid_.near(r, [&](int member) {
        const auto s = static_cast<std::size_t>(member);
        const double dx = r.x - x[s];
        const double dy = r.y - y[s];
        pairs += dx * dx + dy * dy < square ? 1 : 0;
      });
    });
  }
  return pairs;
}

void Neighbourhoods::list(std::span<const double> x, std::span<const double> y, const Walls& walls) {
  const double wide = (1 + margin) * reach_;
  const double square = wide * wide;
  grid_.sort(x, y, wide);
  begin_.assign(1, 0);
  member_.clear();
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto self = static_cast<int>(k);
    const std::size_t first = member_.size();
    member_.push_back(self);
    each_image({x[k], y[k]}, walls, wide, [&](Point r) {
      grid_.near(r, [&](int s) {
        const double dx = r.x - x[static_cast<std::size_t>(s)];
        const double dy = r.y - y[static_cast<std::size_t>(s)];
        if (s != self && dx * dx + dy * dy < square) member_.push_back(s);
      });
    });
    const auto neighbours = member_.begin() + static_cast<std::ptrdiff_t>(first) + 1;
    std::sort(neighbours, member_.end());
    member_.erase(std::unique(neighbours, member_.end()), member_.end());
    begin_.push_back(static_cast<int>(member_.size()));
  }
}

}  // namespace seiche::overlapping_particles
