#include "validation/instruments/plan/plan_gauges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "seiche/plan_lattice/lattice_interpolant.hpp"

namespace seiche::validation {
namespace {

using plan_lattice::corner_values;

constexpr double touch = 1e-9;  // of a cell: a gauge on a wall stands in the water

}  // namespace

PlanGauges::PlanGauges(plan_lattice::Shape shape, std::vector<Point> places)
    : shape_(shape), places_(std::move(places)), cells_(places_.size(), none), elevations_(places_.size(), 0.0) {}

std::span<const double> PlanGauges::read(PlanSurface surface) {
  for (std::size_t k = 0; k < places_.size(); ++k) elevations_[k] = read_one(k, surface);
  return elevations_;
}

std::size_t PlanGauges::nearest_cell(Point place, PlanSurface surface) const {
  constexpr plan_lattice::CellCoordinates centre{.s = 0.5, .t = 0.5};
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
    const double distance = std::hypot(corner_values(surface.x, shape_, cell).at(centre) - place.x,
                                       corner_values(surface.y, shape_, cell).at(centre) - place.y);
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
    const plan_lattice::CellCoordinates at = plan_lattice::find_in_cell(
        places_[gauge], corner_values(surface.x, shape_, cell), corner_values(surface.y, shape_, cell));
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
      return inside ? corner_values(surface.z, shape_, cell).at(at) : std::numeric_limits<double>::quiet_NaN();
    }
    cell = neighbour;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace seiche::validation
