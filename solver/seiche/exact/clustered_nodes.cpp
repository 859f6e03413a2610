#include "seiche/exact/clustered_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace seiche::exact {
namespace {

constexpr long double long_pi = std::numbers::pi_v<long double>;

/// asinh(width sinh s) for s >= 0 without overflow.
long double line_map(double s, double width) {
  const auto length = static_cast<long double>(s);
  return length < 100 ? std::asinh(width * std::sinh(length)) : length + std::log(static_cast<long double>(width));
}

}  // namespace

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

}  // namespace seiche::exact
