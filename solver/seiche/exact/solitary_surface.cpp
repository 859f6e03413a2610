#include "seiche/exact/solitary_surface.hpp"

#include <fmt/format.h>
#include <gsl/gsl_sf_expint.h>

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

/// The kernel 1/sinh(pi z/p) is below round-off at 12.5 p.
constexpr double kernel_reach = 12.5;

/// 1 - q exp(-i theta) without cancellation in the tail.
Complex defect(double log_speed, double inclination) {
  const double half = std::sin(0.5 * inclination);
  const double speed = std::exp(log_speed);
  return {-std::expm1(log_speed) + 2 * speed * half * half, speed * std::sin(inclination)};
}

}  // namespace

SolitarySurface::SolitarySurface(SolitaryCrest crest, Resolution resolution)
    : solution_(solve_solitary_wave(crest, resolution)),
      froude_(std::sqrt(solution_.froude_squared)),
      crest_speed_(std::sqrt(1 - 2 * solution_.elevation[0] / solution_.froude_squared)),
      decay_rate_(solitary_decay_rate(solution_.froude_squared)) {
  integrate_position();
  place_contour();
}

void SolitarySurface::integrate_position() {
  const auto& [nodes, spacing, potential, stretch, elevation, theta, froude_squared, correction] = solution_;
  const Index count = elevation.size();
  std::vector<double> sine_integral;  // Si(pi k)/pi
  for (Index k = 0; k < 2 * count; ++k) sine_integral.push_back(gsl_sf_Si(pi * static_cast<double>(k)) / pi);
  const auto si = [&](Index k) {
    return k < 0 ? -sine_integral[static_cast<std::size_t>(-k)] : sine_integral[static_cast<std::size_t>(k)];
  };
  const VectorXd tau = 0.5 * (-2 / froude_squared * elevation.array()).log1p();
  const VectorXd inverse_speed = (-tau.array()).exp();
  // dX/ds = (cos(theta)/q - 1) dphi/ds, dy/ds = sin(theta)/q dphi/ds.
  const VectorXd displacement_rate = stretch.array() * ((-tau.array()).unaryExpr([](double t) {
                                       return std::expm1(t);
                                     }) - 2 * inverse_speed.array() * (0.5 * theta.array()).sin().square());
  const VectorXd climb = stretch.array() * theta.array().sin() * inverse_speed.array();
  VectorXd displacement = VectorXd::Zero(count);
  for (Index i = 1; i < count; ++i) {
    double sum = displacement_rate[0] * si(i);
    for (Index j = 1; j < count; ++j) sum += displacement_rate[j] * (si(i - j) + si(i + j));
    displacement[i] = spacing * sum;
  }
  end_displacement_ = spacing * (displacement_rate.sum() - 0.5 * displacement_rate[0]);
  position_ = potential + displacement;
  VectorXd decaying = displacement;
  for (Index i = 0; i < count; ++i) {
    decaying[i] -= end_displacement_ * std::tanh(0.5 * static_cast<double>(i) * spacing);
  }
  interpolation_ = SincInterpolation(spacing, elevation, decaying, displacement_rate);
  const VectorXd advance = stretch + displacement_rate;
  const auto line_integral = [&](const VectorXd& even) { return 2 * spacing * (even.sum() - 0.5 * even[0]); };
  integrals_.mass = line_integral(elevation.cwiseProduct(advance));
  integrals_.potential_energy = 0.5 * line_integral(elevation.cwiseProduct(elevation).cwiseProduct(advance));
  integrals_.kinetic_energy = -0.5 * froude_squared * line_integral(displacement.cwiseProduct(climb));
  integrals_.circulation = 2 * froude_ * end_displacement_;
}

void SolitarySurface::place_contour() {
  const auto& [nodes, spacing, potential, stretch, elevation, theta, froude_squared, correction] = solution_;
  const Index count = elevation.size();
  // Poles of the kernel at z + i p must stay outside the wave and its image, 2 (1 + a) < 3.7 high.
  kernel_period_ = std::max(6.0, 3 / decay_rate_);
  const double last = position_[count - 1] + kernel_reach * kernel_period_;
  for (Index j = 0; contour_.empty() || contour_.back() < last; ++j) {
    const double s = static_cast<double>(j) * spacing;
    double x = 0;
    double y = 0;
    Complex tangent;
    Complex value = 0;
    if (j < count) {
      const double tau = 0.5 * std::log1p(-2 / froude_squared * elevation[j]);
      x = position_[j];
      y = elevation[j];
      tangent = stretch[j] * std::polar(std::exp(-tau), theta[j]);
      value = froude_ * defect(tau, theta[j]);
    } else {
      x = static_cast<double>(nodes.potential(s)) + end_displacement_;
      tangent = nodes.stretch(s);
    }
    const Complex argument = Complex(x, 1 + y) * (pi / kernel_period_);
    velocity_.add(pole(x, y), (j == 0 ? 0.5 : 1.0) * Complex(0, 1) * std::sinh(argument) * tangent, value);
    contour_.push_back(x);
  }
}

