// A curve over the horizontal by its arc length: what goes to and fro, and its ends.
#include <cmath>

#include "seiche/geometry/curve.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::curve_test {

TEST_CASE("a point of a graph and its arc length belong together", "[geometry]") {
  Check check("graph_curve", "A graph as a curve by its arc length",
              "A face between two levels, y = -1 + 0.3 (1 + tanh((x + 2)/0.21)), from -6 to 0, in 1 to 200 panels.",
              "arc length from begin to end");
  const auto elevation = [](double x) { return -1 + 0.3 * (1 + std::tanh((x + 2) / 0.21)); };
  const auto slope = [](double x) { return 0.3 / 0.21 / std::pow(std::cosh((x + 2) / 0.21), 2); };
  const auto bend = [&](double x) { return -2 / 0.21 * std::tanh((x + 2) / 0.21) * slope(x); };
  constexpr double begin = -6;
  constexpr long most = 200;
  Count beyond;
  Worst apart;
  for (long panels = 1; panels <= most; ++panels) {
    const GraphCurve curve(elevation, slope, bend, begin, 0, static_cast<std::size_t>(panels));
    for (int k = 0; k <= 60; ++k) {
      const Point on{begin + 0.1 * k, elevation(begin + 0.1 * k)};
      beyond.add(on.x, [&](double) {
        try {
          const Point again = curve.position(curve.arc_length_at(on));
          if (panels >= 40) apart.add(std::hypot(again.x - on.x, again.y - on.y), on.x);
          return false;
        } catch (const Infeasible&) {
          return true;
        }
      });
    }
  }
  check.that("ends", "The number of points of the graph whose arc length lies beyond the curve is zero.",
             "points beyond the ends", {.value = beyond.value(), .resolution = "1 to 200 panels"}, Bound{0, "none"});
  check.from("arc length by Gauss's rule over each panel")
      .that("round-trip", "The point at the arc length of a given point is the given point.", "largest distance [m]",
            {.value = apart.value(), .resolution = "40 to 200 panels"},
            Roundoff{most, 6, "a sum over the panels, of positions up to 6 m from the origin"});
}

}  // namespace seiche::verification::curve_test
