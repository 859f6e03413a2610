#include "seiche/geometry/plan_bottom.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <gsl/gsl_linalg.h>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche {

double PlanBottom::increment(double x, double y, double dx, double dy) const {
  // Abramowitz and Stegun, table 25.4.
  static constexpr std::array<std::pair<double, double>, 2> gauss{
      std::pair{0.339981043584856264803, 0.652145154862546142627},
      std::pair{0.861136311594052575224, 0.347854845137453857373}};
  double sum = 0;
  for (const auto& [place, weight] : gauss) {
    for (const double s : {0.5 - 0.5 * place, 0.5 + 0.5 * place}) {
      const Integral at = integral(x + s * dx, y + s * dy);
      sum += 0.5 * weight * (at.elevation * dx + at.along_y * dy);
    }
  }
  return sum;
}

namespace {

/// Weights of f(0), f(1), f'(0), f'(1) on an interval of length `width`.
using Weights = std::array<double, 4>;

Weights value_weights(double width, double t) {
  const double s = 1 - t;
  return {s * s * (1 + 2 * t), t * t * (1 + 2 * s), width * t * s * s, -width * t * t * s};
}

Weights slope_weights(double width, double t) {
  const double bend = 6 * t * (1 - t) / width;
  return {-bend, bend, (1 - t) * (1 - 3 * t), t * (3 * t - 2)};
}

/// Of the integral from the interval's begin to t.
Weights integral_weights(double width, double t) {
  const double end = t * t * t * (1 - t / 2);
  return {width * (t - end), width * end, width * width * t * t * (0.5 + t * (t / 4 - 2.0 / 3)),
          width * width * t * t * t * (t / 4 - 1.0 / 3)};
}

double sum(const Weights& weights, double f0, double f1, double d0, double d1) {
  return weights[0] * f0 + weights[1] * f1 + weights[2] * d0 + weights[3] * d1;
}

/// Slopes at the knots of the not-a-knot cubic splines through many sets of values.
class KnotSlopes {
 public:
  explicit KnotSlopes(std::span<const double> knots)
      : n_(knots.size()), diagonal_(n_, 0.0), above_(n_ - 1, 0.0), below_(n_ - 1, 0.0), values_(n_), slopes_(n_) {
    for (std::size_t i = 0; i + 1 < n_; ++i) widths_.push_back(knots[i + 1] - knots[i]);
    for (std::size_t i = 1; i + 1 < n_; ++i) {
      below_[i - 1] = widths_[i];
      diagonal_[i] = 2 * (widths_[i - 1] + widths_[i]);
      above_[i] = widths_[i - 1];
    }
    diagonal_[0] = widths_[1];
    above_[0] = widths_[0] + widths_[1];
    diagonal_[n_ - 1] = widths_[n_ - 3];
    below_[n_ - 2] = widths_[n_ - 2] + widths_[n_ - 3];
  }

  /// value(i) and slope(i) give the i-th value and take the i-th slope.
  template <class Value, class Slope>
  void find(const Value& value, const Slope& slope) {
    const auto secant = [&](std::size_t i) { return (value(i + 1) - value(i)) / widths_[i]; };
    for (std::size_t i = 1; i + 1 < n_; ++i) {
      values_[i] = 3 * (widths_[i] * secant(i - 1) + widths_[i - 1] * secant(i));
    }
    const auto end = [](double outer, double inner, double outer_secant, double inner_secant) {
      const double both = outer + inner;
      return ((outer + 2 * both) * inner * outer_secant + outer * outer * inner_secant) / both;
    };
    values_[0] = end(widths_[0], widths_[1], secant(0), secant(1));
    values_[n_ - 1] = end(widths_[n_ - 2], widths_[n_ - 3], secant(n_ - 2), secant(n_ - 3));
    const auto diagonal = gsl_vector_const_view_array(diagonal_.data(), n_);
    const auto above = gsl_vector_const_view_array(above_.data(), n_ - 1);
    const auto below = gsl_vector_const_view_array(below_.data(), n_ - 1);
    const auto right = gsl_vector_const_view_array(values_.data(), n_);
    auto solution = gsl_vector_view_array(slopes_.data(), n_);
    gsl_linalg_solve_tridiag(&diagonal.vector, &above.vector, &below.vector, &right.vector, &solution.vector);
    for (std::size_t i = 0; i < n_; ++i) slope(i) = slopes_[i];
  }

