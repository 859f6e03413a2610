#include "seiche/exact/affine_drop.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/LU>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double tolerance = 1e-14;
/// |X|^2 of a surface point that carries round-off of a few maps.
constexpr double outermost = 1 + 1e-12;

/// Accuracy of an integrated motion that lasts so long, in units of its strength.
double integrated(double duration) {
  return 3 * (duration * tolerance + 4 * epsilon * std::sqrt(30));
}
const std::string steps_of_drop =
    "steps that keep their errors of seventh order at 1e-14; the solution of eighth order that is carried on errs less "
    "by the step; rounded in about 30 steps; growing at most as the deformation, threefold";

/// sqrt(2 (1 + 2 s^2)/(1 + s^2)), between sqrt 2 and 2; the division last keeps it finite for any s.
double slowness(double s) {
  return std::sqrt(2 * (2 - 1 / (1 + s * s)));
}

/// a/c of sigma = (a/c - c/a)/2.
double stretch(double sigma) {
  return sigma >= 0 ? sigma + std::hypot(1, sigma) : 1 / (std::hypot(1, sigma) - sigma);
}

}  // namespace

Vector2d DropInstant::label(double x, double y) const {
  require_finite("x", x);
  require_finite("y", y);
  const Vector2d particle = deformation.inverse() * Vector2d(x, y);
  if (!(particle.squaredNorm() <= outermost)) {
    // The range of y inside the drop at this x, from the quadratic |A^-1 (x, y)|^2 = 1.
    const Matrix2d form = (deformation * deformation.transpose()).inverse();
    const double middle = -form(0, 1) / form(1, 1) * x;
    const double half = (1 - form.determinant() / form(1, 1) * x * x) / form(1, 1);
    const double widest = std::sqrt(form(1, 1) / form.determinant());
    require_that<OutsideFluid>(half >= 0, "x = {:.17g} is outside the drop: must be in [{:g}, {:g}]", x, -widest,
                               widest);
    require_that<OutsideFluid>(false, "y = {:.17g} is outside the drop at x = {:g}: must be in [{:g}, {:g}]", y, x,
                               middle - std::sqrt(half), middle + std::sqrt(half));
  }
  return particle;
}

StretchingDrop::StretchingDrop(double semi_axis, double other_axis, double strain_rate, double density)
    : density_(density) {
  require_all_positive({{"semi_axis", semi_axis},
                        {"other_axis", other_axis},
                        {"magnitude of the strain_rate", std::abs(strain_rate)},
                        {"density", density}});
  mean_axis_ = std::sqrt(semi_axis) * std::sqrt(other_axis);
  start_ = 0.5 * (semi_axis - other_axis) / mean_axis_;
  invariant_ = strain_rate * strain_rate * (semi_axis * semi_axis + other_axis * other_axis);
  direction_ = std::copysign(1.0, strain_rate);
}

double StretchingDrop::time_between(double from, double to) const {
  // With sigma = sinh w the integrand is sqrt(2 cosh 2w), singular at w = +-i pi/4: 30 points per panel of at most 1
  // leave 1e-30.
  const double first = std::asinh(from);
  const double last = std::asinh(to);
  const auto panels = std::max(1, static_cast<int>(std::ceil(std::abs(last - first))));
  return direction_ * mean_axis_ / std::sqrt(invariant_) *
         integral<30>([](double w) { return std::sqrt(2 * std::cosh(2 * w)); }, first, last, panels);
}

