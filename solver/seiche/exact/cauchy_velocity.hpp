/// Velocity inside a wave from its values on the surface, by the quotient of two Cauchy sums.
///
/// Cauchy's formula with a kernel of simple pole z, summed by the trapezoidal rule along the closed contour, over the
/// same sum for the constant 1: errors of the rule near the pole cancel in the quotient, so that it is uniformly
/// accurate up to the surface (a barycentric formula). Waves symmetric about the crest have a contour of pairs with
/// conjugate poles and conjugate weights; in a variable p(z), even about the bottom where there is one, the mirror
/// image is contained in the sum:
///
///     f(z) = sum_j [w_j f_j/(p_j - p) + conj] / sum_j [w_j/(p_j - p) + conj].
///
/// References: Helsing & Ojala, On the evaluation of layer potentials close to their sources, J. Comput. Phys. 227
/// (2008) 2899; Berrut & Trefethen, Barycentric Lagrange interpolation, SIAM Rev. 46 (2004) 501.
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

namespace seiche::exact {

class CauchyVelocity {
 public:
  using Complex = std::complex<double>;

  /// @param pole    p_j;  @param weight  w_j, halved where a pole is its own conjugate;  @param value  f_j = u - i v
  void add(Complex pole, Complex weight, Complex value) {
    pole_re_.push_back(pole.real());
    pole_im_.push_back(pole.imag());
    weight_re_.push_back(weight.real());
    weight_im_.push_back(weight.imag());
    moment_re_.push_back((weight * value).real());
    moment_im_.push_back((weight * value).imag());
    values_.push_back(value);
  }
  [[nodiscard]] std::size_t size() const { return values_.size(); }

  /// f where the variable is p, from the nodes first <= j < last.
  [[nodiscard]] Complex at(Complex p, std::size_t first, std::size_t last) const {
    double numerator_re = 0;
    double numerator_im = 0;
    double denominator_re = 0;
    double denominator_im = 0;
    const double im_sum = -2 * p.imag();
#pragma omp simd reduction(+ : numerator_re, numerator_im, denominator_re, denominator_im)
    for (std::size_t j = first; j < last; ++j) {
      const double a_re = pole_re_[j] - p.real();
      const double a_im = pole_im_[j] - p.imag();
      const double b_im = -pole_im_[j] - p.imag();
      // 1/((p_j - p)(conj p_j - p)), then w (conj p_j - p) + conj(w) (p_j - p).
      const double product_re = a_re * a_re - a_im * b_im;
      const double product_im = a_re * im_sum;
      const double scale = 1 / (product_re * product_re + product_im * product_im);
      const double inverse_re = product_re * scale;
      const double inverse_im = -product_im * scale;
      const double difference = 2 * pole_im_[j];
      const double w_re = 2 * weight_re_[j] * a_re + weight_im_[j] * difference;
      const double w_im = weight_re_[j] * im_sum;
      const double m_re = 2 * moment_re_[j] * a_re + moment_im_[j] * difference;
      const double m_im = moment_re_[j] * im_sum;
      denominator_re += w_re * inverse_re - w_im * inverse_im;
      denominator_im += w_re * inverse_im + w_im * inverse_re;
      numerator_re += m_re * inverse_re - m_im * inverse_im;
      numerator_im += m_re * inverse_im + m_im * inverse_re;
    }
    const Complex quotient = Complex(numerator_re, numerator_im) / Complex(denominator_re, denominator_im);
    if (std::isfinite(quotient.real()) && std::isfinite(quotient.imag())) return quotient;
    return at_node(p, first, last);
  }

 private:
  /// The value of the node that coincides with p.
  [[nodiscard]] Complex at_node(Complex p, std::size_t first, std::size_t last) const {
    std::size_t nearest = first;
    double distance = std::numeric_limits<double>::infinity();
    bool conjugate = false;
    for (std::size_t j = first; j < last; ++j) {
      const Complex pole(pole_re_[j], pole_im_[j]);
      for (const bool mirrored : {false, true}) {
        const double next = std::abs((mirrored ? std::conj(pole) : pole) - p);
        if (next >= distance) continue;
        distance = next;
        nearest = j;
        conjugate = mirrored;
      }
    }
    return conjugate ? std::conj(values_[nearest]) : values_[nearest];
  }

  std::vector<double> pole_re_, pole_im_, weight_re_, weight_im_, moment_re_, moment_im_;
  std::vector<Complex> values_;
};

}  // namespace seiche::exact
