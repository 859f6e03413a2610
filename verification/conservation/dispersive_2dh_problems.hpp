/// Motions of the 2DH model on which gradients, conservation, accuracy and symmetries are tried.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <utility>

#include "seiche/models/dispersive_shallow_water_2d/model.hpp"
#include "verification/conservation/mechanical_problem.hpp"
#include "verification/polynomial_bottom.hpp"

namespace seiche::verification {

using PlanProblem = MechanicalProblem<dispersive_shallow_water_2d::Model, dispersive_shallow_water_2d::Lattice,
                                      dispersive_shallow_water_2d::VelocityAt, dispersive_shallow_water_2d::Settings>;

/// Nodes off the sides moved at random along x and y by up to `part` [m].
inline dispersive_shallow_water_2d::Lattice jittered(dispersive_shallow_water_2d::Lattice lattice, double part,
                                                     unsigned seed) {
  std::minstd_rand random(seed);
  std::uniform_real_distribution<double> uniform(-part, part);
  for (std::size_t j = 1; j < lattice.shape.rows; ++j) {
    for (std::size_t i = 1; i < lattice.shape.columns; ++i) {
      lattice.x[lattice.shape.node(i, j)] += uniform(random);
      lattice.y[lattice.shape.node(i, j)] += uniform(random);
    }
  }
  return lattice;
}

/// b = -1 + height exp(-(x - 5)^2/4) (1 + sin(0.6 y)/2): no polynomial, its integral an error function.
class BumpBottom final : public PlanBottom {
 public:
  explicit BumpBottom(double height = 0.3) : height_(height) {}

  [[nodiscard]] Slope slope(double x, double y) const override {
    const double bump = height_ * std::exp(-(x - 5) * (x - 5) / 4);
    return {-1 + bump * across(y), -0.5 * (x - 5) * bump * across(y), bump * across_rate(y)};
  }
  [[nodiscard]] Integral integral(double x, double y) const override {
    const double bump = height_ * std::exp(-(x - 5) * (x - 5) / 4);
    const double area = height_ * std::sqrt(std::numbers::pi) * std::erf((x - 5) / 2);
    return {-1 + bump * across(y), -x + area * across(y), area * across_rate(y)};
  }

 private:
  [[nodiscard]] static double across(double y) { return 1 + 0.5 * std::sin(0.6 * y); }
  [[nodiscard]] static double across_rate(double y) { return 0.3 * std::cos(0.6 * y); }

  double height_;
};

/// Degree 4, so that Gauss's rule of three points on edges is exact: depths 0.6 to 1.3 in the box [0, 10] x [0, 10].
inline std::shared_ptr<const PlanBottom> quartic_bottom() {
  return polynomial_bottom({{-1.2, 0, 0}, {0.05, 1, 0}, {0.01, 1, 1}, {-0.006, 0, 2}, {-1e-4, 2, 2}, {-2e-5, 4, 0}});
}

/// A hump of 0.3 in a box 10 x 10 depths, 20 x 20 cells; its walls at x, y = 0 mirror it.
inline dispersive_shallow_water_2d::Lattice plan_hump_in_box(std::shared_ptr<const PlanBottom> bottom = {}) {
  const auto hump = [](double x, double y) { return 0.3 * std::exp(-0.3 * (x * x + y * y)); };
  return dispersive_shallow_water_2d::rectangular_lattice(
      {.end = 10, .north = 10, .columns = 20, .rows = 20, .elevation = hump, .bottom = std::move(bottom)});
}

/// A hump of 0.15 beside the bump, box 20 x 10 depths, 40 x 20 cells.
inline dispersive_shallow_water_2d::Lattice hump_over_bump() {
  const auto hump = [](double x, double y) {
    return 0.15 * std::exp(-0.3 * ((x - 10) * (x - 10) + (y - 4) * (y - 4)));
  };
  const auto bump = std::make_shared<BumpBottom>();
  return dispersive_shallow_water_2d::rectangular_lattice(
      {.end = 20, .north = 10, .columns = 40, .rows = 20, .elevation = hump, .bottom = bump});
}

/// A rectangle of 24 x 24 cells of 0.5 about the origin that no side holds.
inline dispersive_shallow_water_2d::Rectangle free_square() {
  constexpr plan_lattice::FreeSide free;
  return {.begin = -6, .end = 6, .south = -6, .north = 6, .columns = 24, .rows = 24, .sides = {free, free, free, free}};
}

/// 24 x 24 cells of 0.5, off a square at random, that no side holds; sheared and stirred at random.
/// @param stands  on the level z = 0 with nothing around it; else 1 deep in still water that lies around it
inline PlanProblem free_blob(bool stands, dispersive_shallow_water_2d::Settings settings = {}) {
  std::minstd_rand random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  auto square = free_square();
  square.elevation = [&](double, double) { return (stands ? 1.0 : 0.0) + 0.04 * uniform(random); };
  if (stands) square.bottom = polynomial_bottom({{.coefficient = 0}});
  const auto stirred = [&](double x, double y) {
    return dispersive_shallow_water_2d::Velocity{0.3 - 0.1 * y + 0.02 * uniform(random),
                                                 0.2 + 0.05 * x + 0.02 * uniform(random), 0.02 * uniform(random)};
  };
  return PlanProblem(jittered(rectangular_lattice(square), 0.04, 2), stirred, settings);
}

}  // namespace seiche::verification