Complex SolitarySurface::pole(double x, double y) const {
  const Complex root = std::sinh(Complex(x, 1 + y) * (pi / kernel_period_));
  return root * root;
}

SolitarySurface::Point SolitarySurface::point(double label) const {
  const SurfaceSample sample = interpolation_.at(label);
  const double displacement = end_displacement_ * std::tanh(0.5 * label) + sample.displacement;
  return {label, static_cast<double>(solution_.nodes.potential(label)) + displacement, displacement, sample.elevation,
          solution_.nodes.stretch(label) + sample.stretch};
}

SolitarySurface::Point SolitarySurface::find(double x) const {
  const auto begin = contour_.begin();
  const auto end = begin + solution_.elevation.size();
  const auto right = std::clamp<std::ptrdiff_t>(std::upper_bound(begin, end, x) - begin, 1, end - begin - 1);
  const double left_x = position_[right - 1];
  const double fraction = (x - left_x) / (position_[right] - left_x);
  Point result = point((static_cast<double>(right - 1) + fraction) * solution_.spacing);
  // The map is monotone and nearly linear between nodes: Newton's method converges from the chord.
  constexpr double accuracy = 1e-9;  // the step after it is exact to round-off
  for (int step = 0; step < 8; ++step) {
    const double correction = (x - result.x) / result.stretch;
    const bool last = std::abs(correction) < accuracy;
    result = point(std::max(0.0, result.label + correction));
    if (last) break;
  }
  return result;
}

double SolitarySurface::elevation(double x) const {
  const double distance = std::abs(x);
  const Index last = position_.size() - 1;
  if (distance >= position_[last]) return 0;
  return find(distance).elevation;
}

double SolitarySurface::potential(double x) const {
  const double distance = std::abs(x);
  const Index last = position_.size() - 1;
  const double value = distance >= position_[last] ? end_displacement_ : find(distance).displacement;
  return std::copysign(froude_ * value, x);
}

double SolitarySurface::half_width() const {
  const Index count = position_.size();
  Index right = 1;
  while (right < count - 1 && solution_.elevation[right] > 0.5 * amplitude()) ++right;
  double low = static_cast<double>(right - 1) * solution_.spacing;
  double high = static_cast<double>(right) * solution_.spacing;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (point(middle).elevation > 0.5 * amplitude() ? low : high) = middle;
  }
  return point(0.5 * (low + high)).x;
}

double SolitarySurface::maximum_slope() const {
  Index steepest = 0;
  solution_.inclination.minCoeff(&steepest);
  const VectorXd none = VectorXd::Zero(position_.size());
  const SincInterpolation inclination(solution_.spacing, none, solution_.inclination, none);
  const auto at = [&](double s) { return inclination.at(s).displacement; };
  const double s = static_cast<double>(steepest) * solution_.spacing;
  return -boost::math::tools::brent_find_minima(at, s - solution_.spacing, s + solution_.spacing, 40).second;
}

Velocity SolitarySurface::velocity(double x, double y) const {
  const double distance = std::abs(x);
  const Index count = position_.size();
  constexpr double rounding = 1e-13;  // elevation(x) itself counts as inside
  const auto right = std::upper_bound(contour_.begin(), contour_.begin() + count, distance) - contour_.begin();
  const double lowest = right < count ? solution_.elevation[right] : 0;
  if (y > lowest) {
    const double surface = elevation(x);
    if (y > surface + rounding) {
      throw OutsideFluid(fmt::format(
          "y/depth = {:.17g} is above the surface: at x/depth = {:.17g} it must be in [-1, {:.17g}]", y, x, surface));
    }
  }
  if (y < -1 - rounding) {
    throw OutsideFluid(fmt::format("y/depth = {:.17g} is below the bottom: it must be at least -1", y));
  }
  if (distance >= position_[count - 1]) return {};
  const double reach = kernel_reach * kernel_period_;
  const auto index = [&](double bound) {
    return static_cast<std::size_t>(std::lower_bound(contour_.begin(), contour_.end(), bound) - contour_.begin());
  };
  const Complex value = velocity_.at(pole(distance, y), index(distance - reach), index(distance + reach));
  return {value.real(), x < 0 ? value.imag() : -value.imag()};
}

}  // namespace seiche::exact
