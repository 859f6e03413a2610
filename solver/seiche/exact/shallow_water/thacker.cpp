#include "seiche/exact/shallow_water/thacker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace sw = shallow_water;

namespace {

/// Of the length of the channel: smaller bowls have too few digits of x.
constexpr double least_radius = 1e-6;

using std::numbers::pi;
constexpr int instants = 12;
constexpr double smallest_start = 1e-6;  // of the radius: 1 - A is then 2e-12, and known to 1e-4

}  // namespace

Thacker::Thacker(double gravity, double radius, double depth, double length, std::optional<double> displacement)
    : radius_(radius), depth_(depth), centre_(0.5 * length), displacement_(displacement.value_or(0.5 * radius)) {
  require_all_positive({{"gravity", gravity}, {"radius", radius}, {"depth", depth}, {"length", length}});
  require_within("radius", radius, least_radius * length, 0.5 * length);
  require_positive("displacement", displacement_);
  require_within("displacement", displacement_, 0, 0.5 * length - radius);
  frequency_ = std::sqrt(2 * gravity * depth) / radius;
}

double Thacker::elevation(double x) const {
  const double s = (x - centre_) / radius_;
  return depth_ * (s - 1) * (s + 1);
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
  return {[self = *this](double x) { return self.elevation(x); },
          [self = *this](double x) {
            const double s = (x - self.centre_) / self.radius_;
            return self.depth_ * self.radius_ * s * (s * s / 3 - 1);
          }};
}

SelfTest Thacker::self_test() const {
  const double t = 0.3 * period();
  const double middle = 0.5 * (left_shoreline(t) + right_shoreline(t));
  // Simpson's rule is exact for the parabola between the shorelines.
  const double width = right_shoreline(t) - left_shoreline(t);
  const double water = width / 6 * 4 * at(middle, t).depth;
  // xi'' = -w^2 xi with w^2 = 2 g h0/a^2, from xi'^2 + w^2 xi^2 = const.
  const double swing = std::hypot(velocity(t), frequency_ * shift(t));
  return {{"the area of the water is 4 a h0/3", departure(water, area()), 16 * centre_ / radius_ * epsilon,
           "ten roundings at x up to L, over a"},
          {"xi'^2 + w^2 xi^2 is constant", departure(swing, velocity_amplitude()), 32 * epsilon,
           "sine and cosine of the same phase"}};
}

ThackerBowl::ThackerBowl(double gravity, double radius, double depth, double factor)
    : gravity_(gravity), radius_(radius), depth_(depth), frequency_(std::sqrt(factor * gravity * depth) / radius) {
  require_all_positive({{"gravity", gravity}, {"radius", radius}, {"depth", depth}});
}

double ThackerBowl::bed(double x, double y) const {
  const double r = std::hypot(x, y) / radius_;
  return depth_ * (r - 1) * (r + 1);
}

ThackerRadialBowl::ThackerRadialBowl(double gravity, double radius, double depth, double start_radius)
    : ThackerBowl(gravity, radius, depth, 8) {
  require_positive("start_radius", start_radius);
  require_within("start_radius", start_radius, 0, radius);
  const double q = start_radius / radius;
  amplitude_ = (1 - q) * (1 + q) / (1 + q * q);
  require_that(q >= smallest_start,
               "start_radius = {:g} is out of range: must be at least {:g} of the radius {:g}, or 1 - A is lost in "
               "rounding",
               start_radius, smallest_start, radius);
  require_positive("1 - start_radius/radius", amplitude_);
}

double ThackerRadialBowl::stretch(double t) const {
  require_finite("t", t);
  return 1 - amplitude_ * std::cos(frequency_ * t);
}

double ThackerRadialBowl::surface(double x, double y, double t) const {
  const double centre = middle(t);
  const double r2 = (x * x + y * y) / (radius_ * radius_);
  return depth_ * (centre - 1) * (1 - r2 * (centre + 1));
}

BowlState ThackerRadialBowl::at(double x, double y, double t) const {
  require_finite("x", x);
  require_finite("y", y);
  const double edge = shoreline(t);
  const double r = std::hypot(x, y) / edge;
  if (!(r < 1)) return {};
  const double rate = 0.5 * frequency_ * amplitude_ * std::sin(frequency_ * t) / stretch(t);
  return {depth_ * middle(t) * (1 - r) * (1 + r), rate * x, rate * y};
}

