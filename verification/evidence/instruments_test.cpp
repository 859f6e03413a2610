// Instruments that read a number off a series or a profile, on curves for which that number is known.
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "reports/evidence/grid_convergence.hpp"
#include "seiche/samples.hpp"
#include "validation/case/refinement.hpp"
#include "validation/instruments/error_measures.hpp"
#include "validation/instruments/fine_limit.hpp"
#include "validation/instruments/harmonic_fit.hpp"
#include "validation/instruments/mesh/crest_track.hpp"
#include "validation/instruments/oscillation.hpp"
#include "validation/instruments/particles/gauss_outline.hpp"
#include "validation/instruments/peak.hpp"
#include "validation/instruments/plan/oblique_wave.hpp"
#include "validation/instruments/plan/row_crests.hpp"
#include "validation/instruments/plan/wall_history.hpp"
#include "validation/instruments/polyline_distance.hpp"
#include "validation/instruments/straight_line.hpp"
#include "validation/instruments/wave_statistics.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"
#include "validation/studies/shallow_water/profile_measures.hpp"
#include "validation/studies/shallow_water/riemann_profile.hpp"
#include "verification/check.hpp"
#include "verification/message_of.hpp"

namespace seiche::verification::instruments_test {

using namespace validation;

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Claims that a number is what follows by hand.
auto exactly_by(Check& check) {
  return [&check](const std::string& id, const std::string& text, double value, double expected, double operations,
                  double scale, const std::string& reason) {
    check.holds(id + ": " + text, {value}, Roundoff{operations, scale, reason, expected});
  };
}

TEST_CASE("a mirrored dam break has the same requirements", "[evidence]") {
  const auto limits = [](const exact::Riemann& solution) {
    std::vector<double> all;
    for (const RiemannRequirement& one : riemann_requirements(solution, 2, -15, 15, 0.5)) {
      all.push_back(one.bound.limit.value());
    }
    return all;
  };
  const std::vector<double> right = limits(exact::Riemann(9.81, {1, 0}, {0.5, 0}));
  const std::vector<double> left = limits(exact::Riemann(9.81, {0.5, 0}, {1, 0}));
  REQUIRE((right.size() == left.size() && right.size() > 3));
  for (std::size_t k = 0; k < right.size(); ++k) CHECK(left[k] == Approx(right[k]).epsilon(1e-9));
}

TEST_CASE("the curve of a profile advances across its gaps", "[evidence]") {
  const auto ramp = [](double x) { return shallow_water::State{x, 0}; };
  const shallow_water::MeasuredProfile profile{
      .edges = {0, 1, 2}, .means = {{1, 0}, {2, 0}}, .reconstruction = ramp, .breaks = {0.4, 0.1, 1.7}};
  const ProfileCurve curve = computed_curve(profile);
  CHECK(std::is_sorted(curve.x.begin(), curve.x.end()));
  CHECK((curve.x.size() == 16 && curve.depth == curve.x));
}

TEST_CASE("diagnostics for series return known values", "[evidence]") {
  Check check("instruments_of_series", "Instruments for series",
              "Peaks of a parabola, the frequency of a sum of harmonics, the period of a wave, the speed of a crest, "
              "the line through points with known residuals, the limit of two grids.");
  const auto exactly = exactly_by(check);

  // Unequal times: the parabola is the same through any three of its points.
  Peak peak;
  const auto parabola = [](double t) { return 3 - 0.5 * (t - 1.3) * (t - 1.3); };
  for (const double t : {0.0, 0.4, 1.1, 1.6, 2.4, 2.5}) peak.add(t, parabola(t));
  const char* three = "differences of three values of at most 3 over steps of a half";
  exactly("peak", "The maximum of a parabola is interpolated exactly between its points.", peak.value(), 3, 20, 6,
          three);
  exactly("peak-time", "The time of a peak between the points is exact to round-off.", peak.time(), 1.3, 20, 6, three);

  std::vector<double> harmonics;
  constexpr double frequency = 2.7, tau = 0.11;
  for (int n = 0; n < 200; ++n) {
    const double phase = frequency * tau * n + 0.4;
    harmonics.push_back(0.2 + 1.5 * std::cos(phase) + 0.3 * std::sin(2 * phase));
  }
  const Oscillation fit = fit_oscillation(harmonics, tau, {1, 2});
  const char* sums = "sums over 200 samples in the normal equations, whose condition is below ten";
  exactly("frequency", "The fitted frequency of an oscillation with a second harmonic is exact.", fit.frequency,
          frequency, 2000, 10, sums);
  exactly("amplitude", "The fitted amplitude of the first harmonic is exact.", fit.amplitude, 1.5, 2000, 10, sums);

  exactly("sawtooth", "The deviation of a signal that changes its sign from sample to sample is its amplitude.",
          wave_statistics(std::vector<double>{3, -3, 3, -3, 3, -3}).deviation, 3, 20, 3, "a Fourier transform of six");

  std::vector<double> wave;
  for (int n = 0; n <= 400; ++n) wave.push_back(std::cos(2 * pi * n * 0.05 / 3.37));
  check.holds("The fitted period of a wave of 67 points is accurate to 1 %.", {period_of(wave, 0.05).length - 3.37},
              Bound{0.01 * 3.37,
                    "the ends of a window of six periods that is no multiple of them shift the top of the correlation "
                    "by less than a hundredth of one"});

  CrestTrack track;
  for (int n = 0; n <= 50; ++n) {
    track.time.push_back(0.1 * n);
    track.place.push_back(n < 20 ? 0 : 1.25 * 0.1 * (n - 20));
    track.elevation.push_back(n < 20 ? 9 : 0.3);
  }
  const char* thirty = "sums over 31 points of at most 5 times 4";
  exactly("speed", "The fitted crest speed from a given time on is exact.", track.speed(2.0), 1.25, 62, 20, thirty);
  exactly("elevation", "The mean elevation from a stated time on is exact.", track.mean_elevation(2.0), 0.3, 31, 9,
          thirty);

  // Residuals 1, -1, -1, 1 have neither mean nor slope: 4 squares over 2 degrees of freedom, spread 5 of u.
  const std::vector<double> u = {0, 1, 2, 3};
  const std::vector<double> v = {1.5 + 1, 3.5 - 1, 5.5 - 1, 7.5 + 1};
  const StraightLine line = straight_line(u, v);
  const char* four = "sums over four points of at most 9";
  exactly("slope", "The fitted slope of a line through four points is exact.", line.slope, 2, 8, 9, four);
  exactly("slope-error", "The standard error of the slope of a line through four points is exact.", line.slope_error,
          std::sqrt(2.0 / 5), 8, 9, four);
  exactly("mean-error", "The standard error of the mean of the line is exact.", line.mean_error, std::sqrt(2.0 / 4), 8,
          9, four);
  exactly("where", "The position where a line reaches a value is exact.", line.where(6.5).value, 2.5, 8, 9, four);
  exactly("angle", "The angle that a line makes with the axis is exact.", line.angle().value, std::atan(2.0), 8, 9,
          four);
  exactly("angle-error", "The expanded uncertainty of the angle is twice its standard error.",
          line.angle().half_width(), 2 * std::sqrt(0.4) / 5, 8, 9, four);

  const FineLimit limit = fine_limit({0.5, 1}, {1.25, 2}, 2);
  exactly("limit", "The extrapolated limit of two grids at second order is exact.", limit.value, 1, 4, 2,
          "four operations");
  exactly("limit-uncertainty", "The uncertainty of the limit is three times the remaining difference.",
          limit.uncertainty, 0.75, 4, 2, "four operations");
}

TEST_CASE("errors of a profile equal their definitions", "[evidence]") {
  using namespace shallow_water;
  Check check("profile_errors", "Errors of shallow-water profiles",
              "A step of depth from 3 to 1 at x = 1.8 with velocities 2 and 0, cells of unequal width whose mean "
              "depths are 10 % too high and whose velocities are 10 % too low: the errors follow by hand.");
  const auto exactly = exactly_by(check);
  const auto exact = [](double x) { return x < 1.8 ? State{3, 2} : State{1, 0}; };
  // The third cell holds the step: mean depth 2.2, momentum 3.6 over mass 2.2.
  const auto high = [&](double x) { return State{exact(x).depth + (x < 1 ? 0.2 : 0.0), exact(x).velocity}; };
  const MeasuredProfile profile{.edges = {0, 1, 1.5, 2, 4},
                                .means = {{3.1, 1.9}, {3.1, 1.9}, {2.3, 3.6 / 2.2 - 0.1}, {1.1, -0.1}},
                                .reconstruction = high,
                                .breaks = {1}};
  const ProfileError cell = cell_error(profile, exact, {1.8});
  const char* points = "32 points in each of four cells, numbers up to 3";
  exactly("cell-l1", "The mean error of the cell means of depth is exact.", cell.depth.l1, 0.1, 128, 3, points);
  exactly("cell-l2", "The root mean square error of the depths is exact.", cell.depth.l2, 0.1, 128, 3, points);
  exactly("cell-linf", "The largest error of the depths is exact.", cell.depth.linf, 0.1, 128, 3, points);
  exactly("cell-velocity", "The mean error of the mass means of velocity is exact.", cell.velocity.l1, 0.1, 128, 3,
          points);
  const ProfileError rec = reconstruction_error(profile, exact, {1.8});
  exactly("rec-l1", "The mean error of a reconstruction 0.2 too high over a quarter of the length is exact.",
          rec.depth.l1, 0.05, 256, 3, points);
  exactly("rec-l2", "The root mean square error of the depths is exact.", rec.depth.l2, 0.1, 256, 3, points);
  exactly("rec-linf", "The largest error of the depths is exact.", rec.depth.linf, 0.2, 256, 3, points);
  // Of the third cell 0.3 are 0.7 too low and 0.2 are 1.3 too high.
  const ProfileError pc = piecewise_constant_error(profile, exact, {1.8});
  exactly("pc-l1", "The mean error of piecewise constant depths beside a step is exact.", pc.depth.l1,
          (0.1 * 3.5 + 0.7 * 0.3 + 1.3 * 0.2) / 4, 128, 3, points);
  exactly("pc-linf", "The largest error of the rectangles is at the step.", pc.depth.linf, 1.3, 128, 3, points);

  const MeasuredProfile smeared{.edges = {0, 1, 2, 3, 4, 5},
                                .means = {{3, 0}, {2.95, 0}, {2, 0}, {1.2, 0}, {1, 0}},
                                .reconstruction = {},
                                .breaks = {}};
  exactly("width", "The number of cells strictly between 5 and 95 % of a jump is two.", jump_width(smeared, 3, 1, 0, 5),
          2, 1, 0, "a count");
  exactly("position", "The position of the step of equal volume is exact.", jump_position(smeared, 3, 1, 0, 5),
          (10.15 - 5) / 2, 10, 10, "a sum of five cells");
}

TEST_CASE("instruments reject what they cannot read a number off, and say what it is", "[evidence]") {
  const auto said = [](const auto& action) { return message_of(action); };
  const std::vector<double> none, two{0, 1}, five{0, 1, 2, 3, 4}, nodes(25, 0.5);
  const Polyline point{{1}, {2}}, twice{{1, 1}, {2, 2}}, line{{0, 1}, {0, 0}};
  for (const auto& [bad, why] : {std::pair(point, "needs at least two points"), std::pair(twice, "has no length")}) {
    const std::string words = std::string("polyline_distance: a curve ") + why;
    CHECK(said([&, one = bad] { polyline_distance({line}, {one}); }) == words);
    CHECK(said([&, one = bad] { polyline_distance({one}, {line}); }) == words);
  }
  CHECK(said([&] { require_complete({.columns = 3, .rows = 4, .x = nodes, .y = nodes, .z = nodes}); }) ==
        "surface grid of 3 by 4 cells: must be at least 4 by 4");
  CHECK(said([&] { require_complete({.columns = 4, .rows = 3, .x = nodes, .y = nodes, .z = nodes}); }) ==
        "surface grid of 4 by 3 cells: must be at least 4 by 4");
  std::vector<double> infinite = nodes;
  infinite[7] = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<std::string, SurfaceLattice>> grids{
      {"x", {.columns = 4, .rows = 4, .x = infinite, .y = nodes, .z = nodes}},
      {"y", {.columns = 4, .rows = 4, .x = nodes, .y = infinite, .z = nodes}},
      {"z", {.columns = 4, .rows = 4, .x = nodes, .y = nodes, .z = infinite}}};
  for (const auto& [name, grid] : grids) {
    CHECK(said([&, one = grid] { require_complete(one); }) ==
          "surface grid: " + name + " of node 7 is inf, must be finite");
  }
  CHECK(said([&] { require_complete({.columns = 4, .rows = 4, .x = nodes, .y = nodes, .z = five}); }) ==
        "surface grid: z has 5 values, must have 25: one for each node");
  CHECK(said([&] { gauss_particles::surface_contours(two, five, five, 1, 1); }) ==
        "2 x, 5 y, 5 masses; allowed: as many of each");
  CHECK(said([&] { gauss_particles::surface_contours(two, two, five, 1, 1); }) ==
        "2 x, 2 y, 5 masses; allowed: as many of each");
  CHECK(said([&] {
          evidence::grid_convergence({1, 2}, {1, 2}, 2);
        }) == "grid convergence: needs three or more different positive sizes with as many values, got 2 and 2");
  for (const std::vector<double>& sizes : {std::vector<double>{1, 2, 2}, {1, 2, 0}, {1, 2, infinity}}) {
    CHECK_THAT(said([&] { evidence::grid_convergence(sizes, {1, 2, 3}, 2); }), Catch::StartsWith("grid convergence"));
  }
  CHECK_THAT(said([&] { evidence::grid_convergence({1, 2, 4}, {1, 2}, 2); }), Catch::EndsWith("got 3 and 2"));
  Refinement refinement;
  refinement.add(8, {0.5, 0.25});
  refinement.add(16, {0.125, 0.0625});
  CHECK((refinement.on(8, 1) == 0.25 && refinement.on(16, 0) == 0.125 && refinement.finest(1) == 0.0625));
  CHECK(message_of<std::logic_error>([&] { refinement.add(32, {1}); }) == "1 errors of 2 quantities");
  CHECK(message_of<std::logic_error>([&] { return refinement.on(32, 0); }) == "no mesh of 32 cells");
}

TEST_CASE("a mesh is drawn by its columns and rows in the window, and a column more on each side", "[evidence]") {
  // Five columns of two cells: six columns of nodes at x = 0 to 5, three rows at y = 0 to 2.
  lagrangian_mesh_2d::Mesh mesh;
  mesh.columns = 5;
  mesh.rows = 2;
  std::vector<double> x(18), y(18);
  for (std::size_t i = 0; i <= 5; ++i) {
    for (std::size_t j = 0; j <= 2; ++j) {
      x[mesh.node(i, j)] = static_cast<double>(i);
      y[mesh.node(i, j)] = static_cast<double>(j);
    }
  }
  const auto drawn = [&](double begin, double end) {
    evidence::Panel panel({.x = "x", .y = "y"});
    draw_mesh(panel, "mesh", mesh, x, y, {begin, end});
    return panel.series().front();
  };
  const evidence::Series part = drawn(2, 3);  // columns 2 and 3, with 1 and 4
  CHECK(part.x == std::vector<double>{1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 4, 3, 2, 1, 1, 2, 3, 4, 4, 3, 2, 1});
  CHECK(part.y == std::vector<double>{0, 1, 2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2});
  CHECK(drawn(-1, 9).x.size() == 6 * 3 + 3 * 6);
  CHECK(drawn(0, 1).x.size() == 3 * 3 + 3 * 3);  // no column before the first
  CHECK(message_of([&] { drawn(2.5, 3); }) == "fewer than two columns of the mesh between 2.5 and 3");
  const evidence::Axes axes = mesh_axes("part", {2, infinity});
  CHECK((axes.title == "part" && axes.equal_aspect && axes.x_min == 2.0 && !axes.x_max));
}

TEST_CASE("the limit of a wall amplitude is as uncertain as its last value and the rate of the theory", "[evidence]") {
  // Exactly 1 - 0.3 exp(-t/100) until t = 600: the fit is exact, what the last value lacks is 0.3 exp(-6).
  std::vector<double> time, amplitude;
  for (int k = 1; k <= 600; ++k) {
    time.push_back(k);
    amplitude.push_back(1 - 0.3 * std::exp(-k / 100.0));
  }
  const double last = amplitude.back();
  const WallLimit free = wall_limit(time, amplitude);
  CHECK(free.amplitude.value == Approx(1).epsilon(1e-6));
  CHECK(free.exponential.rate == Approx(0.01).epsilon(1e-4));
  CHECK(free.amplitude.uncertainty.value() < 1e-6);
  CHECK(free.amplitude.resolution == "until t = 600");
  for (const double rate : {0.002, 0.005, 1.0}) {
    const double settled = last / (1 - std::exp(-rate * 600));
    CHECK(wall_limit(time, amplitude, rate).amplitude.uncertainty.value() ==
          Approx(std::max(std::abs(settled - 1), 1 - last)).epsilon(1e-3));
  }
  CHECK(message_of([&] { wall_limit(time, amplitude, -1); }) ==
        "wall history: rate = -1 is out of range: must be >= 0");
  std::vector<double> wrong = time;
  wrong[5] = wrong[4];
  CHECK(message_of([&] { wall_limit(wrong, amplitude); }) == "wall history: time 5 after 5, must increase");
  wrong[5] = infinity;
  CHECK_THAT(message_of([&] { wall_limit(wrong, amplitude); }), Catch::EndsWith("at time inf is not finite"));
}

TEST_CASE("an oblique wave has the widths of a wave of amplitude 0.3", "[evidence]") {
  CHECK(ObliqueWave(0.3, 0.5).width_unit() == 1);
  CHECK(ObliqueWave(0.075, 0.5).width_unit() == Approx(2).epsilon(1e-14));
  const ObliqueWave wave(0.3, std::acos(0.8), 2);
  CHECK(wave.elevation(2, 0, 0) == Approx(0.3).epsilon(1e-14));
  // The crest at y is ahead by y tan psi, and moves along the wall with c/cos psi, c = sqrt(1 + a).
  CHECK(wave.crest_at(4, 0) == Approx(2 + 4 * 0.75).epsilon(1e-14));
  CHECK(wave.crest_at(0, 3) == Approx(2 + 3 * std::sqrt(1.3) / 0.8).epsilon(1e-14));
  const auto top = wave.velocity(2, 0, 0);
  CHECK(top.u / -top.v == Approx(0.8 / 0.6).epsilon(1e-12));
  CHECK(wave.elevation(2 + wave.margin(), 0, 0) < 1e-5);
}

}  // namespace seiche::verification::instruments_test
