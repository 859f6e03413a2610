/// A free patch of incompressible fluid in the plane: square lattice of nodes, cells of constant area, no potential.
///
///     f_s = V_s - V_s(0),   V = [(x2 - x0)(y3 - y1) - (x3 - x1)(y2 - y0)]/2,   m_k = a quarter of the cells around
///
/// Areas are bilinear: quadratic constraints, many more and wider coupled than a chain's.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/SparseCholesky>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/start.hpp"

namespace seiche::verification {

class FreePatch {
 public:
  /// Square [-1, 1]^2 of n x n cells, turned by `angle` about the origin and shifted along both axes.
  explicit FreePatch(std::size_t n, double angle = 0, double shift = 0) : n_(n), angle_(angle) {
    const double h = 2.0 / static_cast<double>(n);
    mass_.assign((n + 1) * (n + 1), 0.0);
    for (std::size_t i = 0; i <= n; ++i) {
      for (std::size_t j = 0; j <= n; ++j) {
        const auto r = turned({-1 + h * static_cast<double>(i), -1 + h * static_cast<double>(j)}, angle);
        lattice_.insert(lattice_.end(), {r[0] + shift, r[1] + shift});
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        const std::size_t k = i * (n + 1) + j;
        cells_.push_back({k, k + n + 1, k + n + 2, k + 1});
        for (const std::size_t node : cells_.back()) mass_[node] += h * h / 4;
      }
    }
    gradient_.resize(cells_.size());
    areas_.resize(cells_.size());
    for (std::size_t s = 0; s < cells_.size(); ++s) areas_[s] = bilinear(s, lattice_, lattice_) / 2;
  }

  [[nodiscard]] std::size_t coordinates() const { return lattice_.size(); }
  [[nodiscard]] std::size_t rates() const { return lattice_.size(); }
  [[nodiscard]] std::size_t constraints() const { return cells_.size(); }

  void linearise(mechanics::Interval, mechanics::Input q) {
    find_gradients(q);
    factor();
  }
  void linearise_between(mechanics::Interval, mechanics::Input q0, mechanics::Input q1, int sweep) {
    middle_.resize(q0.size());
    for (std::size_t i = 0; i < q0.size(); ++i) middle_[i] = 0.5 * (q0[i] + q1[i]);
    find_gradients(middle_);
    if (sweep == 0) factor();
  }
  void kick(double, mechanics::Output) const {}
  void advance(mechanics::Input from, mechanics::Input u, double h, mechanics::Output to) const {
    for (std::size_t i = 0; i < u.size(); ++i) to[i] = from[i] + h * u[i];
  }
  void constraint_rates(mechanics::Input u, mechanics::Output w) const {
    for (std::size_t s = 0; s < cells_.size(); ++s) {
      w[s] = 0;
      for (std::size_t c = 0; c < 8; ++c) w[s] += gradient_[s][c] * u[2 * cells_[s][c / 2] + c % 2];
    }
  }
  void react(mechanics::Input mu, mechanics::Output u) const {
    for (std::size_t s = 0; s < cells_.size(); ++s) {
      for (std::size_t c = 0; c < 8; ++c) {
        const std::size_t node = cells_[s][c / 2];
        u[2 * node + c % 2] += mu[s] * gradient_[s][c] / mass_[node];
      }
    }
  }
  void solve(mechanics::Input right_hand_side, mechanics::Output mu) {
    const auto size = static_cast<Eigen::Index>(mu.size());
    Eigen::Map<Eigen::VectorXd>(mu.data(), size) =
        cholesky_.solve(Eigen::Map<const Eigen::VectorXd>(right_hand_side.data(), size));
    ++solves_;
  }
  void constraint_values(mechanics::Input q, mechanics::Output f) const {
    for (std::size_t s = 0; s < cells_.size(); ++s) f[s] = bilinear(s, q, q) / 2 - areas_[s];
  }
  void curvature(mechanics::Input u, mechanics::Input v, mechanics::Output b) const {
    for (std::size_t s = 0; s < cells_.size(); ++s) b[s] = bilinear(s, u, v);
  }

