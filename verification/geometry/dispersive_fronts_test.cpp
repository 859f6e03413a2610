// Where fronts of the dispersive shallow-water model break: shapes whose slope and Froude number are known.
#include <algorithm>
#include <cmath>
#include <vector>

#include "seiche/models/dispersive_shallow_water_1d/channel.hpp"
#include "seiche/shallow_water/relations.hpp"
#include "verification/all_hold.hpp"
#include "verification/check.hpp"

namespace seiche::verification::dispersive_fronts_test {

using namespace dispersive_shallow_water_1d;
using shallow_water::bore_damping;
using shallow_water::bore_froude;

constexpr std::size_t markers = 81;

/// A straight front of a rise over a width at x = 0, down to the right over depth 1, moving like a bore.
struct Front {
  std::vector<double> x, y, u, bed;

  Front(double rise, double width, double shift = 0) {
    for (std::size_t i = 0; i < markers; ++i) {
      x.push_back(0.1 * (static_cast<double>(i) - 40));
      const double s = std::clamp(0.5 - (x.back() - shift) / width, 0.0, 1.0);
      y.push_back(rise * s);
      u.push_back(s);
      bed.push_back(-1);
    }
  }
  [[nodiscard]] BreakingFronts::Surface surface(double period = 0) const { return {x, y, u, bed, 1, period}; }
};

long breaking_cells(const BreakingFronts& fronts) {
  return std::ranges::count_if(fronts.damping(), [](double d) { return d > 0; });
}

TEST_CASE("fronts start to break when steep and continue while they are bores", "[geometry]") {
  Check check(
      "dispersive_fronts", "Fronts that break",
      "Straight fronts over depth 1. They begin at a slope of 30 degrees, end where the Froude number of a bore of "
      "their depths falls below 1.3, a rise of 0.406, and continue while they overlap with earlier breaking fronts.");
  const Breaking settings;
  BreakingFronts fronts(settings, markers - 1);
  const auto counts = [&](const std::string& text, long found, long expected) {
    check.holds(text, {static_cast<double>(found)}, Bound{0, "a number of cells", static_cast<double>(expected)});
  };
  const auto after = [&](const Front& front) {
    fronts.find(front.surface());
    return breaking_cells(fronts);
  };
  counts("A front of slope 1:2 does not start to break.", after({0.5, 1.04}), 0);
  counts("A front of slope 1:1.7 breaks, over all its cells.", after({0.5, 0.84}), 10);
  counts("The breaking of a front that has become gentle continues at its new position.", after({0.5, 1.04, 0.3}), 12);
  counts("A gentle front elsewhere does not continue the breaking.", after({0.5, 1.04, 2.5}), 0);
  counts("A steep front of Froude number 1.29 is not classified as a bore.", after({0.39, 0.44}), 0);
  counts("A steep front of Froude number 1.31 is classified as a breaking bore.", after({0.42, 0.44}), 6);
  counts("Breaking of a bore ends below the ceasing Froude number.", after({0.39, 0.44}), 0);
  Front faint(0.5, 0.84);
  for (std::size_t i = 0; i < markers; ++i) faint.u[i] -= 1e-6 * faint.x[i];
  counts("Water that converges at 1e-6 c/h on either side is not part of the front.", after(faint), 10);

  Front front(0.5, 0.84, -4);
  const Front image(0.5, 0.84, 4.1);  // one period further
  for (std::size_t i = 0; i < markers; ++i) {
    if (front.x[i] < 0) continue;
    front.y[i] = image.y[i];
    front.u[i] = image.u[i];
  }
  BreakingFronts ring(settings, markers);
  ring.find(front.surface(8.1));
  counts("The breaking of a front continues beyond the end of a periodic channel.", breaking_cells(ring), 10);

  all_hold(check, Roundoff{8, 2, "a few roundings"},
           {{"A bore that doubles the depth has Froude number sqrt(3).", bore_froude(1, 1), std::sqrt(3.0)},
            {"The squared Froude number behind the front is 3/8.", bore_damping(1, 1), std::sqrt(1 - 3.0 / 8)},
            {"A bore without height needs no viscosity.", bore_damping(1, 0)}});
  CHECK(std::isinf(bore_froude(0, 1)));
  CHECK(bore_damping(0, 1) == 1);
}

}  // namespace seiche::verification::dispersive_fronts_test
