#include "seiche/exact/released_column.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace {

using std::numbers::pi;
constexpr int most_terms = 20000;

/// Terms until exp(-(n + 1/2) pi decay) is below rounding.
int terms(double decay) {
  constexpr double digits = 38;
  return decay > digits / (pi * most_terms) ? static_cast<int>(digits / (pi * decay)) + 2 : most_terms;
}

/// cosh(a)/cosh(b), or sinh(a)/cosh(b) with sign = -1, without overflow, 0 <= a <= b.
double ratio(double a, double b, double sign) {
  return std::exp(a - b) * (1 + sign * std::exp(-2 * a)) / (1 + std::exp(-2 * b));
}

}  // namespace

ReleasedColumn::ReleasedColumn(double length, double height, double gravity, double density)
    : length_(length), height_(height), weight_(gravity * density) {
  require_all_positive({{"length", length}, {"height", height}, {"gravity", gravity}, {"density", density}});
  require_within("length/height", length / height, 1e-2, 1e2);
}

double ReleasedColumn::across(double x, double y) const {
  double sum = 0;
  for (int n = terms((length_ - x) / height_); n-- > 0;) {
    const double k = (n + 0.5) * pi / height_;
    sum += 2 / (height_ * k * k) * std::cos(k * y) * ratio(k * x, k * length_, 1);
  }
  return height_ - y - sum;
}

double ReleasedColumn::along(double x, double y) const {
  double sum = 0;
  for (int n = terms(y / length_); n-- > 0;) {
    const double q = (n + 0.5) * pi / length_;
    const double term = 2 / (length_ * q * q) * std::cos(q * x) * ratio(q * (height_ - y), q * height_, -1);
    sum += n % 2 == 0 ? term : -term;
  }
  return sum;
}

double ReleasedColumn::pressure(double x, double y) const {
  require_that<OutsideFluid>(x >= 0 && x <= length_ && y >= 0 && y <= height_,
                             "({:g}, {:g}) is outside the column; allowed: [0, {:g}] x [0, {:g}]", x, y, length_,
                             height_);
  if (x == length_ || y == height_) return 0;
  return weight_ * ((length_ - x) / height_ >= y / length_ ? across(x, y) : along(x, y));
}

double ReleasedColumn::uncertainty() const {
  // Beyond 20000 terms, which only the last 0.0006 of the sizes next to the toe would need, what is left out is at
  // most 2 H/(pi^2 20000); elsewhere rounding.
  return 2 / (pi * pi * most_terms) * std::max(1.0, length_ / height_);
}

SelfTest ReleasedColumn::self_test() const {
  constexpr std::array fx{0.0, 0.2, 0.5, 0.8, 0.95};
  constexpr std::array fy{0.05, 0.3, 0.6, 0.9};
  const double between = worst(0, 19, [&](int i) {
    const double x = fx[static_cast<std::size_t>(i / 4)] * length_;
    const double y = fy[static_cast<std::size_t>(i % 4)] * height_;
    return (across(x, y) - along(x, y)) / height_;
  });
  return {{"both series are the same function, relative to rho g H", between, 1e-13,
           "at most some hundred terms, whose sum is of the size of H, and exponentials of arguments up to 40"}};
}

static_assert(ReferenceSolution<ReleasedColumn>);

ExactSolution released_column_entry() {
  return Entry<ReleasedColumn>{
      .name = "released_column",
      .title = "Pressure in a column of water at the instant of its release",
      .citation = "Separation of variables; the problem of Pohle (1950), as told by Stoker, Water Waves (1957), 12.1",
      .formula = "p/(rho g) = H - y - sum 2/(H k^2) cos(k y) cosh(k x)/cosh(k L), k = (n + 1/2) pi/H",
      .parameters = {{"length", "m", 2, 1e-6, 1e6, "of the column, from the wall to the free face"},
                     {"height", "m", 1, 1e-6, 1e6, "of the column"},
                     gravity_parameter(),
                     {"density", "kg/m^3", 1, 1e-6, 1e6, "of the water"}},
      .inputs = {{"x", "m", 0, "from the wall, up to length"}, {"y", "m", 0, "above the floor, up to height"}},
      .outputs = {{"p", "Pa", "pressure"}},
      .scalars = {{"p_corner", "Pa", "pressure at the foot of the wall",
                   [](const ReleasedColumn& column) { return column.pressure(0, 0); }}},
      .make = from<ReleasedColumn>("length", "height", "gravity", "density"),
      .row = [](const ReleasedColumn& column, At at) { return Row{column.pressure(at[0], at[1])}; }};
}

}  // namespace seiche::exact
