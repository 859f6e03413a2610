// The measures that others are scored by, on curves whose measures are known.
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "validation/instruments/agreement.hpp"
#include "verification/check.hpp"
#include "verification/evidence/known_curve.hpp"

namespace seiche::verification::agreement_test {

using namespace validation;

constexpr double pi = std::numbers::pi;

TEST_CASE("measures of agreement have their known values", "[evidence]") {
  Check check("measures_of_agreement", "Measures of agreement",
              "The measures that `seiche score` takes, on curves for which they follow by hand.");
  const auto sine = [](double x) { return std::sin(x); };
  const Points reference = sampled(0, 4 * pi, 400, sine);

  // s = 1.1 r: every relative norm is 0.1, the amplitude 1.1, and nothing is shifted.
  const Agreement high =
      agreement(sampled(0, 4 * pi, 400, [&](double x) { return 1.1 * sine(x); }).curve(), reference.curve());
  const auto exactly = [&](const std::string& id, double value, double expected) {
    check.holds(id + ": The measures of a curve 10 % too high follow from their definitions.", {value},
                Roundoff{2 * 401, expected, "a rounded term and a rounded sum for each of 401 points", expected});
  };
  exactly("relative-l1", high.relative_l1, 0.1);
  exactly("relative-l2", high.relative_l2, 0.1);
  exactly("relative-linf", high.relative_linf, 0.1);
  exactly("amplitude-ratio", high.amplitude_ratio, 1.1);
  exactly("coverage", high.coverage, 1.0);
  exactly("largest-error", high.largest_error, 0.1);
  exactly("peak", high.peak - high.reference_peak, 0.1);
  // sum (s - r)^2 = 0.01 S and sum (|s| + |r|)^2 = 4.41 S for a reference of mean 0.
  exactly("skill", high.skill, 1 - 0.01 / 4.41);

  // The parabola's error is of second order in the spacing over the wave's length: d^2/3 of a spacing at most, where d
  // is the spacing in radians; and one of a sample's interpolation.
  const double spacing = 4 * pi / 400;
  for (const double lag : {0.1, -0.25, 0.7}) {
    const Points late = sampled(0, 4 * pi, 400, [&](double x) { return std::sin(x - lag); });
    check.holds("The measured shift of a sine is accurate to 1 % of the spacing.",
                {agreement(late.curve(), reference.curve()).shift - lag},
                Bound{0.01 * spacing, "a parabola through the maximum of a smooth correlation"});
  }
  // Of two waves a period apart the nearer shift is taken.
  const Points same = sampled(0, 4 * pi, 400, sine);
  check.holds("The measured shift of a periodic curve against itself is zero.",
              {agreement(same.curve(), reference.curve()).shift},
              Bound{1e-12, "symmetric correlation, round-off of three sums"});

  // Seventeen points a period: the next period's lag falls on a multiple of the spacing more closely than the true one.
  const auto wave = [](double t) { return std::cos(2 * pi * t / 16.67); };
  const Points gauge = sampled(0, 100, 100, wave);
  const Points late_gauge = sampled(0, 100, 100, [&](double t) { return wave(t - 0.5); });
  check.holds("The measured shift of periodic curves is the smallest of the matching lags.",
              {agreement(late_gauge.curve(), gauge.curve()).shift - 0.5},
              Bound{0.05, "a parabola through three of seventeen points a period"});

  // Half as many points: the straight lines between them are second-order accurate, d^2/8 of the amplitude.
  const Points coarse = sampled(0, 4 * pi, 40, sine);
  const double step = 4 * pi / 40;
  check.holds("The submitted curve is interpolated linearly between its points.",
              {agreement(coarse.curve(), reference.curve()).largest_error},
              Bound{step * step / 8, "error of linear interpolation, largest second derivative 1"});

  // A curve on half the range covers half of the points, and is compared there alone.
  const Points half = sampled(0, 2 * pi, 200, sine);
  const Agreement part = agreement(half.curve(), reference.curve());
  check.holds("The coverage counts the submitted range alone: no curve is extrapolated.", {part.coverage},
              Bound{1.0 / 401, "one of 401 points", 0.5});
  check.holds("The error excludes reference points that are not covered.", {part.relative_l2},
              Roundoff{201, 1, "sum over 201 points"});
  CHECK_THROWS_AS(agreement(sampled(20, 30, 4, sine).curve(), reference.curve()), std::invalid_argument);

  // A ramp 0, 1, 2, ... reaches 2.5 half-way between its points.
  const Points ramp = sampled(0, 10, 10, [](double x) { return x; });
  check.holds("The arrival time is interpolated between the points.", {first_crossing(ramp.curve(), 2.5)},
              Roundoff{4, 10, "one interpolation", 2.5});
  CHECK(std::isnan(first_crossing(ramp.curve(), 11)));
}

}  // namespace seiche::verification::agreement_test
