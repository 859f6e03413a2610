#include "seiche/models/gauss_particles/spatial_fields.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/require.hpp"

namespace seiche::gauss_particles {

namespace {

using Place = std::array<double, 3>;

/// The derivative of a component of A along an axis.
double derivative(const std::vector<SpatialMonomial>& component, const Place& at, std::size_t axis) {
  double sum = 0;
  for (const SpatialMonomial& term : component) {
    std::array<int, 3> powers{term.x, term.y, term.z};
    double value = term.coefficient * powers[axis];
    if (value == 0) continue;
    --powers[axis];
    for (std::size_t i = 0; i < 3; ++i) {
      for (int k = 0; k < powers[i]; ++k) value *= at[i];
    }
    sum += value;
  }
  return sum;
}

}  // namespace

std::vector<VectorPotential> linear_spatial_fields() {
  return {{{{}, {}, {{1, 0, 1, 0}}}},    // (1, 0, 0)
          {{{{1, 0, 0, 1}}, {}, {}}},    // (0, 1, 0)
          {{{}, {{1, 1, 0, 0}}, {}}},    // (0, 0, 1)
          {{{}, {}, {{0.5, 0, 2, 0}}}},  // (y, 0, 0)
          {{{}, {}, {{1, 0, 1, 1}}}},    // (z, 0, 0)
          {{{{1, 1, 0, 1}}, {}, {}}},    // (0, x, 0)
          {{{{0.5, 0, 0, 2}}, {}, {}}},  // (0, z, 0)
          {{{}, {{0.5, 2, 0, 0}}, {}}},  // (0, 0, x)
          {{{}, {{1, 1, 1, 0}}, {}}},    // (0, 0, y)
          {{{}, {}, {{1, 1, 1, 0}}}},    // (x, -y, 0)
          {{{{1, 0, 1, 1}}, {}, {}}}};   // (0, y, -z)
}

SpatialFields::SpatialFields(std::vector<VectorPotential> basis) : basis_(std::move(basis)) {
  if (basis_.empty()) throw std::invalid_argument("no vector potential; allowed: at least one");
  for (const VectorPotential& potential : basis_) {
    for (const auto& component : potential) {
      for (const SpatialMonomial& term : component) {
        require_finite("coefficient of a vector potential", term.coefficient);
        require_at_least("power of x", term.x, 0);
        require_at_least("power of y", term.y, 0);
        require_at_least("power of z", term.z, 0);
      }
    }
  }
}

void SpatialFields::place(std::span<const double> q, std::span<const double> mass) {
  const auto n = static_cast<Eigen::Index>(mass.size());
  const auto count = static_cast<Eigen::Index>(basis_.size());
  fields_.resize(3 * n, count);
  root_mass_.resize(3 * n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Place at{q[i], q[mass.size() + i], q[2 * mass.size() + i]};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t next = (c + 1) % 3;
      const std::size_t after = (c + 2) % 3;
      const Eigen::Index row = static_cast<Eigen::Index>(c) * n + k;
      root_mass_[row] = std::sqrt(mass[i]);
      for (Eigen::Index a = 0; a < count; ++a) {
        const VectorPotential& potential = basis_[static_cast<std::size_t>(a)];
        fields_(row, a) = derivative(potential[after], at, next) - derivative(potential[next], at, after);
      }
    }
  }
  factors_.compute(root_mass_.asDiagonal() * fields_);
  if (factors_.rank() < count) {
    throw mechanics::Infeasible(
        fmt::format("{} fields, of which {} are independent on the {} particles", count, factors_.rank(), n),
        q.empty() ? 0 : q[0]);
  }
}

void SpatialFields::project(std::span<double> u) {
  const auto size = static_cast<Eigen::Index>(u.size());
  Eigen::Map<Eigen::VectorXd> velocity(u.data(), size);
  const Eigen::VectorXd weighted = root_mass_.cwiseProduct(velocity);
  Eigen::VectorXd solution = factors_.solve(weighted);
  // One correction with the true residual.
  solution += factors_.solve(weighted - root_mass_.cwiseProduct(fields_ * solution));
  velocity = fields_ * solution;
  const Eigen::MatrixXd scaled = root_mass_.asDiagonal() * fields_;
  const Eigen::VectorXd defect = scaled.transpose() * (weighted - root_mass_.cwiseProduct(velocity));
  const double norm = weighted.norm();
  residual_ = norm > 0 ? (defect.array() / scaled.colwise().norm().transpose().array()).abs().maxCoeff() / norm : 0;
}

}  // namespace seiche::gauss_particles
