#include "seiche/exact/overturning/overturning_wave.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "seiche/divergence.hpp"
#include "seiche/exact/overturning/surface_curve.hpp"
#include "seiche/samples.hpp"
#include "verification/difference.hpp"
#include "verification/self_test_claims.hpp"

namespace seiche::verification::overturning_wave_test {

using exact::OverturningWave;
using exact::overturning::SurfaceCurve;

const std::string source =
    "Baker, Meiron & Orszag, J. Fluid Mech. 123 (1982) 477; Longuet-Higgins & Cokelet, Proc. R. Soc. Lond. A 350 "
    "(1976) 1; regression: values computed once with 512 and 1024 nodes";

constexpr double period = 2 * std::numbers::pi;
const OverturningWave::Parameters deep_water{.amplitude = 0.5};
const OverturningWave::Parameters over_bottom{.amplitude = 0.408407044966673, .depth = 0.816814089933346};
const double finite_period = period / std::sqrt(std::tanh(over_bottom.depth));

SurfaceCurve curve(const OverturningWave::Profile& profile) {
  std::vector<std::complex<double>> displacements;
  const auto n = static_cast<double>(profile.x.size());
  for (std::size_t j = 0; j < profile.x.size(); ++j) {
    displacements.emplace_back(profile.x[j] - period * static_cast<double>(j) / n, profile.y[j]);
  }
  return SurfaceCurve(displacements);
}

void claim_conservation(Check& check, const OverturningWave& wave, double until, const std::string& when) {
  const auto start = wave.integrals(0);
  Worst volume, energy, impulse;
  for (int i = 1; i <= 12; ++i) {
    const auto now = wave.integrals(until * i / 12);
    volume.add(now.volume - start.volume);
    energy.add((now.kinetic_energy + now.potential_energy) / (start.kinetic_energy + start.potential_energy) - 1);
    impulse.add(now.impulse / start.impulse - 1);
  }
  const std::string reason = "errors of some 400 steps of tolerance 2e-11, which do not all add up";
  check.that("volume", "Volume is conserved " + when + ".", "change of volume", {volume.value()}, Bound{1e-11, reason});
  check.that("energy", "Energy is conserved " + when + ".", "relative change", {energy.value()},
             Bound{2 * 400 * std::pow(2e-11 / wave.extremes(0).highest, 1.2),
                   "some 400 steps whose fourth-order errors are kept at 2e-11, over the amplitude, twice as much of a "
                   "square; the fifth-order solution that is carried on errs less by a step, the fifth root of that"});
  check.that("impulse", "Impulse is conserved " + when + ".", "relative change", {impulse.value()},
             Bound{1e-10, reason});
}

TEST_CASE("a steep wave over a bottom overturns, its jet lands, and its invariants are conserved", "[exact][full]") {
  Check check("exact_overturning_finite_depth", "Overturning wave over a flat bottom, until the jet meets the surface",
              "Depth and height 0.13 wavelengths; at $t = 0$ a cosine with the surface potential of the linear wave. "
              "Volume, energy and impulse are conserved by the motion. A second number of nodes and a second tolerance "
              "give the numerical error.",
              source);
  const OverturningWave wave(over_bottom);
  claim_conservation(check, wave, 0.48 * finite_period, "up to 0.48 periods");
  auto second = over_bottom;
  second.markers = 448;
  second.tolerance = 1e-11;
  const OverturningWave other(second);
  const std::string both = " by 512 nodes, tolerance 2e-11, less 448 nodes, 1e-11";
  check.that("self-convergence", "The surface at 0.46 periods does not depend on resolution and tolerance.",
             "Hausdorff distance of 512 nodes, tolerance 2e-11, and 448 nodes, 1e-11 [1/k]",
             {curve(wave.profile(0.46 * finite_period)).distance(curve(other.profile(0.46 * finite_period)))},
             Bound{1e-8, "five times the distance between surfaces by 512 and 1024 nodes, 2e-9"});
  check.that("vertical-tangent", "The time of the first vertical tangent does not depend on resolution and tolerance.",
             "time" + both + " [1/sqrt(g k)]",
             {wave.vertical_tangent_time().value() - other.vertical_tangent_time().value()},
             Bound{1e-8, "errors of some 400 steps of tolerance 2e-11, of a front that moves at a speed of order 1"});
  check.that("touch-down", "The time of jet impact does not depend on resolution and tolerance.",
             "extrapolated time" + both + " [1/sqrt(g k)]",
             {wave.touch_down_time().value() - other.touch_down_time().value()},
             Bound{0.0017, "the difference of that time between 512 and 1024 nodes"});
  self_test_holds(check, "finite-depth", wave);
  CHECK_THROWS_AS(wave.profile(0.6 * finite_period), Divergence);
}

TEST_CASE("a steep wave in deep water overturns and conserves its invariants", "[exact]") {
  Check check("exact_overturning_deep", "Overturning wave in deep water",
              "At $t = 0$ $\\eta = 0.5 \\cos x$ with surface potential $0.5 e^{\\eta} \\sin x$, whose kinetic energy "
              "is $\\frac{\\pi}{2} A^2 I_0(2A)$. The nose of the jet against an earlier computation "
              "of ours.",
              source);
  auto parameters = deep_water;
  parameters.last_time = 4.4;
  const OverturningWave wave(parameters);
  check.from("(pi/2) A^2 I_0(2A): integral of the squared velocity of exp(y) sin x")
      .that("kinetic-energy", "The first integral equation gives the kinetic energy in closed form.",
            "kinetic energy at t = 0 [g/k^3]", {wave.integrals(0).kinetic_energy},
            Roundoff{512, 0.5, "sum over 512 nodes; the equation is solved to 1e-15", 0.497182907563303});
  Worst nose_x, nose_y;
  for (const auto& [t, x, y] : {std::tuple{4.0, 5.74728, 0.53257}, {4.4, 6.44821, 0.40559}}) {
    const auto jet = wave.jet(t).value();
    nose_x.add(jet.nose_x - x);
    nose_y.add(jet.nose_y - y);
  }
  check.that("nose-abscissa", "The position of the jet tip agrees with the reference at t = 4 and 4.4.",
             "largest difference [1/k]", {nose_x.value()}, Bound{5e-6, "half a unit of the last printed digit"});
  check.that("nose-ordinate", "The height of the jet's nose agrees with the reference at t = 4 and 4.4.",
             "largest difference [1/k]", {nose_y.value()},
             Bound{3.7e-4,
                   "the reference gives the node that is farthest ahead; its neighbours among 1024 are 7.4e-4 above "
                   "and below it at t = 4, and the surface is vertical there"});
  claim_conservation(check, wave, 4.2, "up to t = 4.2");
  self_test_holds(check, "deep", wave);
}

TEST_CASE("an overturning wave is even in its points and rejects parameters outside its range", "[exact]") {
  const OverturningWave unit({.amplitude = 0.3, .depth = 1, .markers = 128, .last_time = 0.5});
  const auto arc = unit.profile(0.5, 101);
  CHECK(std::abs(arc.x.back() - arc.x.front() - period) < 1e-14);
  CHECK(std::abs(std::hypot(arc.x[1] - arc.x[0], arc.y[1] - arc.y[0]) -
                 std::hypot(arc.x[51] - arc.x[50], arc.y[51] - arc.y[50])) < 1e-4);
  CHECK(!unit.vertical_tangent_time());
  CHECK(!unit.jet(0.5));
  const OverturningWave breaking({.amplitude = over_bottom.amplitude, .depth = over_bottom.depth, .markers = 96});
  try {
    (void)breaking.profile(0.6 * finite_period);
    FAIL("the jet has met the surface by then");
  } catch (const Divergence& end) {
    CHECK(end.time() == breaking.end_time());
    CHECK(std::abs(end.place() - breaking.jet(end.time()).value().nose_x) < period / 4);  // on the crest
  }
  CHECK_THROWS_AS(unit.profile(0.6), std::invalid_argument);
  CHECK_THROWS_AS(unit.profile(-0.1), std::invalid_argument);
}

TEST_CASE("waves in a tank agree with linear theory while they are low", "[exact]") {
  Check check(
      "exact_waves_in_tank", "Waves of many lengths in a tank",
      "Linear theory satisfies its own equations inside the water, by differences. Computed surfaces depart "
      "from it by the square of the height, from H/h = 0.01 and 0.02 on. Amplitudes follow JONSWAP's spectrum as a "
      "function of the period, in bands of the dispersion relation by differences.",
      "Baldock, Swan & Taylor, Phil. Trans. R. Soc. Lond. A 354 (1996) 649; Hasselmann et al. (1973); linear "
      "theory");
  using exact::WavesInTank;
  const WavesInTank group({.amplitude = 0.2,
                           .wavelength = 20,
                           .depth = 2,
                           .gravity = 9.81,
                           .focus = 3,
                           .peak = 4,
                           .seed = 7,
                           .markers = 64,
                           .last_time = 0.1});
  Worst worst;
  for (const auto& [x, y, t] : {std::tuple{0.7, -0.3, 0.0}, std::tuple{4.1, -1.6, 1.3}, std::tuple{8.9, 0.1, 4.0}}) {
    const auto here = group.linear(x, y, t);
    const auto slope = [&](double dx, double dy, double dt, double WavesInTank::Linear::*what) {
      return difference([&](double s) { return group.linear(x + s * dx, y + s * dy, t + s * dt).*what; }, 1e-2);
    };
    using L = WavesInTank::Linear;
    const double rate = slope(0, 0, 1, &L::potential);
    worst.add(slope(1, 0, 0, &L::potential) - here.velocity.u);
    worst.add(slope(0, 1, 0, &L::potential) - here.velocity.v);
    worst.add(slope(0, 1, 0, &L::discharge) - here.velocity.u);
    worst.add(slope(1, 0, 0, &L::discharge) + here.velocity.v);  // no water through the bottom
    worst.add(here.pressure + rate + 0.5 * std::pow(std::hypot(here.velocity.u, here.velocity.v), 2) + 9.81 * y);
    const auto still = group.linear(x, 0, t);
    const double sinks = difference([&](double s) { return group.linear(x, 0, t + s).elevation; }, 1e-2);
    worst.add(sinks - still.velocity.v);
    worst.add(difference([&](double s) { return group.linear(x, 0, t + s).potential; }, 1e-2) + 9.81 * still.elevation);
  }
  check.that("linear", "The linear waves satisfy Laplace's, Bernoulli's and the surface's linear equations.",
             "largest departure [m/s, m^2/s^2]", {worst.value()},
             Bound{1e-7, "fourth-order differences err by (w s)^4/480 of w phi: w = 4.7, s = 0.01, phi up to 2"});
  const auto modes = group.modes();
  const auto period = [](double n) {
    const double k = n * std::numbers::pi / 10;
    return 2 * std::numbers::pi / std::sqrt(9.81 * k * std::tanh(2 * k));
  };
  // S(T) |d(1/T)/dn| over that of the peak.
  const auto energy = [&](double n) {
    const double ratio = period(4) / period(n);
    const double s = ratio <= 1 ? 0.07 : 0.09;
    return std::pow(ratio, -5) * std::exp(1.25 - 1.25 / (ratio * ratio * ratio * ratio)) *
           std::pow(3.3, std::exp(-(ratio - 1) * (ratio - 1) / (2 * s * s)) - 1) *
           difference([&](double m) { return 1 / period(n + m); }, 1e-2) /
           difference([&](double m) { return 1 / period(4 + m); }, 1e-2);
  };
  Worst spectrum;
  double sum = 0;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    spectrum.add(std::pow(modes[i].amplitude / modes[2].amplitude, 2) / energy(2 + static_cast<double>(i)) - 1);
    sum += modes[i].amplitude;
  }
  check.that("spectrum", "The energy of each mode follows JONSWAP's spectrum with its peak at mode 4.",
             "largest departure of a^2/a_peak^2, relative", {spectrum.value()},
             Bound{1e-8, "fourth-order differences of 1/T: (0.01/n)^4/30, and rounding over 0.01"});
  CHECK(std::abs(sum - 0.2) < 1e-15);
  // Two modes of 0.05, whose mean squares over the tank and time are a quarter of their squares.
  const WavesInTank two({.first = 2, .last = 3, .markers = 64, .last_time = 0.01});
  CHECK(std::abs(two.significant_height() - 4 * std::sqrt(2 * 0.05 * 0.05 / 4)) < 1e-15);
  // Phases at the focus, of many seas: uniform over the circle, so that the resultant of n is below 4 sqrt(n).
  std::array<double, 2> resultant{};
  constexpr int seas = 400;
  for (int seed = 1; seed <= seas; ++seed) {
    const auto mode = WavesInTank::modes_of({.focus = 2, .seed = seed})[1];
    resultant[0] += std::cos(mode.phase + 2 * mode.frequency);
    resultant[1] += std::sin(mode.phase + 2 * mode.frequency);
  }
  CHECK(std::hypot(resultant[0], resultant[1]) < 4 * std::sqrt(seas));
  for (const auto& mode : WavesInTank::modes_of({.focus = 2})) {
    CHECK(std::abs(mode.phase + 2 * mode.frequency) < 1e-14);
    CHECK(mode.amplitude == 0.1 / 6);
  }
  const auto excess = [](double amplitude) {
    const WavesInTank low({.amplitude = amplitude, .gravity = 1, .focus = 9, .markers = 128});
    return low.extremes(9).highest / amplitude - 1;
  };
  check.that("limit", "The crest at the focus departs from linear theory in proportion to the height.",
             "excess of a crest of H/h = 0.02 over one of 0.01", {excess(0.02) / excess(0.01)},
             Bound{0.1, "the next term is of the order of k a = 0.05", 2});
}

