/// Logarithm of a sum of exponentials of linear functions of x, y and t, with its derivatives of any order.
///
///     F = ln tau,   tau = sum_m exp(p_m x + q_m y + r_m t + s_m)
///
/// The derivatives of F are the joint cumulants of (p, q, r) under the weights exp(...)/tau, by the recursion that
/// follows from differentiating d_i tau = tau d_i F. Tau-functions of solitons have this form.
///
/// When not to use it: orders above about eight (the recursion's cost doubles with every order).
#pragma once

#include <array>
#include <vector>

namespace seiche::exact {

class ExponentialSum {
 public:
  using Triple = std::array<double, 3>;
  using Order = std::array<int, 3>;

  struct Term {
    Triple rate;      ///< p, q, r
    double constant;  ///< s
  };

  /// @param terms  at least one
  explicit ExponentialSum(std::vector<Term> terms) : terms_(std::move(terms)) {}

  /// d^(a+b+c) ln tau / dx^a dy^b dt^c at a point (x, y, t); a + b + c > 0.
  [[nodiscard]] double log_derivative(const Triple& at, const Order& order) const;

 private:
  std::vector<Term> terms_;
};

}  // namespace seiche::exact
