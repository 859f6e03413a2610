#include "seiche/exact/overturning/surface_velocity.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "seiche/require.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::exact::overturning {

namespace {

struct Pole {
  double re, im;
  explicit Pole(std::complex<double> z) : re(z.real()), im(z.imag()) {}
};

/// Over the markers j of row i, j = i left out: of phi_s,j/(E_j - E_i), of phi_s,j/(1 - e_i conj e_j), and of A_ij x_j
/// in double precision.
struct Sums {
  double direct_re = 0, direct_im = 0, image_re = 0, image_im = 0, product = 0;
};

/// Arrays over the markers: E, e (none in infinitely deep water, where it is zero), phi_s, x, and the row of A.
struct Markers {
  const double *E_re, *E_im, *e_re, *e_im, *phi_s, *x;
  float* row;
};

/// Adds the markers [begin, end), none of them the one of the row. a and z carry the factor.
template <bool above_bottom>
SEICHE_INLINE void add_markers(std::size_t begin, std::size_t end, Pole Ei, Pole ei, Pole a, Pole z, Markers at,
                               Sums& sums) {
  double direct_re = 0;
  double direct_im = 0;
  double image_re = 0;
  double image_im = 0;
  double product = 0;
#pragma omp simd reduction(+ : direct_re, direct_im, image_re, image_im, product)
  for (std::size_t j = begin; j < end; ++j) {
    const double d_re = at.E_re[j] - Ei.re;
    const double d_im = at.E_im[j] - Ei.im;
    const double d2 = d_re * d_re + d_im * d_im;
    double d_inv = 1 / d2;
    double image = z.re;
    if constexpr (above_bottom) {
      const double p_re = 1 - (ei.re * at.e_re[j] + ei.im * at.e_im[j]);
      const double p_im = ei.re * at.e_im[j] - ei.im * at.e_re[j];
      const double p2 = p_re * p_re + p_im * p_im;
      const double both = 1 / (d2 * p2);
      d_inv = both * p2;
      const double p_inv = both * d2;
      image = p_inv * (z.re * p_re + z.im * p_im);
      image_re += p_inv * at.phi_s[j] * p_re;
      image_im -= p_inv * at.phi_s[j] * p_im;
    } else {
      image_re += at.phi_s[j];
    }
    const double entry = d_inv * (a.re * d_re + a.im * d_im) + image;
    at.row[j] = static_cast<float>(entry);
    product += entry * at.x[j];
    const double d_phi = d_inv * at.phi_s[j];
    direct_re += d_phi * d_re;
    direct_im -= d_phi * d_im;
  }
  sums.direct_re += direct_re;
  sums.direct_im += direct_im;
  sums.image_re += image_re;
  sums.image_im += image_im;
  sums.product += product;
}

SEICHE_SIMD_CLONES void add_above_bottom(std::size_t begin, std::size_t end, Pole Ei, Pole ei, Pole a, Pole z,
                                         Markers at, Sums& sums) {
  add_markers<true>(begin, end, Ei, ei, a, z, at, sums);
}

SEICHE_SIMD_CLONES void add_in_deep_water(std::size_t begin, std::size_t end, Pole Ei, Pole ei, Pole a, Pole z,
                                          Markers at, Sums& sums) {
  add_markers<false>(begin, end, Ei, ei, a, z, at, sums);
}

/// y = x - A x with A stored by rows.
SEICHE_SIMD_CLONES void subtract(const float* A, std::size_t n, const double* x, double* y) {
  for (std::size_t i = 0; i < n; ++i) {
    const float* row = A + i * n;
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t j = 0; j < n; ++j) sum += static_cast<double>(row[j]) * x[j];
    y[i] = x[i] - sum;
  }
}

/// Row i of A without its diagonal: A_ij = factor Re[z_s E_i/(E_j - E_i) + z_s/(1 - e_i conj e_j)], z_s that of marker
/// i.
///
/// @param e    of every marker; nullptr for infinite depth, where it is zero
/// @param row  receives A_ij, in single precision
Sums kernel_row(std::size_t i, std::complex<double> z_s, double factor, const Complexes& E, const Complexes* e,
                const double* phi_s, const double* x, std::vector<float>::iterator row) {
  const Markers at{E.re.data(), E.im.data(), e ? e->re.data() : nullptr, e ? e->im.data() : nullptr, phi_s, x, &*row};
  const auto add = e ? add_above_bottom : add_in_deep_water;
  Sums sums;
  for (const auto& [begin, end] : {std::pair{std::size_t{0}, i}, std::pair{i + 1, E.re.size()}}) {
    add(begin, end, Pole(E[i]), Pole(e ? (*e)[i] : 0), Pole(factor * z_s * E[i]), Pole(factor * z_s), at, sums);
  }
  return sums;
}

using Complex = std::complex<double>;

/// Part of a residual that corrections by the matrix in single precision leave: its rounding, 2^-24, to the residual.
constexpr double single_precision = 1e-7;
constexpr int most_passes = 5;

std::size_t checked(std::size_t markers, double depth) {
  require_at_least("markers", static_cast<long>(markers), 8);
  if (!std::isinf(depth)) require_finite("depth", depth);
  require_positive("depth", std::isinf(depth) && depth > 0 ? 1 : depth);
  return markers;
}

}  // namespace

