#include "seiche/exact/conformal_wave.hpp"

#include <algorithm>
#include <array>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::exact {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;
constexpr long double long_pi = std::numbers::pi_v<long double>;

/// asinh(width sinh s) for s >= 0 without overflow.
long double line_map(double s, double width) {
  const auto length = static_cast<long double>(s);
  return length < 100 ? std::asinh(width * std::sinh(length)) : length + std::log(static_cast<long double>(width));
}

/// 1 - q exp(-i theta) without cancellation in gentle waves.
Complex velocity_defect(double log_speed, double inclination) {
  const double half = std::sin(0.5 * inclination);
  const double speed = std::exp(log_speed);
  return {-std::expm1(log_speed) + 2 * speed * half * half, speed * std::sin(inclination)};
}

}  // namespace

void require_resolution(Resolution resolution) {
  require_within("resolution.refinement", resolution.refinement, 0.5, 2);
  require_within("resolution.clustering", resolution.clustering, 0.25, 4);
}

long double LineNodes::potential(double s) const {
  return (uniform() ? static_cast<long double>(s) : line_map(s, width_)) / rate_;
}

double LineNodes::stretch(double s) const {
  if (uniform() || s >= 100) return 1 / rate_;
  const double sinh = width_ * std::sinh(s);
  return width_ * std::cosh(s) / (rate_ * std::sqrt(1 + sinh * sinh));
}

double LineNodes::label(double potential) const {
  const double length = rate_ * potential;
  if (uniform()) return length;
  return length < 300 ? std::asinh(std::sinh(length) / width_) : length - std::log(width_);
}

