#include "seiche/exact/serre_cnoidal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace {

/// The parameter m of the elliptic functions, and 1 - m: each to all its digits.
struct EllipticParameter {
  double m, complement;

  static EllipticParameter of(double m) { return {m, 1 - m}; }
  static EllipticParameter without(double complement) { return {1 - complement, complement}; }
};

/// K and E/K, by the arithmetic-geometric mean, which keeps the digits as m -> 1.
struct CompleteIntegrals {
  double first;
  double ratio;
};

CompleteIntegrals complete_integrals(EllipticParameter parameter) {
  double a = 1;
  double b = std::sqrt(parameter.complement);
  double weight = 0.5;
  double sum = weight * parameter.m;
  while (std::abs(a - b) > 1e-8 * a) {  // the next difference is its square
    const double c = (a - b) / 2;
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
    weight *= 2;
    sum += weight * c * c;
  }
  return {std::numbers::pi / (a + b), 1 - sum};
}

/// Depths under crest and trough, the third root, and what decides the length.
struct Roots {
  double crest, trough, lowest, kappa, first;
};

Roots roots_of(double height, double depth, EllipticParameter parameter) {
  const CompleteIntegrals complete = complete_integrals(parameter);
  const double span = height / parameter.m;  // h_c - h_0
  const double lowest = depth - span * complete.ratio;
  const double crest = lowest + span;
  const double trough = crest - height;
  const double kappa = lowest > 0 ? std::sqrt(0.75 * span / (lowest * trough * crest)) : 0;
  return {crest, trough, lowest, kappa, complete.first};
}

/// Points of the sums over a wavelength: the nearest singularity of the longest wave leaves exp(-0.4 points).
constexpr int points = 512;
/// 1 - m of the longest wave: between its crests the depth is constant to eight digits.
constexpr double least_complement = 1e-8;

/// Of the depth: shorter and lower waves have too few digits, the shorter are no waves of shallow water either.
constexpr double least_wavelength = 0.01;
constexpr double least_height = 1e-9;

/// Throws std::invalid_argument.
EllipticParameter parameter_of(double height, double wavelength, double depth) {
  const auto longer = [&](EllipticParameter parameter) {
    const Roots r = roots_of(height, depth, parameter);
    return r.lowest > 0 ? 2 * r.first / r.kappa - wavelength : -wavelength;
  };
  const double longest = longer(EllipticParameter::without(least_complement));
  require_that(longest > 0,
               "wavelength = {:g} is out of range: must be below {:g}, where the crests of waves of this height "
               "and depth are solitary",
               wavelength, longest + wavelength);
  std::uintmax_t evaluations = 200;
  const auto close = [](double a, double b) { return std::abs(a - b) <= 4e-16 * a; };
  const double middle = longer(EllipticParameter::of(0.5));
  if (middle > 0) {
    // The third root is below 0 where m is half the height over the depth.
    const auto [low, high] =
        boost::math::tools::toms748_solve([&](double m) { return longer(EllipticParameter::of(m)); },
                                          0.5 * height / depth, 0.5, -wavelength, middle, close, evaluations);
    return EllipticParameter::of(0.5 * (low + high));
  }
  const auto [low, high] = boost::math::tools::toms748_solve(
      [&](double complement) { return longer(EllipticParameter::without(complement)); }, least_complement, 0.5, longest,
      middle, close, evaluations);
  return EllipticParameter::without(0.5 * (low + high));
}

}  // namespace

SerreCnoidal::SerreCnoidal(double height, double wavelength, double depth, double gravity)
    : wavelength_(wavelength), depth_(depth), gravity_(gravity) {
  require_positive("wavelength", wavelength);
  require_positive("depth", depth);
  require_positive("gravity", gravity);
  require_positive("height", height);
  require_within("height", height, least_height * depth, depth);
  require_that(wavelength >= least_wavelength * depth,
               "wavelength = {:g} is out of range: must be at least a hundredth of the depth, {:g}; these "
               "equations are of long waves",
               wavelength, least_wavelength * depth);
  const EllipticParameter parameter = parameter_of(height, wavelength, depth);
  const Roots roots = roots_of(height, depth, parameter);
  modulus_ = std::sqrt(parameter.m);
  crest_ = roots.crest;
  trough_ = roots.trough;
  lowest_ = roots.lowest;
  kappa_ = roots.kappa;
  discharge_ = std::sqrt(gravity * lowest_ * trough_ * crest_);
  Mean velocity;
  for (int i = 0; i < points; ++i) {
    const double h = depth_ + elevation(wavelength_ * i / points);
    velocity.add((1 + slope_squared(h) / 3) / h);
  }
  speed_ = discharge_ * velocity.value();
}

