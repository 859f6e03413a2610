#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "seiche/geometry/curve.hpp"
#include "seiche/models/dispersive_shallow_water_1d/model.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::dispersive_elementary_volumes_test {

using namespace dispersive_shallow_water_1d;

const std::string source = "Frank, Discrete models of incompressible fluids (1994), ch. 3, figure 4 and formula (10)";

/// Level bottom, a slope of 1 to 3, and a wave before it.
struct Shore {
  std::vector<double> knots{-9, -3, 6}, levels{-1, -1, 2};
  Channel channel{
      .bottom = std::make_shared<PiecewiseLinearBottom>(knots, levels), .left = End::wall, .right = End::tip};
  Markers markers;

  Shore() {
    const auto hump = [](double x) { return 0.4 / std::pow(std::cosh((x + 3.6) / 1.1), 2); };
    const auto excess = [](double x) { return 0.44 * std::tanh((x + 3.6) / 1.1); };
    const auto motion = [&](double x) { return SurfaceMotion{hump(x), 0, 0}; };
    markers = moved_markers(channel, equal_labels(channel, -7.2, 0, 12), motion, excess, 0);
  }

  [[nodiscard]] double surface(double x) const {
    const auto k =
        static_cast<std::size_t>(std::upper_bound(markers.x.begin(), markers.x.end() - 1, x) - markers.x.begin());
    const double share = (x - markers.x[k - 1]) / (markers.x[k] - markers.x[k - 1]);
    return (1 - share) * markers.y[k - 1] + share * markers.y[k];
  }

  /// Outline of the water between two places: bottom from left to right, surface back.
  [[nodiscard]] std::vector<Point> outline(double from, double to) const {
    std::vector<Point> points{{from, channel.bottom->elevation(from)}};
    for (std::size_t i = 0; i < knots.size(); ++i) {
      if (knots[i] > from && knots[i] < to) points.push_back({knots[i], levels[i]});
    }
    points.push_back({to, channel.bottom->elevation(to)});
    points.push_back({to, surface(to)});
    for (std::size_t i = markers.size(); i-- > 0;) {
      if (markers.x[i] > from && markers.x[i] < to) points.push_back({markers.x[i], markers.y[i]});
    }
    points.push_back({from, surface(from)});
    return points;
  }

  /// Ends of the elementary volumes: the ends of the water and the middles of the cells.
  [[nodiscard]] std::vector<double> boundaries() const {
    std::vector<double> x{markers.x.front()};
    for (std::size_t j = 0; j + 1 < markers.size(); ++j) x.push_back(0.5 * (markers.x[j] + markers.x[j + 1]));
    x.push_back(markers.x.back());
    return x;
  }
};

/// Area and centroid of a polygon.
std::pair<double, Point> shape_of(const std::vector<Point>& outline) {
  double area = 0, x = 0, y = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const double cross = a.x * b.y - b.x * a.y;
    area += 0.5 * cross;
    x += cross * (a.x + b.x) / 6;
    y += cross * (a.y + b.y) / 6;
  }
  return {area, {x / area, y / area}};
}

/// @param x, y  of the centres of the elementary volumes
void draw(Check& check, const Shore& shore, const std::vector<double>& x, const std::vector<double>& y) {
  auto& figure = check.figure("model", "The discrete shallow-water model on a slope",
                              "Nodes on the surface; elementary volumes, bounded by verticals at the middle abscissas "
                              "between nodes; the particle of each volume, of its mass, drawn at its centre of area. "
                              "The last node, the tip, is where the surface meets the bottom.",
                              {"frank-fig-4"});
  auto& panel = figure.panel(
      {.x = "x/H", .y = "y/H", .equal_aspect = true, .x_min = -7.2, .x_max = 0.8, .y_min = -1.25, .y_max = 0.6});
  panel.fill("water", shore.markers.x, shore.markers.y, Role::water);
  panel.fill("bottom", shore.knots, shore.levels, Role::bed);
  for (const double end : shore.boundaries()) {
    panel.line("elementary volumes", std::vector{end, end},
               std::vector{shore.channel.bottom->elevation(end), shore.surface(end)}, Role::peer);
  }
  panel.line("surface", shore.markers.x, shore.markers.y, Role::exact);
  panel.points("markers", shore.markers.x, shore.markers.y, Role::computed);
  panel.points("particles", x, y, Role::data);
}

TEST_CASE("particles of the dispersive model have the mass of their elementary volumes", "[conservation]") {
  Check check("conservation_elementary_volumes", "Elementary volumes of the discrete shallow-water model",
              "The water between the surface through the nodes and the bottom is cut by verticals at the middles "
              "between nodes. A particle has the mass of its piece, constant in time. Here the pieces are measured as "
              "polygons, over a bottom with a corner inside a cell.",
              source);
  const Shore shore;
  const Model model(shore.channel, shore.markers);
  const std::vector<double> ends = shore.boundaries();
  const auto area = [&](double from, double to) { return shape_of(shore.outline(from, to)).first; };
  std::vector<double> x, y;
  Worst worst_mass, worst_cell;
  for (std::size_t i = 0; i < model.size(); ++i) {
    const auto [volume, centre] = shape_of(shore.outline(ends[i], ends[i + 1]));
    x.push_back(centre.x);
    y.push_back(centre.y);
    worst_mass.add(model.masses()[i] - volume);
    if (i + 1 == model.size()) break;
    worst_cell.add(model.rest_volumes()[i] - area(shore.markers.x[i], shore.markers.x[i + 1]));
  }
  const double water = area(shore.markers.x.front(), shore.markers.x.back());
  const auto claim = [&](const std::string& text, double defect, double scale) {
    check.holds(text, {defect},
                Roundoff{40, scale, "products x y of the polygon's corners, eight corners of five operations"});
  };
  claim("The masses are the areas of the elementary volumes.", worst_mass.value(), 7.2);
  claim("The constant volumes are the areas between neighbouring nodes.", worst_cell.value(), 7.2);
  const std::span<const double> masses = model.masses();
  claim("The elementary volumes fill the water.", std::abs(std::accumulate(masses.begin(), masses.end(), 0.0) - water),
        7.2 * std::sqrt(12));
  const double triangle = model.rest_volumes().back();
  check.that("tip", "The mass of the tip's particle is a quarter of its triangle.",
             "mass of the tip/area of the last cell", {model.masses().back() / triangle},
             Roundoff{10, 0.25, "two areas of five operations each", 0.25});
  Channel consistent = shore.channel;
  consistent.tip_mass = TipMass::consistent;
  check.from("rigid acceleration of a plane surface over a plane slope")
      .that("tip-consistent", "The consistent mass of the tip is a sixth of its triangle.",
            "mass of the tip/area of the last cell", {Model(consistent, shore.markers).masses().back() / triangle},
            Roundoff{10, 1.0 / 6, "two areas of five operations each", 1.0 / 6});
  draw(check, shore, x, y);
}

}  // namespace seiche::verification::dispersive_elementary_volumes_test
