#include "seiche/exact/solitary_asymptotic.hpp"

#include <limits>

#include <boost/math/tools/roots.hpp>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {
namespace {

double sech_squared(double x) {
  const double s = 1 / std::cosh(x);
  return s * s;
}

}  // namespace

AsymptoticSolitary::AsymptoticSolitary(double amplitude, double depth, double gravity, const Series& series,
                                       double limit)
    : ratio_(amplitude / depth), depth_(depth), gravity_(gravity), series_(series) {
  require_positive("amplitude", amplitude);
  require_positive("depth", depth);
  require_positive("gravity", gravity);
  require_within("amplitude/depth", ratio_, 0, limit);
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

BoussinesqSolitary::BoussinesqSolitary(double amplitude, double depth, double gravity)
    : AsymptoticSolitary(amplitude, depth, gravity,
                         {.decay = std::sqrt(0.75 * amplitude / depth),
                          .froude = std::sqrt(1 + amplitude / depth),
                          .conserves_momentum = true}) {}

SerreSolitary::SerreSolitary(double amplitude, double depth, double gravity, double alpha)
    : AsymptoticSolitary(amplitude, depth, gravity,
                         {.decay = std::sqrt(amplitude / depth / (4 * alpha * (1 + amplitude / depth))),
                          .froude = std::sqrt(1 + amplitude / depth),
                          .conserves_momentum = true},
                         std::numeric_limits<double>::max()) {
  require_positive("alpha", alpha);
}

LaitoneSolitary::LaitoneSolitary(double amplitude, double depth, double gravity)
    : AsymptoticSolitary(amplitude, depth, gravity,
                         {.decay = std::sqrt(0.75 * amplitude / depth) * (1 - 0.625 * amplitude / depth),
                          .froude = 1 + amplitude / depth * (0.5 - 0.15 * amplitude / depth),
                          .b = 0.75}) {}

GrimshawSolitary::GrimshawSolitary(double amplitude, double depth, double gravity)
    : AsymptoticSolitary(amplitude, depth, gravity, [a = amplitude / depth]() -> Series {
        return {.decay = std::sqrt(0.75 * a) * (1 - a * (0.625 - 71.0 / 128 * a)),
                .froude = std::sqrt(1 + a * (1 - a * (0.05 + 3.0 / 70 * a))),
                .b = 0.75,
                .c = 0.625,
                .d = 101.0 / 80};
      }()) {}

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
      .make = made_by(
          [](int theory, double amplitude, double depth, double gravity) -> AsymptoticSolitary {
            if (theory == 0) return BoussinesqSolitary(amplitude, depth, gravity);
            if (theory == 1) return SerreSolitary(amplitude, depth, gravity);
            if (theory == 2) return LaitoneSolitary(amplitude, depth, gravity);
            return GrimshawSolitary(amplitude, depth, gravity);
          },
          "theory", "amplitude", "depth", "gravity"),
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

}  // namespace seiche::exact
