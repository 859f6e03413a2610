#include "seiche/exact/thacker.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "seiche/require.hpp"

namespace seiche::exact {

namespace sw = shallow_water;

namespace {

/// Of the length of the channel: smaller bowls have too few digits of x.
constexpr double least_radius = 1e-6;

}  // namespace

Thacker::Thacker(double gravity, double radius, double depth, double length, std::optional<double> displacement)
    : radius_(radius), depth_(depth), centre_(0.5 * length), displacement_(displacement.value_or(0.5 * radius)) {
  require_positive("gravity", gravity);
  require_positive("radius", radius);
  require_positive("depth", depth);
  require_positive("length", length);
  require_within("radius", radius, least_radius * length, 0.5 * length);
  require_positive("displacement", displacement_);
  require_within("displacement", displacement_, 0, 0.5 * length - radius);
  frequency_ = std::sqrt(2 * gravity * depth) / radius;
}

double Thacker::elevation(double x) const {
  const double s = (x - centre_) / radius_;
  return depth_ * (s - 1) * (s + 1);
}

double Thacker::shift(double t) const {
  return -displacement_ * std::cos(frequency_ * t);
}
double Thacker::velocity(double t) const {
  return displacement_ * frequency_ * std::sin(frequency_ * t);
}
double Thacker::left_shoreline(double t) const {
  return centre_ + shift(t) - radius_;
}
double Thacker::right_shoreline(double t) const {
  return centre_ + shift(t) + radius_;
}
double Thacker::period() const {
  return 2 * std::numbers::pi / frequency_;
}

double Thacker::carried(double x0, double t) const {
  // cos 0 - cos wt = 2 sin^2(wt/2): no cancellation at small times.
  const double half = std::sin(0.5 * frequency_ * t);
  return x0 + 2 * displacement_ * half * half;
}

sw::State Thacker::at(double x, double t) const {
  require_finite("x", x);
  require_not_negative("t", t);
  const double s = (x - centre_ - shift(t)) / radius_;
  if (!(std::abs(s) < 1)) return {0, 0};
  return {depth_ * (1 - s) * (1 + s), velocity(t)};
}

Bed Thacker::bed() const {
  const double centre = centre_;
  const double radius = radius_;
  const double depth = depth_;
  return {[=](double x) {
            const double s = (x - centre) / radius;
            return depth * (s - 1) * (s + 1);
          },
          [=](double x) {
            const double s = (x - centre) / radius;
            return depth * radius * s * (s * s / 3 - 1);
          }};
}

// Twenty roundings where the channel is four radii long, of x up to its length.
double Thacker::uncertainty() const {
  return 10 * centre_ / radius_ * std::numeric_limits<double>::epsilon();
}

SelfTest Thacker::self_test() const {
  const double t = 0.3 * period();
  const double middle = 0.5 * (left_shoreline(t) + right_shoreline(t));
  // Simpson's rule is exact for the parabola between the shorelines.
  const double width = right_shoreline(t) - left_shoreline(t);
  const double water = width / 6 * 4 * at(middle, t).depth;
  // xi'' = -w^2 xi with w^2 = 2 g h0/a^2, from xi'^2 + w^2 xi^2 = const.
  const double swing = std::hypot(velocity(t), frequency_ * shift(t));
  const double limit = 32 * std::numeric_limits<double>::epsilon();
  return {{"the area of the water is 4 a h0/3", std::abs(water - area()) / area(),
           16 * centre_ / radius_ * std::numeric_limits<double>::epsilon(), "ten roundings at x up to L, over a"},
          {"xi'^2 + w^2 xi^2 is constant", std::abs(swing - velocity_amplitude()) / velocity_amplitude(), limit,
           "sine and cosine of the same phase"}};
}

Provenance Thacker::provenance() {
  return {
      "Thacker, Some exact solutions to the nonlinear shallow-water wave equations, J. Fluid Mech. 107 (1981) 499; "
      "Delestre et al., SWASHES (2013), section 4.2.1",
      "h = h0 (1 - ((x - L/2 - xi)/a)^2), u = xi', xi = -displacement cos(w t), w = sqrt(2 g h0)/a"};
}

static_assert(ReferenceSolution<Thacker>);

}  // namespace seiche::exact
