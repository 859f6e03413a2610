#include "seiche/models/overlapping_particles/particles.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::overlapping_particles {

using std::numbers::pi;

Shape shape_named(std::string_view name) {
  return value_named<Shape>("shape", name, {{"smoothed", Shape::smoothed}, {"ball", Shape::ball}});
}

Kernel::Kernel(Shape shape, double support) : shape_(shape), support_(support) {
  require_positive("support", support);
  const double square = pi * support * support;
  if (shape == Shape::smoothed) {
    value_scale_ = 7 / square;
    slope_scale_ = -140 / (square * support * support);
  } else {
    value_scale_ = 2 / pi;
    slope_scale_ = -4 / (pi * support);
  }
}

double Kernel::value(double distance) const {
  const double q = distance / support_;
  if (!(q < 1)) return 0;
  if (shape_ == Shape::ball) return value_scale_ * (std::acos(q) - q * std::sqrt(1 - q * q));
  const double rest = (1 - q) * (1 - q);
  return value_scale_ * rest * rest * (1 + 4 * q);
}

double Kernel::slope_over_distance(double distance) const {
  const double q = distance / support_;
  if (shape_ == Shape::ball) return slope_scale_ * std::sqrt(1 - q * q) / distance;
  const double rest = 1 - q;
  return slope_scale_ * rest * rest * rest;
}

namespace {

constexpr double most_places = 1e7;
/// Of a length: places that are on the rim but for rounding are on it.
constexpr double rim = 1e-12;

}  // namespace

void Particles::require_valid() const {
  require_that(y.size() == size() && mass.size() == size(),
               "particles: {} x, {} y and {} masses; allowed: as many of each", size(), y.size(), mass.size());
  require_that(size() >= 3, "{} particles; allowed: at least 3", size());
  require_positive("spacing", spacing);
  for (std::size_t k = 0; k < size(); ++k) {
    require_finite(fmt::format("x of particle {}", k), x[k]);
    require_finite(fmt::format("y of particle {}", k), y[k]);
    require_positive(fmt::format("mass of particle {}", k), mass[k]);
  }
}

Particles staggered(const Rows& rows) {
  const double h = rows.spacing;
  require_positive("spacing", h);
  require_positive("density", rows.density);
  require_positive("upper.x - lower.x", rows.upper.x - rows.lower.x);
  require_positive("upper.y - lower.y", rows.upper.y - rows.lower.y);
  const double height = h * std::numbers::sqrt3 / 2;
  const double places = (rows.upper.x - rows.lower.x) / h * ((rows.upper.y - rows.lower.y) / height);
  require_that(places <= most_places, "spacing = {:g} makes {:g} places; allowed: at most {:g}", h, places,
               most_places);
  Particles particles{.x = {}, .y = {}, .mass = {}, .spacing = h};
  const auto first = std::lround(std::ceil((rows.lower.y - rows.through.y) / height - rim));
  const auto last = std::lround(std::floor((rows.upper.y - rows.through.y) / height + rim));
  for (long j = first; j <= last; ++j) {
    const double shift = j % 2 == 0 ? 0 : 0.5;
    const auto begin = std::lround(std::ceil((rows.lower.x - rows.through.x) / h - shift - rim));
    const auto end = std::lround(std::floor((rows.upper.x - rows.through.x) / h - shift + rim));
    for (long i = begin; i <= end; ++i) {
      const Point place{rows.through.x + (static_cast<double>(i) + shift) * h,
                        rows.through.y + static_cast<double>(j) * height};
      if (rows.inside && !rows.inside(place)) continue;
      particles.x.push_back(place.x);
      particles.y.push_back(place.y);
      particles.mass.push_back(rows.density * h * height);
    }
  }
  return particles;
}

Particles staggered_disc(double radius, double spacing, double density) {
  require_positive("radius", radius);
  const auto inside = [&](Point r) {
    const double distance = std::hypot(r.x, r.y) / radius;
    return distance < 1 - rim || (distance < 1 + rim && r.y != 0);
  };
  Particles particles = staggered({.spacing = spacing,
                                   .lower = {-radius, -radius},
                                   .upper = {radius, radius},
                                   .through = {0, 0},
                                   .density = density,
                                   .inside = inside});
  const double share = density * std::numbers::pi * radius * radius / static_cast<double>(particles.size());
  particles.mass.assign(particles.size(), share);
  return particles;
}

namespace {

/// Of unit normals, for walls that are given by rounded numbers.
constexpr double aligned = 1e-12;

Image reflection(const Wall& wall, int number) {
  const auto [nx, ny] = wall.normal;
  const double twice = 2 * dot(wall.through, wall.normal);
  return {1 - 2 * nx * nx, -2 * nx * ny, 1 - 2 * ny * ny, twice * wall.normal, number, number};
}

/// About walls at right angles: the same in either order.
Image both(const Image& a, const Image& b) {
  return {-1, 0, -1, a.offset + b.offset, a.one, b.one};
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
      if (std::abs(dot(n, m)) < aligned) {
        images_.push_back(both(images_[static_cast<std::size_t>(one)], images_[static_cast<std::size_t>(other)]));
      } else if (dot(n, m) < -1 + aligned) {
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
  return dot(r - w.through, w.normal);
}

int Walls::behind(Point r) const {
  for (int wall = 0; wall < static_cast<int>(walls_.size()); ++wall) {
    if (!(distance(wall, r) > 0)) return wall;
  }
  return -1;
}

}  // namespace seiche::overlapping_particles
