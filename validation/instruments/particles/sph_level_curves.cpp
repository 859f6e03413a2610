#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "validation/instruments/particles/sph_free_surface.hpp"

namespace seiche::wcsph {
namespace {

/// Marching squares. Edges of the grid are numbered: 2 (j columns + i) from point (i, j) to the right, and the next odd
/// number upwards. On every edge that the curve crosses one segment ends and one begins, those at the border excepted.
class Tracer {
 public:
  Tracer(const Raster& raster, double level)
      : raster_(raster),
        level_(level),
        next_(2 * raster.values.size(), none),
        entered_(2 * raster.values.size(), false) {
    for (long j = 0; j + 1 < raster.rows; ++j) {
      for (long i = 0; i + 1 < raster.columns; ++i) cell(i, j);
    }
  }

  std::vector<Contour> curves() {
    std::vector<Contour> result;
    for (const bool from_border : {true, false}) {
      for (std::size_t edge = 0; edge < next_.size(); ++edge) {
        if (next_[edge] == none || (from_border && entered_[edge])) continue;
        result.push_back(follow(edge));
      }
    }
    return result;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  [[nodiscard]] std::size_t point(long i, long j) const { return static_cast<std::size_t>(j * raster_.columns + i); }
  [[nodiscard]] bool wet(std::size_t p) const { return raster_.values[p] >= level_; }

  void cell(long i, long j) {
    // Counter-clockwise; edge k leads from corner k to the next.
    const std::array<std::size_t, 4> corners{point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)};
    const std::array<std::size_t, 4> edges{2 * corners[0], 2 * corners[1] + 1, 2 * corners[3], 2 * corners[0] + 1};
    const auto is_wet = [&](std::size_t k) { return wet(corners[k % 4]); };
    const bool saddle = is_wet(0) == is_wet(2) && is_wet(1) == is_wet(3) && is_wet(0) != is_wet(1);
    double sum = 0;
    for (const std::size_t corner : corners) sum += raster_.values[corner];
    const bool wet_middle = sum >= 4 * level_;
    for (std::size_t k = 0; k < 4; ++k) {
      if (is_wet(k) || !is_wet(k + 1)) continue;
      // The segment begins where the edge comes out of the air, and ends where one goes into it.
      std::size_t last = (k + 1) % 4;
      if (saddle) {
        last = wet_middle ? (k + 3) % 4 : (k + 1) % 4;
      } else {
        while (is_wet(last + 1)) last = (last + 1) % 4;
      }
      next_[edges[k]] = edges[last];
      entered_[edges[last]] = true;
    }
  }

  [[nodiscard]] Place crossing(std::size_t edge) const {
    const std::size_t from = edge / 2;
    const bool upwards = edge % 2 == 1;
    const std::size_t to = from + (upwards ? static_cast<std::size_t>(raster_.columns) : 1);
    const double part = (level_ - raster_.values[from]) / (raster_.values[to] - raster_.values[from]);
    const auto columns = static_cast<std::size_t>(raster_.columns);
    const std::size_t column = from % columns;
    const std::size_t row = from / columns;
    return {raster_.left + (static_cast<double>(column) + (upwards ? 0 : part)) * raster_.step,
            raster_.bottom + (static_cast<double>(row) + (upwards ? part : 0)) * raster_.step};
  }

  Contour follow(std::size_t edge) {
    Contour curve;
    const std::size_t first = edge;
    while (true) {
      const Place place = crossing(edge);
      curve.x.push_back(place.x);
      curve.z.push_back(place.z);
      const std::size_t following = next_[edge];
      next_[edge] = none;
      if (following == none) return curve;
      if (following == first) {
        curve.closed = true;
        return curve;
      }
      edge = following;
    }
  }

  const Raster& raster_;
  double level_;
  std::vector<std::size_t> next_;
  std::vector<bool> entered_;
};

/// Counter-clockwise distance along the border of the box from its upper left corner.
double along_border(const Box& box, const Place& p) {
  const double height = box.top - box.bottom;
  const double width = box.right - box.left;
  const std::array<double, 4> distance{std::abs(p.x - box.left), std::abs(p.z - box.bottom), std::abs(p.x - box.right),
                                       std::abs(p.z - box.top)};
  const auto side = std::min_element(distance.begin(), distance.end()) - distance.begin();
  if (side == 0) return box.top - p.z;
  if (side == 1) return height + (p.x - box.left);
  if (side == 2) return height + width + (p.z - box.bottom);
  return 2 * height + width + (box.right - p.x);
}

/// Air on the left of a curve that is cut off from the upper end of the box.
double air_below(const Contour& curve, const Box& box) {
  Contour loop = curve;
  if (!curve.closed) {
    // Along the border from the end of the curve counter-clockwise to its beginning, with the air on the left.
    const double end = along_border(box, {curve.x.back(), curve.z.back()});
    const double begin = along_border(box, {curve.x.front(), curve.z.front()});
    const double height = box.top - box.bottom;
    const double width = box.right - box.left;
    if (begin < end || begin >= 2 * height + width) return 0;  // over the upper end
    const std::array<std::pair<double, Place>, 2> corners{
        {{height, {box.left, box.bottom}}, {height + width, {box.right, box.bottom}}}};
    for (const auto& [place, corner] : corners) {
      if (place <= end || place >= begin) continue;
      loop.x.push_back(corner.x);
      loop.z.push_back(corner.z);
    }
    loop.closed = true;
  }
  return std::max(loop.area(), 0.0);
}

}  // namespace

std::vector<Contour> level_curves(const Raster& raster, double level) {
  require_positive("step", raster.step);
  require_at_least("columns", raster.columns, 2);
  require_at_least("rows", raster.rows, 2);
  if (raster.values.size() != static_cast<std::size_t>(raster.columns * raster.rows)) {
    throw std::invalid_argument(fmt::format("{} values for {} x {} points: must be as many", raster.values.size(),
                                            raster.columns, raster.rows));
  }
  std::vector<Contour> curves = Tracer(raster, level).curves();
  const Box box{raster.left, raster.left + static_cast<double>(raster.columns - 1) * raster.step, raster.bottom,
                raster.bottom + static_cast<double>(raster.rows - 1) * raster.step};
  for (Contour& curve : curves) curve.air = air_below(curve, box);
  std::stable_sort(curves.begin(), curves.end(),
                   [](const Contour& a, const Contour& b) { return a.length() > b.length(); });
  return curves;
}

}  // namespace seiche::wcsph
