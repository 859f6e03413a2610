#include "validation/instruments/particles/gauss_pressure.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <Eigen/QR>

#include "seiche/models/gauss_particles/field_space.hpp"
#include "seiche/require.hpp"

namespace seiche::gauss_particles {

namespace {

/// Calls visit(number, i, j) for all powers x^i y^j of at most that degree.
template <class Visit>
void each_power(int degree, Visit&& visit) {
  Eigen::Index number = 0;
  for (int i = 0; i <= degree; ++i) {
    for (int j = 0; i + j <= degree; ++j) visit(number++, i, j);
  }
}

}  // namespace

PressureFit::PressureFit(const Model& model, double tau, std::function<Level(Point place)> level, int degree)
    : level_(std::move(level)), degree_(degree) {
  require_positive("tau", tau);
  require_at_least("degree", degree, 0);
  if (!level_) throw std::invalid_argument("no level function; allowed: one that is zero on the surface");
  if (model.projected().empty()) throw std::logic_error("the pressure is known after a step");
  const auto n = static_cast<Eigen::Index>(model.size());
  const Eigen::Index count = static_cast<Eigen::Index>(degree + 1) * (degree + 2) / 2;
  Eigen::MatrixXd fields(2 * n, count);
  Eigen::VectorXd gradient(2 * n);
  const double factor = 2 * model.settings().density / tau;
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const auto at_y = static_cast<std::size_t>(n + k);
    const Point place{model.places()[at], model.places()[at_y]};
    const Level l = level_(place);
    const double weight = std::sqrt(model.particles().mass[at]);
    gradient[k] = weight * factor * (model.before_projection()[at] - model.projected()[at]);
    gradient[n + k] = weight * factor * (model.before_projection()[at_y] - model.projected()[at_y]);
    each_power(degree, [&](Eigen::Index number, int i, int j) {
      const double value = power(place.x, i) * power(place.y, j);
      const double along = i == 0 ? 0 : i * power(place.x, i - 1) * power(place.y, j);
      const double up = j == 0 ? 0 : j * power(place.x, i) * power(place.y, j - 1);
      fields(k, number) = weight * (l.gradient.x * value + l.value * along);
      fields(n + k, number) = weight * (l.gradient.y * value + l.value * up);
    });
  }
  const Eigen::VectorXd solution = fields.colPivHouseholderQr().solve(gradient);
  coefficients_.assign(solution.data(), solution.data() + count);
}

double PressureFit::pressure(Point place) const {
  double sum = 0;
  each_power(degree_, [&](Eigen::Index number, int i, int j) {
    sum += coefficients_[static_cast<std::size_t>(number)] * power(place.x, i) * power(place.y, j);
  });
  return level_(place).value * sum;
}

}  // namespace seiche::gauss_particles
