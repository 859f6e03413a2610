// Instruments that read a number off a series or a profile, on curves for which that number is known.
#include <cmath>
#include <numbers>
#include <vector>

#include "seiche/samples.hpp"
#include "validation/instruments/error_measures.hpp"
#include "validation/instruments/fine_limit.hpp"
#include "validation/instruments/harmonic_fit.hpp"
#include "validation/instruments/mesh/crest_track.hpp"
#include "validation/instruments/oscillation.hpp"
#include "validation/instruments/peak.hpp"
#include "validation/instruments/straight_line.hpp"
#include "validation/instruments/wave_statistics.hpp"
#include "validation/studies/shallow_water/profile_measures.hpp"
#include "validation/studies/shallow_water/riemann_profile.hpp"
#include "verification/check.hpp"

namespace seiche::verification::instruments_test {

using namespace validation;

constexpr double pi = std::numbers::pi;

/// Claims that a number is what follows by hand.
class Exactly {
 public:
  explicit Exactly(Check& check) : check_(check) {}
  void operator()(const std::string& id, const std::string& text, double value, double expected, double operations,
                  double scale, const std::string& reason) const {
    check_.holds(id + ": " + text, {value}, Roundoff{operations, scale, reason, expected});
  }

 private:
  Check& check_;
};

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
  const shallow_water::MeasuredProfile profile{.edges = {0, 1, 2},
                                               .means = {{1, 0}, {2, 0}},
                                               .reconstruction =
                                                   [](double x) {
                                                     return shallow_water::State{x, 0};
                                                   },
                                               .breaks = {0.4, 0.1, 1.7}};
  const ProfileCurve curve = computed_curve(profile);
  CHECK(std::is_sorted(curve.x.begin(), curve.x.end()));
  CHECK((curve.x.size() == 16 && curve.depth == curve.x));
}

TEST_CASE("diagnostics for series return known values", "[evidence]") {
  Check check("instruments_of_series", "Instruments for series",
              "Peaks of a parabola, the frequency of a sum of harmonics, the period of a wave, the speed of a crest, "
              "the line through points with known residuals, the limit of two grids.");
  const Exactly exactly(check);

  // Unequal times: the parabola is the same through any three of its points.
  Peak peak;
  const auto parabola = [](double t) { return 3 - 0.5 * (t - 1.3) * (t - 1.3); };
  for (const double t : {0.0, 0.4, 1.1, 1.6, 2.4, 2.5}) peak.add(t, parabola(t));
  const char* three = "differences of three values of at most 3 over steps of a half";
  exactly("peak", "The maximum of a parabola is interpolated exactly between its points.", peak.value(), 3, 20, 6,
          three);
  exactly("peak-time", "The time of a peak between the points is exact to round-off.", peak.time(), 1.3, 20, 6, three);

  std::vector<double> harmonics;
  constexpr double frequency = 2.7;
  constexpr double tau = 0.11;
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
  const Exactly exactly(check);
  const auto exact = [](double x) { return x < 1.8 ? State{3, 2} : State{1, 0}; };
  // The third cell holds the step: mean depth 2.2, momentum 3.6 over mass 2.2.
  const MeasuredProfile profile{.edges = {0, 1, 1.5, 2, 4},
                                .means = {{3.1, 1.9}, {3.1, 1.9}, {2.3, 3.6 / 2.2 - 0.1}, {1.1, -0.1}},
                                .reconstruction =
                                    [&](double x) {
                                      return State{exact(x).depth + (x < 1 ? 0.2 : 0.0), exact(x).velocity};
                                    },
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

}  // namespace seiche::verification::instruments_test
