#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/bessel.hpp>

#include "seiche/exact/solitary_runup.hpp"
#include "seiche/samples.hpp"
#include "validation/case/reference_table.hpp"
#include "verification/difference.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::solitary_runup_test {

using namespace exact;

const std::string source = "Synolakis, J. Fluid Mech. 185 (1987) 523";
const std::string frank = "Frank, Discrete models of incompressible fluid (1994), table of ch. 3";

/// The integral at one time by adaptive quadrature, with other Bessel functions than the solution's.
double by_quadrature(double amplitude, double cotangent, double t) {
  const double alpha = 0.5 * std::numbers::pi / std::sqrt(0.75 * amplitude);
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
      [&](double k) {
        const double z = 2 * k * cotangent;
        const std::complex<double> response(boost::math::cyl_bessel_j(0, z), -boost::math::cyl_bessel_j(1, z));
        const std::complex<double> wave = std::polar(1.0, -k * t);
        return 8.0 / 3 * k / std::sinh(alpha * k) * (wave / response).real();
      },
      0.0, 45 / alpha, 15, 1e-13);
}

/// Largest amplitude for which the shoreline does not break on its way up.
double breaking_amplitude(double cotangent) {
  const double estimate = SolitaryRunup(1, 1, 0.01, cotangent).breaking_amplitude();
  double low = 0.9 * estimate, high = 1.05 * estimate;
  for (int i = 0; i < 8; ++i) {
    const double middle = 0.5 * (low + high);
    (SolitaryRunup(1, 1, middle, cotangent).shoreline_steepness().run_up < 1 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

TEST_CASE("the run-up of solitary waves on a plane beach follows Synolakis' integral", "[exact]") {
  Check check("exact_solitary_runup", "Run-up of solitary waves on a plane beach",
              "The integral by an adaptive rule; the nonlinear shoreline's kinematics; the exact limit of breaking at "
              "the shoreline against Synolakis' criterion; the published analytic profiles. The law is the leading "
              "term: 2.5 % low even for the published wave, 26 % low at 45 degrees. A solver of the shallow-water "
              "equations should be compared with the integral.",
              source);
  Largest adaptive;
  for (const auto& [amplitude, cotangent] : std::vector<std::pair<double, double>>{
           {0.019, 19.85}, {0.0185, 19.85}, {0.05, 10}, {0.03, 10}, {0.1, 3.732}, {0.05, 2.747}, {0.1, 1}}) {
    const SolitaryRunup wave(1, 1, amplitude, cotangent);
    for (const double t : {1.2 * cotangent, 2.1 * cotangent, 3.5 * cotangent}) {
      adaptive.add(std::abs(by_quadrature(amplitude, cotangent, t) - wave.linear_elevation(t)) /
                   wave.highest().elevation);
    }
  }
  check.that("adaptive", "The elevation by adaptive quadrature of the same integral is the same within 2e-12.",
             "largest difference over the run-up", {adaptive.value()},
             Bound{2e-12, "tolerance 1e-13 on each of up to 20 panels"});

  // The shoreline moves along the beach: elevation' = velocity tan beta.
  const SolitaryRunup wave(1, 1, 0.0185, 19.85);
  refine(check, {.axis = "time difference", .sizes = falling(0.8, 5), .title = {}, .floor = 1e-12},
         {{"kinematics",
           "The nonlinear shoreline moves along the beach: the residual falls at fourth order in time.",
           {4, 0.3, "fourth-order differences of a smooth function"}}},
         [&](double span) {
           Worst largest;
           for (const double t : {28.0, 33.0, 36.0, 40.0, 44.0}) {
             const double rise = difference([&](double d) { return wave.shoreline(t + d).elevation; }, span);
             largest.add(rise - wave.shoreline(t).velocity / 19.85);
           }
           return largest.value();
         });
  check.from("Carrier and Greenspan, J. Fluid Mech. 4 (1958) 97")
      .that("same-maximum", "Linear and nonlinear theory have the same maximum.",
            "shoreline at the time of the linear maximum [d]", {wave.shoreline(wave.highest().time).elevation},
            Bound{1e-14, "uncertainty of R, 1e-13 R", wave.highest().elevation});
}

TEST_CASE("Synolakis' breaking criterion is the limit of flat beaches", "[exact][full]") {
  Check check("exact_solitary_breaking", "Breaking of solitary waves on a plane beach",
              "The shoreline breaks during run-up when $X_0^2 R''$ reaches $g$. The amplitude at which it does is "
              "compared with $a = 0.8183 (\\cot\\beta)^{-10/9} d$, derived for long beaches.",
              source);
  std::vector<double> cotangents = {5, 10, 20, 40};
  std::vector<double> ratios;
  for (const double cotangent : cotangents) {
    ratios.push_back(breaking_amplitude(cotangent) / SolitaryRunup(1, 1, 0.01, cotangent).breaking_amplitude());
  }
  check.that("criterion", "The exact amplitude of breaking approaches the criterion as the beach becomes flatter.",
             "amplitude of breaking over the criterion rises towards 1 from cot beta = 5 to 40",
             {std::is_sorted(ratios.begin(), ratios.end()) && ratios.back() < 1 ? 1.0 : 0.0},
             Qualitative{"each of the four ratios is above the one before and below 1",
                         "the criterion is the leading term for large cot beta"});
}

TEST_CASE("the published analytic profiles end at the computed shoreline", "[exact]") {
  Check check("exact_solitary_profiles", "Analytic profiles of Synolakis' solution",
              "a/d = 0.019 on 1:19.85. The first wet point of each published profile brackets the shoreline within "
              "their spacing of 0.1 d along the beach, 0.005 d in elevation.",
              source);
  const io::Table profiles =
      validation::reference_table("synolakis_1987_analytic_profiles", check.record().reference_data);
  const SolitaryRunup wave(1, 1, 0.019, 19.85);
  const double shift = std::acosh(std::sqrt(20.0)) / std::sqrt(0.75 * 0.019);
  Worst worst;
  double previous = 0;
  for (std::size_t row = 0; row < profiles.rows(); ++row) {
    const double t = profiles.column("t")[row];
    if (t == previous) continue;
    previous = t;
    if (t - shift >= wave.breaking_time()) continue;
    const double first = -profiles.column("x_over_d")[row] / 19.85;
    const double middle = first + 0.05 / 19.85;
    worst.add(wave.shoreline(t - shift).elevation - middle);
  }
  check.that("bracket", "Every profile up to breaking in run-down ends at the shoreline within half a spacing.",
             "largest distance from the middle between the first wet point and the dry one before [d]", {worst.value()},
             Bound{0.05 / 19.85 + 5e-6, "half the spacing of the profiles, and half a unit of their last digit"});
  CHECK(std::isfinite(wave.breaking_time()));
  CHECK_THROWS_AS(wave.shoreline(wave.breaking_time() + 1e-6), std::invalid_argument);
  CHECK_THROWS_AS(wave.shoreline(std::nan("")), std::invalid_argument);
}

TEST_CASE("Hall and Watts' correlation and Frank's run-up table", "[exact]") {
  Check check("exact_hall_watts", "Hall and Watts' correlation, and Frank's table",
              "The correlation's own identity; the columns of Frank's table that can be recomputed.", frank);

  const io::Table runup = validation::reference_table("frank_1994_runup", check.record().reference_data);
  Worst law;
  for (std::size_t row = 0; row < runup.rows(); ++row) {
    const SolitaryRunup wave(1, 1, runup.column("A")[row], runup.column("cot_slope")[row]);
    law.add(wave.law() - runup.column("R_law")[row]);
  }
  check.that("frank-law", "All entries of the law printed in Frank's table agree with it.", "largest difference [d]",
             {law.value()}, Bound{0.0015, "three decimals, amplitudes rounded to two or three digits"});

  const io::Table measured = validation::reference_table("frank_1994_runup_hall_watts", check.record().reference_data);
  Largest others, suspicious;
  for (std::size_t row = 0; row < measured.rows(); ++row) {
    const double cotangent = measured.column("cot_slope")[row], amplitude = measured.column("A")[row];
    const double printed = measured.column("R_HW")[row];
    const double deviation = std::abs(HallWatts(1, 1 / cotangent).runup(amplitude) / printed - 1);
    (printed == 0.173 ? suspicious : others).add(deviation);
  }
  check.that(
      "frank-hall-watts", "Frank's interpolations of the measurements follow the correlation, but for one entry.",
      "largest relative difference", {.value = others.value(), .uncertainty = 0},  // a formula, evaluated to round-off
      evidence::Uncertainty{
          .data = HallWatts::scatter(), .useful = 0.15, .reason = "scatter of run-up measurements, 5 % (assumed)"});
  const Bound limit{.limit = 0.03, .reason = "the accuracy of an interpolation of their plotted measurements"};
  check.known_failure("frank-hall-watts-close",
                      "Frank's interpolations of the measured run-up follow the correlation to 3 %.",
                      "largest relative difference", {others.value()}, limit,
                      {.value = 0.05543,
                       .width = 5e-5,
                       .reason = "four of 17 entries differ by 3.3 to 5.5 %: three of the four at cot 1 and one at cot "
                                 "2.747, the others by less than 3 %; the interpolation differs from the correlation, "
                                 "a formula as exact as the digits of this band"});
  check.known_failure("frank-hall-watts-173", "Frank's entry for cot 3.732, a = 0.05 follows the correlation to 3 %.",
                      "relative difference", {suspicious.value()}, limit,
                      {.value = 0.27,
                       .width = 5e-5,
                       .reason = "0.173 is out of line with its neighbours, 0.281 at a = 0.1 and 0.121 on the slope "
                                 "3.333: a misprint is likely; the correlation is a formula"});
}

}  // namespace seiche::verification::solitary_runup_test
