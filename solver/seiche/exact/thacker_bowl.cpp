#include "seiche/exact/thacker_bowl.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

static_assert(ReferenceSolution<ThackerRadialBowl>);
static_assert(ReferenceSolution<ThackerPlanarBowl>);

namespace {

using std::numbers::pi;
constexpr int instants = 12;
constexpr double smallest_start = 1e-6;  // of the radius: 1 - A is then 2e-12, and known to 1e-4

const std::string thacker = "Thacker, J. Fluid Mech. 107 (1981) 499; Delestre et al., SWASHES (2013), section 4.2.2";

void require_bowl(double gravity, double radius, double depth) {
  require_positive("gravity", gravity);
  require_positive("radius", radius);
  require_positive("depth", depth);
}

double paraboloid(double x, double y, double radius, double depth) {
  const double r = std::hypot(x, y) / radius;
  return depth * (r - 1) * (r + 1);
}

}  // namespace

ThackerRadialBowl::ThackerRadialBowl(double gravity, double radius, double depth, double start_radius)
    : gravity_(gravity), radius_(radius), depth_(depth) {
  require_bowl(gravity, radius, depth);
  require_positive("start_radius", start_radius);
  require_within("start_radius", start_radius, 0, radius);
  const double q = start_radius / radius;
  amplitude_ = (1 - q) * (1 + q) / (1 + q * q);
  if (!(q >= smallest_start)) {
    throw std::invalid_argument(fmt::format(
        "start_radius = {:g} is out of range: must be at least {:g} of the radius {:g}, or 1 - A is lost in "
        "rounding",
        start_radius, smallest_start, radius));
  }
  require_positive("1 - start_radius/radius", amplitude_);
  frequency_ = std::sqrt(8 * gravity * depth) / radius;
}

double ThackerRadialBowl::stretch(double t) const {
  require_finite("t", t);
  return 1 - amplitude_ * std::cos(frequency_ * t);
}

double ThackerRadialBowl::bed(double x, double y) const {
  return paraboloid(x, y, radius_, depth_);
}

double ThackerRadialBowl::shoreline(double t) const {
  return radius_ * std::sqrt(stretch(t) / std::sqrt((1 - amplitude_) * (1 + amplitude_)));
}

double ThackerRadialBowl::surface(double x, double y, double t) const {
  const double centre = std::sqrt((1 - amplitude_) * (1 + amplitude_)) / stretch(t);
  const double r2 = (x * x + y * y) / (radius_ * radius_);
  return depth_ * (centre - 1) * (1 - r2 * (centre + 1));
}

BowlState ThackerRadialBowl::at(double x, double y, double t) const {
  require_finite("x", x);
  require_finite("y", y);
  const double edge = shoreline(t);
  const double r = std::hypot(x, y) / edge;
  if (!(r < 1)) return {};
  const double d = stretch(t);
  const double centre = std::sqrt((1 - amplitude_) * (1 + amplitude_)) / d;
  const double rate = 0.5 * frequency_ * amplitude_ * std::sin(frequency_ * t) / d;
  return {depth_ * centre * (1 - r) * (1 + r), rate * x, rate * y};
}

PlanePoint ThackerRadialBowl::carried(PlanePoint start, double t) const {
  const double factor = std::sqrt(stretch(t) / stretch(0));
  return {factor * start.x, factor * start.y};
}

double ThackerRadialBowl::period() const {
  return 2 * pi / frequency_;
}

double ThackerRadialBowl::volume() const {
  return 0.5 * pi * radius_ * radius_ * depth_;
}

double ThackerRadialBowl::energy() const {
  // At rest (t = 0) the surface is a paraboloid of centre height h0 c, c = sqrt((1 + A)/(1 - A)).
  const double c = std::sqrt((1 + amplitude_) / (1 - amplitude_));
  return gravity_ * pi * radius_ * radius_ * depth_ * depth_ * ((c + 1 / c) / 6 - 0.5);
}

Provenance ThackerRadialBowl::provenance() {
  return {thacker,
          "eta = h0 (sqrt(1 - A^2)/D - 1 - (r^2/a^2)((1 - A^2)/D^2 - 1)), u_r = r w A sin(w t)/(2 D), "
          "D = 1 - A cos(w t), w = sqrt(8 g h0)/a, A = (a^2 - r0^2)/(a^2 + r0^2)"};
}

double ThackerRadialBowl::uncertainty() const {
  // 1 - A cos(w t) cancels to 1 - A once a period.
  return 20 * std::numeric_limits<double>::epsilon() / (1 - amplitude_);
}

