#include "seiche/geometry/plan_bottom.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "seiche/require.hpp"

namespace seiche {

namespace {

double power(double x, int n) {
  double product = 1;
  for (int k = 0; k < n; ++k) product *= x;
  return product;
}

/// d(x^n)/dx.
double power_rate(double x, int n) {
  return n == 0 ? 0.0 : n * power(x, n - 1);
}

}  // namespace

OutsidePlanBottom::OutsidePlanBottom(double x, double y, const char* coordinate, double lowest, double highest)
    : std::runtime_error(fmt::format("({:g}, {:g}) is outside the bottom; allowed: {} within [{:g}, {:g}]", x, y,
                                     coordinate, lowest, highest)),
      x_(x) {}

double PlanBottom::increment(double x, double y, double dx, double dy) const {
  // Abramowitz and Stegun, table 25.4.
  static constexpr std::array<std::pair<double, double>, 2> gauss{
      std::pair{0.339981043584856264803, 0.652145154862546142627},
      std::pair{0.861136311594052575224, 0.347854845137453857373}};
  double sum = 0;
  for (const auto& [place, weight] : gauss) {
    for (const double s : {0.5 - 0.5 * place, 0.5 + 0.5 * place}) {
      const Integral at = integral(x + s * dx, y + s * dy);
      sum += 0.5 * weight * (at.elevation * dx + at.along_y * dy);
    }
  }
  return sum;
}

PolynomialBottom::PolynomialBottom(std::vector<Term> terms) : terms_(std::move(terms)) {
  if (terms_.empty()) throw std::invalid_argument("a polynomial bottom without terms; allowed: at least one");
  for (const Term& term : terms_) {
    require_finite("coefficient", term.coefficient);
    require_within("x_power", term.x_power, 0, 12);
    require_within("y_power", term.y_power, 0, 12);
  }
}

PlanBottom::Slope PolynomialBottom::slope(double x, double y) const {
  Slope sum;
  for (const Term& term : terms_) {
    const double along_x = power(x, term.x_power);
    const double along_y = power(y, term.y_power);
    sum.elevation += term.coefficient * along_x * along_y;
    sum.along_x += term.coefficient * power_rate(x, term.x_power) * along_y;
    sum.along_y += term.coefficient * along_x * power_rate(y, term.y_power);
  }
  return sum;
}

PlanBottom::Integral PolynomialBottom::integral(double x, double y) const {
  Integral sum;
  for (const Term& term : terms_) {
    const double along_x = power(x, term.x_power);
    const double integrated = along_x * x / (term.x_power + 1);
    const double along_y = power(y, term.y_power);
    sum.elevation += term.coefficient * along_x * along_y;
    sum.value += term.coefficient * integrated * along_y;
    sum.along_y += term.coefficient * integrated * power_rate(y, term.y_power);
  }
  return sum;
}

}  // namespace seiche
