#include "seiche/models/overlapping_particles/kernel.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"

namespace seiche::overlapping_particles {

using std::numbers::pi;

Shape shape_named(std::string_view name) {
  if (name == "smoothed") return Shape::smoothed;
  if (name == "ball") return Shape::ball;
  throw std::invalid_argument(fmt::format("shape = \"{}\"; allowed: smoothed, ball", name));
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

}  // namespace seiche::overlapping_particles
