#include "seiche/plan_lattice/bilinear_cell.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::plan_lattice {
namespace {

constexpr double longest = 0.7;    // of Newton's steps [cell]
constexpr double settled = 1e-13;  // the last one
constexpr int most = 20;

}  // namespace

CornerValues corner_values(std::span<const double> values, const Shape& shape, std::size_t cell) {
  const auto [c0, c1, c2, c3] = shape.corners(cell);
  return {values[c0], values[c1], values[c2], values[c3]};
}

CellCoordinates find_in_cell(Point place, const CornerValues& x, const CornerValues& y) {
  CellCoordinates at;
  for (int iteration = 0; iteration < most; ++iteration) {
    const double dx = place.x - x.at(at);
    const double dy = place.y - y.at(at);
    const double xs = x.along_s(at.t), xt = x.along_t(at.s);
    const double ys = y.along_s(at.t), yt = y.along_t(at.s);
    const double jacobian = xs * yt - xt * ys;
    const double ds = std::clamp((dx * yt - dy * xt) / jacobian, -longest, longest);
    const double dt = std::clamp((dy * xs - dx * ys) / jacobian, -longest, longest);
    at = {std::clamp(at.s + ds, -2.0, 3.0), std::clamp(at.t + dt, -2.0, 3.0)};
    if (std::abs(ds) + std::abs(dt) < settled) break;
  }
  return at;
}

}  // namespace seiche::plan_lattice
