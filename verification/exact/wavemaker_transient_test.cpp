#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

#include "seiche/exact/wavemaker.hpp"
#include "seiche/samples.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "verification/digits_table.hpp"

namespace seiche::verification::wavemaker_transient_test {

using namespace exact;
using validation::each;
using validation::evenly;

const std::string source = "Kennard, Quart. Appl. Math. 7 (1949) 303; Joo, Schultz and Messiter (1990)";

constexpr double g = 9.81, depth = 4, period = 4.7, stroke = 2.11, gauge = 27.3;
constexpr double omega = 2 * std::numbers::pi / period;

/// The same integral by the trapezoidal rule up to `largest`, as it is written: no path, no divided difference.
double by_trapezoid(double x, double t, double largest, long points) {
  const double step = largest / static_cast<double>(points);
  const double forced = omega * std::sin(omega * t);
  double sum = 0.5 * (0.5 * depth) * std::sin(omega * t) / omega;  // k = 0
  for (long j = 1; j <= points; ++j) {
    const double k = step * static_cast<double>(j);
    const double w = std::sqrt(g * k * std::tanh(k * depth));
    const double q = std::tanh(k * depth) / k - (1 - 1 / std::cosh(std::min(k * depth, 700.0))) / (k * k * depth);
    const double b = (forced - w * std::sin(w * t)) / (omega * omega - w * w);
    sum += (j == points ? 0.5 : 1) * q * b * std::cos(k * x);
  }
  return omega * stroke / std::numbers::pi * step * sum;
}

double crest_to_trough(const WavemakerTransient& wave, double from, double to) {
  Largest highest;
  Smallest lowest;
  for (int i = 0; i <= 400; ++i) {
    const double eta = wave.elevation(gauge, from + (to - from) * i / 400);
    highest.add(eta);
    lowest.add(eta);
  }
  return highest.value() - lowest.value();
}

void claim_volume(Check& check, const WavemakerTransient& wave, double mean_of_shape) {
  const double t = 0.25 * period;
  // The start leaves ripples of phase g t^2/(4x) ever shorter towards the paddle: panels of six radians of that, at
  // most a depth wide, from 5 mm to where even the fastest wave sqrt(g d) t is far behind.
  const double ripples = 0.25 * g * t * t;
  const double end = std::sqrt(g * depth) * t + 40 * depth;
  double volume = 0;
  const auto add = [&](double from, double to) {
    volume +=
        boost::math::quadrature::gauss<double, 20>::integrate([&](double x) { return wave.elevation(x, t); }, from, to);
  };
  add(0, 0.005);
  for (double x = 0.005; x < end;) {
    const double next = std::min({end, x + depth, x / std::max(1e-3, 1 - 6 * x / ripples)});
    add(x, next);
    x = next;
  }
  const double displaced = 0.5 * stroke * std::sin(omega * t) * mean_of_shape * depth;
  check.holds("volume-" + std::string(name_of(wave.steady().paddle())) +
                  ": The water that the paddle has displaced is under the surface.",
              {volume},
              Bound{1e-6,
                    "below 5 mm ripples of up to 0.03 mm are not resolved: 0.15e-6; the panels beyond, of six radians "
                    "with 20 points, to round-off",
                    displaced});
}

TEST_CASE("the start of a wavemaker from rest agrees with linear theory", "[exact]") {
  Check check("exact_wavemaker_transient", "Start-up of a wavemaker",
              "Flap of stroke 2.11 m and period 4.7 s in 4 m of water, gauge at 27.3 m. The integral of the linear "
              "theory is evaluated along paths in the complex plane; here it is compared with the plain trapezoidal "
              "rule, which reaches four digits with a cut at $kd = 40$, and with its own value for other paths. The "
              "first arrival is almost zero, the second wave is too low and the third too high: a numerical flume must "
              "be compared with this, not with the steady wave.",
              source);
  const WavemakerTransient wave(Paddle::flap, {g, depth}, exact::Period{period}, stroke);

  const std::vector<double> times = {1, 1.5, 2, 2.1, 2.5, 3};
  const std::vector<std::string> printed = {"0.0926", "-0.2470", "0.4556", "0.6179", "-0.6382", "0.4067"};
  std::vector<Printed> rows;
  Worst difference, cut;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double exact = wave.elevation(gauge, times[i] * period);
    const double coarse = by_trapezoid(gauge, times[i] * period, 40 / depth, 200000);
    rows.push_back({coarse, printed[i]});
    cut.add(coarse - exact);
    difference.add(by_trapezoid(gauge, times[i] * period, 300, 300000) - exact);
  }
  check_table(check, "cut-rule", "elevation at 1, 1.5, 2, 2.1, 2.5, 3 T by the trapezoidal rule cut at kd = 40", rows,
              source);
  // What the cut at K leaves out: amplitude (omega S/pi)/(K sqrt(gK)) over the rate of its phase, x - t sqrt(g/K)/2.
  const auto left_out = [](double largest, double t) {
    return omega * stroke / std::numbers::pi / (largest * std::sqrt(g * largest)) /
           (gauge - 0.5 * t * std::sqrt(g / largest));
  };
  const std::string reason = "asymptotic size of the integral beyond the cut";
  check.that("cut", "The deficit of the quadrature cut at kd = 40 equals the part beyond the cut.",
             "largest difference from the trapezoidal rule, 200 000 points to k = 10/m [m]", {cut.value()},
             Bound{left_out(10, 3 * period), reason});
  check.that(
      "trapezoid",
      "The trapezoidal rule cut 30 times further out agrees within the asymptotic size of the integral beyond the cut.",
      "largest difference from the trapezoidal rule, 300 000 points to k = 300/m [m]", {difference.value()},
      Bound{left_out(300, 3 * period), reason});

