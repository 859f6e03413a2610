#include "seiche/exact/model_waves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rg.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/tools/roots.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {
namespace {

double sech_squared(double x) {
  const double s = 1 / std::cosh(x);
  return s * s;
}

/// The parameter m of the elliptic functions, and 1 - m: each to all its digits.
struct EllipticParameter {
  double m, complement;

  static EllipticParameter of(double m) { return {m, 1 - m}; }
  static EllipticParameter without(double complement) { return {1 - complement, complement}; }
};

/// Depths under crest and trough, the third root, and what decides the length.
struct Roots {
  double crest, trough, lowest, kappa, first;
};

Roots roots_of(double height, double depth, EllipticParameter parameter) {
  // The complete integrals K and E in Carlson's forms, which keep the digits as m -> 1.
  const double first = boost::math::ellint_rf(0.0, parameter.complement, 1.0);
  const double second = 2 * boost::math::ellint_rg(0.0, parameter.complement, 1.0);
  const double span = height / parameter.m;  // h_c - h_0
  const double lowest = depth - span * second / first;
  const double crest = lowest + span;
  const double trough = crest - height;
  const double kappa = lowest > 0 ? std::sqrt(0.75 * span / (lowest * trough * crest)) : 0;
  return {crest, trough, lowest, kappa, first};
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
  const double middle = longer(EllipticParameter::of(0.5));
  const auto solved = [&](auto parameter, double least, double at_least) {
    std::uintmax_t evaluations = 200;
    const auto close = [](double a, double b) { return std::abs(a - b) <= 4e-16 * a; };
    const auto [low, high] = boost::math::tools::toms748_solve([&](double m) { return longer(parameter(m)); }, least,
                                                               0.5, at_least, middle, close, evaluations);
    return parameter(0.5 * (low + high));
  };
  // The third root is below 0 where m is half the height over the depth.
  if (middle > 0) return solved(EllipticParameter::of, 0.5 * height / depth, -wavelength);
  return solved(EllipticParameter::without, least_complement, longest);
}

}  // namespace

AsymptoticSolitary::Series AsymptoticSolitary::series_of(Theory theory, double a, double alpha) {
  const double long_wave = std::sqrt(0.75 * a);
  switch (theory) {
    case Theory::boussinesq:
      return {.decay = long_wave, .froude = std::sqrt(1 + a), .conserves_momentum = true};
    case Theory::rayleigh:
      return {.decay = std::sqrt(a / (4 * alpha * (1 + a))), .froude = std::sqrt(1 + a), .conserves_momentum = true};
    case Theory::laitone:
      return {.decay = long_wave * (1 - 0.625 * a), .froude = 1 + a * (0.5 - 0.15 * a), .b = 0.75};
    default:  // Grimshaw
      return {.decay = long_wave * (1 - a * (0.625 - 71.0 / 128 * a)),
              .froude = std::sqrt(1 + a * (1 - a * (0.05 + 3.0 / 70 * a))),
              .b = 0.75,
              .c = 0.625,
              .d = 101.0 / 80};
  }
}

AsymptoticSolitary::AsymptoticSolitary(Theory theory, double amplitude, double depth, double gravity, double alpha)
    : ratio_(amplitude / depth), depth_(depth), gravity_(gravity), series_(series_of(theory, ratio_, alpha)) {
  require_all_positive({{"amplitude", amplitude}, {"depth", depth}, {"gravity", gravity}, {"alpha", alpha}});
  require_within("amplitude/depth", ratio_, 0,
                 theory == Theory::rayleigh ? std::numeric_limits<double>::max() : highest);
}

double AsymptoticSolitary::profile(double x) const {
  const double a = ratio_;
  const double s2 = sech_squared(series_.decay * x);
  const double t2 = std::pow(std::tanh(series_.decay * x), 2);
  return a * s2 * (1 - a * t2 * (series_.b - a * (series_.c - series_.d * s2)));
}

double AsymptoticSolitary::profile_area() const {
  const auto& [decay, froude, b, c, d, exact] = series_;
  return ratio_ / decay * (2 - ratio_ * (2 * b / 3 - ratio_ * (2 * c / 3 - 4 * d / 15)));
}

double AsymptoticSolitary::elevation(double x) const {
  require_finite("x", x);
  return depth_ * profile(x / depth_);
}

