#include <array>
#include <cmath>
#include <numbers>

#include "seiche/exact/model_waves.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "seiche/samples.hpp"
#include "verification/difference.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::solitary_asymptotic_test {

using namespace exact;
using Theory = AsymptoticSolitary::Theory;

const std::string series_source =
    "Boussinesq (1872); Rayleigh (1876); Laitone, J. Fluid Mech. 9 (1960) 430; Grimshaw, J. Fluid Mech. 46 (1971) 611";
const std::string serre_source = "Serre, Houille Blanche 8 (1953) 374; Green and Naghdi, J. Fluid Mech. 78 (1976) 237";

/// Residual of the steady Serre equations (w u' + g eta' + (alpha/h) (h^2 D^2 h)' = 0, w = u - c, D = w d/dx) at x by
/// nested fourth-order differences of half-width `span`.
double serre_residual(const SerreSolitary& wave, double alpha, double x, double span) {
  const auto difference = [span](const auto& f, double at) {
    return verification::difference([&](double d) { return f(at + d); }, span);
  };
  const auto depth = [&](double p) { return wave.depth() + wave.elevation(p); };
  const auto relative = [&](double p) { return wave.depth_averaged_velocity(p) - wave.speed(); };
  const auto rate = [&](double p) { return relative(p) * difference(depth, p); };
  const auto dynamic = [&](double p) { return depth(p) * depth(p) * relative(p) * difference(rate, p); };
  return relative(x) * difference(relative, x) + wave.gravity() * difference(depth, x) +
         alpha / depth(x) * difference(dynamic, x);
}

/// Largest distance of two elevations over the wave.
double profile_error(const AsymptoticSolitary& wave, const SolitaryWave& truth) {
  Worst largest;
  const double width = 12 / std::sqrt(0.75 * truth.amplitude());
  for (int i = 0; i <= 400; ++i) {
    const double x = width * i * i / 160000;  // dense near the crest
    largest.add(wave.elevation(x) - truth.elevation(x));
  }
  return largest.value();
}

TEST_CASE("the series for the solitary wave have the speeds and identities known", "[exact]") {
  Check check("exact_solitary_series", "Solitary waves as series in amplitude",
              "Excess mass in closed form against the profiles; $3V = "
              "(F^2-1)M$ where it holds exactly; the wave of Serre satisfies the equations of Serre at any amplitude, "
              "for any factor $\\alpha$ of the vertical kinetic energy.");
  for (const double alpha : {1.0 / 3, 0.4}) {
    const SerreSolitary wave(1, 2, 9.81, alpha);
    check.source(serre_source);
    refine(check,
           {.axis = "width of the differences",
            .sizes = falling(0.8, 6, std::numbers::sqrt2),
            .title = {},
            .floor = 1e-10},
           {{alpha < 0.35 ? "serre" : "serre-alpha",
             alpha < 0.35 ? "Rayleigh's wave satisfies the Serre equations."
                          : "The wave with alpha = 0.4 satisfies the equations with alpha = 0.4.",
             {4, 0.2, "fourth-order differences of an analytic solution"}}},
           [&](double span) {
             Worst largest;
             for (double x = 0.2; x < 8; x += 0.3) largest.add(serre_residual(wave, alpha, x, span));
             return largest.value();
           });
  }
  const SerreSolitary wave(0.6, 2, 9.81);
  Worst inverse;
  for (double x = -15; x < 15; x += 0.7) inverse.add(wave.place_of(wave.depth() * x + wave.excess_up_to(x)) - x);
  check.from(serre_source)
      .that("particles", "The position of a given volume is the inverse of the volume up to a position.",
            "error of the position [m]", {inverse.value()}, Roundoff{15, 17, "15 roundings of lengths up to 17 m"});
  CHECK(std::abs(wave.elevation(3, 2) - wave.elevation(3 - 2 * wave.speed())) == 0);
  CHECK_NOTHROW(SerreSolitary(3));
}

TEST_CASE("the series depart from the exact solitary wave at their orders in amplitude", "[exact]") {
  Check check(
      "exact_solitary_orders", "Order of the series for the solitary wave",
      "Profile and speed against the wave of the full Euler equations at amplitudes from 0.05 to 0.2 of the depth: the "
      "first term that a series neglects decides. This verifies the series and the exact solver by each other.");
  check.source(series_source);
  const auto right = [](const std::string& id, const std::string& what, double order) {
    return Refined{
        id, what + ".", {order, 0.25, "first neglected power of the amplitude; the next is 0.05 to 0.2 of it"}};
  };
  refine(
      check,
      {"amplitude/depth", {0.2, 0.1414, 0.1, 0.0707, 0.05}, "errors", "Error of the series against amplitude", 1e-13},
      {right("boussinesq", "Boussinesq's profile is right to first order", 2),
       right("rayleigh", "Rayleigh's profile is right to first order", 2),
       right("laitone", "Laitone's profile is right to second order", 3),
       right("grimshaw", "Grimshaw's profile is right to third order", 4),
       right("speed-rayleigh", "c^2 = 1 + a is right to first order", 2),
       right("speed-laitone", "Laitone's speed is right to second order", 3),
       right("speed-grimshaw", "Grimshaw's speed is right to third order", 4)},
      [](double a) {
        const SolitaryWave truth(a);
        const SerreSolitary serre(a);
        const AsymptoticSolitary laitone(Theory::laitone, a);
        const AsymptoticSolitary grimshaw(Theory::grimshaw, a);
        const auto speed = [&](const AsymptoticSolitary& wave) { return std::abs(wave.speed() - truth.speed()); };
        return std::array{profile_error(AsymptoticSolitary(Theory::boussinesq, a), truth),
                          profile_error(serre, truth),
                          profile_error(laitone, truth),
                          profile_error(grimshaw, truth),
                          speed(serre),
                          speed(laitone),
                          speed(grimshaw)};
      });
}

}  // namespace seiche::verification::solitary_asymptotic_test
