#include "seiche/linear/fourier.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fftw3.h>

#include "seiche/require.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::linear {
namespace {

void destroy(fftw_plan_s* plan) {
  const std::scoped_lock lock(planner());
  fftw_destroy_plan(plan);
}

void destroy(fftwf_plan_s* plan) {
  const std::scoped_lock lock(planner());
  fftwf_destroy_plan(plan);
}

fftwf_complex* fftw(std::complex<float>* data) {
  return reinterpret_cast<fftwf_complex*>(data);
}

/// z_n = (a_2n, b_2n), z_{N-1-n} = (a_{2n+1}, b_{2n+1}).
SEICHE_SIMD_CLONES void pack(const float* __restrict a, const float* __restrict b, float* __restrict z,
                             std::size_t size) {
  const std::size_t half = size / 2;
  for (std::size_t n = 0; n < half; ++n) {
    z[2 * n] = a[2 * n];
    z[2 * n + 1] = b[2 * n];
  }
  if (size % 2 == 1) {
    z[2 * half] = a[size - 1];
    z[2 * half + 1] = b[size - 1];
  }
  float* const end = z + 2 * (size - 1);
  for (std::size_t n = 0; n < half; ++n) {
    end[-2 * static_cast<std::ptrdiff_t>(n)] = a[2 * n + 1];
    end[-2 * static_cast<std::ptrdiff_t>(n) + 1] = b[2 * n + 1];
  }
}

SEICHE_SIMD_CLONES void unpack(const float* __restrict z, float* __restrict a, float* __restrict b, std::size_t size) {
  const std::size_t half = size / 2;
  const float* const end = z + 2 * (size - 1);
  for (std::size_t n = 0; n < half; ++n) {
    a[2 * n] = z[2 * n];
    a[2 * n + 1] = end[-2 * static_cast<std::ptrdiff_t>(n)];
  }
  for (std::size_t n = 0; n < half; ++n) {
    b[2 * n] = z[2 * n + 1];
    b[2 * n + 1] = end[-2 * static_cast<std::ptrdiff_t>(n) + 1];
  }
  if (size % 2 == 1) {
    a[size - 1] = z[2 * half];
    b[size - 1] = z[2 * half + 1];
  }
}

/// Coefficients of both rows from the spectrum Z of a + i b: A_m = (Z_m + conj Z_{N-m})/2, B_m = (Z_m - conj
/// Z_{N-m})/2i.
SEICHE_SIMD_CLONES void separate(const float* __restrict z, const float* __restrict cosine,
                                 const float* __restrict sine, float* __restrict a, float* __restrict b,
                                 std::size_t size) {
  const std::size_t half = size / 2;
  a[0] = z[0];
  b[0] = z[1];
  float* const a_high = a + half;
  float* const b_high = b + half;
  const float* const z_end = z + 2 * size;
  const std::size_t pairs = (size - 1) / 2;
  for (std::size_t m = 1; m <= pairs; ++m) {
    const float re = 0.5f * z[2 * m];
    const float im = 0.5f * z[2 * m + 1];
    const float re_high = 0.5f * z_end[-2 * static_cast<std::ptrdiff_t>(m)];
    const float im_high = 0.5f * z_end[-2 * static_cast<std::ptrdiff_t>(m) + 1];
    const float c = cosine[m];
    const float s = sine[m];
    a[m] = c * (re + re_high) + s * (im - im_high);
    b[m] = c * (im + im_high) + s * (re_high - re);
    a_high[m] = s * (re + re_high) - c * (im - im_high);
    b_high[m] = s * (im + im_high) - c * (re_high - re);
  }
  if (size % 2 == 0) {
    a[half] = cosine[half] * z[2 * half];
    b[half] = cosine[half] * z[2 * half + 1];
  }
}

/// Z_m = exp(i pi m/2N) [A_m - i A_{N-m} + i (B_m - i B_{N-m})].
SEICHE_SIMD_CLONES void join(const float* __restrict a, const float* __restrict b, const float* __restrict cosine,
                             const float* __restrict sine, float* __restrict z, std::size_t size) {
  const std::size_t half = size / 2;
  z[0] = a[0];
  z[1] = b[0];
  const float* const a_high = a + half;
  const float* const b_high = b + half;
  float* const z_end = z + 2 * size;
  const std::size_t pairs = (size - 1) / 2;
  for (std::size_t m = 1; m <= pairs; ++m) {
    const float c = cosine[m];
    const float s = sine[m];
    const float re = a[m] + b_high[m];
    const float im = b[m] - a_high[m];
    const float re_high = a_high[m] + b[m];
    const float im_high = b_high[m] - a[m];
    z[2 * m] = c * re - s * im;
    z[2 * m + 1] = s * re + c * im;
    z_end[-2 * static_cast<std::ptrdiff_t>(m)] = s * re_high - c * im_high;
    z_end[-2 * static_cast<std::ptrdiff_t>(m) + 1] = c * re_high + s * im_high;
  }
  if (size % 2 == 0) {
    const float twice = 2 * cosine[half];
    z[2 * half] = twice * a[half];
    z[2 * half + 1] = twice * b[half];
  }
}

}  // namespace

