/// Bottom z = b(x, y) seen from above, z counted from the still-water level.
///
/// Models that keep water at rest need the volume over the bottom as a sum over edges, which cancels between
/// neighbours: beside b they take its integral along x,
///
///     B(x, y) = int^x b(s, y) ds,   B_x = b,
///
/// so that the integral of b over a polygon is that of B dy around it.
#pragma once

#include <limits>
#include <stdexcept>
#include <vector>

namespace seiche {

/// A place where the bottom is not defined.
class OutsidePlanBottom : public std::runtime_error {
 public:
  OutsidePlanBottom(double x, double y, const char* coordinate, double lowest, double highest);
  [[nodiscard]] double place() const { return x_; }

 private:
  double x_;
};

class PlanBottom {
 public:
  struct Slope {
    double elevation = 0;  ///< b
    double along_x = 0;    ///< b_x
    double along_y = 0;    ///< b_y
  };
  struct Integral {
    double elevation = 0;  ///< b
    double value = 0;      ///< B, from any origin that depends on y alone
    double along_y = 0;    ///< B_y
  };

  virtual ~PlanBottom() = default;
  /// Throw OutsidePlanBottom.
  [[nodiscard]] virtual Slope slope(double x, double y) const = 0;
  [[nodiscard]] virtual Integral integral(double x, double y) const = 0;
  /// B(x + dx, y + dy) - B(x, y), rounded as a number of its own size and not of B's: the integral of b dx + B_y dy
  /// along the straight way, by Gauss's rule of four points. For ways along which b is a polynomial of degree six in
  /// effect; bottoms that are smooth in pieces add up their pieces.
  [[nodiscard]] virtual double increment(double x, double y, double dx, double dy) const;
};

/// b = sum c_kl x^k y^l.
class PolynomialBottom final : public PlanBottom {
 public:
  struct Term {
    double coefficient = 0;
    int x_power = 0;
    int y_power = 0;
  };
  /// Throws std::invalid_argument for no terms, coefficients that are not finite, powers outside 0..12.
  explicit PolynomialBottom(std::vector<Term> terms);
  [[nodiscard]] Slope slope(double x, double y) const override;
  [[nodiscard]] Integral integral(double x, double y) const override;

 private:
  std::vector<Term> terms_;
};

}  // namespace seiche
