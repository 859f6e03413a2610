#include "seiche/exact/overturning/overturning_wave.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/exact/overturning/surface_curve.hpp"
#include "seiche/samples.hpp"
#include "validation/case/reference_table.hpp"
#include "verification/self_test_claims.hpp"

namespace overturning_wave_test {

using namespace seiche;
using exact::OverturningWave;
using exact::overturning::SurfaceCurve;
using namespace seiche::verification;

const std::string source =
    "Baker, Meiron & Orszag, J. Fluid Mech. 123 (1982) 477; Longuet-Higgins & Cokelet, Proc. R. Soc. Lond. A 350 "
    "(1976) "
    "1; regression: numbers computed once by an earlier program, 512 and 1024 markers";

constexpr double period = 2 * std::numbers::pi;
const OverturningWave::Parameters deep_water{.amplitude = 0.5};
const OverturningWave::Parameters over_bottom{.amplitude = 0.408407044966673, .depth = 0.816814089933346};
const double finite_period = period / std::sqrt(std::tanh(over_bottom.depth));

struct Points {
  std::vector<double> x, y;
};

SurfaceCurve curve(const OverturningWave::Profile& profile) {
  std::vector<std::complex<double>> displacements;
  const auto n = static_cast<double>(profile.x.size());
  for (std::size_t j = 0; j < profile.x.size(); ++j) {
    displacements.emplace_back(profile.x[j] - period * static_cast<double>(j) / n, profile.y[j]);
  }
  return SurfaceCurve(displacements);
}

std::map<double, Points> profiles(const std::string& name, evidence::Record& record) {
  const auto table = validation::reference_table(name, record.reference_data);
  std::map<double, Points> result;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    Points& points = result[table.column("t")[row]];
    points.x.push_back(table.column("x")[row]);
    points.y.push_back(table.column("y")[row]);
  }
  return result;
}

double distance(const OverturningWave& wave, double t, const Points& points) {
  const SurfaceCurve surface = curve(wave.profile(t));
  Largest largest;
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    largest.add(surface.distance({points.x[i], points.y[i]}));
  }
  return largest.value();
}

struct Row {
  double t, highest, lowest;
  double known;  ///< distance between the tabulated computations
};

void claim_table(Check& check, const OverturningWave& wave, const std::vector<Row>& rows,
                 const std::map<double, Points>& reference, double unit, const std::string& unit_name) {
  Worst extremes;
  evidence::Table table{.id = "profiles",
                        .title = "Distance from the reference profiles",
                        .caption = "Largest distance of a reference point from the computed surface.",
                        .columns = {{"t", unit_name}, {"distance", "1/k"}, {"y max", "1/k"}, {"y min", "1/k"}},
                        .rows = {}};
  for (const Row& row : rows) {
    const auto at = std::ranges::min_element(reference, {},
                                             [&](const auto& entry) { return std::abs(entry.first - row.t * unit); });
    REQUIRE(std::abs(at->first - row.t * unit) < 1e-9);
    const double measured = distance(wave, at->first, at->second);
    const auto [highest, lowest] = wave.extremes(row.t * unit);
    extremes.add(highest - row.highest);
    extremes.add(lowest - row.lowest);
    table.rows.push_back({row.t, measured, highest, lowest});
    check.holds(fmt::format("The surface at t = {:.2f} {} is the reference's.", row.t, unit_name), {measured},
                Bound{std::max(1e-7, row.known),
                      "interpolation of the reference, 1e-7, or the distance between its computations "
                      "with 512 and 1024 markers where that is larger"});
  }
  check.table(table);
  check.that({.id = "extremes",
              .text = "Highest and lowest elevation have every digit of the reference at all its times.",
              .quantity = "largest difference",
              .unit = "1/k",
              .source = source},
             {.value = extremes.value()},
             Bound{3.5e-8,
                   "3e-8: extremes of the reference are sampled at 64 points per marker; half a unit of "
                   "the eighth decimal"});
}