  Worst late;
  for (const double t : {19.3 * period, 40.2 * period}) {
    late.add(by_trapezoid(gauge, t, 300, 300000) - wave.elevation(gauge, t));
  }
  check.that("late", "The trapezoidal rule with two cuts agrees within the integral beyond them as short waves pass.",
             "largest difference from the same rule at 19.3 T and 40.2 T [m]", {late.value()},
             Bound{left_out(300, 40.2 * period), reason});

  const std::vector<double> heights = {0.093, 0.832, 1.271};
  Worst deviation;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double from = static_cast<double>(i) * period;
    deviation.add(crest_to_trough(wave, from, from + period) - heights[i]);
  }
  check.that("heights", "Crest to trough in the first three periods is 0.093, 0.832 and 1.271 m.",
             "largest difference [m]", {deviation.value()},
             Bound{0.0005 + 2 * cut.value(),
                   "half a unit of the last digit, and at crest and trough the error just measured of the rule cut at "
                   "kd = 40 that these numbers come from"});
  check_table(check, "steady", "height of the steady wave", {{wave.steady().wave_height(), "1.0813"}}, source);
  std::vector<double> departures;
  for (const int elapsed : {3, 10, 19, 40}) {
    double square = 0;
    for (int i = 0; i < 40; ++i) {
      const double t = (elapsed + i / 40.0) * period;
      square += std::pow(wave.elevation(gauge, t) - wave.steady().elevation(gauge, t), 2) / 40;
    }
    departures.push_back(std::sqrt(square));
  }
  check.that("approach", "The wave approaches the steady wave.",
             "rms departure during one period falls from 3 T to 10 T to 19 T to 40 T",
             {std::is_sorted(departures.rbegin(), departures.rend()) ? 1.0 : 0.0},
             Qualitative{"each of the four numbers is below the one before",
                         "the transient disperses; its size after given periods is not published"});
  claim_volume(check, wave, 0.5);
  claim_volume(check, WavemakerTransient(Paddle::piston, {g, depth}, exact::Period{period}, stroke), 1);

  auto& panel = check
                    .figure("start", "The first three periods one wavelength from the flap",
                            "Linear theory from rest, and the steady wave that it approaches.", {"sph-fig-5"})
                    .panel({.x = "t/T", .y = "surface elevation [m]", .title = "x = 27.3 m, d = 4 m, T = 4.7 s"});
  const std::vector<double> t = evenly(0, 3, 301);
  panel.line("from rest", t, each(t, [&](double part) { return wave.elevation(gauge, part * period); }), Role::exact);
  panel.line("steady wave", t, each(t, [&](double part) { return wave.steady().elevation(gauge, part * period); }),
             Role::guide);
  CHECK(wave.elevation(1, 0) == 0);
  CHECK_THROWS_AS(wave.initial_rate_of_piston(1), std::invalid_argument);
}

}  // namespace seiche::verification::wavemaker_transient_test