double AsymptoticSolitary::depth_averaged_velocity(double x) const {
  const double eta = elevation(x);
  return speed() * eta / (depth_ + eta);
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
  if (series_.conserves_momentum) {
    const double excess = (series_.froude - 1) * (series_.froude + 1) * mass;
    // F^2 - 1 = a is formed from a rounded F.
    identities.push_back({"3 V = (F^2 - 1) M", std::abs(3 * potential / excess - 1), 1e-14 + 1e-15 / ratio_,
                          reason + "; 4 ulp of F over F^2 - 1"});
  }
  return identities;
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

ExactSolution solitary_asymptotic_entry() {
  return Entry<AsymptoticSolitary>{
      .name = "solitary_asymptotic",
      .title = "Solitary waves as series in the amplitude: Boussinesq, Rayleigh, Laitone, Grimshaw",
      .citation =
          "Boussinesq (1872), J. Math. Pures Appl. 17, 55; Rayleigh (1876), Phil. Mag. 1, 257; Serre (1953), Houille "
          "Blanche 8, 374; Laitone (1960), The second approximation to cnoidal and solitary waves, J. Fluid Mech. 9, "
          "430; Grimshaw (1971), The solitary wave in water of variable depth II, J. Fluid Mech. 46, 611",
      .formula =
          "eta = a sech^2(sqrt(3a/4) X), c^2 = 1 + a, u = c eta/(1 + eta); eta = a sech^2(sqrt(a/(4 alpha (1 + a))) "
          "X), c^2 = 1 + a, u = c eta/(1 + eta), alpha = 1/3; eta = a S - (3/4) a^2 S (1 - S), S = sech^2(sqrt(3a/4) "
          "(1 - 5a/8) X), c = 1 + a/2 - 3a^2/20; eta = a s^2 - (3/4) a^2 s^2 q^2 + a^3 ((5/8) s^2 q^2 - (101/80) s^4 "
          "q^2), c^2 = 1 + a - a^2/20 - 3a^3/70",
      .parameters = {{"theory", "1", 3, 0, 3, "whose series", {"boussinesq", "rayleigh", "laitone", "grimshaw"}},
                     {"amplitude", "m", 0.3, 1e-9, 1e6, "crest above still water, up to 0.8332 depth"},
                     depth_parameter(1, 1e6),
                     gravity_parameter()},
      .inputs = {position_x, time_t},
      .outputs = {surface_eta, mean_velocity_u},
      .scalars = {{"speed", "m/s", "phase speed", &AsymptoticSolitary::speed},
                  {"mass", "m^2", "int eta dx", &AsymptoticSolitary::area}},
      .make = from<AsymptoticSolitary>("theory", "amplitude", "depth", "gravity"),
      .row = [](const AsymptoticSolitary& wave, At at) { return travelling_row(wave, wave.speed(), at); }};
}

ExactSolution serre_solitary_entry() {
  return Entry<SerreSolitary>{
      .name = "serre_solitary",
      .title = "Solitary wave of Rayleigh, exact for the equations of Serre (Green-Naghdi)",
      .citation = "Rayleigh (1876), Phil. Mag. 1, 257; Serre (1953), Houille Blanche 8, 374",
      .formula = "eta = a sech^2(sqrt(a/(4 alpha (1 + a))) X), c^2 = 1 + a, u = c eta/(1 + eta), alpha = 1/3",
      .parameters = {{"amplitude", "m", 0.3, 1e-9, 1e6, "crest above still water"},
                     depth_parameter(1, 1e6),
                     gravity_parameter(),
                     {"alpha", "1", 1.0 / 3, 1e-6, 10, "factor of the vertical kinetic energy, 1/3 for Serre"}},
      .inputs = {position_x, time_t},
      .outputs = {surface_eta, mean_velocity_u},
      .scalars = {{"speed", "m/s", "phase speed", &SerreSolitary::speed},
                  {"mass", "m^2", "int eta dx", &SerreSolitary::area}},
      .make = from<SerreSolitary>("amplitude", "depth", "gravity", "alpha"),
      .row = [](const SerreSolitary& wave, At at) { return travelling_row(wave, wave.speed(), at); }};
}

SerreCnoidal::SerreCnoidal(double height, double wavelength, double depth, double gravity)
    : wavelength_(wavelength), depth_(depth), gravity_(gravity) {
  require_all_positive({{"wavelength", wavelength}, {"depth", depth}, {"gravity", gravity}, {"height", height}});
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
      .row = [](const SerreCnoidal& wave, At at) { return travelling_row(wave, wave.phase_speed(), at); }};
}

}  // namespace seiche::exact
