#include "seiche/models/lagrangian_mesh_2d/layer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/geometry/curve.hpp"
#include "seiche/geometry/gauss_mean.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::lagrangian_mesh_2d {

namespace {

Mesh empty_mesh(std::size_t columns, std::size_t rows) {
  require_at_least("columns", static_cast<long>(columns), 1);
  require_at_least("rows", static_cast<long>(rows), 1);
  Mesh mesh{{columns, rows}};
  mesh.x.resize(mesh.nodes());
  mesh.y.resize(mesh.nodes());
  return mesh;
}

/// Ends of columns of equal area, int (depth + elevation) dx from one to the next is the same; over a curved bottom of
/// equal width.
std::vector<double> column_ends(const Layer& layer) {
  const auto n = static_cast<double>(layer.columns);
  std::vector<double> ends(layer.columns + 1);
  for (std::size_t i = 0; i <= layer.columns; ++i) {
    ends[i] = layer.begin + (layer.end - layer.begin) * (static_cast<double>(i) / n);
  }
  if (!layer.elevation || layer.bottom) return ends;
  const auto depth = [&](double x) { return layer.depth + layer.elevation(x); };
  // Area up to the ends of narrow strips, then Newton's iteration inside the strip where a column ends.
  const std::size_t strips = 4 * layer.columns;
  const double width = (layer.end - layer.begin) / static_cast<double>(strips);
  const auto area_between = [&](double from, double to) { return (to - from) * gauss_mean(depth, from, to); };
  std::vector<double> area{0};
  for (std::size_t k = 0; k < strips; ++k) {
    const double from = layer.begin + width * static_cast<double>(k);
    area.push_back(area.back() + area_between(from, from + width));
    require_that(area.back() > area[k], "no water between {:g} and {:g}: the elevation must be above -depth = {:g}",
                 from, from + width, -layer.depth);
  }
  for (std::size_t i = 1; i < layer.columns; ++i) {
    const double wanted = area.back() * (static_cast<double>(i) / n);
    const auto k = static_cast<std::size_t>(std::upper_bound(area.begin(), area.end(), wanted) - area.begin()) - 1;
    const double from = layer.begin + width * static_cast<double>(k);
    double x = from + width * (wanted - area[k]) / (area[k + 1] - area[k]);
    for (int iteration = 0; iteration < 20; ++iteration) {
      const double step = (wanted - area[k] - area_between(from, x)) / depth(x);
      x += step;
      if (std::abs(step) <= 1e-15 * (std::abs(layer.begin) + std::abs(layer.end))) break;
    }
    ends[i] = x;
  }
  return ends;
}

/// Puts the bottom and the slope on one curve, along which the toe slides too.
void round_toe(Mesh& mesh, Point toe, double tan_slope, double rounding) {
  const auto curve = std::make_shared<BentLine>(toe, Point{1, 0}, Point{1, tan_slope}, rounding);
  const auto put = [&](std::size_t node) {
    const auto [x, y] = curve->position(curve->arc_length_at({mesh.x[node], mesh.y[node]}));
    mesh.x[node] = x;
    mesh.y[node] = y;
  };
  for (std::size_t i = 0; i <= mesh.columns; ++i) put(mesh.node(i, 0));
  for (std::size_t j = 1; j <= mesh.rows; ++j) put(mesh.node(mesh.columns, j));
  mesh.sides.bottom = mesh.sides.right = Wall{curve};
}

}  // namespace

Mesh free_patch(std::size_t columns, std::size_t rows, Point lower_left, Point upper_right) {
  Mesh mesh = empty_mesh(columns, rows);
  for (std::size_t j = 0; j <= rows; ++j) {
    for (std::size_t i = 0; i <= columns; ++i) {
      const std::size_t k = mesh.node(i, j);
      mesh.x[k] = lower_left.x + (upper_right.x - lower_left.x) * static_cast<double>(i) / static_cast<double>(columns);
      mesh.y[k] = lower_left.y + (upper_right.y - lower_left.y) * static_cast<double>(j) / static_cast<double>(rows);
    }
  }
  return mesh;
}

Mesh layer_mesh(const Layer& layer) {
  require_finite("begin", layer.begin);
  require_finite("end", layer.end);
  require_positive("end - begin", layer.end - layer.begin);
  require_positive("depth", layer.depth);
  Mesh mesh = empty_mesh(layer.columns, layer.rows);
  const std::vector<double> x = column_ends(layer);
  for (std::size_t i = 0; i <= layer.columns; ++i) {
    const double low = layer.bottom ? layer.bottom->position(layer.bottom->arc_length_at({x[i], 0})).y : -layer.depth;
    const double high = layer.elevation ? layer.elevation(x[i]) : 0.0;
    for (std::size_t j = 0; j <= layer.rows; ++j) {
      const std::size_t k = mesh.node(i, j);
      mesh.x[k] = x[i];
      mesh.y[k] = plan_lattice::equally_spaced(low, high, j, layer.rows);
    }
  }
  mesh.sides = {vertical_wall(layer.begin), vertical_wall(layer.end),
                layer.bottom ? Wall{layer.bottom} : level_wall(-layer.depth), FreeSide{}};
  return mesh;
}

Mesh layer_mesh_with_slope(const Layer& layer, double tan_slope, double blend, double rounding) {
  require_positive("tan_slope", tan_slope);
  require_not_negative("blend", blend);
  require_not_negative("rounding", rounding);
  Mesh mesh = layer_mesh(layer);
  const double cot = 1 / tan_slope;
  if (blend == 0) blend = std::max(4 * cot, 4.0) * layer.depth;
  const Point toe{layer.end, -layer.depth};
  for (std::size_t i = 0; i <= layer.columns; ++i) {
    const double phi = std::clamp(1 - (layer.end - mesh.x[mesh.node(i, 0)]) / blend, 0.0, 1.0);
    for (std::size_t j = 0; j <= layer.rows; ++j) {
      const std::size_t k = mesh.node(i, j);
      mesh.x[k] += (mesh.y[k] - toe.y) * cot * phi;
    }
  }
  // Counted from the still-water contact point, whose level is then 0 to the last bit.
  const Point contact{toe.x + layer.depth * cot, 0};
  mesh.sides.right = Wall{std::make_shared<Line>(contact, Point{1, tan_slope})};
  if (rounding > 0) round_toe(mesh, toe, tan_slope, rounding);
  return mesh;
}

}  // namespace seiche::lagrangian_mesh_2d
