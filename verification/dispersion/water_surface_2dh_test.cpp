// The water's surface over lattices with improved dispersion.
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "seiche/models/dispersive_shallow_water_1d/water_surface.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/plan/water_surface.hpp"
#include "verification/check.hpp"
#include "verification/conservation/differences.hpp"

namespace seiche::verification::water_surface_2dh_test {

using plan_lattice::Shape, validation::WaterSurface;

constexpr double pi = std::numbers::pi, improved = 1.0 / 15;
constexpr double accuracy = 1e-8;  // of the solution, relative to the difference from z
const std::string derived = "derived in validation/instruments/plan/water_surface.hpp";

/// Markers and the water of cells.
struct Sheet {
  Shape shape;
  std::vector<double> q, volumes;

  explicit Sheet(Shape of) : shape(of), q(3 * of.nodes()), volumes(of.cells()) {}

  [[nodiscard]] double& x(std::size_t node) { return q[node]; }
  [[nodiscard]] double& y(std::size_t node) { return q[shape.nodes() + node]; }
  [[nodiscard]] double& z(std::size_t node) { return q[2 * shape.nodes() + node]; }
  [[nodiscard]] double area(std::size_t cell) {
    const auto [c0, c1, c2, c3] = shape.corners(cell);
    return 0.5 * ((x(c2) - x(c0)) * (y(c3) - y(c1)) - (x(c3) - x(c1)) * (y(c2) - y(c0)));
  }
};

template <class Visit>
void for_nodes(Shape shape, const Visit& visit) {
  for (std::size_t j = 0; j <= shape.rows; ++j) {
    for (std::size_t i = 0; i <= shape.columns; ++i) visit(shape.node(i, j), i, j);
  }
}

void turn(Sheet& sheet, double angle) {
  for (std::size_t node = 0; node < sheet.shape.nodes(); ++node) {
    const Point at{sheet.x(node), sheet.y(node)};
    sheet.x(node) = at.x * std::cos(angle) - at.y * std::sin(angle);
    sheet.y(node) = at.x * std::sin(angle) + at.y * std::cos(angle);
  }
}

/// Equal rectangles of depth 1, turned.
Sheet turned(Shape shape, double h1, double h2, double angle) {
  Sheet sheet(shape);
  for_nodes(shape, [&](std::size_t node, std::size_t i, std::size_t j) {
    sheet.x(node) = h1 * static_cast<double>(i);
    sheet.y(node) = h2 * static_cast<double>(j);
  });
  for (double& volume : sheet.volumes) volume = h1 * h2;
  turn(sheet, angle);
  return sheet;
}

TEST_CASE("the water's surface of a wave over equal rectangles has its closed form", "[dispersion]") {
  Check check("water_surface_factor_2dh", "The water's surface in 2DH: factor of waves over a level bottom",
              "Rectangles of 0.3 h x 0.2 h between walls along a turned square: every wave cos(k x) cos(l y) of the "
              "mesh corresponds to one of the water's surface with (1 + 3 s/4)/(1 + s/4) times its amplitude, s = "
              "gamma Q with the Q of dispersion_energy.hpp.",
              derived);
  const Shape shape{12, 9};
  constexpr double h1 = 0.3, h2 = 0.2;
  Sheet sheet = turned(shape, h1, h2, 0.7);
  WaterSurface surface(shape, improved);
  Worst deviation;
  for (std::size_t m = 0; m <= shape.columns; ++m) {
    for (std::size_t n = 0; n <= shape.rows; ++n) {
      const double half1 = 0.5 * pi * static_cast<double>(m) / static_cast<double>(shape.columns);
      const double half2 = 0.5 * pi * static_cast<double>(n) / static_cast<double>(shape.rows);
      const double s = improved * (std::pow(2 * std::sin(half1) * std::cos(half2) / h1, 2) +
                                   std::pow(2 * std::sin(half2) * std::cos(half1) / h2, 2));
      const double factor = (1 + 0.75 * s) / (1 + 0.25 * s);
      for_nodes(shape, [&](std::size_t node, std::size_t i, std::size_t j) {
        sheet.z(node) = std::cos(2 * half1 * static_cast<double>(i)) * std::cos(2 * half2 * static_cast<double>(j));
      });
      const auto found = surface.read(sheet.volumes, sheet.q);
      for (std::size_t node = 0; node < shape.nodes(); ++node) deviation.add(found[node] - factor * sheet.z(node));
    }
  }
  check.that("factor", "Every wave is higher by its factor, within the solver's accuracy times the root of 130 nodes.",
             "largest deviation over the amplitude",
             {.value = deviation.value(), .resolution = "12 x 9 rectangles, all waves"},
             Bound{2 * std::sqrt(13.0 * 10.0) * accuracy,
                   "the solution's relative accuracy in the mean of 130 nodes; the surface elevation is at most three "
                   "times the nodes'"});
}

TEST_CASE("for waves along one axis the surface agrees with a channel", "[dispersion]") {
  Check check("water_surface_channel_2dh", "The water's surface in 2DH: as in a channel",
              "Columns of unequal widths and depths, three rows of unequal widths, elevations at random along the "
              "channel: each row's nodes against the nodes of a channel with the water of a unit of width.",
              derived);
  const Shape shape{20, 3};
  Sheet sheet(shape);
  std::minstd_rand random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> x{0}, z{uniform(random)}, volume;
  for (std::size_t i = 0; i < shape.columns; ++i) {
    x.push_back(x.back() + 0.2 + 0.3 * uniform(random));
    z.push_back(uniform(random));
    volume.push_back((0.3 + uniform(random)) * (x[i + 1] - x[i]));
  }
  const std::vector<double> y{0, 0.3, 0.8, 1.0};
  for_nodes(shape, [&](std::size_t node, std::size_t i, std::size_t j) {
    sheet.x(node) = x[i];
    sheet.y(node) = y[j];
    sheet.z(node) = z[i];
    if (i < shape.columns && j < shape.rows) sheet.volumes[j * shape.columns + i] = volume[i] * (y[j + 1] - y[j]);
  });
  const auto channel = dispersive_shallow_water_1d::water_surface({.bottom = {}, .gamma = improved}, x, z, volume);
  WaterSurface surface(shape, improved);
  const auto found = surface.read(sheet.volumes, sheet.q);
  Worst difference, moved;
  for (std::size_t node = 0; node < shape.nodes(); ++node) {
    difference.add(found[node] - channel[node % (shape.columns + 1)]);
    moved.add(found[node] - sheet.z(node));
  }
  check.that("same", "The surface of the 2DH model equals the surface of the 1D channel.",
             "largest difference over the largest elevation above the nodes",
             {.value = difference.value() / moved.value(), .resolution = "20 x 3 cells"},
             Bound{std::sqrt(84.0) * 3 * accuracy,
                   "the solution's relative accuracy in the mean of 84 nodes whose areas differ 9 times"});
}

TEST_CASE("the surface holds the nodes' water, whichever way the mesh lies", "[dispersion]") {
  Check check("water_surface_water_2dh", "The water's surface in 2DH: water and turns",
              "Cells off a square at random with elevations and depths at random: the water between nodes and surface, "
              "and the surface of the same mesh turned by 40 degrees.",
              derived);
  Sheet sheet = turned({14, 11}, 1, 1, 0);
  std::minstd_rand random(5);
  std::uniform_real_distribution<double> uniform(-0.25, 0.25);
  for (double& value : sheet.q) value += uniform(random);
  for (std::size_t cell = 0; cell < sheet.shape.cells(); ++cell) {
    sheet.volumes[cell] = (2 + 4 * uniform(random)) * sheet.area(cell);
  }
  WaterSurface surface(sheet.shape, improved);
  const auto read = surface.read(sheet.volumes, sheet.q);
  const std::vector<double> found(read.begin(), read.end());
  double water = 0, moved = 0;
  for (std::size_t cell = 0; cell < sheet.shape.cells(); ++cell) {
    for (const std::size_t node : sheet.shape.corners(cell)) {
      water += 0.25 * sheet.area(cell) * (found[node] - sheet.z(node));
      moved += 0.25 * sheet.area(cell) * std::abs(found[node] - sheet.z(node));
    }
  }
  check.that("water", "The water volumes under nodes and surface agree within 20 times the solver's accuracy.",
             "water between them over the water displaced", {.value = water / moved, .resolution = "14 x 11 cells"},
             Bound{20 * accuracy,
                   "the residual's sum: its accuracy times the root of 180 nodes, and the slope of the surface over "
                   "the displacement by the solution"});
  Sheet other = sheet;
  turn(other, 40 * pi / 180);
  WaterSurface again(other.shape, improved);
  const auto same = again.read(other.volumes, other.q);
  check.from("rotation")
      .that("turned", "The surface of the turned grid is the same to round-off.", "largest difference",
            {.value = largest_difference(same, found), .resolution = "14 x 11 cells"},
            Roundoff{400, 1, "some twenty iterations of twenty operations"});
}

}  // namespace seiche::verification::water_surface_2dh_test