SelfTest ThackerRadialBowl::self_test() const {
  Worst volume_defect;
  Largest energy_defect;
  const double scale = energy() + 0.5 * gravity_ * pi * radius_ * radius_ * depth_ * depth_;
  for (int i = 0; i < instants; ++i) {
    const double t = period() * i / instants;
    const auto over_disc = [&](const auto& f) {
      return boost::math::quadrature::gauss<double, 7>::integrate([&](double r) { return 2 * pi * r * f(r); }, 0.0,
                                                                  shoreline(t));
    };
    volume_defect.add(over_disc([&](double r) { return at(r, 0, t).depth; }) / volume() - 1);
    const double total = over_disc([&](double r) {
      const BowlState s = at(r, 0, t);
      return s.depth * (0.5 * s.u * s.u + gravity_ * (bed(r, 0) + 0.5 * s.depth));
    });
    energy_defect.add(std::abs(total - energy()) / scale);
  }
  // The volume is proportional to D/D, whatever the error of D; the energy's parts to 1/D, D = 1 - A cos(w t) >= 1 - A
  // after three roundings of numbers up to 1.
  const double volume_limit = 4 * std::numeric_limits<double>::epsilon() * std::sqrt(32);
  const double energy_limit =
      4 * std::numeric_limits<double>::epsilon() * std::hypot(std::sqrt(40), std::numbers::sqrt3 / (1 - amplitude_));
  return {
      {"volume is constant, pi a^2 h0/2", volume_defect.value(), volume_limit,
       "the quadrature is exact for the polynomials; 32 roundings: 11 of a depth over its ring, 7 additions, 10 of "
       "the shoreline's square and the height of the centre, 4 of the closed form"},
      {"kinetic + potential energy is constant", energy_defect.value(), energy_limit,
       "the quadrature is exact for the polynomials; 40 roundings, 8 more than the volume for the energy of a point, "
       "and 3 of D = 1 - A cos(w t), over its smallest value 1 - A"}};
}

ThackerPlanarBowl::ThackerPlanarBowl(double gravity, double radius, double depth, double displacement)
    : radius_(radius), depth_(depth), displacement_(displacement) {
  require_bowl(gravity, radius, depth);
  require_positive("displacement", displacement);
  frequency_ = std::sqrt(2 * gravity * depth) / radius;
}

double ThackerPlanarBowl::bed(double x, double y) const {
  return paraboloid(x, y, radius_, depth_);
}

PlanePoint ThackerPlanarBowl::centre(double t) const {
  require_finite("t", t);
  return {displacement_ * std::cos(frequency_ * t), displacement_ * std::sin(frequency_ * t)};
}

double ThackerPlanarBowl::surface(double x, double y, double t) const {
  const PlanePoint c = centre(t);
  return depth_ / (radius_ * radius_) * (2 * x * c.x + 2 * y * c.y - displacement_ * displacement_);
}

BowlState ThackerPlanarBowl::at(double x, double y, double t) const {
  require_finite("x", x);
  require_finite("y", y);
  const PlanePoint c = centre(t);
  const double depth = -paraboloid(x - c.x, y - c.y, radius_, depth_);
  if (!(depth > 0)) return {};
  return {depth, -frequency_ * c.y, frequency_ * c.x};
}

PlanePoint ThackerPlanarBowl::carried(PlanePoint start, double t) const {
  const PlanePoint c = centre(t);
  return {start.x + c.x - displacement_, start.y + c.y};
}

double ThackerPlanarBowl::period() const {
  return 2 * pi / frequency_;
}

double ThackerPlanarBowl::volume() const {
  return 0.5 * pi * radius_ * radius_ * depth_;
}

Provenance ThackerPlanarBowl::provenance() {
  return {thacker,
          "eta = (s h0/a^2)(2 x cos(w t) + 2 y sin(w t) - s), (u, v) = s w (-sin(w t), cos(w t)), w = sqrt(2 g h0)/a"};
}

double ThackerPlanarBowl::uncertainty() const {
  return 20 * std::numeric_limits<double>::epsilon();
}

SelfTest ThackerPlanarBowl::self_test() const {
  // The depth is a translated paraboloid: it must equal surface - bed, a plane minus the fixed one.
  Largest depth_defect;
  Worst pressure_defect;
  const double scale = depth_ * (1 + displacement_ / radius_) * (1 + displacement_ / radius_);
  for (int i = 0; i < instants; ++i) {
    const double t = period() * i / instants;
    const PlanePoint c = centre(t);
    const double x = c.x + 0.6 * radius_;
    const double y = c.y - 0.3 * radius_;
    depth_defect.add(std::abs(at(x, y, t).depth - (surface(x, y, t) - bed(x, y))) / scale);
    // Acceleration -w^2 (centre) = -g grad eta: 2 g s h0/a^2 = s w^2, along the centre's direction.
    const double rise = surface(2 * c.x, 2 * c.y, t) - surface(c.x, c.y, t);  // slope times displacement
    const double expected = 2 * depth_ * displacement_ * displacement_ / (radius_ * radius_);
    pressure_defect.add(rise / expected - 1);
  }
  return {{"depth = surface - bed", depth_defect.value(), 4 * std::numeric_limits<double>::epsilon() * std::sqrt(32),
           "32 roundings of terms up to h0 (1 + s/a)^2: 4 of the centre, 10 of the depth, 9 of the surface, 8 of the "
           "bed, 1 of their difference"},
          {"slope of the surface = 2 h0 s/a^2", pressure_defect.value(), 4e-15, "18 ulp for 12 roundings"}};
}

}  // namespace seiche::exact
