// Two lines joined by an arc: places, chords and moments.
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/math/quadrature/gauss.hpp>

#include "seiche/geometry/curve.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::bent_line_test {

/// Integral of y^2/2 x' between arc lengths that a bend does not lie between, by Gauss's rule.
double moment_between(const BentLine& line, double from, double to) {
  const double half = 0.5 * (to - from);
  return half * boost::math::quadrature::gauss<double, 15>::integrate(
                    [&](double part) {
                      const double s = 0.5 * (from + to) + half * part;
                      const double y = line.position(s).y;
                      return 0.5 * y * y * line.tangent(s).x;
                    },
                    -1, 1);
}

TEST_CASE("chords, positions and moments of a bent line agree to round-off", "[geometry]") {
  Check check("bent_line", "Two lines joined by an arc",
              "A level line at y = -1 that turns at (3, -1), to the left and to the right, by 0.1 to 1.5. Arc lengths "
              "before, on and after the arc, and intervals over one, two or all three of these.",
              "definition");
  Worst chord, length, back, moments;
  for (const double angle : {-1.2, 0.1, std::numbers::pi / 4, 1.1, 1.5}) {
    const double rounding = 0.4;
    const BentLine line({3, -1}, {1, 0}, {std::cos(angle), std::sin(angle)}, rounding);
    const double half = 0.5 * std::abs(angle) * line.radius();
    const std::vector<double> places{-2, -half, -0.6 * half, 0, 0.3 * half, half, 1.5};
    for (std::size_t a = 0; a < places.size(); ++a) {
      const Point t = line.tangent(places[a]);
      length.add(std::hypot(t.x, t.y) - 1, angle);
      back.add(line.arc_length_at(line.position(places[a])) - places[a], angle);
      double sum = 0;
      for (std::size_t b = a + 1; b < places.size(); ++b) {
        const Point from = line.position(places[a]), to = line.position(places[b]);
        const double apart = places[b] - places[a];
        const Point mean = line.mean_tangent(places[b], places[a]);
        chord.add(std::hypot(apart * mean.x - (to.x - from.x), apart * mean.y - (to.y - from.y)), angle);
        sum += moment_between(line, places[b - 1], places[b]);
        moments.add(apart * line.mean_moment_rate(places[a], places[b]) - sum, angle);
        moments.add(line.moment(places[b]) - line.moment(places[a]) - sum, angle);
      }
    }
  }
  const Roundoff roundings{.operations = 100, .scale = 5, .reason = "a hundred roundings of lengths up to 5"};
  check.that("chord", "Mean tangents equal the chords of the line.", "largest difference", {chord.value()}, roundings);
  check.that("tangent", "Tangent vectors of the line have length 1.", "largest defect", {length.value()}, roundings);
  check.that("foot", "The arc length found for a point of the curve is the point's own.", "largest difference",
             {back.value()}, roundings);
  check.that("moment", "Moments are the integrals of y^2/2 x'.", "largest difference", {moments.value()}, roundings);
  CHECK_THROWS_AS(BentLine({0, 0}, {1, 0}, {1, 0}, 0.1), std::invalid_argument);
  CHECK_THROWS_AS(BentLine({0, 0}, {1, 0}, {0, 1}, 0.1), std::invalid_argument);
  CHECK_THROWS_AS(BentLine({0, 0}, {1, 0}, {1, 1}, 0), std::invalid_argument);
}

}  // namespace seiche::verification::bent_line_test