void claim_conservation(Check& check, const OverturningWave& wave, double until, const std::string& when) {
  const auto start = wave.integrals(0);
  Worst volume;
  Worst energy;
  Worst impulse;
  for (int i = 1; i <= 12; ++i) {
    const auto now = wave.integrals(until * i / 12);
    volume.add(now.volume - start.volume);
    energy.add((now.kinetic_energy + now.potential_energy) / (start.kinetic_energy + start.potential_energy) - 1);
    impulse.add(now.impulse / start.impulse - 1);
  }
  const std::string reason =
      "errors of some 400 steps of tolerance 2e-11, which do not all add up: reached by the "
      "earlier program";
  check.that(
      {.id = "volume", .text = "Volume is conserved " + when + ".", .quantity = "change of volume", .source = source},
      {.value = volume.value()}, Bound{1e-11, reason});
  check.that(
      {.id = "energy", .text = "Energy is conserved " + when + ".", .quantity = "relative change", .source = source},
      {.value = energy.value()},
      Bound{2 * 400 * std::pow(2e-11 / wave.extremes(0).highest, 1.2),
            "some 400 steps whose errors of fourth order are kept at 2e-11, over the amplitude, "
            "twice as much of a square; the solution of fifth order that is carried on errs less "
            "by a step, the fifth root of that"});
  check.that(
      {.id = "impulse", .text = "Impulse is conserved " + when + ".", .quantity = "relative change", .source = source},
      {.value = impulse.value()}, Bound{1e-10, reason});
}

void claim_vertical_tangent(Check& check, const OverturningWave& wave, double printed) {
  check.that({.id = "vertical-tangent",
              .text = "The front is first vertical when the reference's is.",
              .quantity = "time of the first vertical tangent",
              .unit = "1/sqrt(g k)",
              .source = source},
             {.value = wave.vertical_tangent_time().value()},
             Bound{5e-5, "half a unit of the last printed digit", printed});
}

void draw(Check& check, const OverturningWave& wave, const std::map<double, Points>& reference, double until,
          const std::string& id, const std::string& title, double unit, const std::string& unit_name) {
  auto& figure =
      check.figure(id, title,
                   "Lines: 512 markers; dots: every tenth point of the earlier computation with 1024 markers. "
                   "Units of 1/k; time grows upwards, each profile is drawn 0.5 above the one before.");
  auto& panel = figure.panel({.x = "k x", .y = "k y + 0.5 n", .equal_aspect = true});
  double shift = 0;
  for (const auto& [t, points] : reference) {
    if (t > until) break;
    auto profile = wave.profile(t, 800);
    Points dots;
    for (std::size_t i = 0; i < points.x.size(); i += 10) {
      dots.x.push_back(points.x[i]);
      dots.y.push_back(points.y[i] + shift);
    }
    for (double& y : profile.y) y += shift;
    panel.line(fmt::format("t = {:.2f} {}", t / unit, unit_name), profile.x, profile.y, Role::computed);
    panel.points(shift == 0 ? "reference" : "", dots.x, dots.y, Role::exact);
    shift += 0.5;
  }
}