SurfaceVelocity::SurfaceVelocity(std::size_t markers, double depth)
    : n_(checked(markers, depth)),
      depth_(depth),
      has_bottom_(std::isfinite(depth)),
      fourier_(markers),
      work_(markers),
      coefficients_(markers),
      z_s_(markers),
      z_ss_(markers),
      velocity_(markers),
      phi_s_(markers),
      phi_ss_(markers),
      E_(markers),
      e_(markers),
      A_(markers * markers),
      residual_(static_cast<Eigen::Index>(markers)) {}

void SurfaceVelocity::differentiate(SurfaceView<const double> surface) {
  const auto first = [&](std::size_t k) {
    return fourier_.is_sawtooth(k) ? Complex(0) : Complex(0, fourier_.wavenumber(k));
  };
  for (std::size_t j = 0; j < n_; ++j) work_[j] = {surface.displacement[j], surface.y[j]};
  fourier_.coefficients(work_, coefficients_);
  for (std::size_t k = 0; k < n_; ++k) work_[k] = first(k) * coefficients_[k];
  fourier_.samples(work_, z_s_);
  for (std::size_t k = 0; k < n_; ++k) work_[k] *= first(k);
  fourier_.samples(work_, z_ss_);
  for (std::size_t j = 0; j < n_; ++j) {
    z_s_[j] += 1;
    work_[j] = surface.potential[j];
  }
  fourier_.coefficients(work_, coefficients_);
  // phi_s and phi_ss are real: one transform carries both.
  for (std::size_t k = 0; k < n_; ++k) work_[k] = first(k) * (1.0 + Complex(0, 1) * first(k)) * coefficients_[k];
  fourier_.samples(work_, work_);
  for (std::size_t j = 0; j < n_; ++j) {
    phi_s_[j] = work_[j].real();
    phi_ss_[j] = work_[j].imag();
  }
}

void SurfaceVelocity::exponentials(SurfaceView<const double> surface) {
  for (std::size_t j = 0; j < n_; ++j) {
    const double x = label(j, n_) + surface.displacement[j];
    const Complex direction(std::cos(x), std::sin(x));
    E_.set(j, std::exp(-surface.y[j]) * direction);
    if (has_bottom_) e_.set(j, std::exp(-surface.y[j] - depth_) * direction);
  }
}

double SurfaceVelocity::assemble(const Eigen::VectorXd& psi_s) {
  const double factor = 2 / static_cast<double>(n_);  // w/pi
  double b_squared = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    const Complex z_s = z_s_[i];
    const auto row = A_.begin() + static_cast<std::ptrdiff_t>(i * n_);
    const Sums sums = kernel_row(i, z_s, -factor, E_, has_bottom_ ? &e_ : nullptr, phi_s_.data(), psi_s.data(), row);
    const double image = has_bottom_ ? 1 / (1 - std::norm(e_[i])) : 1;  // 1/(1 - e_i conj e_i)
    const Complex regular = z_ss_[i] / (2.0 * z_s);
    const double diagonal = factor * (regular.imag() - z_s.real() * (image - 0.5));
    const double b =
        factor *
        (-(z_s * (E_[i] * Complex(sums.direct_re, sums.direct_im) - Complex(sums.image_re, sums.image_im))).imag() +
         z_s.imag() * phi_s_[i] * (0.5 + image) + phi_ss_[i] - phi_s_[i] * regular.real());
    row[static_cast<std::ptrdiff_t>(i)] = static_cast<float>(diagonal);
    b_squared += b * b;
    const double psi = psi_s[static_cast<Eigen::Index>(i)];
    residual_[static_cast<Eigen::Index>(i)] = b - psi + (sums.product + diagonal * psi);
  }
  return std::sqrt(b_squared);
}

void SurfaceVelocity::solve(SurfaceView<const double> surface, Eigen::VectorXd& psi_s, double tolerance) {
  differentiate(surface);
  exponentials(surface);
  const auto apply = [&](const Eigen::VectorXd& x, Eigen::VectorXd& y) { subtract(A_.data(), n_, x.data(), y.data()); };
  // Each pass leaves of the residual what single precision misses; a first guess from the past needs one.
  bool solved = false;
  for (int pass = 0; !solved && pass < most_passes; ++pass) {
    const double goal = tolerance * assemble(psi_s);
    const double residual = residual_.norm();
    iterations_ += gmres_.solve(apply, residual_, correction_, std::max(goal / residual, single_precision));
    psi_s += correction_;
    solved = residual * single_precision <= goal;
  }
  ++solves_;
  for (std::size_t i = 0; i < n_; ++i) velocity_[i] = Complex(phi_s_[i], psi_s[static_cast<Eigen::Index>(i)]) / z_s_[i];
}

Invariants SurfaceVelocity::invariants(SurfaceView<const double> surface, const Eigen::VectorXd& psi_s,
                                       const Bars& bars) const {
  Invariants sum;
  for (std::size_t i = 0; i < n_; ++i) {
    const Complex zeta(label(i, n_) + surface.displacement[i], surface.y[i]);
    const double y = (zeta + bars.offset(zeta)).imag();
    const Complex z_s = bars.slope(zeta) * z_s_[i];
    sum.volume += y * z_s.real();
    sum.kinetic_energy -= 0.5 * surface.potential[i] * psi_s[static_cast<Eigen::Index>(i)];
    sum.potential_energy += 0.5 * y * y * z_s.real();
    sum.impulse -= surface.potential[i] * z_s.imag();
  }
  const double w = label(1, n_);
  return {w * sum.volume, w * sum.kinetic_energy, w * sum.potential_energy, w * sum.impulse};
}

}  // namespace seiche::exact::overturning
