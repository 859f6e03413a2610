/// Bottom z = b(x, y) seen from above, z counted from the still-water level.
///
/// Models that keep water at rest need the volume over the bottom as a sum over edges, which cancels between
/// neighbours: beside b they take its integral along x,
///
///     B(x, y) = int^x b(s, y) ds,   B_x = b,
///
/// so that the integral of b over a polygon is that of B dy around it.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "seiche/divergence.hpp"

namespace seiche {

/// Gauss's rule of three points on [0, 1], along an edge or a way over a bottom.
struct GaussPoint {
  double t;
  double weight;
};

inline const std::array<GaussPoint, 3>& gauss_points() {
  static const double half = 0.5 * std::sqrt(0.6);
  static const std::array points{GaussPoint{0.5 - half, 5.0 / 18}, GaussPoint{0.5, 8.0 / 18},
                                 GaussPoint{0.5 + half, 5.0 / 18}};
  return points;
}

class PlanBottom {
 public:
  struct Slope {
    double elevation = 0;  ///< b
    double along_x = 0;    ///< b_x
    double along_y = 0;    ///< b_y
  };
  struct Integral {
    double elevation = 0;  ///< b
    double value = 0;      ///< B, from any origin that depends on y alone
    double along_y = 0;    ///< B_y
  };

  virtual ~PlanBottom() = default;
  /// Throw Infeasible where the bottom is not defined.
  [[nodiscard]] virtual Slope slope(double x, double y) const = 0;
  [[nodiscard]] virtual Integral integral(double x, double y) const = 0;
  /// B(x + dx, y + dy) - B(x, y), rounded as a number of its own size and not of B's: the integral of b dx + B_y dy
  /// along the straight way, by Gauss's rule of four points. For ways along which b is a polynomial of degree six in
  /// effect; bottoms that are smooth in pieces add up their pieces.
  [[nodiscard]] virtual double increment(double x, double y, double dx, double dy) const;
};

// Bottom through given elevations on a rectangular grid, such as a bathymetry raster: the bicubic spline.
//
//     b(x, y) = sum over the four nodes of a cell of  f h h + f_x g h + f_y h g + f_xy g g,   h, g Hermite's cubics
//
// whose slopes f_x, f_y, f_xy make second derivatives continuous (not-a-knot ends). Cubic polynomials of x and y are
// exact, smooth bottoms of order 4. The integral B along x, which keeps lakes at rest, is that of the spline itself.
//
// When not to use it: bottoms with steps, which a spline overshoots by some tenths of the step near them.
//
// Reference: C. de Boor, Bicubic spline interpolation, J. Math. and Phys. 41 (1962) 212.

class SplineBottom final : public PlanBottom {
 public:
  /// @param x, y       ascending places of the grid's lines, at least four each
  /// @param elevation  row by row: that of (x[i], y[j]) at [j * x.size() + i]
  /// Throws std::invalid_argument.
  SplineBottom(std::vector<double> x, std::vector<double> y, std::vector<double> elevation);

  /// The spline through the values of a function on lines `spacing` apart or a little less.
  struct Sampling {
    double begin = 0;
    double end = 0;
    double south = 0;
    double north = 0;
    double spacing = 1;
  };
  /// Throws std::invalid_argument for ends out of order, fewer than four lines or more than 5000.
  static SplineBottom sampled(const Sampling& sampling, const std::function<double(double x, double y)>& elevation);

  [[nodiscard]] Slope slope(double x, double y) const override;
  [[nodiscard]] Integral integral(double x, double y) const override;
  /// Exact: cell by cell of the grid.
  [[nodiscard]] double increment(double x, double y, double dx, double dy) const override;

 private:
  struct Node {
    double f = 0, fx = 0, fy = 0, fxy = 0;
    double sum = 0, sum_y = 0;  ///< integrals of f and f_y along x up to the node
  };
  /// Place within a cell: numbers of its first lines, and where between them.
  struct Local {
    std::size_t line = 0;
    double width = 0;
    double t = 0;
  };

  static Local find(std::span<const double> lines, double place);
  void require_inside(double x, double y) const;
  [[nodiscard]] const Node& node(std::size_t i, std::size_t j) const { return nodes_[j * x_.size() + i]; }

  std::vector<double> x_, y_;
  std::vector<Node> nodes_;
};

}  // namespace seiche