PlanePoint ThackerRadialBowl::carried(PlanePoint start, double t) const {
  const double factor = std::sqrt(stretch(t) / stretch(0));
  return {factor * start.x, factor * start.y};
}

double ThackerRadialBowl::energy() const {
  // At rest (t = 0) the surface is a paraboloid of centre height h0 c, c = sqrt((1 + A)/(1 - A)).
  const double c = std::sqrt((1 + amplitude_) / (1 - amplitude_));
  return gravity_ * pi * radius_ * radius_ * depth_ * depth_ * ((c + 1 / c) / 6 - 0.5);
}

SelfTest ThackerRadialBowl::self_test() const {
  Worst volume_defect, energy_defect;
  const double scale = energy() + 0.5 * gravity_ * pi * radius_ * radius_ * depth_ * depth_;
  for (int i = 0; i < instants; ++i) {
    const double t = period() * i / instants;
    const auto over_disc = [&](const auto& f) {
      return integral<7>([&](double r) { return 2 * pi * r * f(r, at(r, 0, t)); }, 0, shoreline(t), 1);
    };
    volume_defect.add(over_disc([](double, const BowlState& s) { return s.depth; }) / volume() - 1);
    const double total = over_disc([&](double r, const BowlState& s) {
      return s.depth * (0.5 * s.u * s.u + gravity_ * (bed(r, 0) + 0.5 * s.depth));
    });
    energy_defect.add((total - energy()) / scale);
  }
  const double energy_limit = 4 * epsilon * std::hypot(std::sqrt(40), std::numbers::sqrt3 / (1 - amplitude_));
  return {{"volume is constant, pi a^2 h0/2", volume_defect.value(), 4 * epsilon * std::sqrt(32),
           "the quadrature is exact for the polynomials; 32 roundings: 11 of a depth over its ring, 7 additions, 10 of "
           "the shoreline's square and the height of the centre, 4 of the closed form"},
          {"kinetic + potential energy is constant", energy_defect.value(), energy_limit,
           "the quadrature is exact for the polynomials; 40 roundings, 8 more than the volume for the energy of a "
           "point, and 3 of D = 1 - A cos(w t), over its smallest value 1 - A"}};
}

ThackerPlanarBowl::ThackerPlanarBowl(double gravity, double radius, double depth, double displacement)
    : ThackerBowl(gravity, radius, depth, 2), displacement_(displacement) {
  require_positive("displacement", displacement);
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
  const double depth = -bed(x - c.x, y - c.y);
  if (!(depth > 0)) return {};
  return {depth, -frequency_ * c.y, frequency_ * c.x};
}

PlanePoint ThackerPlanarBowl::carried(PlanePoint start, double t) const {
  const PlanePoint c = centre(t);
  return {start.x + c.x - displacement_, start.y + c.y};
}

SelfTest ThackerPlanarBowl::self_test() const {
  // The depth is a translated paraboloid: it must equal surface - bed, a plane minus the fixed one.
  const double scale = depth_ * (1 + displacement_ / radius_) * (1 + displacement_ / radius_);
  const double depth_defect = worst(0, instants - 1, [&](int i) {
    const double t = period() * i / instants;
    const double x = centre(t).x + 0.6 * radius_;
    const double y = centre(t).y - 0.3 * radius_;
    return (at(x, y, t).depth - (surface(x, y, t) - bed(x, y))) / scale;
  });
  // Acceleration -w^2 (centre) = -g grad eta: 2 g s h0/a^2 = s w^2, along the centre's direction.
  const double expected = 2 * depth_ * displacement_ * displacement_ / (radius_ * radius_);
  const double pressure_defect = worst(0, instants - 1, [&](int i) {
    const double t = period() * i / instants;
    const PlanePoint c = centre(t);
    return (surface(2 * c.x, 2 * c.y, t) - surface(c.x, c.y, t)) / expected - 1;  // slope times displacement
  });
  return {{"depth = surface - bed", depth_defect, 4 * epsilon * std::sqrt(32),
           "32 roundings of terms up to h0 (1 + s/a)^2: 4 of the centre, 10 of the depth, 9 of the surface, 8 of the "
           "bed, 1 of their difference"},
          {"slope of the surface = 2 h0 s/a^2", pressure_defect, 4e-15, "18 ulp for 12 roundings"}};
}

