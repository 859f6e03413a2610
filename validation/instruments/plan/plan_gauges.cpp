#include "validation/instruments/plan/plan_gauges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/samples.hpp"

namespace seiche::validation {
namespace {

using bilinear_patch::Corners;

constexpr double touch = 1e-9;     // of a cell: a gauge on a wall stands in the water
constexpr double longest = 0.7;    // of Newton's steps [cell]
constexpr double settled = 1e-13;  // the last one
constexpr int most = 20;

struct CellCoordinates {
  double s = 0.5, t = 0.5;
};

/// Where a place is in a cell with corners (x, y), by Newton's method. Outside the map may invert: there the
/// coordinates tell the way, and stay within two cells.
CellCoordinates find_in_cell(Point place, const Corners& x, const Corners& y) {
  CellCoordinates at;
  for (int iteration = 0; iteration < most; ++iteration) {
    const double dx = place.x - mix(x, at.s, at.t);
    const double dy = place.y - mix(y, at.s, at.t);
    const double xs = along_s(x, at.t), xt = along_t(x, at.s);
    const double ys = along_s(y, at.t), yt = along_t(y, at.s);
    const double jacobian = xs * yt - xt * ys;
    const double ds = std::clamp((dx * yt - dy * xt) / jacobian, -longest, longest);
    const double dt = std::clamp((dy * xs - dx * ys) / jacobian, -longest, longest);
    at = {std::clamp(at.s + ds, -2.0, 3.0), std::clamp(at.t + dt, -2.0, 3.0)};
    if (std::abs(ds) + std::abs(dt) < settled) break;
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
  Smallest nearest;
  for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
    const auto centre = [&](std::span<const double> values) {
      return mix(bilinear_patch::at_corners(values, shape_.corners(cell)), 0.5, 0.5);
    };
    nearest.add(distance({centre(surface.x), centre(surface.y)}, place), static_cast<double>(cell));
  }
  return static_cast<std::size_t>(nearest.where());
}

double PlanGauges::read_one(std::size_t gauge, PlanSurface surface) {
  std::size_t& cell = cells_[gauge];
  if (cell == none) cell = nearest_cell(places_[gauge], surface);
  for (std::size_t moves = 0; moves <= shape_.columns + shape_.rows; ++moves) {
    const auto corners = [&](std::span<const double> values) {
      return bilinear_patch::at_corners(values, shape_.corners(cell));
    };
    const CellCoordinates at = find_in_cell(places_[gauge], corners(surface.x), corners(surface.y));
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
      return inside ? mix(corners(surface.z), at.s, at.t) : std::numeric_limits<double>::quiet_NaN();
    }
    cell = neighbour;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace seiche::validation
