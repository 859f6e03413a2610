#include "seiche/exact/stokes_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

/// 1 - q exp(-i theta) without cancellation in gentle waves.
Complex velocity_defect(double log_speed, double inclination) {
  const double half = std::sin(0.5 * inclination);
  const double speed = std::exp(log_speed);
  return {-std::expm1(log_speed) + 2 * speed * half * half, speed * std::sin(inclination)};
}

/// Integral from 0 of an even periodic function on s_j = pi j/m, without the part of its mean.
VectorXd odd_integral(const VectorXd& even) {
  const Index last = even.size() - 1;
  const auto angle = [&](Index product) {
    return pi * static_cast<double>(product % (2 * last)) / static_cast<double>(last);
  };
  VectorXd result = VectorXd::Zero(even.size());
  for (Index k = 1; k < last; ++k) {
    double coefficient = 0.5 * (even[0] + (k % 2 == 0 ? 1 : -1) * even[last]);
    for (Index j = 1; j < last; ++j) coefficient += even[j] * std::cos(angle(j * k));
    coefficient *= 2 / (static_cast<double>(last) * static_cast<double>(k));
    for (Index j = 1; j < last; ++j) result[j] += coefficient * std::sin(angle(j * k));
  }
  return result;
}

/// x in [-pi, pi].
double reduced(double x) {
  return std::remainder(x, 2 * pi);
}

}  // namespace

StokesSurface::StokesSurface(StokesSolution solution)
    : solution_(std::move(solution)), speed_(std::sqrt(solution_.speed_squared)) {
  integrate_position();
  place_contour();
}

StokesSurface StokesSurface::with_mean_depth(StokesCrest crest, double mean_depth, Resolution resolution) {
  if (std::isinf(mean_depth)) return StokesSurface(solve_stokes_wave(crest, mean_depth, resolution));
  double depth = mean_depth;
  StokesSurface wave(solve_stokes_wave(crest, depth, resolution));
  double excess = wave.mean_depth() - mean_depth;
  double slope = 1;
  constexpr int most_steps = 12;
  for (int step = 0; step < most_steps && std::abs(excess) > 2e-16 * mean_depth; ++step) {
    const double change = -excess / slope;
    const StokesSolution nearby = wave.solution();
    wave = StokesSurface(solve_stokes_wave(crest, depth + change, resolution, &nearby));
    depth += change;
    const double next = wave.mean_depth() - mean_depth;
    if (std::abs(next) >= 0.5 * std::abs(excess)) break;
    slope = (next - excess) / change;
    excess = next;
  }
  return wave;
}

void StokesSurface::integrate_position() {
  const auto& [nodes, potential, stretch, tau, theta, speed_squared, depth, correction] = solution_;
  const Index count = tau.size();
  const Index last = count - 1;
  const auto mean = [&](const VectorXd& even) {
    return (even.sum() - 0.5 * (even[0] + even[last])) / static_cast<double>(last);
  };
  const VectorXd inverse_speed = (-tau.array()).exp();
  const VectorXd advance = stretch.array() * theta.array().cos() * inverse_speed.array();
  const VectorXd climb = stretch.array() * theta.array().sin() * inverse_speed.array();
  const VectorXd head = -0.5 * speed_squared * (2 * tau.array()).unaryExpr([](double t) { return std::expm1(t); });
  const double mean_head = mean(head.cwiseProduct(advance));
  elevation_ = head.array() - mean_head;
  bernoulli_ = 0.5 * speed_squared - mean_head;
  const VectorXd periodic = odd_integral(advance);
  position_.resize(count);
  for (Index j = 0; j < count; ++j)
    position_[j] = pi * static_cast<double>(j) / static_cast<double>(last) + periodic[j];
  interpolation_ = TrigonometricInterpolation(elevation_, periodic, advance);
  const double conformal_mean = mean(elevation_.cwiseProduct(stretch));
  mean_depth_ = depth - conformal_mean;
  integrals_.impulse = -speed_ * conformal_mean;
  integrals_.kinetic_energy = -0.5 * speed_squared * mean((position_ - potential).cwiseProduct(climb));
  integrals_.potential_energy = 0.5 * mean(elevation_.cwiseProduct(elevation_).cwiseProduct(advance));
}

bool StokesSurface::bottom_matters() const {
  constexpr double deep = 19;  // exp(-2 k h) is below round-off
  return mean_depth_ < deep;
}

