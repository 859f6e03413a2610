#include "seiche/models/overlapping_particles/neighbourhoods.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace seiche::overlapping_particles {

namespace {

constexpr double cells_per_particle = 4;
constexpr double some_cells = 64;

long cell_at(double place, double begin, double cell, long cells) {
  const double s = std::floor((place - begin) / cell);
  return static_cast<long>(std::clamp(s, 0.0, static_cast<double>(cells - 1)));
}

/// Of the reach, beyond it: more makes the matrix fuller, less the lists shorter-lived.
constexpr double margin = 0.1;

}  // namespace

long CellGrid::column_of(double x) const {
  return cell_at(x, x0_, cell_, columns_);
}

long CellGrid::row_of(double y) const {
  return cell_at(y, y0_, cell_, rows_);
}

void CellGrid::sort(std::span<const double> x, std::span<const double> y, double reach) {
  const auto [left, right] = std::minmax_element(x.begin(), x.end());
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  const double width = *right - *left;
  const double height = *high - *low;
  x0_ = *left;
  y0_ = *low;
  cell_ = reach;
  const double most = cells_per_particle * static_cast<double>(x.size()) + some_cells;
  while ((std::floor(width / cell_) + 1) * (std::floor(height / cell_) + 1) > most) cell_ *= 2;
  columns_ = static_cast<long>(width / cell_) + 1;
  rows_ = static_cast<long>(height / cell_) + 1;

  begin_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  cell_of_.resize(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    cell_of_[k] = row_of(y[k]) * columns_ + column_of(x[k]);
    ++begin_[static_cast<std::size_t>(cell_of_[k])];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  particle_.resize(x.size());
  // From the last particle on, each cell is filled from its end, which becomes its beginning.
  for (std::size_t k = x.size(); k-- > 0;) {
    particle_[static_cast<std::size_t>(--begin_[static_cast<std::size_t>(cell_of_[k])])] = static_cast<int>(k);
  }
}

bool Neighbourhoods::update(std::span<const double> x, std::span<const double> y, const Walls& walls) {
  if (!begin_.empty()) {
    grid_.sort(x, y, reach_);
    if (complete(x, y, walls)) return false;
  }
  list(x, y, walls);
  return true;
}

/// Whether the lists hold as many pairs within the reach as there are.
bool Neighbourhoods::complete(std::span<const double> x, std::span<const double> y, const Walls& walls) const {
  const double square = reach_ * reach_;
  long missing = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    each_image({x[k], y[k]}, walls, reach_, [&](Point r) {
      const auto within = [&](int member) {
        const auto s = static_cast<std::size_t>(member);
        const double dx = r.x - x[s];
        const double dy = r.y - y[s];
        return dx * dx + dy * dy < square ? 1 : 0;
      };
      grid_.near(r, [&](int s) { missing += within(s); });
      for (int e = begin_[k]; e < begin_[k + 1]; ++e) missing -= within(member_[static_cast<std::size_t>(e)]);
    });
  }
  return missing == 0;
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
