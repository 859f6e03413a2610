/// What is read off a gauge's record or a profile, from the measured and from the computed curve by the same rule.
///
/// Standard uncertainties, from u_i of the points and u_x of the abscissa:
///
/// - highest: extreme of the points in the window; what adding u_i changes
/// - height: highest less lowest; sqrt(2) times that
/// - when highest: abscissa of the highest point; u_x, half of what lies within 2 u_i of the top over sqrt(3), and d
/// - arrival: first abscissa at or above a level, between points on a straight line; u_x, what u_i changes, and d
/// - mean, impulse: trapezoidal mean, and integral, over the window; what adding u_i, and moving the window by u_x,
/// changes
/// - at: value at an abscissa; u_i there, and the slope times u_x
/// - harmonic: amplitude of harmonic n, least squares with the mean and harmonics to 4; stated, and u_i/sqrt(10)
/// - misfit: rms of computed less measured at the measured points; that of u_i and of slope times u_x
///
/// d is half of the distance of the points there: what lies between two of them is not seen.
///
/// The misfit is expected to be 0, every other reading to be what the measured curve gives. A misfit of which the
/// computed curve covers fewer than nine tenths of the points is NaN.
#pragma once

#include <functional>
#include <limits>
#include <ranges>
#include <span>
#include <string>
#include <vector>

#include "validation/instruments/agreement.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::laboratory {

/// What a reading measures: the summary over experiments has a bias and a scatter for each but the misfit.
enum class Kind { arrival, place, height, run_up, pressure, period, velocity, statistic, misfit };
const char* name(Kind kind);

struct Window {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool holds(double x) const { return x >= from && x <= to; }
};

/// Indices of the abscissae in a window; the view refers to them.
inline auto inside(std::span<const double> x, Window window) {
  return indices(x.size()) | std::views::filter([=](std::size_t i) { return window.holds(x[i]); });
}

/// A measured curve and how well its points are known.
struct Measured {
  double group = 0;
  std::vector<double> x = {}, y = {};
  std::vector<double> u = {};  ///< standard uncertainty of y, point by point
  double u_x = 0;              ///< of the abscissa

  [[nodiscard]] Curve curve() const { return {x, y}; }
};

struct Reading {
  std::string id;
  Kind kind = Kind::height;
  std::string words;  ///< "highest elevation"
  double group = 0;
  Window window = {};
  std::function<double(Curve)> read = {};  ///< of the points in the window; empty for the misfit
  bool along = false;                      ///< read in the unit of the abscissa
  /// Standard uncertainty of what is read, where it is not what adding the u of the points changes.
  std::function<double(const Measured&)> spread = {};

  [[nodiscard]] bool misfit() const { return !read; }
  /// What a curve gives; NaN where the window holds no points.
  [[nodiscard]] double of(Curve curve, const Measured& measured) const;
  [[nodiscard]] double expected(const Measured& measured) const;
  /// What adding the u of the points changes.
  [[nodiscard]] double shifted(const Measured& measured) const;
  [[nodiscard]] double uncertainty(const Measured& measured) const;
};

Reading highest(double group, Window window, Kind kind = Kind::height);
Reading height(double group, Window window);
Reading when_highest(double group, Window window, Kind kind = Kind::arrival);
Reading arrival(double group, double level, Window window);
Reading mean(double group, Window window, Kind kind = Kind::height);
Reading impulse(double group, Window window);
Reading at(double group, double abscissa, Kind kind);
/// @param uncertainty  standard, of the amplitude, beside what slow errors of the points make of it
Reading harmonic(double group, int order, double period, Window window, double uncertainty);
Reading misfit(double group, Window window);

/// How much later than the measured curve a computed one is: the lag within +-range that leaves the smallest misfit in
/// the window.
double lag_of(Curve computed, const Measured& measured, Window window, double range);

}  // namespace seiche::validation::laboratory
