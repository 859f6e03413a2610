#include "validation/instruments/plan_gauges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace seiche::validation {
namespace {

constexpr double touch = 1e-9;  // of a cell: a gauge on a wall stands in the water

struct Corners {
  double c0, c1, c2, c3;

  [[nodiscard]] double at(double s, double t) const {
    return (1 - t) * ((1 - s) * c0 + s * c1) + t * ((1 - s) * c3 + s * c2);
  }
  [[nodiscard]] double along_s(double t) const { return (1 - t) * (c1 - c0) + t * (c2 - c3); }
  [[nodiscard]] double along_t(double s) const { return (1 - s) * (c3 - c0) + s * (c2 - c1); }
};

Corners corners_of(std::span<const double> values, const plan_lattice::Shape& shape, std::size_t cell) {
  const auto [c0, c1, c2, c3] = shape.corners(cell);
  return {values[c0], values[c1], values[c2], values[c3]};
}

/// Where in a cell a place is: both in [0, 1] inside.
struct Local {
  double s = 0.5, t = 0.5;
};

Local find(Point place, const Corners& x, const Corners& y) {
  Local at;
  constexpr int most = 20;
  for (int iteration = 0; iteration < most; ++iteration) {
    const double dx = place.x - x.at(at.s, at.t);
    const double dy = place.y - y.at(at.s, at.t);
    const double xs = x.along_s(at.t), xt = x.along_t(at.s);
    const double ys = y.along_s(at.t), yt = y.along_t(at.s);
    const double jacobian = xs * yt - xt * ys;
    // Far outside a cell the map may fold: the next cell is a few cells away at most.
    const double ds = std::clamp((dx * yt - dy * xt) / jacobian, -2.0, 2.0);
    const double dt = std::clamp((dy * xs - dx * ys) / jacobian, -2.0, 2.0);
    at = {std::clamp(at.s + ds, -2.0, 3.0), std::clamp(at.t + dt, -2.0, 3.0)};
    if (std::abs(ds) + std::abs(dt) < 1e-13) break;
  }
  return at;
}

}  // namespace

PlanGauges::PlanGauges(plan_lattice::Shape shape, std::vector<Point> places)
    : shape_(shape), places_(std::move(places)), cells_(places_.size(), none), elevations_(places_.size(), 0.0) {}

std::span<const double> PlanGauges::read(PlanSurface surface) {
  for (std::size_t k = 0; k < places_.size(); ++k) elevations_[k] = read_one(k, surface);
  return elevations_;
}

std::size_t PlanGauges::nearest_cell(Point place, PlanSurface surface) const {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
    const double distance = std::hypot(corners_of(surface.x, shape_, cell).at(0.5, 0.5) - place.x,
                                       corners_of(surface.y, shape_, cell).at(0.5, 0.5) - place.y);
    if (distance < least) {
      least = distance;
      nearest = cell;
    }
  }
  return nearest;
}

double PlanGauges::read_one(std::size_t gauge, PlanSurface surface) {
  std::size_t& cell = cells_[gauge];
  if (cell == none) cell = nearest_cell(places_[gauge], surface);
  for (std::size_t moves = 0; moves <= shape_.columns + shape_.rows; ++moves) {
    const Local at = find(places_[gauge], corners_of(surface.x, shape_, cell), corners_of(surface.y, shape_, cell));
    const std::size_t i = cell % shape_.columns;
    const std::size_t j = cell / shape_.columns;
    const auto next = [](double share, std::size_t index, std::size_t count) {
      if (share < -touch && index > 0) return index - 1;
      if (share > 1 + touch && index + 1 < count) return index + 1;
      return index;
    };
    const std::size_t neighbour = next(at.t, j, shape_.rows) * shape_.columns + next(at.s, i, shape_.columns);
    if (neighbour == cell) {
      const bool inside = std::min(at.s, at.t) >= -touch && std::max(at.s, at.t) <= 1 + touch;
      return inside ? corners_of(surface.z, shape_, cell).at(at.s, at.t) : std::numeric_limits<double>::quiet_NaN();
    }
    cell = neighbour;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace seiche::validation
