#include "validation/laboratory/reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>
#include <Eigen/QR>

#include "seiche/samples.hpp"
#include "validation/case/parameter.hpp"

namespace seiche::validation::laboratory {
namespace {

struct Cut {
  std::vector<double> x, y;
  [[nodiscard]] Curve curve() const { return {x, y}; }
};

Cut within(Curve curve, Window window) {
  Cut cut;
  for (const std::size_t i : inside(curve.x, window)) {
    cut.x.push_back(curve.x[i]);
    cut.y.push_back(curve.y[i]);
  }
  return cut;
}

double place_of_largest(Curve curve) {
  const auto top = std::max_element(curve.y.begin(), curve.y.end());
  return curve.x[static_cast<std::size_t>(top - curve.y.begin())];
}

double integral(Curve curve) {
  double sum = 0;
  for (std::size_t i = 1; i < curve.x.size(); ++i) {
    sum += 0.5 * (curve.x[i] - curve.x[i - 1]) * (curve.y[i] + curve.y[i - 1]);
  }
  return sum;
}

/// Slope of a curve at its points, one-sided at the ends.
double slope_at(Curve curve, std::size_t i) {
  const std::size_t a = i == 0 ? 0 : i - 1;
  const std::size_t b = std::min(i + 1, curve.x.size() - 1);
  return b > a ? (curve.y[b] - curve.y[a]) / (curve.x[b] - curve.x[a]) : 0;
}

double misfit_of(Curve computed, const Measured& measured, Window window, double lag) {
  constexpr double least_covered = 0.9;
  Mean square;
  double asked = 0;
  double covered = 0;
  for (const std::size_t i : inside(measured.x, window)) {
    ++asked;
    const double x = measured.x[i] + lag;
    if (computed.x.empty() || x < computed.x.front() || x > computed.x.back()) continue;
    ++covered;
    square.add(std::pow(linear_at(computed, x) - measured.y[i], 2));
  }
  return covered < least_covered * asked ? nan : std::sqrt(square.value());
}

double uncertainty_of_misfit(const Measured& measured, Window window) {
  Mean square;
  for (const std::size_t i : inside(measured.x, window)) {
    const double along = slope_at(measured.curve(), i) * measured.u_x;
    square.add(measured.u[i] * measured.u[i] + along * along);
  }
  return std::sqrt(square.value());
}

/// Standard uncertainty of a place between points at `i` and beside it.
double between_points(const std::vector<double>& x, std::size_t i) {
  const double before = i > 0 ? x[i] - x[i - 1] : 0;
  const double after = i + 1 < x.size() ? x[i + 1] - x[i] : 0;
  return std::max(before, after) / 2;
}

/// Half of what lies within 2 u of the top: a point there may be the highest, for two points differ by as much.
double blunt(const Measured& measured, Window window) {
  const Cut cut = within(measured.curve(), window);
  const auto highest = static_cast<std::size_t>(std::max_element(cut.y.begin(), cut.y.end()) - cut.y.begin());
  const double top = cut.y.at(highest);
  std::vector<double> near;
  for (const std::size_t i : inside(measured.x, window)) {
    if (!(measured.y[i] < top - 2 * measured.u[i])) near.push_back(measured.x[i]);
  }
  const double half = 0.5 * (near.back() - near.front());
  return std::hypot(measured.u_x, half / std::numbers::sqrt3, between_points(cut.x, highest));
}

/// Amplitude of one harmonic by least squares with the mean and four harmonics.
double amplitude(Curve curve, int order, double period) {
  const Eigen::Map<const Eigen::ArrayXd> t(curve.x.data(), static_cast<Eigen::Index>(curve.x.size()));
  const Eigen::Map<const Eigen::VectorXd> y(curve.y.data(), t.size());
  Eigen::MatrixXd waves = Eigen::MatrixXd::Ones(t.size(), 9);
  for (int m = 1; m <= 4; ++m) {
    const Eigen::ArrayXd phase = 2 * std::numbers::pi * m / period * t;
    waves.col(2 * m - 1) = phase.cos();
    waves.col(2 * m) = phase.sin();
  }
  const Eigen::VectorXd solved = waves.colPivHouseholderQr().solve(y);
  return std::hypot(solved[2 * order - 1], solved[2 * order]);
}

/// The uncertainty of an integral over a window, or of a mean: it also changes where the abscissa is off by u_x.
Reading integrated(const Reading& reading, bool over_length) {
  Reading known = reading;
  known.spread = [reading, over_length](const Measured& measured) {
    const double from = std::max(reading.window.from, measured.x.front());
    const double to = std::min(reading.window.to, measured.x.back());
    const double change = (linear_at(measured.curve(), to) - linear_at(measured.curve(), from)) * measured.u_x;
    return std::hypot(reading.shifted(measured), over_length ? change / (to - from) : change);
  };
  return known;
}

}  // namespace

const char* name(Kind kind) {
  constexpr std::array<const char*, 9> names{"arrival", "position", "height",    "run-up", "pressure",
                                             "period",  "velocity", "statistic", "misfit"};
  return names.at(static_cast<std::size_t>(kind));
}

double Reading::of(Curve curve, const Measured& measured) const {
  if (misfit()) return misfit_of(curve, measured, window, 0);
  const Cut cut = within(curve, window);
  return cut.x.empty() ? nan : read(cut.curve());
}

double Reading::expected(const Measured& measured) const {
  return misfit() ? 0 : of(measured.curve(), measured);
}

double Reading::shifted(const Measured& measured) const {
  Measured up = measured;
  Measured down = measured;
  std::ranges::transform(measured.y, measured.u, up.y.begin(), std::plus{});
  std::ranges::transform(measured.y, measured.u, down.y.begin(), std::minus{});
  return 0.5 * (of(up.curve(), up) - of(down.curve(), down));
}

double Reading::uncertainty(const Measured& measured) const {
  if (spread) return spread(measured);
  if (misfit()) return uncertainty_of_misfit(measured, window);
  const double change = std::abs(shifted(measured));
  if (!along) return change;
  const auto next = std::upper_bound(measured.x.begin(), measured.x.end(), expected(measured));
  const auto here = static_cast<std::size_t>(std::max(next - measured.x.begin() - 1, 0L));
  return std::hypot(change, measured.u_x, between_points(measured.x, here));
}

Reading highest(double group, Window window, Kind kind) {
  return {.id = "highest",
          .kind = kind,
          .words = "highest value",
          .group = group,
          .window = window,
          .read = [](Curve curve) { return largest(curve.y); }};
}

Reading height(double group, Window window) {
  const Reading top = highest(group, window);
  return {.id = "height",
          .words = "height from trough to crest",
          .group = group,
          .window = window,
          .read = [](Curve curve) { return largest(curve.y) - smallest(curve.y); },
          .spread = [top](const Measured& measured) { return std::numbers::sqrt2 * top.uncertainty(measured); }};
}

Reading when_highest(double group, Window window, Kind kind) {
  return {.id = "when",
          .kind = kind,
          .words = kind == Kind::place ? "position of the maximum" : "time of the maximum",
          .group = group,
          .window = window,
          .read = place_of_largest,
          .along = true,
          .spread = [window](const Measured& measured) { return blunt(measured, window); }};
}

Reading arrival(double group, double level, Window window) {
  return {.id = "arrival",
          .kind = Kind::arrival,
          .words = fmt::format("first at or above {:g}", level),
          .group = group,
          .window = window,
          .read = [level](Curve curve) { return first_crossing(curve, level); },
          .along = true};
}

Reading mean(double group, Window window, Kind kind) {
  return integrated({.id = fmt::format("mean-{:g}-{:g}", window.from, window.to),
                     .kind = kind,
                     .words = fmt::format("mean from {:g} to {:g}", window.from, window.to),
                     .group = group,
                     .window = window,
                     .read = [](Curve curve) { return integral(curve) / (curve.x.back() - curve.x.front()); }},
                    true);
}

Reading impulse(double group, Window window) {
  return integrated({.id = "impulse",
                     .kind = Kind::pressure,
                     .words = fmt::format("impulse from {:g} to {:g}", window.from, window.to),
                     .group = group,
                     .window = window,
                     .read = integral},
                    false);
}

Reading at(double group, double abscissa, Kind kind) {
  return {.id = fmt::format("at-{:g}", abscissa),
          .kind = kind,
          .words = fmt::format("value at {:g}", abscissa),
          .group = group,
          .read = [abscissa](Curve curve) { return linear_at(curve, abscissa); },
          .spread =
              [abscissa](const Measured& measured) {
                const double slope =
                    (linear_at(measured.curve(), std::min(abscissa + measured.u_x, measured.x.back())) -
                     linear_at(measured.curve(), std::max(abscissa - measured.u_x, measured.x.front()))) /
                    2;
                return std::hypot(linear_at({measured.x, measured.u}, abscissa), slope);
              }};
}

Reading harmonic(double group, int order, double period, Window window, double uncertainty) {
  return {.id = fmt::format("harmonic-{}", order),
          .words = fmt::format("amplitude of harmonic {}", order),
          .group = group,
          .window = window,
          .read = [order, period](Curve curve) { return amplitude(curve, order, period); },
          .spread =
              [uncertainty](const Measured& measured) {
                return std::hypot(uncertainty, measured.u.front() / std::sqrt(10.0));
              }};
}

Reading misfit(double group, Window window) {
  return {.id = "misfit",
          .kind = Kind::misfit,
          .words = "root mean square difference from the measured points",
          .group = group,
          .window = window};
}

double lag_of(Curve computed, const Measured& measured, Window window, double range) {
  constexpr int steps = 200;
  const double step = range / steps;
  const auto misfit = [&](double lag) { return misfit_of(computed, measured, window, lag); };
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = -steps; k <= steps; ++k) {
    if (const double left = misfit(k * step); left < least) {
      least = left;
      best = k * step;
    }
  }
  // A parabola through the squares at the three best lags.
  const auto square = [&](double lag) { return std::pow(misfit(lag), 2); };
  const double before = square(best - step);
  const double after = square(best + step);
  const double curvature = before - 2 * least * least + after;
  if (std::isfinite(curvature) && curvature > 0)
    best += std::clamp(0.5 * (before - after) / curvature, -1.0, 1.0) * step;
  return std::isfinite(least) ? std::clamp(best, -range, range) : nan;
}

}  // namespace seiche::validation::laboratory