  [[nodiscard]] double kinetic_energy(mechanics::Input, mechanics::Input u) const {
    double sum = 0;
    for (std::size_t i = 0; i < u.size(); ++i) sum += mass_[i / 2] * u[i] * u[i] / 2;
    return sum;
  }
  [[nodiscard]] double potential_energy(mechanics::Input) const { return 0; }
  [[nodiscard]] std::array<double, 2> momentum(mechanics::Input, mechanics::Input u) const {
    std::array<double, 2> sum{};
    for (std::size_t i = 0; i < u.size(); ++i) sum[i % 2] += mass_[i / 2] * u[i];
    return sum;
  }
  [[nodiscard]] std::array<double, 1> angular_momentum(mechanics::Input q, mechanics::Input u) const {
    double sum = 0;
    for (std::size_t k = 0; k < mass_.size(); ++k)
      sum += mass_[k] * (q[2 * k] * u[2 * k + 1] - q[2 * k + 1] * u[2 * k]);
    return {sum};
  }

  [[nodiscard]] long solves() const { return solves_; }

  /// At rest in the lattice but for u = (0.4 x - 0.7 y + 0.1 sin 2y + 0.3, 0.5 x - 0.4 y + 0.1 cos 3x - 0.2),
  /// projected; x, y and u along the turned axes from the patch's centre.
  mechanics::State start() {
    mechanics::State state{.q = lattice_, .u = {}};
    const FreePatch standard(n_);
    for (std::size_t i = 0; i < lattice_.size(); i += 2) {
      const double x = standard.lattice_[i];
      const double y = standard.lattice_[i + 1];
      const auto u = turned(
          {0.4 * x - 0.7 * y + 0.1 * std::sin(2 * y) + 0.3, 0.5 * x - 0.4 * y + 0.1 * std::cos(3 * x) - 0.2}, angle_);
      state.u.insert(state.u.end(), u.begin(), u.end());
    }
    mechanics::Start(*this).project(state);
    return state;
  }

  static std::array<double, 2> turned(std::array<double, 2> r, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * r[0] - s * r[1], s * r[0] + c * r[1]};
  }

 private:
  /// v^T (Hessian of V_s) w; twice the area for v = w = q.
  [[nodiscard]] double bilinear(std::size_t s, mechanics::Input v, mechanics::Input w) const {
    const auto& [r0, r1, r2, r3] = cells_[s];
    const auto across = [](mechanics::Input z, std::size_t from, std::size_t to, std::size_t c) {
      return z[2 * to + c] - z[2 * from + c];
    };
    return 0.5 * (across(v, r0, r2, 0) * across(w, r1, r3, 1) + across(w, r0, r2, 0) * across(v, r1, r3, 1) -
                  across(v, r1, r3, 0) * across(w, r0, r2, 1) - across(w, r1, r3, 0) * across(v, r0, r2, 1));
  }
  void find_gradients(mechanics::Input q) {
    for (std::size_t s = 0; s < cells_.size(); ++s) {
      const auto& [r0, r1, r2, r3] = cells_[s];
      const double x02 = (q[2 * r2] - q[2 * r0]) / 2;
      const double y02 = (q[2 * r2 + 1] - q[2 * r0 + 1]) / 2;
      const double x13 = (q[2 * r3] - q[2 * r1]) / 2;
      const double y13 = (q[2 * r3 + 1] - q[2 * r1 + 1]) / 2;
      gradient_[s] = {-y13, x13, y02, -x02, y13, -x13, -y02, x02};
    }
  }
  void factor() {
    entries_.clear();
    // Row of A = J M^-1 J^T by way of the nodes' lists of (cell, gradient).
    around_.assign(mass_.size(), {});
    for (std::size_t s = 0; s < cells_.size(); ++s) {
      for (std::size_t c = 0; c < 4; ++c)
        around_[cells_[s][c]].push_back({s, gradient_[s][2 * c], gradient_[s][2 * c + 1]});
    }
    for (std::size_t k = 0; k < mass_.size(); ++k) {
      for (const Corner& a : around_[k]) {
        for (const Corner& b : around_[k]) {
          entries_.emplace_back(static_cast<int>(a.cell), static_cast<int>(b.cell), (a.x * b.x + a.y * b.y) / mass_[k]);
        }
      }
    }
    const auto size = static_cast<Eigen::Index>(cells_.size());
    matrix_.resize(size, size);
    matrix_.setFromTriplets(entries_.begin(), entries_.end());
    cholesky_.compute(matrix_);
  }

  struct Corner {
    std::size_t cell;
    double x, y;
  };

  std::size_t n_;
  double angle_;
  std::vector<double> lattice_, mass_, areas_, middle_;
  std::vector<std::array<std::size_t, 4>> cells_;
  std::vector<std::array<double, 8>> gradient_;
  std::vector<std::vector<Corner>> around_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky_;
  long solves_ = 0;
};

}  // namespace seiche::verification
