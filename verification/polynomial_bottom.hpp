/// A bottom seen from above that is a polynomial: what tests compare with, exact of any degree.
#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/geometry/plan_bottom.hpp"

namespace seiche {

/// b = sum c_kl x^k y^l.
class PolynomialBottom final : public PlanBottom {
 public:
  struct Term {
    double coefficient = 0;
    int x_power = 0;
    int y_power = 0;
  };
  explicit PolynomialBottom(std::vector<Term> terms) : terms_(std::move(terms)) {}

  [[nodiscard]] Slope slope(double x, double y) const override {
    Slope sum;
    for (const auto& [coefficient, k, l] : terms_) {
      sum.elevation += coefficient * power(x, k) * power(y, l);
      sum.along_x += coefficient * power_rate(x, k) * power(y, l);
      sum.along_y += coefficient * power(x, k) * power_rate(y, l);
    }
    return sum;
  }
  [[nodiscard]] Integral integral(double x, double y) const override {
    Integral sum;
    for (const auto& [coefficient, k, l] : terms_) {
      const double integrated = power(x, k) * x / (k + 1);
      sum.elevation += coefficient * power(x, k) * power(y, l);
      sum.value += coefficient * integrated * power(y, l);
      sum.along_y += coefficient * integrated * power_rate(y, l);
    }
    return sum;
  }

 private:
  static double power(double x, int n) {
    double product = 1;
    for (int k = 0; k < n; ++k) product *= x;
    return product;
  }
  static double power_rate(double x, int n) { return n == 0 ? 0.0 : n * power(x, n - 1); }

  std::vector<Term> terms_;
};

/// z = -depth, known between two places alone.
class EndingBottom final : public PlanBottom {
 public:
  EndingBottom(double depth, double begin, double end) : depth_(depth), begin_(begin), end_(end) {}
  [[nodiscard]] Slope slope(double x, double y) const override { return {.elevation = integral(x, y).elevation}; }
  [[nodiscard]] Integral integral(double x, double y) const override {
    if (!(x > begin_ && x < end_)) {
      throw Infeasible(x, "({:g}, {:g}) is outside the bottom; allowed: x within {:g}", x, y, end_);
    }
    return {.elevation = -depth_, .value = -depth_ * x};
  }

 private:
  double depth_, begin_, end_;
};

inline std::shared_ptr<const PolynomialBottom> polynomial_bottom(std::vector<PolynomialBottom::Term> terms) {
  return std::make_shared<const PolynomialBottom>(std::move(terms));
}

}  // namespace seiche
