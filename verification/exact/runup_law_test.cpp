#include <cmath>
#include <complex>
#include <numbers>

#include <boost/math/tools/minima.hpp>

#include "seiche/exact/solitary_runup.hpp"
#include "verification/check.hpp"

namespace seiche::verification::runup_law_test {

using exact::SolitaryRunup;

constexpr double pi = std::numbers::pi;
const std::string source = "Synolakis, J. Fluid Mech. 185 (1987) 523";

/// sum over m of (2m + 1 + i s)^-power, its tail by the midpoint rule.
std::complex<double> sum_of_powers(double s, double power) {
  constexpr int terms = 1000;
  std::complex<double> sum = std::pow(std::complex<double>(2 * terms, s), 1 - power) / (2 * (power - 1));
  for (int m = terms; m-- > 0;) sum += std::pow(std::complex<double>(2 * m + 1, s), -power);
  return sum;
}

/// Largest value of a function of the scaled time s while the wave comes up: the crest is at s = -0.23.
template <class Function>
double largest_before_crest(const Function& f) {
  constexpr int bits = 30;
  return -boost::math::tools::brent_find_minima([&](double s) { return -f(s); }, -1.5, -0.1, bits).second;
}

/// Of R/d over sqrt(cot beta) (a/d)^(5/4) before its maximum is taken, per unit of the sum.
double factor() {
  return 8.0 / 3 * std::sqrt(pi) * std::pow(2 / pi, 2.5) * std::pow(0.75, 1.25) * 2 * std::tgamma(2.5);
}

TEST_CASE("the coefficients of the run-up laws follow from the integral", "[exact]") {
  Check check("exact_runup_law", "Coefficients of the run-up and breaking laws",
              "On a flat beach, $z = 2 k X_0$ large, $1/(J_0 - i J_1) \\to \\sqrt{\\pi z/2}\\, e^{i(z - \\pi/4)}$, and "
              "with $\\mathrm{csch}\\, \\alpha k = 2 \\sum e^{-(2m+1) \\alpha k}$, $\\alpha = \\pi/\\sqrt{3a}$, "
              "Synolakis' integral becomes a sum: $R = C(s) \\sqrt{\\cot\\beta}\\, a^{5/4}$, $C(s) = \\frac{16}{3} "
              "\\Gamma(\\frac52) \\sqrt\\pi (2/\\pi)^{5/2} (3/4)^{5/4}\\, \\mathrm{Re}\\, e^{-i\\pi/4} \\sum (2m + 1 + "
              "i s)^{-5/2}$, $s = (t - 2 X_0)/\\alpha$. Its maximum is the law's coefficient. The wave breaks on the "
              "way up where $X_0^2 R'' = g$: the second derivative of the same sum gives the breaking amplitude.",
              source);
  const std::complex<double> turned = std::polar(1.0, -0.25 * pi);
  const double highest =
      factor() * largest_before_crest([&](double s) { return (turned * sum_of_powers(s, 2.5)).real(); });
  const double curvature = factor() * std::pow(2 / pi, 2) * 0.75 * 2.5 * 3.5 *
                           largest_before_crest([&](double s) { return -(turned * sum_of_powers(s, 4.5)).real(); });
  const SolitaryRunup wave(1, 1, 0.01, 20);
  check.that("coefficient", "The coefficient of the run-up law is the maximum of the series.",
             "law over sqrt(cot beta) (a/d)^(5/4)", {wave.law() / (std::sqrt(20.0) * std::pow(0.01, 1.25))},
             Bound{0.001, "a unit of the last of the three printed decimals, which were cut: the series has 2.83151",
                   highest});
  check.that("breaking", "The coefficient of the breaking law is that at which the series' curvature reaches gravity.",
             "breaking amplitude over d (cot beta)^(-10/9)", {wave.breaking_amplitude() * std::pow(20.0, 10.0 / 9)},
             Bound{5e-5, "half a unit of the last of four printed decimals", std::pow(curvature, -4.0 / 9)});
}

}  // namespace seiche::verification::runup_law_test
