#include "seiche/models/dispersive_shallow_water_2d/drag.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "seiche/require.hpp"

namespace seiche::dispersive_shallow_water_2d {

namespace {

/// Inverse mass of a node along a horizontal direction.
double inverse_along(const InverseMasses& inverse, std::size_t k, Point t) {
  return inverse.xx[k] * t.x * t.x + 2 * inverse.xy[k] * t.x * t.y + inverse.yy[k] * t.y * t.y;
}

}  // namespace

Drag::Drag(DragSettings settings, const Lattice& lattice, double inertia)
    : settings_(settings), shape_(lattice.shape), breaking_(settings.breaking_slope, inertia, lattice.shape) {
  require_not_negative("manning", settings.manning);
  require_not_negative("shore_rate", settings.shore_rate);
  require_not_negative("lattice_rate", settings.lattice_rate);
  require_not_negative("breaking_slope", settings.breaking_slope);
  if (settings.shore_rate > 0 && !std::holds_alternative<plan_lattice::ShoreSide>(lattice.sides.south)) {
    throw std::invalid_argument("shore_rate without a shoreline on the south side; allowed: 0");
  }
  if (settings.absorption) {
    for (std::size_t k = 0; k < lattice.shape.nodes(); ++k) {
      absorption_.push_back(settings.absorption({lattice.x[k], lattice.y[k]}));
      require_not_negative("absorption", absorption_.back());
    }
  }
}

void Drag::measure(const Lattice& lattice, std::span<const double> volumes, mechanics::Input q, bool new_step) {
  const std::size_t n = lattice.shape.nodes();
  if (settings_.manning > 0) {
    depth_.assign(n, 0.0);
    area_.assign(n, 0.0);
    for (std::size_t cell = 0; cell < lattice.shape.cells(); ++cell) {
      const double area = cell_area(lattice.shape, q, cell);
      for (const std::size_t k : lattice.shape.corners(cell)) {
        depth_[k] += volumes[cell];
        area_[k] += area;
      }
    }
    for (std::size_t k = 0; k < n; ++k) depth_[k] /= area_[k];
  }
  if (settings_.shore_rate > 0) {
    along_.resize(shape_.columns + 1);
    for (std::size_t i = 1; i < shape_.columns; ++i) {
      const Point chord{q[i + 1] - q[i - 1], q[n + i + 1] - q[n + i - 1]};
      const double length = std::hypot(chord.x, chord.y);
      along_[i] = {chord.x / length, chord.y / length};
    }
  }
  if (settings_.breaking_slope > 0 && new_step) breaking_.measure(volumes, q);
}

void Drag::slow(std::span<const double> masses, const InverseMasses& inverse, double gravity, double h,
                mechanics::Output u) const {
  const std::size_t n = masses.size();
  if (settings_.manning > 0) {
    for (std::size_t k = 0; k < n; ++k) {
      const double rate =
          gravity * settings_.manning * settings_.manning * std::hypot(u[k], u[n + k]) / std::pow(depth_[k], 4.0 / 3);
      const double lost = -masses[k] * h * rate / (1 + h * rate);
      push(inverse, k, {lost * u[k], lost * u[n + k]}, u);
    }
  }
  if (settings_.shore_rate > 0) {
    // Between the ends, which lie on walls.
    for (std::size_t i = 1; i < shape_.columns; ++i) {
      const std::size_t beside = i + shape_.columns + 1;
      const Point t = along_[i];
      const double difference = (u[i] - u[beside]) * t.x + (u[n + i] - u[n + beside]) * t.y;
      const double part = h * settings_.shore_rate / (1 + h * settings_.shore_rate);
      const double impulse = part * difference / (inverse_along(inverse, i, t) + inverse_along(inverse, beside, t));
      push(inverse, i, {-impulse * t.x, -impulse * t.y}, u);
      push(inverse, beside, {impulse * t.x, impulse * t.y}, u);
    }
  }
  if (settings_.lattice_rate > 0) slow_pattern(masses, inverse, h, u);
  if (settings_.breaking_slope > 0) breaking_.exchange(masses, inverse, gravity, h, u);
}

void Drag::absorb(double h, mechanics::Output u) const {
  const std::size_t n = u.size() / 3;
  for (std::size_t k = 0; k < absorption_.size(); ++k) {
    const double left = 1 / (1 + h * absorption_[k]);
    for (std::size_t axis = 0; axis < 3; ++axis) u[axis * n + k] *= left;
  }
}

// All pairs of neighbouring cells at once, each so much that what a node gets from all of them takes energy: by the
// largest of its nodes' sums of |weight| |weights| / (mass lightness), Gershgorin's bound of the pairs' sum.
void Drag::slow_pattern(std::span<const double> masses, const InverseMasses& inverse, double h,
                        mechanics::Output u) const {
  constexpr std::array along_pair{1.0, -2.0, 1.0};
  constexpr std::array across_pair{1.0, -1.0};
  constexpr double weights = 8;  // sum of |weight|
  const std::size_t n = masses.size();
  // The whole pattern sees its nodes in six pairs along each direction, 32/3 times what one pair does.
  const double part = 3.0 / 32 * h * settings_.lattice_rate;
  const auto in_pair = [&](std::size_t first, std::size_t along, std::size_t across, const auto& act) {
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 2; ++b) act(first + a * along + b * across, along_pair[a] * across_pair[b]);
    }
  };
  const auto in_pairs = [&](const auto& act) {
    for (std::size_t j = 0; j < shape_.rows; ++j) {
      for (std::size_t i = 0; i + 1 < shape_.columns; ++i) act(shape_.node(i, j), 1, shape_.columns + 1);
    }
    for (std::size_t j = 0; j + 1 < shape_.rows; ++j) {
      for (std::size_t i = 0; i < shape_.columns; ++i) act(shape_.node(i, j), shape_.columns + 1, 1);
    }
  };
  const auto lightness_of = [&](std::size_t first, std::size_t along, std::size_t across) {
    double lightness = 0;
    in_pair(first, along, across, [&](std::size_t k, double weight) { lightness += weight * weight / masses[k]; });
    return lightness;
  };
  share_.assign(n, 0.0);
  in_pairs([&](std::size_t first, std::size_t along, std::size_t across) {
    const double share = weights / lightness_of(first, along, across);
    in_pair(first, along, across,
            [&](std::size_t k, double weight) { share_[k] += std::abs(weight) * share / masses[k]; });
  });
  impulse_.assign(n, {0, 0});
  in_pairs([&](std::size_t first, std::size_t along, std::size_t across) {
    double share = 0;
    Impulse difference{0, 0};
    in_pair(first, along, across, [&](std::size_t k, double weight) {
      share = std::max(share, share_[k]);
      difference.x += weight * u[k];
      difference.y += weight * u[n + k];
    });
    const double taken = -part / (1 + part * share) / lightness_of(first, along, across);
    in_pair(first, along, across, [&](std::size_t k, double weight) {
      impulse_[k].x += weight * taken * difference.x;
      impulse_[k].y += weight * taken * difference.y;
    });
  });
  for (std::size_t k = 0; k < n; ++k) push(inverse, k, impulse_[k], u);
}

}  // namespace seiche::dispersive_shallow_water_2d
