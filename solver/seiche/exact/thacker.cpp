#include "seiche/exact/thacker.hpp"

#include <cmath>
#include <numbers>

#include "seiche/require.hpp"

namespace seiche::exact {

namespace sw = shallow_water;

Thacker::Thacker(double gravity, double radius, double depth, double length, std::optional<double> displacement)
    : radius_(radius), depth_(depth), centre_(0.5 * length), displacement_(displacement.value_or(0.5 * radius)) {
  require_positive("gravity", gravity);
  require_positive("radius", radius);
  require_positive("depth", depth);
  require_positive("length", length);
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

Provenance Thacker::provenance() {
  return {
      "Thacker, Some exact solutions to the nonlinear shallow-water wave equations, J. Fluid Mech. 107 (1981) 499; "
      "Delestre et al., SWASHES (2013), section 4.2.1",
      "h = h0 (1 - ((x - L/2 - xi)/a)^2), u = xi', xi = -displacement cos(w t), w = sqrt(2 g h0)/a"};
}

}  // namespace seiche::exact