 private:
  std::size_t n_;
  std::vector<double> widths_, diagonal_, above_, below_, values_, slopes_;
};

void require_lines(const char* name, std::span<const double> lines) {
  require_at_least(fmt::format("lines of {}", name), static_cast<long>(lines.size()), 4);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    require_finite(fmt::format("{}[{}]", name, i), lines[i]);
    const double before = i > 0 ? lines[i - 1] : -std::numeric_limits<double>::infinity();
    require_that(lines[i] > before, "{}[{}] = {:g}; allowed: above the last one, {:g}", name, i, lines[i], before);
  }
}

}  // namespace

SplineBottom::SplineBottom(std::vector<double> x, std::vector<double> y, std::vector<double> elevation)
    : x_(std::move(x)), y_(std::move(y)) {
  require_lines("x", x_);
  require_lines("y", y_);
  require_that(elevation.size() == x_.size() * y_.size(), "elevation has {} values; allowed: {} x {}", elevation.size(),
               x_.size(), y_.size());
  for (std::size_t k = 0; k < elevation.size(); ++k) {
    require_finite(fmt::format("elevation[{}]", k), elevation[k]);
    nodes_.push_back({.f = elevation[k]});
  }
  const auto at = [this](std::size_t i, std::size_t j) -> Node& { return nodes_[j * x_.size() + i]; };
  KnotSlopes along_x(x_);
  KnotSlopes along_y(y_);
  for (std::size_t j = 0; j < y_.size(); ++j) {
    along_x.find([&](std::size_t i) { return at(i, j).f; }, [&](std::size_t i) -> double& { return at(i, j).fx; });
  }
  for (std::size_t i = 0; i < x_.size(); ++i) {
    along_y.find([&](std::size_t j) { return at(i, j).f; }, [&](std::size_t j) -> double& { return at(i, j).fy; });
    along_y.find([&](std::size_t j) { return at(i, j).fx; }, [&](std::size_t j) -> double& { return at(i, j).fxy; });
  }
  for (std::size_t j = 0; j < y_.size(); ++j) {
    for (std::size_t i = 1; i < x_.size(); ++i) {
      const Weights whole = integral_weights(x_[i] - x_[i - 1], 1);
      const Node& last = at(i - 1, j);
      Node& next = at(i, j);
      next.sum = last.sum + sum(whole, last.f, next.f, last.fx, next.fx);
      next.sum_y = last.sum_y + sum(whole, last.fy, next.fy, last.fxy, next.fxy);
    }
  }
}

SplineBottom SplineBottom::sampled(const Sampling& sampling,
                                   const std::function<double(double x, double y)>& elevation) {
  require_positive("spacing", sampling.spacing);
  const auto lines = [&](const char* name, double from, double to) {
    require_finite(name, from);
    require_finite(name, to);
    require_that(to > from, "{} ends at {:g}; allowed: above {:g}", name, to, from);
    const double count = std::ceil((to - from) / sampling.spacing * (1 - 1e-12));
    require_within(fmt::format("intervals along {}", name), count, 3, 5000);
    std::vector<double> places;
    // From both ends: a symmetric range has symmetric lines.
    for (double k = 0; k <= count; ++k) places.push_back((from * (count - k) + to * k) / count);
    return places;
  };
  std::vector<double> x = lines("x", sampling.begin, sampling.end);
  std::vector<double> y = lines("y", sampling.south, sampling.north);
  std::vector<double> values;
  for (const double at_y : y) {
    for (const double at_x : x) values.push_back(elevation(at_x, at_y));
  }
  return SplineBottom(std::move(x), std::move(y), std::move(values));
}

SplineBottom::Local SplineBottom::find(std::span<const double> lines, double place) {
  const std::size_t last = lines.size() - 2;
  // Lines mostly lie at equal distances: the guess is right but for rounding.
  const double guess = static_cast<double>(last + 1) * (place - lines.front()) / (lines.back() - lines.front());
  auto line = static_cast<std::size_t>(std::clamp(guess, 0.0, static_cast<double>(last)));
  if ((line > 0 && place < lines[line]) || (line < last && place >= lines[line + 1])) {
    const auto above = std::upper_bound(lines.begin() + 1, lines.end() - 1, place);
    line = static_cast<std::size_t>(above - lines.begin()) - 1;
  }
  const double width = lines[line + 1] - lines[line];
  return {.line = line, .width = width, .t = (place - lines[line]) / width};
}