TEST_CASE("a steep wave over a bottom overturns and touches down as the reference does", "[exact][full]") {
  Check check("exact_overturning_finite_depth", "Overturning wave over a flat bottom, until the jet meets the surface",
              "Depth and height 0.13 wavelengths; at $t = 0$ a cosine with the surface potential of the "
              "linear wave. The surface "
              "is compared with an earlier computation of ours at seven times, up to 0.49 linear periods; "
              "touch-down follows at 0.495. "
              "Volume, energy and impulse are conserved by the motion. A second number of markers and a "
              "second tolerance tell the "
              "numerical error.");
  check.source(source);
  const OverturningWave wave(over_bottom);
  const auto reference = profiles("overturning_wave_finite_depth", check.record());
  claim_table(check, wave,
              {{0.20, 0.50258640, -0.33633753, 8e-14},
               {0.30, 0.54016046, -0.34621816, 2e-13},
               {0.38, 0.57716544, -0.33287618, 8e-13},
               {0.42, 0.52309015, -0.31468459, 3e-11},
               {0.46, 0.45072547, -0.28918737, 2e-9},
               {0.48, 0.41614482, -0.27486145, 2e-8},
               {0.49, 0.40077443, -0.26772362, 7e-8}},
              reference, finite_period, "periods");
  claim_vertical_tangent(check, wave, 2.2198);
  check.that({.id = "collapse",
              .text = "The computation ends, for the jet is too close to the water ahead, when the reference does.",
              .quantity = "last time computed",
              .unit = "1/sqrt(g k)"},
             {.value = wave.end_time(), .resolution = "512 markers"},
             Bound{0.0017, "difference of that time between 512 and 1024 markers in the reference", 3.7911});
  check.that({.id = "touch-down",
              .text = "The gap closes when the reference's finer computation ends.",
              .quantity = "touch-down, extrapolated from the gap",
              .unit = "1/sqrt(g k)"},
             {.value = wave.touch_down_time().value(), .resolution = "512 markers"},
             Bound{0.0017, "difference of that time between 512 and 1024 markers in the reference", 3.7928});
  claim_conservation(check, wave, 0.48 * finite_period, "up to 0.48 periods");
  auto second = over_bottom;
  second.markers = 448;
  second.tolerance = 1e-11;
  second.last_time = 0.46 * finite_period;
  check.that(
      {.id = "self-convergence",
       .text = "At 0.46 periods the surface does not depend on the markers and the tolerance.",
       .quantity = "Hausdorff distance of 512 markers, tolerance 2e-11, and 448 markers, 1e-11",
       .unit = "1/k"},
      {.value =
           curve(wave.profile(second.last_time)).distance(curve(OverturningWave(second).profile(second.last_time)))},
      Bound{1e-8, "five times the reference's own distance at this time"});
  self_test_holds(check, "finite-depth", wave);
  draw(check, wave, reference, 3.7, "profiles", "Overturning over a bottom", finite_period, "periods");
  CHECK_THROWS_AS(wave.profile(0.6 * finite_period), Divergence);
}

TEST_CASE("a steep wave in deep water overturns as the reference does", "[exact]") {
  Check check(
      "exact_overturning_deep", "Overturning wave in deep water",
      "At $t = 0$ $\\eta = 0.5 \\cos x$ with surface potential $0.5 e^{\\eta} \\sin x$, whose kinetic energy is "
      "$\\frac{\\pi}{2} A^2 I_0(2A)$. Profiles, extremes, vertical tangent and nose of the jet against an earlier "
      "computation of ours.");
  auto parameters = deep_water;
  parameters.last_time = 4.4;
  const OverturningWave wave(parameters);
  check.that({.id = "kinetic-energy",
              .text = "The first integral equation gives the kinetic energy in closed form.",
              .quantity = "kinetic energy at t = 0",
              .unit = "g/k^3",
              .source = "(pi/2) A^2 I_0(2A): integral of the squared velocity of exp(y) sin x"},
             {.value = wave.integrals(0).kinetic_energy},
             Roundoff{512, 0.5, "sum over 512 markers; the equation is solved to 1e-15", 0.497182907563303});
  const auto reference = profiles("overturning_wave_deep", check.record());
  claim_table(check, wave,
              {{2.0, 0.60030152, -0.45545802, 1e-13},
               {3.0, 0.81973490, -0.35712013, 4e-13},
               {3.4, 0.66703867, -0.34104680, 4e-13},
               {3.8, 0.62646722, -0.36429875, 2e-11},
               {4.0, 0.67943467, -0.37883297, 2e-10},
               {4.2, 0.72343104, -0.38792561, 1e-9},
               {4.4, 0.75335830, -0.38857212, 6e-9}},
              reference, 1, "1/sqrt(g k)");
  claim_vertical_tangent(check, wave, 3.3623);
  Worst nose_x;
  Worst nose_y;
  for (const auto& [t, x, y] : {std::tuple{4.0, 5.74728, 0.53257}, {4.4, 6.44821, 0.40559}}) {
    const auto jet = wave.jet(t).value();
    nose_x.add(jet.nose_x - x);
    nose_y.add(jet.nose_y - y);
  }
  check.that({.id = "nose-abscissa",
              .text = "The nose of the jet is as far ahead as the reference's, at t = 4 and 4.4.",
              .quantity = "largest difference",
              .unit = "1/k",
              .source = source},
             {.value = nose_x.value()}, Bound{5e-6, "half a unit of the last printed digit"});
  check.that({.id = "nose-ordinate",
              .text = "The height of the jet's nose agrees with the reference at t = 4 and 4.4.",
              .quantity = "largest difference",
              .unit = "1/k",
              .source = source},
             {.value = nose_y.value()},
             Bound{3.7e-4,
                   "the reference gives the marker that is farthest ahead; its neighbours among 1024 "
                   "are 7.4e-4 above and below it at t = 4, and the surface is vertical there"});
  claim_conservation(check, wave, 4.2, "up to t = 4.2");
  self_test_holds(check, "deep", wave);
  draw(check, wave, reference, 4.4, "profiles", "Overturning in deep water", 1, "");
}

