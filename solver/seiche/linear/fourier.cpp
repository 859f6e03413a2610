#include "seiche/linear/fourier.hpp"

#include <algorithm>
#include <new>

#include <fftw3.h>

#include "seiche/require.hpp"

namespace seiche::linear {
namespace {

fftw_plan_s* plan(std::size_t size, std::complex<double>* buffer, int sign) {
  const std::scoped_lock lock(planner());
  auto* data = reinterpret_cast<fftw_complex*>(buffer);
  return fftw_plan_dft_1d(static_cast<int>(size), data, data, sign, FFTW_ESTIMATE);
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

}  // namespace seiche::linear
