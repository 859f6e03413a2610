#include "seiche/linear/fourier.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>

#include <fftw3.h>

#include "seiche/require.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::linear {
namespace {

fftw_plan_s* plan(std::size_t size, std::complex<double>* buffer, int sign) {
  const std::scoped_lock lock(planner());
  auto* data = reinterpret_cast<fftw_complex*>(buffer);
  return fftw_plan_dft_1d(static_cast<int>(size), data, data, sign, FFTW_ESTIMATE);
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

void Fourier::DestroyPlan::operator()(fftw_plan_s* plan) const {
  const std::scoped_lock lock(planner());
  fftw_destroy_plan(plan);
}

void Fourier::FreeBuffer::operator()(std::complex<double>* buffer) const {
  fftw_free(buffer);
}

Fourier::Fourier(std::size_t size) : size_(size) {
  require_at_least("size", static_cast<long>(size), 1);
  buffer_.reset(reinterpret_cast<std::complex<double>*>(fftw_alloc_complex(size)));
  if (!buffer_) throw std::bad_alloc();
  forward_.reset(plan(size, buffer_.get(), FFTW_FORWARD));
  backward_.reset(plan(size, buffer_.get(), FFTW_BACKWARD));
}

void Fourier::run(const Plan& plan, std::span<const std::complex<double>> in, std::span<std::complex<double>> out,
                  double factor) {
  std::ranges::copy(in, buffer_.get());
  fftw_execute(plan.get());
  for (std::size_t i = 0; i < size_; ++i) out[i] = factor * buffer_.get()[i];
}

void Fourier::coefficients(std::span<const std::complex<double>> samples, std::span<std::complex<double>> result) {
  run(forward_, samples, result, 1 / static_cast<double>(size_));
}

void Fourier::samples(std::span<const std::complex<double>> coefficients, std::span<std::complex<double>> result) {
  run(backward_, coefficients, result, 1);
}

void CosineTransform::DestroyPlan::operator()(fftwf_plan_s* plan) const {
  const std::scoped_lock lock(planner());
  fftwf_destroy_plan(plan);
}

void CosineTransform::Workspace::Free::operator()(std::complex<float>* buffer) const {
  fftwf_free(buffer);
}

CosineTransform::Workspace::Buffer CosineTransform::Workspace::allocate(std::size_t size) {
  Buffer buffer(reinterpret_cast<std::complex<float>*>(fftwf_alloc_complex(size)));
  if (!buffer) throw std::bad_alloc();
  return buffer;
}

CosineTransform::Workspace::Workspace(const CosineTransform& transform)
    : rows_(allocate(transform.size())), spectrum_(allocate(transform.size())) {}

CosineTransform::CosineTransform(std::size_t size) : size_(size) {
  require_at_least("size", static_cast<long>(size), 1);
  for (std::size_t m = 0; m <= size / 2; ++m) {
    const double angle = std::numbers::pi * static_cast<double>(m) / (2 * static_cast<double>(size));
    cosine_.push_back(static_cast<float>(std::cos(angle)));
    sine_.push_back(static_cast<float>(std::sin(angle)));
  }
  Workspace workspace(*this);
  auto* const rows = fftw(workspace.rows_.get());
  auto* const spectrum = fftw(workspace.spectrum_.get());
  const std::scoped_lock lock(planner());
  const int n = static_cast<int>(size);
  forward_.reset(fftwf_plan_dft_1d(n, rows, spectrum, FFTW_FORWARD, FFTW_ESTIMATE));
  backward_.reset(fftwf_plan_dft_1d(n, spectrum, rows, FFTW_BACKWARD, FFTW_ESTIMATE));
}

void CosineTransform::forward(std::array<const float*, 2> rows, std::array<float*, 2> coefficients,
                              Workspace& workspace) const {
  auto* const z = workspace.rows_.get();
  auto* const spectrum = workspace.spectrum_.get();
  pack(rows[0], rows[1], reinterpret_cast<float*>(z), size_);
  fftwf_execute_dft(forward_.get(), fftw(z), fftw(spectrum));
  separate(reinterpret_cast<const float*>(spectrum), cosine_.data(), sine_.data(), coefficients[0], coefficients[1],
           size_);
}

void CosineTransform::backward(std::array<const float*, 2> coefficients, std::array<float*, 2> rows,
                               Workspace& workspace) const {
  auto* const z = workspace.rows_.get();
  auto* const spectrum = workspace.spectrum_.get();
  join(coefficients[0], coefficients[1], cosine_.data(), sine_.data(), reinterpret_cast<float*>(spectrum), size_);
  fftwf_execute_dft(backward_.get(), fftw(spectrum), fftw(z));
  unpack(reinterpret_cast<const float*>(z), rows[0], rows[1], size_);
}

}  // namespace seiche::linear
