#include "seiche/exact/stretching_drop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

#include "seiche/require.hpp"

namespace seiche::exact {
namespace {

constexpr double round_off = std::numeric_limits<double>::epsilon();

/// sqrt(2 (1 + 2 s^2)/(1 + s^2)), between sqrt 2 and 2; the division last keeps it finite for any s.
double slowness(double s) {
  return std::sqrt(2 * (2 - 1 / (1 + s * s)));
}

/// a/c of sigma = (a/c - c/a)/2.
double stretch(double sigma) {
  return sigma >= 0 ? sigma + std::hypot(1, sigma) : 1 / (std::hypot(1, sigma) - sigma);
}

}  // namespace

StretchingDrop::StretchingDrop(double semi_axis, double other_axis, double strain_rate, double density)
    : density_(density) {
  require_positive("semi_axis", semi_axis);
  require_positive("other_axis", other_axis);
  require_positive("magnitude of the strain_rate", std::abs(strain_rate));
  require_positive("density", density);
  mean_axis_ = std::sqrt(semi_axis) * std::sqrt(other_axis);
  start_ = 0.5 * (semi_axis - other_axis) / mean_axis_;
  invariant_ = strain_rate * strain_rate * (semi_axis * semi_axis + other_axis * other_axis);
  direction_ = std::copysign(1.0, strain_rate);
}

double StretchingDrop::time_between(double from, double to) const {
  // With sigma = sinh w the integrand is sqrt(2 cosh 2w), singular at w = +-i pi/4: 30 points per panel of at most 1
  // leave 1e-30.
  const double first = std::asinh(from);
  const double width = std::asinh(to) - first;
  const double panels = std::max(1.0, std::ceil(std::abs(width)));
  double integral = 0;
  for (double k = 0; k < panels; ++k) {
    integral += boost::math::quadrature::gauss<double, 30>::integrate(
        [](double w) { return std::sqrt(2 * std::cosh(2 * w)); }, first + width * k / panels,
        first + width * (k + 1) / panels);
  }
  return direction_ * mean_axis_ / std::sqrt(invariant_) * integral;
}

double StretchingDrop::elongation(double t) const {
  require_finite("t", t);
  // d sigma/dt lies between v/2 and v/sqrt 2: Newton's steps cannot leave the half-line and converge from anywhere.
  const double speed = direction_ * std::sqrt(invariant_) / mean_axis_;
  double sigma = start_ + speed * t / slowness(start_ + 0.5 * speed * t);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const double step = (t - time_between(start_, sigma)) * speed / slowness(sigma);
    sigma += step;
    if (std::abs(step) <= 4 * round_off * (std::abs(sigma) + std::abs(start_))) break;
  }
  return sigma;
}

double StretchingDrop::rate_at(double elongation) const {
  const double ratio = stretch(elongation);
  return direction_ * std::sqrt(invariant_) / (mean_axis_ * std::hypot(ratio, 1 / ratio));
}

double StretchingDrop::semi_axis(double t) const {
  return mean_axis_ * stretch(elongation(t));
}
double StretchingDrop::other_axis(double t) const {
  return mean_axis_ * stretch(-elongation(t));
}
double StretchingDrop::strain_rate(double t) const {
  return rate_at(elongation(t));
}

double StretchingDrop::time_of(double semi_axis) const {
  require_positive("semi_axis", semi_axis);
  const double ratio = semi_axis / mean_axis_;
  return time_between(start_, 0.5 * (ratio - 1 / ratio));
}

DropInstant StretchingDrop::at(double t) const {
  const double sigma = elongation(t);
  const double a = mean_axis_ * stretch(sigma);
  const double b = mean_axis_ * stretch(-sigma);
  const double alpha = rate_at(sigma);
  const double crossing = alpha * a * b / std::hypot(a, b);
  return {.deformation = Eigen::Vector2d(a, b).asDiagonal(),
          .rate = Eigen::Vector2d(alpha * a, -alpha * b).asDiagonal(),
          .central_pressure = density_ * crossing * crossing};
}

Eigen::Vector2d StretchingDrop::carried(double x0, double y0, double t) const {
  static_cast<void>(at(0).velocity(x0, y0));  // throws outside the drop
  const double factor = stretch(elongation(t)) / stretch(start_);
  return {x0 * factor, y0 / factor};
}

Provenance StretchingDrop::provenance() {
  return {
      "Dirichlet, Abh. Kgl. Ges. Wiss. Goettingen 8 (1860) 3; Longuet-Higgins, J. Fluid Mech. 55 (1972) 529; "
      "Monaghan, J. Comput. Phys. 110 (1994) 399",
      "alpha^2 (a^2 + b^2) = C, a b = c^2, t = (c/sqrt C) int sqrt(2 (1 + 2 s^2)/(1 + s^2)) ds, s = (a - b)/(2 c)"};
}

double StretchingDrop::uncertainty() const {
  return 1e-14;
}

SelfTest StretchingDrop::self_test() const {
  const double unit = mean_axis_ / std::sqrt(invariant_);
  const double t = 1.7 * unit * std::hypot(1, start_);  // as much deformation where the ellipse is slender
  const double a = semi_axis(t);
  const double b = other_axis(t);
  const double alpha = strain_rate(t);
  // The quadrature solves the equation of motion: an independent integrator must arrive at the same ellipse.
  const DropInstant start = at(0);
  const AffineDrop general(start.deformation, Eigen::Vector2d(strain_rate(0), -strain_rate(0)).asDiagonal(), density_);
  const DropInstant end = general.at(t);
  return {
      {"a b = c^2", std::abs(a * b / (mean_axis_ * mean_axis_) - 1), 8 * round_off, "8 roundings"},
      {"alpha^2 (a^2 + b^2) = C", std::abs(alpha * alpha * (a * a + b * b) / invariant_ - 1), 16 * round_off,
       "16 roundings"},
      {"time of the axis at time t is t", std::abs(time_of(a) / t - 1), 64 * round_off,
       "two quadratures of 30 points a panel, axis rounded"},
      {"the ellipse is that of the integrated equation of motion",
       (end.deformation - at(t).deformation).norm() / at(t).deformation.norm(),
       3 * (1.7 * 1e-14 + 4 * round_off * std::sqrt(30)),
       "steps that keep their errors of seventh order at 1e-14; the solution of eighth order that is carried on errs "
       "less by the step, and all steps together last at most 1.7 in units of the strain; rounded in about 30 steps; "
       "growing at most as the deformation, threefold"}};
}

static_assert(ReferenceSolution<StretchingDrop>);

}  // namespace seiche::exact
