#include "seiche/models/overlapping_particles/walls.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::overlapping_particles {

namespace {

/// Of unit normals, for walls that are given by rounded numbers.
constexpr double aligned = 1e-12;

double product(Point a, Point b) {
  return a.x * b.x + a.y * b.y;
}

Image reflection(const Wall& wall, int number) {
  const auto [nx, ny] = wall.normal;
  const double twice = 2 * product(wall.through, wall.normal);
  return {1 - 2 * nx * nx, -2 * nx * ny, 1 - 2 * ny * ny, {twice * nx, twice * ny}, number, number};
}

/// About walls at right angles: the same in either order.
Image both(const Image& a, const Image& b) {
  return {-1, 0, -1, {a.offset.x + b.offset.x, a.offset.y + b.offset.y}, a.one, b.one};
}

}  // namespace

Walls::Walls(std::vector<Wall> walls, double reach) : walls_(std::move(walls)) {
  int number = 0;
  for (Wall& wall : walls_) {
    require_finite(fmt::format("through.x of wall {}", number), wall.through.x);
    require_finite(fmt::format("through.y of wall {}", number), wall.through.y);
    const double length = std::hypot(wall.normal.x, wall.normal.y);
    require_positive(fmt::format("length of the normal of wall {}", number), length);
    wall.normal = {wall.normal.x / length, wall.normal.y / length};
    images_.push_back(reflection(wall, number++));
  }
  for (int one = 0; one < number; ++one) {
    for (int other = one + 1; other < number; ++other) {
      const Point n = walls_[static_cast<std::size_t>(one)].normal;
      const Point m = walls_[static_cast<std::size_t>(other)].normal;
      if (std::abs(product(n, m)) < aligned) {
        images_.push_back(both(images_[static_cast<std::size_t>(one)], images_[static_cast<std::size_t>(other)]));
      } else if (product(n, m) < -1 + aligned) {
        require_apart(one, other, reach);
      } else {
        throw std::invalid_argument(fmt::format(
            "walls {} and {} have normals ({:g}, {:g}) and ({:g}, {:g}); allowed: opposite, or at right angles", one,
            other, n.x, n.y, m.x, m.y));
      }
    }
  }
}

void Walls::require_apart(int one, int other, double reach) const {
  const double gap = distance(one, walls_[static_cast<std::size_t>(other)].through);
  require_that(gap >= reach, "walls {} and {} are {:g} apart; allowed: at least the support {:g}", one, other, gap,
               reach);
}

double Walls::distance(int wall, Point r) const {
  const Wall& w = walls_[static_cast<std::size_t>(wall)];
  return product({r.x - w.through.x, r.y - w.through.y}, w.normal);
}

int Walls::behind(Point r) const {
  for (int wall = 0; wall < static_cast<int>(walls_.size()); ++wall) {
    if (!(distance(wall, r) > 0)) return wall;
  }
  return -1;
}

}  // namespace seiche::overlapping_particles
