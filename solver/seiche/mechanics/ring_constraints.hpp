/// Constraints between nodes in a plane and their neighbours, node by node: what free-Lagrangian models share.
///
/// Ring k are the constraints that node k moves, the k-th first, each with its gradient by r_k. Rates of the
/// constraints, reactions, and A = G W G^T with a stabilisation:
///
/// @f[ \left(A + \epsilon \frac{\mathrm{tr} A}{N} L^T L\right) \mu = \dots @f]
///
/// is solved instead of A, row k of L over ring k; where forces of some multipliers cancel A is singular. The
/// stabilisation takes energy from the water, in each step an amount that is known.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "seiche/geometry/curve.hpp"
#include "seiche/linear/sparse_cholesky.hpp"
#include "seiche/mechanics/constrained_model.hpp"

namespace seiche::mechanics {

class RingConstraints {
 public:
  /// As RingMatrix::set_rings; both must stay as they are until other rings are set.
  void set_rings(std::span<const int> begin, std::span<const int> member);
  /// @param gradient  entry by entry of the rings; must stay until the next factor
  /// @param row       of L, likewise; empty without stabilisation
  /// @param respond   respond(k, force): what node k answers, W_k force
  /// @return nothing; of a matrix that is singular without stabilisation the smallest pivot over the largest
  template <class Respond>
  [[nodiscard]] std::optional<double> factor(std::span<const Point> gradient, std::span<const double> row,
                                             double stabilisation, const Respond& respond) {
    gradient_ = gradient;
    row_ = row;
    response_.resize(gradient.size());
    double trace = 0;
    each_ring([&](std::size_t k, std::size_t first, std::size_t last) {
      for (std::size_t e = first; e < last; ++e) {
        response_[e] = respond(k, gradient[e]);
        trace += dot(gradient[e], response_[e]);
      }
    });
    const double mean = trace / static_cast<double>(begin_.size() - 1);
    stiffness_ = stabilisation * mean;
    matrix_.sum([&](std::size_t k, int p, int q) {
      const auto one = static_cast<std::size_t>(begin_[k] + p);
      const auto other = static_cast<std::size_t>(begin_[k] + q);
      const double product = dot(gradient_[one], response_[other]);
      return row_.empty() ? product : product + stiffness_ * row_[one] * row_[other];
    });
    return solver_.factor_or_singular(matrix_, mean, stabilisation != 0);
  }

  /// w = G u, with u all velocities along x, then all along y.
  void rates(Input u, Output w) const;
  /// u += W G^T mu.
  void react(Input mu, Output u) const;
  void solve(Input right_hand_side, Output mu) { solver_.solve(right_hand_side, mu); }
  /// Energy that the stabilisation takes in a step with these impulses of the multipliers:
  /// 2 mu.(epsilon tr A/N) L^T L mu. Never negative.
  [[nodiscard]] double stabilisation_loss(Input impulses) const;

  [[nodiscard]] const linear::RingSolver& solver() const { return solver_; }
  /// A with its stabilisation, of the last factor.
  [[nodiscard]] const linear::RingMatrix& matrix() const { return matrix_; }

 private:
  /// visit(k, first, last): ring k are the entries first to last - 1.
  template <class Visit>
  void each_ring(const Visit& visit) const {
    for (std::size_t k = 0; k + 1 < begin_.size(); ++k) {
      visit(k, static_cast<std::size_t>(begin_[k]), static_cast<std::size_t>(begin_[k + 1]));
    }
  }
  [[nodiscard]] std::size_t member(std::size_t entry) const { return static_cast<std::size_t>(member_[entry]); }

  std::span<const int> begin_, member_;
  std::span<const Point> gradient_;
  std::span<const double> row_;
  std::vector<Point> response_;
  double stiffness_ = 0;  // epsilon tr A/N
  linear::RingMatrix matrix_;
  linear::RingSolver solver_;
};

}  // namespace seiche::mechanics