void SplineBottom::require_inside(double x, double y) const {
  const auto require = [&](double at, const char* coordinate, const std::vector<double>& places) {
    if (at >= places.front() && at <= places.back()) return;
    throw Infeasible(x, "({:g}, {:g}) is outside the bottom; allowed: {} within [{:g}, {:g}]", x, y, coordinate,
                     places.front(), places.back());
  };
  require(x, "x", x_);
  require(y, "y", y_);
}

PlanBottom::Slope SplineBottom::slope(double x, double y) const {
  require_inside(x, y);
  const Local at_x = find(x_, x);
  const Local at_y = find(y_, y);
  const Weights value = value_weights(at_x.width, at_x.t);
  const Weights rate = slope_weights(at_x.width, at_x.t);
  std::array<double, 2> f{}, fx{}, fy{}, fxy{};
  for (std::size_t side = 0; side < 2; ++side) {
    const Node& left = node(at_x.line, at_y.line + side);
    const Node& right = node(at_x.line + 1, at_y.line + side);
    f[side] = sum(value, left.f, right.f, left.fx, right.fx);
    fx[side] = sum(rate, left.f, right.f, left.fx, right.fx);
    fy[side] = sum(value, left.fy, right.fy, left.fxy, right.fxy);
    fxy[side] = sum(rate, left.fy, right.fy, left.fxy, right.fxy);
  }
  const Weights across = value_weights(at_y.width, at_y.t);
  return {.elevation = sum(across, f[0], f[1], fy[0], fy[1]),
          .along_x = sum(across, fx[0], fx[1], fxy[0], fxy[1]),
          .along_y = sum(slope_weights(at_y.width, at_y.t), f[0], f[1], fy[0], fy[1])};
}

PlanBottom::Integral SplineBottom::integral(double x, double y) const {
  require_inside(x, y);
  const Local at_x = find(x_, x);
  const Local at_y = find(y_, y);
  const Weights value = value_weights(at_x.width, at_x.t);
  const Weights whole = integral_weights(at_x.width, at_x.t);
  std::array<double, 2> f{}, fy{}, area{}, area_y{};
  for (std::size_t side = 0; side < 2; ++side) {
    const Node& left = node(at_x.line, at_y.line + side);
    const Node& right = node(at_x.line + 1, at_y.line + side);
    f[side] = sum(value, left.f, right.f, left.fx, right.fx);
    fy[side] = sum(value, left.fy, right.fy, left.fxy, right.fxy);
    area[side] = left.sum + sum(whole, left.f, right.f, left.fx, right.fx);
    area_y[side] = left.sum_y + sum(whole, left.fy, right.fy, left.fxy, right.fxy);
  }
  const Weights across = value_weights(at_y.width, at_y.t);
  return {.elevation = sum(across, f[0], f[1], fy[0], fy[1]),
          .value = sum(across, area[0], area[1], area_y[0], area_y[1]),
          .along_y = sum(slope_weights(at_y.width, at_y.t), area[0], area[1], area_y[0], area_y[1])};
}

double SplineBottom::increment(double x, double y, double dx, double dy) const {
  std::vector<double> ends;  // of the pieces of the way, as parts of it
  const auto add_crossings = [&](std::span<const double> lines, double from, double way) {
    const auto first = std::upper_bound(lines.begin(), lines.end(), std::min(from, from + way));
    for (auto line = first; line != lines.end() && *line < std::max(from, from + way); ++line) {
      ends.push_back((*line - from) / way);
    }
  };
  add_crossings(x_, x, dx);
  add_crossings(y_, y, dy);
  std::sort(ends.begin(), ends.end());
  ends.push_back(1);
  double sum = 0;
  double begin = 0;
  for (const double end : ends) {
    sum += PlanBottom::increment(x + begin * dx, y + begin * dy, (end - begin) * dx, (end - begin) * dy);
    begin = end;
  }
  return sum;
}

}  // namespace seiche
