/// Bottom y = b(x) of a channel, y counted from the still-water level: b < 0 under water, b > 0 on dry land.
///
/// Models that conserve volume and energy to round-off need exact means of b and b^2 over an interval, however short,
/// besides b and its slope. All throw Infeasible for a place outside [begin, end].
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "seiche/divergence.hpp"

namespace seiche {

class BottomProfile {
 public:
  virtual ~BottomProfile() = default;

  /// b(x) and b'(x) at places in any order; at a corner the slope of its right side.
  virtual void sample(std::span<const double> x, std::span<double> elevation, std::span<double> slope) const = 0;
  /// Mean of b over [from, to], exact also for from = to (b itself) and from > to.
  [[nodiscard]] virtual double mean(double from, double to) const = 0;
  /// Mean of b^2 over [from, to].
  [[nodiscard]] virtual double mean_square(double from, double to) const = 0;
  /// The slope, if it is one and the same on all of [from, to].
  [[nodiscard]] virtual std::optional<double> uniform_slope(double from, double to) const = 0;
  [[nodiscard]] virtual double begin() const { return -std::numeric_limits<double>::infinity(); }
  [[nodiscard]] virtual double end() const { return std::numeric_limits<double>::infinity(); }

  [[nodiscard]] double elevation(double x) const;
  [[nodiscard]] double slope(double x) const;
};

/// b = -depth everywhere.
class LevelBottom final : public BottomProfile {
 public:
  /// @param depth  [m], positive
  explicit LevelBottom(double depth);
  void sample(std::span<const double> x, std::span<double> elevation, std::span<double> slope) const override;
  [[nodiscard]] double mean(double, double) const override { return elevation_; }
  [[nodiscard]] double mean_square(double, double) const override { return elevation_ * elevation_; }
  [[nodiscard]] std::optional<double> uniform_slope(double, double) const override { return 0.0; }

 private:
  double elevation_;
};

/// Straight pieces between knots (x_k, b_k), x_k ascending.
class PiecewiseLinearBottom final : public BottomProfile {
 public:
  /// Throws std::invalid_argument: fewer than two knots, x not ascending, values not finite.
  PiecewiseLinearBottom(std::vector<double> x, std::vector<double> elevation);
  void sample(std::span<const double> x, std::span<double> elevation, std::span<double> slope) const override;
  [[nodiscard]] double mean(double from, double to) const override;
  [[nodiscard]] double mean_square(double from, double to) const override;
  [[nodiscard]] std::optional<double> uniform_slope(double from, double to) const override;
  [[nodiscard]] double begin() const override { return x_.front(); }
  [[nodiscard]] double end() const override { return x_.back(); }

 private:
  [[nodiscard]] std::size_t piece(double x) const;
  [[nodiscard]] double on_piece(std::size_t k, double x) const { return b_[k] + slope_[k] * (x - x_[k]); }
  template <class Integrand>
  [[nodiscard]] double mean_of(double from, double to, const Integrand& integrand) const;

  std::vector<double> x_, b_, slope_;
};

/// Any smooth bottom from two functions. Means by Gauss's rule with ten points: exact to round-off over intervals on
/// which b is a polynomial of degree nine in effect, that is over a cell or a step's motion, not over many wavelengths.
class SmoothBottom final : public BottomProfile {
 public:
  /// Throws std::invalid_argument for missing functions or begin >= end.
  SmoothBottom(std::function<double(double)> elevation, std::function<double(double)> slope, double begin, double end);
  void sample(std::span<const double> x, std::span<double> elevation, std::span<double> slope) const override;
  [[nodiscard]] double mean(double from, double to) const override;
  [[nodiscard]] double mean_square(double from, double to) const override;
  [[nodiscard]] std::optional<double> uniform_slope(double from, double to) const override;
  [[nodiscard]] double begin() const override { return begin_; }
  [[nodiscard]] double end() const override { return end_; }

 private:
  void require_inside(double from, double to) const;

  std::function<double(double)> elevation_, slope_;
  double begin_, end_;
};

/// Bed elevation z(x) [m] with its primitive Z(x), Z' = z [m^2]: models that keep a lake at rest to round-off need the
/// exact mean of the bed over a cell, not a sample of it.
struct Bed {
  std::function<double(double)> elevation;
  std::function<double(double)> primitive;

  /// Throws std::invalid_argument unless both functions are given, finite and consistent: at sampled points of
  /// [start, end] a central difference of the primitive must agree with the elevation to 1e-6 of the range of the
  /// elevations and 0.
  void validate(double start, double end) const;
};

}  // namespace seiche
