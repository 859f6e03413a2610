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

TEST_CASE("every kind of series keeps what it is given, in its own place", "[figure]") {
  const std::vector<double> x{1, 2}, y{3, 4}, error{5, 6}, edges{7, 8, 9};
  Panel panel({.x = "x", .y = "y"});
  panel.line("a", x, y, Role::exact);
  panel.points("b", x, y, Role::data, error);
  panel.steps("c", edges, y, Role::peer);
  panel.fill("d", x, y, Role::bed);
  panel.vertical("e", x, Role::water);
  const std::vector<Series> expected{{"a", Role::exact, Style::line, x, y, {}, {}, 0},
                                     {"b", Role::data, Style::points, x, y, error, {}, 0},
                                     {"c", Role::peer, Style::steps, edges, y, {}, {}, 0},
                                     {"d", Role::bed, Style::fill, x, y, {}, {}, 0},
                                     {"e", Role::water, Style::vertical, x, {}, {}, {}, 0}};
  REQUIRE(panel.series().size() == expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const Series& found = panel.series()[k];
    const Series& same = expected[k];
    CHECK((found.label == same.label && found.role == same.role && found.style == same.style));
    CHECK((found.x == same.x && found.y == same.y && found.y_error == same.y_error && found.z.empty()));
    CHECK(found.row_points == 0);
  }
  CHECK_THROWS_WITH(panel.line("f", edges, y), "figure series 'f': 3 abscissae for 2 ordinates, must be 2");
  CHECK_THROWS_WITH(panel.points("g", x, y, Role::data, edges), Catch::Contains("series 'g': 2 abscissae for 2"));
  CHECK_THROWS_WITH(panel.steps("h", x, y), "figure series 'h': 2 abscissae for 2 ordinates, must be 3");
  CHECK_THROWS_WITH(panel.fill("i", edges, y), Catch::Contains("series 'i': 3 abscissae for 2 ordinates"));
  CHECK(panel.series().size() == expected.size());
}

}  // namespace seiche::verification::figure_test