PeriodicNodes::PeriodicNodes(double width) : width_(width) {
  long double a = 1;
  long double b = width_;
  while (std::abs(a - b) > 1e-10L * a) {  // quadratic convergence: one more mean is exact
    const long double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  quarter_period_ = long_pi / (a + b);
}

PeriodicNodes::Jacobi PeriodicNodes::jacobi(long double u) const {
  constexpr int levels = 12;
  std::array<long double, levels> ratio{};
  long double a = 1;
  long double b = width_;
  long double angle = u;
  int last = 0;
  while (last < levels && std::abs(a - b) > 1e-20L * a) {
    const long double mean = (a + b) / 2;
    ratio[static_cast<std::size_t>(last++)] = (a - b) / 2 / mean;
    b = std::sqrt(a * b);
    a = mean;
    angle *= 2;
  }
  angle *= a;
  while (last > 0) angle = (angle + std::asin(ratio[static_cast<std::size_t>(--last)] * std::sin(angle))) / 2;
  const long double sn = std::sin(angle);
  const long double cn = std::cos(angle);
  return {sn, cn, std::sqrt(cn * cn + width_ * width_ * sn * sn)};
}

PeriodicNodes::Node PeriodicNodes::at(double s) const {
  const long double u = static_cast<long double>(s) / long_pi * quarter_period_;
  const long double scale = 2 * quarter_period_ / long_pi;
  if (2 * u < quarter_period_) {
    const auto [sn, cn, dn] = jacobi(u);
    return {2 * std::atan2(width_ * sn, cn), static_cast<double>(scale * width_ / dn)};
  }
  // sn(u) = cn(v)/dn(v), cn(u) = k' sn(v)/dn(v), dn(u) = k'/dn(v) with v = K - u: no loss where cn(u) is small.
  const auto [sn, cn, dn] = jacobi(std::max(quarter_period_ - u, 0.0L));
  return {2 * std::atan2(cn, sn), static_cast<double>(scale * dn)};
}

double PeriodicNodes::label(double potential) const {
  double low = 0;
  double high = std::numbers::pi;
  double s = potential;
  for (int step = 0; step < 60 && high - low > 1e-15; ++step) {
    const Node node = at(s);
    const double excess = static_cast<double>(node.potential) - potential;
    (excess > 0 ? high : low) = s;
    const double next = s - excess / node.stretch;
    if (std::abs(next - s) < 1e-15) return next;
    s = next > low && next < high ? next : 0.5 * (low + high);
  }
  return s;
}

SincInterpolation::SincInterpolation(double spacing, const VectorXd& elevation, const VectorXd& displacement,
                                     const VectorXd& stretch)
    : spacing_(spacing) {
  for (Index j = 0; j < elevation.size(); ++j) {
    const double sign = j % 2 == 0 ? 1 : -1;
    const double fold = j == 0 ? 0.5 : 1;
    elevation_.push_back(sign * fold * elevation[j]);
    displacement_.push_back(sign * static_cast<double>(j) * displacement[j]);
    stretch_.push_back(sign * fold * stretch[j]);
    position_.push_back(static_cast<double>(j));
  }
}

SurfaceSample SincInterpolation::at(double s) const {
  const double t = s / spacing_;
  const double nearest = std::round(t);
  const double offset = t - nearest;
  const double sign = std::fmod(nearest, 2) == 0 ? 1 : -1;
  if (std::abs(offset) < 1e-290) {
    const auto j = static_cast<std::size_t>(nearest);
    const double fold = sign * (j == 0 ? 2 : 1);
    return {fold * elevation_[j], j == 0 ? 0 : sign * displacement_[j] / nearest, fold * stretch_[j]};
  }
  double elevation = 0;
  double displacement = 0;
  double stretch = 0;
#pragma omp simd reduction(+ : elevation, displacement, stretch)
  for (std::size_t j = 0; j < position_.size(); ++j) {
    const double kernel = 1 / ((t - position_[j]) * (t + position_[j]));
    elevation += elevation_[j] * kernel;
    displacement += displacement_[j] * kernel;
    stretch += stretch_[j] * kernel;
  }
  const double factor = 2 * sign * std::sin(std::numbers::pi * offset) / std::numbers::pi;
  return {factor * t * elevation, factor * displacement, factor * t * stretch};
}

TrigonometricInterpolation::TrigonometricInterpolation(const VectorXd& elevation, const VectorXd& displacement,
                                                       const VectorXd& stretch) {
  const Index intervals = elevation.size() - 1;
  for (Index j = 0; j <= intervals; ++j) {
    const double s = std::numbers::pi * static_cast<double>(j) / static_cast<double>(intervals);
    const double half = std::sin(0.5 * s);
    const bool end = j == 0 || j == intervals;
    const double weight = (j % 2 == 0 ? 1 : -1) * (end ? 0.5 : 1.0);
    position_.push_back(half * half);
    weight_.push_back(weight);
    elevation_.push_back(weight * elevation[j]);
    displacement_.push_back(end ? 0 : weight * displacement[j] * std::sin(s));
    stretch_.push_back(weight * stretch[j]);
  }
}

SurfaceSample TrigonometricInterpolation::at(double s) const {
  const double half = std::sin(0.5 * s);
  const double position = half * half;
  double elevation = 0;
  double displacement = 0;
  double stretch = 0;
  double total = 0;
  double sine = std::sin(s);
#pragma omp simd reduction(+ : elevation, displacement, stretch, total)
  for (std::size_t j = 0; j < position_.size(); ++j) {
    const double kernel = 1 / (position_[j] - position);
    total += weight_[j] * kernel;
    elevation += elevation_[j] * kernel;
    displacement += displacement_[j] * kernel;
    stretch += stretch_[j] * kernel;
  }
  if (!std::isfinite(total)) {  // a node's own place
    std::size_t j = 0;
    while (position_[j] != position) ++j;
    sine = 2 * std::sqrt(position * (1 - position));
    total = weight_[j];
    elevation = elevation_[j];
    displacement = displacement_[j];
    stretch = stretch_[j];
  }
  return {elevation / total, sine > 0 ? displacement / (total * sine) : 0, stretch / total};
}

ConformalSurface::Point ConformalSurface::find(double x) const {
  const auto* begin = position_.data();
  const auto* end = begin + position_.size();
  const auto right = std::clamp<std::ptrdiff_t>(std::upper_bound(begin, end, x) - begin, 1, end - begin - 1);
  const double fraction = (x - position_[right - 1]) / (position_[right] - position_[right - 1]);
  const auto inside = [&](double label) { return std::clamp(label, 0.0, last_label_); };
  // The map is monotone and nearly linear between nodes: Newton's method converges from the chord.
  Point result = point(inside((static_cast<double>(right - 1) + fraction) * spacing_));
  constexpr double accuracy = 1e-9;  // the step after it is exact to round-off
  for (int step = 0; step < 8; ++step) {
    const double correction = (x - result.x) / result.stretch;
    const bool last = std::abs(correction) < accuracy;
    result = point(inside(result.label + correction));
    if (last) break;
  }
  return result;
}

double ConformalSurface::elevation(double x) const {
  const double distance = std::abs(reduced(x));
  return distance >= end_ ? 0 : find(distance).elevation;
}

void ConformalSurface::add_to_contour(Complex z, double log_speed, double inclination, double stretch) {
  const Complex tangent = stretch * std::polar(std::exp(-log_speed), inclination);
  velocity_.add(pole(z), pole_slope(z) * tangent, speed_ * velocity_defect(log_speed, inclination));
  contour_.push_back(z.real());
}

double ConformalSurface::steepest(const VectorXd& inclination, const std::function<double(double)>& between) const {
  Index node = 0;
  inclination.minCoeff(&node);
  const double s = static_cast<double>(node) * spacing_;
  return -boost::math::tools::brent_find_minima(between, s - spacing_, s + spacing_, 40).second;
}

Velocity ConformalSurface::velocity(double x, double y) const {
  const double place = reduced(x);
  const double distance = std::abs(place);
  constexpr double rounding = 1e-13;  // elevation(x) itself counts as inside
  const auto* begin = position_.data();
  const auto right = std::min<std::ptrdiff_t>(std::upper_bound(begin, begin + position_.size(), distance) - begin,
                                              position_.size() - 1);
  if (y > elevation_[right]) {
    const double surface = elevation(distance);
    require_that<OutsideFluid>(
        y <= surface + rounding,
        "{0}y{1} = {2:.17g} is above the surface: at {0}x{1} = {3:.17g} it must be in [{4:.17g}, {5:.17g}]", before_,
        after_, y, x, -depth_, surface);
  }
  require_that<OutsideFluid>(y >= -depth_ * (1 + rounding),
                             "{0}y{1} = {2:.17g} is below the bottom: it must be at least {3:.17g}", before_, after_, y,
                             -depth_);
  constexpr double calm = -100;  // velocities are below exp(-100)
  if (y < calm || distance >= end_) return {};
  const auto index = [&](double bound) {
    return static_cast<std::size_t>(std::lower_bound(contour_.begin(), contour_.end(), bound) - contour_.begin());
  };
  const Complex value = velocity_.at(pole({distance, y}), index(distance - reach_), index(distance + reach_));
  return {value.real(), place < 0 ? value.imag() : -value.imag()};
}

double section_flux(const ConformalSurface& wave, double bottom) {
  constexpr int panels = 14;
  constexpr double ratio = 0.4;
  const double top = wave.crest();
  double sum = 0;
  for (int panel = 0; panel < panels; ++panel) {
    const double far = (top - bottom) * std::pow(ratio, panel);
    const double near = panel + 1 < panels ? ratio * far : 0;
    sum += boost::math::quadrature::gauss<double, 20>::integrate(
        [&](double depth) { return wave.velocity(0, top - depth).u; }, near, far);
  }
  return sum;
}

}  // namespace seiche::exact