TEST_CASE("waves over bars keep to the bottom and have the frequency of Bragg's law", "[exact]") {
  Check check(
      "exact_waves_over_bars", "Waves in a tank over bars",
      "The bottom is a trochoid, to which the velocities at the start keep. The frequency of standing waves with "
      "two bars to a wavelength differs from that over a level bottom by what first-order theory gives.",
      "C. C. Mei, Resonant reflection of surface water waves by periodic sandbars, J. Fluid Mech. 152 (1985) 315");
  using exact::WavesInTank;
  const WavesInTank sea({.last = 8, .peak = 3, .seed = 5, .bar_height = 0.3, .bars = 6, .last_time = 2});
  const exact::overturning::Bars& bars = sea.bars();
  Worst bottom, gradient, through;
  for (const double s : {0.1, 0.7, 1.3, 2.9, 4.4}) {
    const double x = s - 0.15 * std::sin(std::numbers::pi * s);
    const auto [elevation, slope, curvature] = bars.bottom(x);
    bottom.add(elevation - (0.15 * std::cos(std::numbers::pi * s) - 1));
    bottom.add(slope - difference([&](double d) { return bars.bottom(x + d).elevation; }, 1e-3));
    bottom.add(curvature - difference([&](double d) { return bars.bottom(x + d).slope; }, 1e-3));
    const auto below = sea.linear(x, elevation, 0);
    through.add((below.velocity.v - slope * below.velocity.u) / 0.1);
    through.add(below.discharge / 0.1);
    const double y = 0.5 * elevation;
    const auto here = sea.linear(x, y, 0);
    gradient.add(difference([&](double d) { return sea.linear(x + d, y, 0).potential; }, 1e-3) - here.velocity.u);
    gradient.add(difference([&](double d) { return sea.linear(x, y + d, 0).potential; }, 1e-3) - here.velocity.v);
  }
  Worst surface;
  const auto start = sea.profile(0);
  for (std::size_t k = 0; k < start.x.size(); ++k) {
    const auto given = sea.linear(start.x[k], start.y[k], 0).velocity;
    surface.add(start.u[k] - given.u);
    surface.add(start.v[k] - given.v);
  }
  check.that("bottom", "The bottom, its slope and its second derivative agree with the trochoid to 1e-8.",
             "largest departure from the trochoid and from differences", {bottom.value()},
             Bound{1e-8,
                   "differences err by s^4/480 = 2e-15 of the sixth derivative, at most b 6!/0.16^6 = 6e6: continued "
                   "to complex x, the curve is singular 0.16 from its crest"});
  check.that("through", "The velocity through the bottom is zero at the start.",
             "largest velocity across over the amplitude", {through.value()},
             Bound{1e-13, "rounding of eight modes and of Newton's iteration"});
  check.that("gradient", "The velocities at the start equal the gradient of the potential to 1e-12 m/s.",
             "largest departure [m/s]", {gradient.value()},
             Bound{1e-12, "differences err by s^4/480 = 2e-15 of k^5 phi = 4.2^5 0.05, and round 0.05 over 0.001"});
  check.that("surface",
             "The surface velocities from the surface potential equal the velocities in the water to 1e-11 m/s.",
             "largest departure at t = 0 [m/s]", {surface.value()},
             Bound{1e-11, "integral equation solved to 1e-15, kernels rounded at neighbouring markers 0.025 apart"});
  self_test_holds(check, "bars", sea);

  const double k = std::numbers::pi / 2;
  const auto frequency_squared = [&](double height) {
    const WavesInTank wave({.amplitude = 1e-3,
                            .gravity = 1,
                            .first = 3,
                            .last = 3,
                            .bar_height = height,
                            .bars = 6,
                            .markers = 64,
                            .last_time = 1.6});
    const auto mode = [&](double t) {
      const auto [time, x, y, potential, u, v] = wave.profile(t);
      double sum = 0;
      for (std::size_t j = 0; j < x.size(); ++j) {
        const std::size_t next = (j + 1) % x.size();
        const double width = x[next] - x[j] + (next == 0 ? 12 : 0);
        sum += width * (y[j] * std::cos(k * x[j]) + y[next] * std::cos(k * x[next]));
      }
      return sum;
    };
    double before = 1, after = 1.6;  // the first zero, a quarter of a period
    for (int i = 0; i < 50; ++i) (mode((before + after) / 2) > 0 ? before : after) = (before + after) / 2;
    return std::pow(std::numbers::pi / (2 * before), 2);
  };
  const double level = frequency_squared(0);
  const auto shift = [&](double height) {
    return (frequency_squared(height) - level) / (height / 2 * std::pow(k / std::cosh(k), 2) / 2);
  };
  check.that(
      "bragg",
      "The squared frequency of waves of twice the bars' spacing rises by g b k^2/(2 cosh^2 kh), in the limit of "
      "low bars.",
      "shift over first-order theory's, from bars 0.025 and 0.05 high", {2 * shift(0.025) - shift(0.05)},
      Bound{1.5e-3, "(n b)^2 = 0.039^2: the term after the one that both heights together take out", 1});
}

}  // namespace seiche::verification::overturning_wave_test
