#include "seiche/models/gauss_particles/field_space.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::gauss_particles {

std::vector<StreamFunction> linear_fields() {
  return {{{1, 0, 1}}, {{-1, 1, 0}}, {{-0.5, 2, 0}, {-0.5, 0, 2}}, {{1, 1, 1}}, {{-0.5, 2, 0}, {0.5, 0, 2}}};
}

PolynomialSpace::PolynomialSpace(std::vector<StreamFunction> basis) : basis_(std::move(basis)) {
  require_that(!basis_.empty(), "no stream function; allowed: at least one");
  for (const StreamFunction& function : basis_) {
    for (const Monomial& term : function) {
      require_finite("coefficient of a stream function", term.coefficient);
      require_at_least("power of x", term.x, 0);
      require_at_least("power of y", term.y, 0);
    }
  }
}

void PolynomialSpace::place(mechanics::Interval, std::span<const double> x, std::span<const double> y,
                            std::span<const double> mass, double) {
  const auto n = static_cast<Eigen::Index>(x.size());
  const auto count = static_cast<Eigen::Index>(basis_.size());
  fields_.setZero(2 * n, count);
  root_mass_.resize(2 * n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    root_mass_[k] = root_mass_[n + k] = std::sqrt(mass[i]);
    for (Eigen::Index a = 0; a < count; ++a) {
      for (const Monomial& term : basis_[static_cast<std::size_t>(a)]) {
        if (term.y > 0) fields_(k, a) += term.coefficient * term.y * power(x[i], term.x) * power(y[i], term.y - 1);
        if (term.x > 0) fields_(n + k, a) -= term.coefficient * term.x * power(x[i], term.x - 1) * power(y[i], term.y);
      }
    }
  }
  factors_.compute(root_mass_.asDiagonal() * fields_);
  facts_ = {.unknowns = basis_.size()};
  if (factors_.rank() < count) {
    throw mechanics::Infeasible(x.empty() ? 0 : x[0], "{} fields, of which {} are independent on the {} particles",
                                count, factors_.rank(), n);
  }
}

void PolynomialSpace::project(std::span<double> u, std::span<double> v, std::span<const double> impulse_x,
                              std::span<const double> impulse_y) {
  const auto n = static_cast<Eigen::Index>(u.size());
  w_.resize(2 * n);
  w_.head(n) = Eigen::Map<const Eigen::VectorXd>(u.data(), n);
  w_.tail(n) = Eigen::Map<const Eigen::VectorXd>(v.data(), n);
  const Eigen::VectorXd weighted = root_mass_.cwiseProduct(w_);
  Eigen::VectorXd solution = factors_.solve(weighted);
  // One correction with the true residual.
  solution += factors_.solve(weighted - root_mass_.cwiseProduct(fields_ * solution));
  const Eigen::MatrixXd scaled = root_mass_.asDiagonal() * fields_;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(fields_.cols());
  if (!impulse_x.empty()) {
    load = fields_.topRows(n).transpose() * Eigen::Map<const Eigen::VectorXd>(impulse_x.data(), n) +
           fields_.bottomRows(n).transpose() * Eigen::Map<const Eigen::VectorXd>(impulse_y.data(), n);
    solution += (scaled.transpose() * scaled).ldlt().solve(load);
  }
  const Eigen::VectorXd projected = fields_ * solution;
  const double norm = weighted.norm();
  const Eigen::VectorXd defect = load + scaled.transpose() * (weighted - root_mass_.cwiseProduct(projected));
  facts_.residual =
      norm > 0 ? (defect.array() / scaled.colwise().norm().transpose().array()).abs().maxCoeff() / norm : 0;
  Eigen::Map<Eigen::VectorXd>(u.data(), n) = projected.head(n);
  Eigen::Map<Eigen::VectorXd>(v.data(), n) = projected.tail(n);
}

}  // namespace seiche::gauss_particles
