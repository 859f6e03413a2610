#include "seiche/exact/overturning/cauchy_kernel.hpp"

#include <utility>

#include "seiche/simd_clones.hpp"

namespace seiche::exact::overturning {
namespace {

struct Pole {
  double re, im;
  explicit Pole(std::complex<double> z) : re(z.real()), im(z.imag()) {}
};

struct Sums {
  double direct_re = 0, direct_im = 0, image_re = 0, image_im = 0, product = 0;
};

/// Markers [begin, end), none of them marker i, above a bottom. a and z carry the factor.
SEICHE_SIMD_CLONES void above_bottom(std::size_t begin, std::size_t end, Pole Ei, Pole ei, Pole a, Pole z,
                                     const double* E_re, const double* E_im, const double* e_re, const double* e_im,
                                     const double* phi_s, const double* x, float* row, Sums& sums) {
  double direct_re = 0;
  double direct_im = 0;
  double image_re = 0;
  double image_im = 0;
  double product = 0;
#pragma omp simd reduction(+ : direct_re, direct_im, image_re, image_im, product)
  for (std::size_t j = begin; j < end; ++j) {
    const double d_re = E_re[j] - Ei.re;
    const double d_im = E_im[j] - Ei.im;
    const double p_re = 1 - (ei.re * e_re[j] + ei.im * e_im[j]);
    const double p_im = ei.re * e_im[j] - ei.im * e_re[j];
    const double d2 = d_re * d_re + d_im * d_im;
    const double p2 = p_re * p_re + p_im * p_im;
    const double both = 1 / (d2 * p2);
    const double d_inv = both * p2;
    const double p_inv = both * d2;
    const double entry = d_inv * (a.re * d_re + a.im * d_im) + p_inv * (z.re * p_re + z.im * p_im);
    row[j] = static_cast<float>(entry);
    product += entry * x[j];
    const double d_phi = d_inv * phi_s[j];
    const double p_phi = p_inv * phi_s[j];
    direct_re += d_phi * d_re;
    direct_im -= d_phi * d_im;
    image_re += p_phi * p_re;
    image_im -= p_phi * p_im;
  }
  sums.direct_re += direct_re;
  sums.direct_im += direct_im;
  sums.image_re += image_re;
  sums.image_im += image_im;
  sums.product += product;
}

/// The same in infinitely deep water: e = 0.
SEICHE_SIMD_CLONES void in_deep_water(std::size_t begin, std::size_t end, Pole Ei, Pole a, Pole z, const double* E_re,
                                      const double* E_im, const double* phi_s, const double* x, float* row,
                                      Sums& sums) {
  double direct_re = 0;
  double direct_im = 0;
  double image_re = 0;
  double product = 0;
#pragma omp simd reduction(+ : direct_re, direct_im, image_re, product)
  for (std::size_t j = begin; j < end; ++j) {
    const double d_re = E_re[j] - Ei.re;
    const double d_im = E_im[j] - Ei.im;
    const double d_inv = 1 / (d_re * d_re + d_im * d_im);
    const double entry = d_inv * (a.re * d_re + a.im * d_im) + z.re;
    row[j] = static_cast<float>(entry);
    product += entry * x[j];
    const double d_phi = d_inv * phi_s[j];
    direct_re += d_phi * d_re;
    direct_im -= d_phi * d_im;
    image_re += phi_s[j];
  }
  sums.direct_re += direct_re;
  sums.direct_im += direct_im;
  sums.image_re += image_re;
  sums.product += product;
}

SEICHE_SIMD_CLONES void subtract(const float* A, std::size_t n, const double* x, double* y) {
  for (std::size_t i = 0; i < n; ++i) {
    const float* row = A + i * n;
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t j = 0; j < n; ++j) sum += static_cast<double>(row[j]) * x[j];
    y[i] = x[i] - sum;
  }
}

}  // namespace

RowSums kernel_row(std::size_t i, std::complex<double> z_s, double factor, const Complexes& E, const Complexes* e,
                   const double* phi_s, const double* x, std::vector<float>::iterator row) {
  const Pole a(factor * z_s * E[i]);
  const Pole z(factor * z_s);
  float* const entries = &*row;
  Sums sums;
  for (const auto& [begin, end] : {std::pair{std::size_t{0}, i}, std::pair{i + 1, E.re.size()}}) {
    if (e != nullptr) {
      above_bottom(begin, end, Pole(E[i]), Pole((*e)[i]), a, z, E.re.data(), E.im.data(), e->re.data(), e->im.data(),
                   phi_s, x, entries, sums);
    } else {
      in_deep_water(begin, end, Pole(E[i]), a, z, E.re.data(), E.im.data(), phi_s, x, entries, sums);
    }
  }
  return {{sums.direct_re, sums.direct_im}, {sums.image_re, sums.image_im}, sums.product};
}

void subtract_product(const std::vector<float>& A, const double* x, double* y, std::size_t n) {
  subtract(A.data(), n, x, y);
}

}  // namespace seiche::exact::overturning