double StretchingDrop::elongation(double t) const {
  require_finite("t", t);
  // d sigma/dt lies between v/2 and v/sqrt 2: Newton's steps cannot leave the half-line and converge from anywhere.
  const double speed = direction_ * std::sqrt(invariant_) / mean_axis_;
  double sigma = start_ + speed * t / slowness(start_ + 0.5 * speed * t);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const double step = (t - time_between(start_, sigma)) * speed / slowness(sigma);
    sigma += step;
    if (std::abs(step) <= 4 * epsilon * (std::abs(sigma) + std::abs(start_))) break;
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

SelfTest StretchingDrop::self_test() const {
  const double unit = mean_axis_ / std::sqrt(invariant_);
  const double t = 1.7 * unit * std::hypot(1, start_);  // as much deformation where the ellipse is slender
  const double a = semi_axis(t);
  const double b = other_axis(t);
  const double alpha = strain_rate(t);
  // The quadrature solves the equation of motion: an independent integrator must arrive at the same ellipse. Of a/c and
  // alpha over its magnitude at the start:
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 2>;
  const double strength = std::abs(strain_rate(0));
  State ellipse{semi_axis(0) / mean_axis_, direction_};
  const auto motion = [](const State& now, State& change, double) {
    const double slenderness = std::pow(now[0], 4);  // (a/b)^2
    change = {now[1] * now[0], now[1] * now[1] * (1 - slenderness) / (1 + slenderness)};
  };
  odeint::integrate_adaptive(odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_fehlberg78<State>()),
                             motion, ellipse, 0.0, t * strength, std::min(0.02, t * strength));
  return {
      {"a b = c^2", departure(a * b, mean_axis_ * mean_axis_), 8 * epsilon, "8 roundings"},
      {"alpha^2 (a^2 + b^2) = C", departure(alpha * alpha * (a * a + b * b), invariant_), 16 * epsilon, "16 roundings"},
      {"time of the axis at time t is t", departure(time_of(a), t), 64 * epsilon,
       "two quadratures of 30 points a panel, axis rounded"},
      {"the ellipse agrees with the integrated equation of motion", departure(ellipse[0] * mean_axis_, a),
       integrated(1.7), steps_of_drop}};
}

static_assert(ReferenceSolution<StretchingDrop>);

ExactSolution affine_drop_entry() {
  return Entry<StretchingDrop>{
      .name = "affine_drop",
      .title = "A free liquid ellipse is stretched, without gravity",
      .citation =
          "Dirichlet, Abh. Kgl. Ges. Wiss. Goettingen 8 (1860) 3; Longuet-Higgins, J. Fluid Mech. 55 (1972) 529; "
          "Monaghan, J. Comput. Phys. 110 (1994) 399",
      .formula =
          "alpha^2 (a^2 + b^2) = C, a b = c^2, t = (c/sqrt C) int sqrt(2 (1 + 2 s^2)/(1 + s^2)) ds, s = (a - b)/(2 c)",
      .parameters = {{"semi_axis", "m", 1, 1e-9, 1e6, "semi-axis along x at t = 0"},
                     {"other_axis", "m", 1, 1e-9, 1e6, "semi-axis along y at t = 0"},
                     {"strain_rate", "1/s", 1, -1e6, 1e6, "u = strain_rate x, v = -strain_rate y at t = 0"},
                     {"density", "kg/m^3", 1, 1e-9, 1e9, "density"}},
      .inputs = {position_x, {"y", "m", 0, "vertical position"}, time_t},
      .outputs = {{"a", "m", "semi-axis along x"},
                  {"b", "m", "semi-axis along y"},
                  {"rate", "1/s", "strain rate"},
                  {"u", "m/s", "velocity along x"},
                  {"v", "m/s", "velocity along y"},
                  {"p", "Pa", "pressure"}},
      .scalars = {{"invariant", "m^2/s^2", "rate^2 (a^2 + b^2), constant", &StretchingDrop::invariant},
                  {"time_of_doubling", "s", "when the semi-axis along x is twice what it was",
                   [](const StretchingDrop& drop) { return drop.time_of(2 * drop.semi_axis(0)); }}},
      .make = from<StretchingDrop>("semi_axis", "other_axis", "strain_rate", "density"),
      .row = [](const StretchingDrop& drop, At at) {
        const double t = at[2];
        const DropInstant instant = drop.at(t);
        const Eigen::Vector2d velocity = instant.velocity(at[0], at[1]);
        return Row{drop.semi_axis(t), drop.other_axis(t), drop.strain_rate(t),
                   velocity.x(),      velocity.y(),       instant.pressure(at[0], at[1])};
      }};
}

}  // namespace seiche::exact