TEST_CASE("an overturning wave scales with wavelength and gravity and refuses what it is not for", "[exact]") {
  const OverturningWave unit({.amplitude = 0.3, .depth = 1, .markers = 128, .last_time = 0.5});
  const double length = 3;
  const double gravity = 9.81;
  const double time = std::sqrt(length / gravity);
  const OverturningWave scaled({.amplitude = 0.3 * length,
                                .wavelength = period * length,
                                .depth = length,
                                .gravity = gravity,
                                .markers = 128,
                                .last_time = 0.5 * time});
  const auto a = unit.profile(0.5);
  const auto b = scaled.profile(0.5 * time);
  Worst difference;
  for (std::size_t j = 0; j < a.x.size(); ++j) {
    difference.add(b.x[j] / length - a.x[j]);
    difference.add(b.y[j] / length - a.y[j]);
    difference.add(b.u[j] * time / length - a.u[j]);
    difference.add(b.v[j] * time / length - a.v[j]);
    difference.add(b.potential[j] * time / (length * length) - a.potential[j]);
  }
  CHECK(difference.value() < 1e-12);  // round-off of the scales shifts the choice of steps
  const auto arc = unit.profile(0.5, 101);
  CHECK(std::abs(arc.x.back() - arc.x.front() - period) < 1e-14);
  CHECK(std::abs(std::hypot(arc.x[1] - arc.x[0], arc.y[1] - arc.y[0]) -
                 std::hypot(arc.x[51] - arc.x[50], arc.y[51] - arc.y[50])) < 1e-4);
  CHECK(!unit.vertical_tangent_time());
  CHECK(!unit.jet(0.5));
  CHECK_THROWS_AS(unit.profile(0.6), std::invalid_argument);
  CHECK_THROWS_AS(unit.profile(-0.1), std::invalid_argument);
  CHECK_THROWS_AS(OverturningWave({.amplitude = -0.1}), std::invalid_argument);
  CHECK_THROWS_AS(OverturningWave({.amplitude = 0.5, .depth = 0.4}), std::invalid_argument);
  CHECK_THROWS_AS(OverturningWave({.amplitude = 0.5, .depth = std::nan("")}), std::invalid_argument);
  CHECK_THROWS_AS(OverturningWave({.markers = 65}), std::invalid_argument);
}

}  // namespace overturning_wave_test