void StokesSurface::place_contour() {
  const auto& [nodes, potential, stretch, tau, theta, speed_squared, depth, correction] = solution_;
  const Index last = tau.size() - 1;
  for (Index j = 0; j <= last; ++j) {
    const Complex tangent = stretch[j] * std::polar(std::exp(-tau[j]), theta[j]);
    const Complex value = speed_ * velocity_defect(tau[j], theta[j]);
    const double fold = j == 0 || j == last ? 0.5 : 1;
    const Complex z(position_[j], elevation_[j]);
    if (bottom_matters()) {
      const Complex above_bottom = z + Complex(0, mean_depth_);
      const Complex root = std::sin(0.5 * above_bottom);
      velocity_.add(root * root, fold * Complex(0, 1) * std::sin(above_bottom) * tangent, value);
    } else {
      velocity_.add(std::exp(Complex(0, 1) * z), fold * tangent, value);
    }
  }
}

StokesSurface::Point StokesSurface::point(double label) const {
  const SurfaceSample sample = interpolation_.at(label);
  return {label, label + sample.displacement, sample.elevation, sample.stretch};
}

StokesSurface::Point StokesSurface::find(double x) const {
  const auto* begin = position_.data();
  const auto* end = begin + position_.size();
  const auto right = std::clamp<std::ptrdiff_t>(std::upper_bound(begin, end, x) - begin, 1, end - begin - 1);
  const double fraction = (x - position_[right - 1]) / (position_[right] - position_[right - 1]);
  const double spacing = pi / static_cast<double>(position_.size() - 1);
  const auto inside = [](double label) { return std::clamp(label, 0.0, pi); };
  Point result = point(inside((static_cast<double>(right - 1) + fraction) * spacing));
  constexpr double accuracy = 1e-9;  // the step after it is exact to round-off
  for (int step = 0; step < 8; ++step) {
    const double correction = (x - result.x) / result.stretch;
    const bool last = std::abs(correction) < accuracy;
    result = point(inside(result.label + correction));
    if (last) break;
  }
  return result;
}

double StokesSurface::elevation(double x) const {
  return find(std::abs(reduced(x))).elevation;
}

double StokesSurface::potential(double x) const {
  const double place = reduced(x);
  const Point surface = find(std::abs(place));
  const double potential = static_cast<double>(solution_.nodes.at(surface.label).potential);
  return std::copysign(speed_ * (surface.x - potential), place);
}

double StokesSurface::maximum_slope() const {
  Index steepest = 0;
  solution_.inclination.minCoeff(&steepest);
  const VectorXd none = VectorXd::Zero(position_.size());
  const TrigonometricInterpolation inclination(none, solution_.inclination, none);
  const double spacing = pi / static_cast<double>(position_.size() - 1);
  const double s = static_cast<double>(steepest) * spacing;
  return -boost::math::tools::brent_find_minima([&](double label) { return inclination.at(label).displacement; },
                                                s - spacing, s + spacing, 40)
              .second;
}

Velocity StokesSurface::velocity(double x, double y) const {
  const double place = reduced(x);
  const double distance = std::abs(place);
  constexpr double rounding = 1e-13;  // elevation(x) itself counts as inside
  const auto* begin = position_.data();
  const auto right = std::min<std::ptrdiff_t>(std::upper_bound(begin, begin + position_.size(), distance) - begin,
                                              position_.size() - 1);
  if (y > elevation_[right]) {
    const double surface = elevation(distance);
    if (y > surface + rounding) {
      throw OutsideFluid(
          fmt::format("k y = {:.17g} is above the surface: at k x = {:.17g} it must be in [{:.17g}, {:.17g}]", y, x,
                      -mean_depth_, surface));
    }
  }
  if (y < -mean_depth_ * (1 + rounding)) {
    throw OutsideFluid(fmt::format("k y = {:.17g} is below the bottom: it must be at least {:.17g}", y, -mean_depth_));
  }
  constexpr double calm = -100;  // velocities are below exp(-100)
  if (y < calm) return {};
  const Complex z(distance, y);
  Complex pole;
  if (bottom_matters()) {
    const Complex root = std::sin(0.5 * (z + Complex(0, mean_depth_)));
    pole = root * root;
  } else {
    pole = std::exp(Complex(0, 1) * z);
  }
  const Complex value = velocity_.at(pole, 0, velocity_.size());
  return {value.real(), place < 0 ? value.imag() : -value.imag()};
}

}  // namespace seiche::exact