ExactSolution thacker_entry() {
  return Entry<Thacker>{
      .name = "thacker",
      .title = "Water oscillates in a parabolic bowl with a plane surface",
      .citation =
          "Thacker, Some exact solutions to the nonlinear shallow-water wave equations, J. Fluid Mech. 107 (1981) 499; "
          "Delestre et al., SWASHES (2013), section 4.2.1",
      .formula = "h = h0 (1 - ((x - L/2 - xi)/a)^2), u = xi', xi = -displacement cos(w t), w = sqrt(2 g h0)/a",
      .parameters = {{"radius", "m", 1, 1e-9, 1e9, "half-width of the water"},
                     {"depth", "m", 0.5, 1e-9, 1e6, "depth of the bowl below the shoreline at rest"},
                     {"displacement", "m", 0.5, 1e-12, 1e9, "amplitude of the motion; at most length/2 - radius"},
                     gravity_parameter(),
                     {"length", "m", 4, 1e-9, 1e9, "length of the channel, the bowl in its middle"}},
      .inputs = {position_x, time_t},
      .outputs = {depth_h, {"u", "m/s", "velocity, 0 where dry"}, {"z", "m", "bed elevation"}},
      .scalars = {{"period", "s", "period of the oscillation", &Thacker::period},
                  {"angular_frequency", "1/s", "sqrt(2 g depth)/radius", &Thacker::angular_frequency},
                  {"velocity_amplitude", "m/s", "largest velocity", &Thacker::velocity_amplitude}},
      .make = from<Thacker>("gravity", "radius", "depth", "length", "displacement"),
      .row = [](const Thacker& solution, At at) {
        const auto state = solution.at(at[0], at[1]);
        return Row{state.depth, state.velocity, solution.elevation(at[0])};
      }};
}

namespace {

template <class Bowl>
ExactSolution bowl_entry(const std::string& name, const std::string& title, const std::string& formula,
                         const Parameter& own) {
  return Entry<Bowl>{
      .name = name,
      .title = title,
      .citation = "Thacker, J. Fluid Mech. 107 (1981) 499; Delestre et al., SWASHES (2013), section 4.2.2",
      .formula = formula,
      .parameters = {{"radius", "m", 1, 1e-9, 1e9, "radius a of the bowl's rim"},
                     {"depth", "m", 0.1, 1e-9, 1e6, "depth h0 of the bowl below the rim"},
                     own,
                     gravity_parameter()},
      .inputs = {position_x, {"y", "m", 0, "horizontal position, at right angles to x"}, time_t},
      .outputs = {{"eta", "m", "surface elevation above the rim's level, where wet"},
                  {"h", "m", "depth, 0 where dry"},
                  {"u", "m/s", "velocity along x"},
                  {"v", "m/s", "velocity along y"},
                  {"z", "m", "bed elevation"}},
      .scalars = {{"period", "s", "period", &Bowl::period}, {"volume", "m^3", "volume of the water", &Bowl::volume}},
      .make = from<Bowl>("gravity", "radius", "depth", own.name),
      .row = [](const Bowl& bowl, At at) {
        const auto state = bowl.at(at[0], at[1], at[2]);
        const double bed = bowl.bed(at[0], at[1]);
        // Where the bed is dry the formula of the surface runs below it; the bed is what is seen.
        return Row{state.depth > 0 ? bowl.surface(at[0], at[1], at[2]) : bed, state.depth, state.u, state.v, bed};
      }};
}

}  // namespace

ExactSolution thacker_radial_entry() {
  return bowl_entry<ThackerRadialBowl>(
      "thacker_radial", "Water pulsates in a paraboloid, a curved surface",
      "eta = h0 (sqrt(1 - A^2)/D - 1 - (r^2/a^2)((1 - A^2)/D^2 - 1)), u_r = r w A sin(w t)/(2 D), D = 1 - A cos(w t), "
      "w = sqrt(8 g h0)/a, A = (a^2 - r0^2)/(a^2 + r0^2)",
      {"start_radius", "m", 0.8, 1e-9, 1e9, "r0 below the radius: at rest at t = 0 inside sqrt(a r0)"});
}

ExactSolution thacker_planar_entry() {
  return bowl_entry<ThackerPlanarBowl>(
      "thacker_planar", "Water circles in a paraboloid, its surface a plane",
      "eta = (s h0/a^2)(2 x cos(w t) + 2 y sin(w t) - s), (u, v) = s w (-sin(w t), cos(w t)), w = sqrt(2 g h0)/a",
      {"displacement", "m", 0.5, 1e-12, 1e9, "distance s of the water's centre from the bowl's"});
}

}  // namespace seiche::exact
