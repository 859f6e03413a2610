#include "reports/evidence/figure.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "verification/check.hpp"

namespace seiche::verification::figure_test {

using namespace evidence;

constexpr std::size_t columns = 60, rows = 40;

/// Where two solitary waves of amplitude 0.3 that run at an angle meet, over a
/// lattice that follows the crests.
struct Crossing {
  std::vector<double> x, y, z;

  Crossing() {
    const auto wave = [](double phase) { return 0.3 / std::pow(std::cosh(std::sqrt(0.225) * phase), 2); };
    for (std::size_t j = 0; j <= rows; ++j) {
      for (std::size_t i = 0; i <= columns; ++i) {
        y.push_back(0.5 * static_cast<double>(j));
        x.push_back(0.5 * static_cast<double>(i) - 15 + 0.1 * y.back());
        z.push_back(wave(x.back() - 0.5 * y.back()) + wave(x.back() + 0.5 * y.back()));
      }
    }
  }
  [[nodiscard]] Lattice lattice() const { return {columns, rows, x, y, z}; }
};

TEST_CASE("surfaces and plan views retain the points of their grid, holes included", "[figure]") {
  Crossing crossing;
  crossing.z[7] = std::numeric_limits<double>::quiet_NaN();
  Panel panel({.x = "x", .y = "y", .z = "z"});
  panel.surface("water", crossing.lattice());
  panel.plan("water", crossing.lattice());
  CHECK(panel.series().at(0).style == Style::surface);
  CHECK(panel.series().at(1).style == Style::plan);
  for (const Series& series : panel.series()) {
    CHECK(series.row_points == columns + 1);
    CHECK(series.x == crossing.x);
    CHECK(series.y == crossing.y);
    CHECK(series.z.size() == crossing.z.size());
    CHECK(std::isnan(series.z[7]));
  }
}

TEST_CASE("a grid whose arrays do not fit its cells is rejected with their numbers", "[figure]") {
  const Crossing crossing;
  Panel panel({.x = "x", .y = "y", .z = "z"});
  Lattice wrong = crossing.lattice();
  wrong.rows = rows - 1;
  CHECK_THROWS_WITH(panel.surface("water", wrong), Catch::Contains("2501 z for 60 x 39 cells, must be 2440 each"));
  wrong = crossing.lattice();
  wrong.z = wrong.z.first(3);
  CHECK_THROWS_AS(panel.plan("water", wrong), std::invalid_argument);
  CHECK_THROWS_AS(panel.plan("water", Lattice{}), std::invalid_argument);
  CHECK(panel.series().empty());
}

}  // namespace seiche::verification::figure_test