Fourier::Fourier(std::size_t size)
    : size_(size), buffer_(size), forward_(nullptr, destroy), backward_(nullptr, destroy) {
  require_at_least("size", static_cast<long>(size), 1);
  const std::scoped_lock lock(planner());
  auto* data = reinterpret_cast<fftw_complex*>(buffer_.data());
  const int n = static_cast<int>(size);
  forward_.reset(fftw_plan_dft_1d(n, data, data, FFTW_FORWARD, FFTW_ESTIMATE));
  backward_.reset(fftw_plan_dft_1d(n, data, data, FFTW_BACKWARD, FFTW_ESTIMATE));
}

void Fourier::run(const Plan& plan, std::span<const std::complex<double>> in, std::span<std::complex<double>> out,
                  double factor) {
  std::ranges::copy(in, buffer_.data());
  fftw_execute(plan.get());
  for (std::size_t i = 0; i < size_; ++i) out[i] = factor * buffer_.data()[i];
}

void Fourier::coefficients(std::span<const std::complex<double>> samples, std::span<std::complex<double>> result) {
  run(forward_, samples, result, 1 / static_cast<double>(size_));
}

void Fourier::samples(std::span<const std::complex<double>> coefficients, std::span<std::complex<double>> result) {
  run(backward_, coefficients, result, 1);
}

CosineTransform::CosineTransform(std::size_t size)
    : size_(size), forward_(nullptr, destroy), backward_(nullptr, destroy) {
  require_at_least("size", static_cast<long>(size), 1);
  for (std::size_t m = 0; m <= size / 2; ++m) {
    const double angle = std::numbers::pi * static_cast<double>(m) / (2 * static_cast<double>(size));
    cosine_.push_back(static_cast<float>(std::cos(angle)));
    sine_.push_back(static_cast<float>(std::sin(angle)));
  }
  Workspace workspace(*this);
  auto* const rows = fftw(workspace.rows.data());
  auto* const spectrum = fftw(workspace.spectrum.data());
  const std::scoped_lock lock(planner());
  const int n = static_cast<int>(size);
  forward_.reset(fftwf_plan_dft_1d(n, rows, spectrum, FFTW_FORWARD, FFTW_ESTIMATE));
  backward_.reset(fftwf_plan_dft_1d(n, spectrum, rows, FFTW_BACKWARD, FFTW_ESTIMATE));
}

void CosineTransform::forward(std::array<const float*, 2> rows, std::array<float*, 2> coefficients,
                              Workspace& workspace) const {
  auto* const z = workspace.rows.data();
  auto* const spectrum = workspace.spectrum.data();
  pack(rows[0], rows[1], reinterpret_cast<float*>(z), size_);
  fftwf_execute_dft(forward_.get(), fftw(z), fftw(spectrum));
  separate(reinterpret_cast<const float*>(spectrum), cosine_.data(), sine_.data(), coefficients[0], coefficients[1],
           size_);
}

void CosineTransform::backward(std::array<const float*, 2> coefficients, std::array<float*, 2> rows,
                               Workspace& workspace) const {
  auto* const z = workspace.rows.data();
  auto* const spectrum = workspace.spectrum.data();
  join(coefficients[0], coefficients[1], cosine_.data(), sine_.data(), reinterpret_cast<float*>(spectrum), size_);
  fftwf_execute_dft(backward_.get(), fftw(spectrum), fftw(z));
  unpack(reinterpret_cast<const float*>(z), rows[0], rows[1], size_);
}

}  // namespace seiche::linear
