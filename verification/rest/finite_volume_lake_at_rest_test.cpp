#include <cmath>
#include <numbers>
#include <vector>

#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::finite_volume_lake_at_rest_test {

using shallow_water_finite_volume::FiniteVolumeFlow;

TEST_CASE("the comparison scheme keeps a lake at rest on an uneven bed, with and without an island", "[rest]") {
  Check check(
      "finite_volume_lake_at_rest", "Finite volumes: a lake at rest",
      "Bed $z = b\\,e^{-(x-5)^2} + 0.05 \\sin 3x$, surface at 0.8 m, 200 cells, 10 000 steps. With $b = 0.3$ the bed "
      "is covered, with $b = 1.2$ an island parts the lake. The hydrostatic reconstruction balances thrust and bed to "
      "round-off; one rounding of $g h^2/2$ per step would random-walk to $4 \\epsilon \\sqrt{10^4}\\, g h \\tau/dx$.");
  constexpr std::size_t cells = 200;
  constexpr double dx = 10.0 / cells;
  for (const double height : {0.3, 1.2}) {
    const Bed bed{[=](double x) { return height * std::exp(-(x - 5) * (x - 5)) + 0.05 * std::sin(3 * x); },
                  [=](double x) {
                    return 0.5 * height * std::sqrt(std::numbers::pi) * std::erf(x - 5) - 0.05 / 3 * std::cos(3 * x);
                  }};
    std::vector<double> depth(cells);
    for (std::size_t i = 0; i < cells; ++i) {
      const double a = dx * static_cast<double>(i);
      depth[i] = std::max(0.0, 0.8 - (bed.primitive(a + dx) - bed.primitive(a)) / dx);
    }
    FiniteVolumeFlow flow({}, 0, 10, depth, std::vector<double>(cells, 0.0), bed);
    for (int k = 0; k < 10000; ++k) flow.advance(0.005);
    Worst fastest, moved;
    for (std::size_t i = 0; i < cells; ++i) {
      fastest.add(flow.discharge()[i]);
      moved.add(flow.depth()[i] - depth[i]);
    }
    const std::string id = height < 1 ? "covered" : "island";
    const Roundoff limit{.operations = 1e4, .scale = 1, .reason = "one rounding of g h tau/dx < 1 per step"};
    check.holds(id + "-discharge: No flow starts.", {fastest.value()}, limit);
    check.holds(id + "-depth: The surface elevation is constant to round-off.", {moved.value()}, limit);
    check.holds(id + "-mass: Mass is constant.", {flow.mass_defect()},
                Roundoff{1e4 * cells, dx, "one rounding per cell and step"});
  }
}

}  // namespace seiche::verification::finite_volume_lake_at_rest_test
