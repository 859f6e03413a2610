/// The pressure behind the reactions of a step.
///
/// At the places of the projection grad p = rho (2/tau)(w - u~), particle by particle, with the lattice's residue of 1
/// to 10 per cent in it; its smooth part is accurate. It is fitted by a pressure that vanishes on the surface, a level
/// function times a polynomial:
///
/// @f[ p = \ell(x, y) \sum_{i + j \le d} a_{ij} \, x^i y^j, \qquad
///     \sum_k m_k \left| \rho \frac{2}{\tau} (\mathbf{w}_k - \tilde{\mathbf{u}}_k) - \nabla p(\mathbf{q}_k) \right|^2 =
///     \min @f]
///
/// When not to use it: surfaces without a level function, as after breaking.
#pragma once

#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/QR>

#include "seiche/models/gauss_particles/field_space.hpp"
#include "seiche/models/gauss_particles/model.hpp"
#include "seiche/require.hpp"

namespace seiche::gauss_particles {

/// A function that is zero on the surface, with its gradient.
struct Level {
  double value = 0;
  Point gradient = {};
};

class PressureFit {
 public:
  /// Of the model's last step, taken by the conservative scheme.
  /// @param tau  its length. @param degree  d, of the polynomial
  /// Throws std::invalid_argument: tau not positive, degree negative, no level function; std::logic_error before a
  /// step.
  PressureFit(const Model& model, double tau, std::function<Level(Point place)> level, int degree)
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

  /// [Pa]
  [[nodiscard]] double pressure(Point place) const {
    double sum = 0;
    each_power(degree_, [&](Eigen::Index number, int i, int j) {
      sum += coefficients_[static_cast<std::size_t>(number)] * power(place.x, i) * power(place.y, j);
    });
    return level_(place).value * sum;
  }

 private:
  /// Calls visit(number, i, j) for all powers x^i y^j of at most that degree.
  template <class Visit>
  static void each_power(int degree, Visit&& visit) {
    Eigen::Index number = 0;
    for (int i = 0; i <= degree; ++i) {
      for (int j = 0; i + j <= degree; ++j) visit(number++, i, j);
    }
  }

  std::function<Level(Point place)> level_;
  int degree_;
  std::vector<double> coefficients_;
};

}  // namespace seiche::gauss_particles
