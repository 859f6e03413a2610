/// Changes of variable that gather equally spaced nodes under the crest of a wave.
///
/// Both are analytic in a strip around the real s axis whose width does not shrink as the cluster becomes narrower, so
/// that series in s converge at the same rate for every steepness and the number of nodes grows like the logarithm of
/// the width only.
#pragma once

namespace seiche::exact {

/// phi(s) = asinh(width sinh s)/rate: spacing ds/rate far away, geometric near phi = 0 for width << 1, uniform for
/// width = 1. Analytic in |Im s| < pi/2.
class LineNodes {
 public:
  LineNodes(double width, double rate) : width_(width), rate_(rate) {}

  [[nodiscard]] long double potential(double s) const;  ///< phi(s)
  [[nodiscard]] double stretch(double s) const;         ///< dphi/ds
  [[nodiscard]] double label(double potential) const;   ///< s(phi)
  [[nodiscard]] double rate() const { return rate_; }
  [[nodiscard]] bool uniform() const { return width_ == 1; }

 private:
  double width_;
  double rate_;
};

/// tan(phi/2) = k' sn(u)/cn(u), u = s K/pi, with Jacobi's functions of the complementary modulus k' (width) and its
/// quarter period K: 2 pi periodic and odd, the identity for k' = 1.
class PeriodicNodes {
 public:
  struct Node {
    long double potential;  ///< phi(s)
    double stretch;         ///< dphi/ds
  };

  explicit PeriodicNodes(double width);

  [[nodiscard]] Node at(double s) const;               ///< 0 <= s <= pi
  [[nodiscard]] double label(double potential) const;  ///< s(phi), 0 <= phi <= pi
  [[nodiscard]] double quarter_period() const { return static_cast<double>(quarter_period_); }

 private:
  struct Jacobi {
    long double sn, cn, dn;
  };
  /// By the descending arithmetic-geometric mean from k' itself: 1 - k'^2 would lose it.
  [[nodiscard]] Jacobi jacobi(long double u) const;

  long double width_;
  long double quarter_period_;
};

}  // namespace seiche::exact