SerreCnoidal::Elliptic SerreCnoidal::at(double x) const {
  require_finite("x", x);
  Elliptic e{};
  double dn = 0;  // inaccurate where cn = 0
  e.sn = boost::math::jacobi_elliptic(modulus_, kappa_ * std::remainder(x, wavelength_), &e.cn, &dn);
  return e;
}

double SerreCnoidal::elevation(double x) const {
  const double cn = at(x).cn;
  return trough_ - depth_ + height() * cn * cn;
}

double SerreCnoidal::elevation_slope(double x) const {
  const auto [sn, cn] = at(x);
  const double dn = std::sqrt(cn * cn + (trough_ - lowest_) / (crest_ - lowest_) * sn * sn);
  return -2 * kappa_ * height() * sn * cn * dn;
}

double SerreCnoidal::excess_up_to(double x) const {
  const Elliptic e = at(x);
  return (crest_ - lowest_) / kappa_ * boost::math::ellint_2(modulus_, std::atan2(e.sn, e.cn)) -
         (depth_ - lowest_) * std::remainder(x, wavelength_);
}

SelfTest SerreCnoidal::self_test() const {
  const double flux = discharge_ * discharge_;
  const double expected = flux / crest_ + gravity_ * crest_ * crest_ / 2 + flux / 3 * curvature(crest_);
  Mean mean;
  Largest momentum, slope, steepest;
  for (int i = 0; i < points; ++i) {
    const double x = wavelength_ * i / points;
    const double h = depth_ + elevation(x);
    const double squared = elevation_slope(x) * elevation_slope(x);
    mean.add(h - depth_);
    slope.add(std::abs(squared - slope_squared(h)));
    steepest.add(squared);
    const double here = flux / h + gravity_ * h * h / 2 + flux / 3 * (curvature(h) - squared / h);
    momentum.add(std::abs(here / expected - 1));
  }
  return {{"mean elevation = 0, over the height", std::abs(mean.value()) / height(), uncertainty(),
           "differences of depths, ten roundings"},
          {"the flux of momentum, seen from the wave, is the same everywhere", momentum.value(), 10 * epsilon,
           "ten roundings of its terms"},
          {"the slope squared agrees with the first integral, over the largest", slope.value() / steepest.value(),
           uncertainty(), "differences of depths, ten roundings"}};
}

ExactSolution serre_cnoidal_entry() {
  return Entry<SerreCnoidal>{
      .name = "serre_cnoidal",
      .title = "Periodic travelling wave of the equations of Serre (Green-Naghdi)",
      .citation = "Serre, La Houille Blanche 8 (1953) 374; El, Grimshaw & Smyth, Phys. Fluids 18 (2006) 027104",
      .formula =
          "h = h_t + (h_c - h_t) cn^2(kappa (x - c t) | m), m = (h_c - h_t)/(h_c - h_0), kappa^2 = 3 (h_c - h_0)/(4 "
          "h_0 h_t h_c), c - u = Q/h, Q^2 = g h_0 h_t h_c",
      .parameters = {{"height", "m", 0.2, 1e-9, 1e6, "from trough to crest"},
                     wavelength_parameter(),
                     depth_parameter(1, 1e6),
                     gravity_parameter()},
      .inputs = {position_x, time_t},
      .outputs = {{"eta", "m", "surface elevation above the mean level"}, mean_velocity_u},
      .scalars = {{"c", "m/s", "phase speed", &SerreCnoidal::phase_speed},
                  {"Q", "m^2/s", "discharge per unit of width, seen from the wave", &SerreCnoidal::discharge}},
      .make = from<SerreCnoidal>("height", "wavelength", "depth", "gravity"),
      .row = [](const SerreCnoidal& wave, At at) {
        const double x = at[0] - wave.phase_speed() * at[1];
        return Row{wave.elevation(x), wave.depth_averaged_velocity(x)};
      }};
}

}  // namespace seiche::exact
