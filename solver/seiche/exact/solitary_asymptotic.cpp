#include "seiche/exact/solitary_asymptotic.hpp"

#include <cmath>
#include <limits>

#include <boost/math/tools/roots.hpp>

#include "seiche/require.hpp"

namespace seiche::exact {

static_assert(ReferenceSolution<BoussinesqSolitary>);
static_assert(ReferenceSolution<SerreSolitary>);
static_assert(ReferenceSolution<LaitoneSolitary>);
static_assert(ReferenceSolution<GrimshawSolitary>);

namespace {

double sech_squared(double x) {
  const double s = 1 / std::cosh(x);
  return s * s;
}

double tanh_squared(double x) {
  const double t = std::tanh(x);
  return t * t;
}

constexpr double unlimited = std::numeric_limits<double>::max();

}  // namespace

AsymptoticSolitary::AsymptoticSolitary(double amplitude, double depth, double gravity, double limit)
    : ratio_(amplitude / depth), depth_(depth), gravity_(gravity) {
  require_positive("amplitude", amplitude);
  require_positive("depth", depth);
  require_positive("gravity", gravity);
  require_within("amplitude/depth", ratio_, 0, limit);
}

double AsymptoticSolitary::elevation(double x) const {
  require_finite("x", x);
  return depth_ * profile(x / depth_);
}

double AsymptoticSolitary::speed() const {
  return froude() * std::sqrt(gravity_ * depth_);
}

double AsymptoticSolitary::depth_averaged_velocity(double x) const {
  const double eta = elevation(x);
  return speed() * eta / (depth_ + eta);
}

double AsymptoticSolitary::area() const {
  return profile_area() * depth_ * depth_;
}

double AsymptoticSolitary::uncertainty() const {
  return 30 * std::numeric_limits<double>::epsilon();
}

SelfTest AsymptoticSolitary::self_test() const {
  // Trapezoidal sums of a function analytic in |Im K x| < pi/2: the error exp(-pi^2/step) is below round-off.
  constexpr double step = 0.125;
  constexpr int reach = 160;  // exp(-2 * 20) of the crest
  double mass = profile(0);
  double square = mass * mass;
  for (int i = 1; i <= reach; ++i) {
    const double eta = profile(i * step / decay());
    mass += 2 * eta;
    square += 2 * eta * eta;
  }
  mass *= step / decay();
  const double potential = 0.5 * square * step / decay();
  const std::string reason = "sum of 160 terms of one sign: 45 ulp for 30 roundings each";
  SelfTest identities{{"crest height = amplitude", std::abs(profile(0) / ratio_ - 1), 1e-15, "4 roundings"},
                      {"area of the profile in closed form", std::abs(mass / profile_area() - 1), 1e-14, reason}};
  if (conserves_momentum()) {
    const double excess = (froude() - 1) * (froude() + 1) * mass;
    // F^2 - 1 = a is formed from a rounded F.
    identities.push_back({"3 V = (F^2 - 1) M", std::abs(3 * potential / excess - 1), 1e-14 + 1e-15 / ratio_,
                          reason + "; 4 ulp of F over F^2 - 1"});
  }
  return identities;
}

BoussinesqSolitary::BoussinesqSolitary(double amplitude, double depth, double gravity)
    : AsymptoticSolitary(amplitude, depth, gravity, highest) {}

double BoussinesqSolitary::decay() const {
  return std::sqrt(0.75 * ratio());
}
double BoussinesqSolitary::froude() const {
  return std::sqrt(1 + ratio());
}
double BoussinesqSolitary::profile(double x) const {
  return ratio() * sech_squared(decay() * x);
}
double BoussinesqSolitary::profile_area() const {
  return 2 * ratio() / decay();
}

Provenance BoussinesqSolitary::provenance() {
  return {"Boussinesq (1872), J. Math. Pures Appl. 17, 55",
          "eta = a sech^2(sqrt(3a/4) X), c^2 = 1 + a, u = c eta/(1 + eta)"};
}

SerreSolitary::SerreSolitary(double amplitude, double depth, double gravity, double alpha)
    : AsymptoticSolitary(amplitude, depth, gravity, unlimited), alpha_(alpha) {
  require_positive("alpha", alpha);
}

double SerreSolitary::decay() const {
  return std::sqrt(ratio() / (4 * alpha_ * (1 + ratio())));
}
double SerreSolitary::froude() const {
  return std::sqrt(1 + ratio());
}
double SerreSolitary::profile(double x) const {
  return ratio() * sech_squared(decay() * x);
}
double SerreSolitary::profile_area() const {
  return 2 * ratio() / decay();
}

double SerreSolitary::excess_up_to(double x) const {
  require_finite("x", x);
  return depth() * depth() * ratio() / decay() * std::tanh(decay() * x / depth());
}

double SerreSolitary::elevation_slope(double x) const {
  require_finite("x", x);
  const double argument = decay() * x / depth();
  return -2 * decay() * ratio() * std::tanh(argument) * sech_squared(argument);
}

double SerreSolitary::water_up_to(double x) const {
  return depth() * x + excess_up_to(x);
}

double SerreSolitary::place_of(double water) const {
  require_finite("water", water);
  const double length = water / depth();
  const double excess = ratio() / decay() * depth();
  constexpr int digits = 50;  // of 53 bits: below the rounding of the residual
  return boost::math::tools::newton_raphson_iterate(
      [&](double x) {
        return std::pair(x + excess * std::tanh(decay() * x / depth()) - length, 1 + profile(x / depth()));
      },
      length / (1 + ratio()), length - excess, length + excess, digits);
}

Provenance SerreSolitary::provenance() {
  return {"Rayleigh (1876), Phil. Mag. 1, 257; Serre (1953), Houille Blanche 8, 374",
          "eta = a sech^2(sqrt(a/(4 alpha (1 + a))) X), c^2 = 1 + a, u = c eta/(1 + eta), alpha = 1/3"};
}

LaitoneSolitary::LaitoneSolitary(double amplitude, double depth, double gravity)
    : AsymptoticSolitary(amplitude, depth, gravity, highest) {}

double LaitoneSolitary::decay() const {
  return std::sqrt(0.75 * ratio()) * (1 - 0.625 * ratio());
}
double LaitoneSolitary::froude() const {
  return 1 + ratio() * (0.5 - 0.15 * ratio());
}
double LaitoneSolitary::profile(double x) const {
  const double a = ratio();
  return a * sech_squared(decay() * x) * (1 - 0.75 * a * tanh_squared(decay() * x));
}
double LaitoneSolitary::profile_area() const {
  // integrals of sech^2 and sech^2 tanh^2: 2 and 2/3
  return ratio() / decay() * (2 - 0.5 * ratio());
}

Provenance LaitoneSolitary::provenance() {
  return {"Laitone (1960), The second approximation to cnoidal and solitary waves, J. Fluid Mech. 9, 430",
          "eta = a S - (3/4) a^2 S (1 - S), S = sech^2(sqrt(3a/4) (1 - 5a/8) X), c = 1 + a/2 - 3a^2/20"};
}

GrimshawSolitary::GrimshawSolitary(double amplitude, double depth, double gravity)
    : AsymptoticSolitary(amplitude, depth, gravity, highest) {}

double GrimshawSolitary::decay() const {
  const double a = ratio();
  return std::sqrt(0.75 * a) * (1 - a * (0.625 - 71.0 / 128 * a));
}
double GrimshawSolitary::froude() const {
  const double a = ratio();
  return std::sqrt(1 + a * (1 - a * (0.05 + 3.0 / 70 * a)));
}
double GrimshawSolitary::profile(double x) const {
  const double a = ratio();
  const double s2 = sech_squared(decay() * x);
  const double t2 = tanh_squared(decay() * x);
  return a * s2 * (1 - a * t2 * (0.75 - a * (0.625 - 101.0 / 80 * s2)));
}
double GrimshawSolitary::profile_area() const {
  // integrals of sech^2, sech^2 tanh^2, sech^4 tanh^2: 2, 2/3, 4/15; a^3 (5/12 - 101/300) = 2 a^3/25
  const double a = ratio();
  return a / decay() * (2 - a * (0.5 - 0.08 * a));
}

Provenance GrimshawSolitary::provenance() {
  return {"Grimshaw (1971), The solitary wave in water of variable depth II, J. Fluid Mech. 46, 611",
          "eta = a s^2 - (3/4) a^2 s^2 q^2 + a^3 ((5/8) s^2 q^2 - (101/80) s^4 q^2), c^2 = 1 + a - a^2/20 - 3a^3/70"};
}

}  // namespace seiche::exact
