/// Discrete Fourier transform of periodic samples (FFTW), with the wavenumbers in order.
///
///     c_k = (1/N) sum_j f_j exp(-i k s_j),   f(s) = sum_k c_k exp(i k s),   s_j = 2 pi j/N,  -N/2 < k <= N/2
///
/// Plans are made once, by estimation: measured plans differ from run to run, and so would the last digits.
/// One object is for one thread.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>

struct fftw_plan_s;

namespace seiche::linear {

// FFTW's planner is the one part of it that two threads must not enter together.

inline std::mutex& planner() {
  static std::mutex mutex;
  return mutex;
}

class Fourier {
 public:
  /// @param size  number of samples N, at least 1. Throws std::invalid_argument.
  explicit Fourier(std::size_t size);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Wavenumber of coefficient i.
  [[nodiscard]] double wavenumber(std::size_t i) const {
    return i <= size_ / 2 ? static_cast<double>(i) : static_cast<double>(i) - static_cast<double>(size_);
  }
  /// Whether coefficient i is the sawtooth, whose derivative vanishes at every sample.
  [[nodiscard]] bool is_sawtooth(std::size_t i) const { return 2 * i == size_; }

  /// Both of length N; the two may be the same memory.
  void coefficients(std::span<const std::complex<double>> samples, std::span<std::complex<double>> result);
  void samples(std::span<const std::complex<double>> coefficients, std::span<std::complex<double>> result);

 private:
  struct DestroyPlan {
    void operator()(fftw_plan_s* plan) const;
  };
  struct FreeBuffer {
    void operator()(std::complex<double>* buffer) const;
  };
  using Plan = std::unique_ptr<fftw_plan_s, DestroyPlan>;

  void run(const Plan& plan, std::span<const std::complex<double>> in, std::span<std::complex<double>> out,
           double factor);

  std::size_t size_;
  std::unique_ptr<std::complex<double>, FreeBuffer> buffer_;  // of size_ numbers
  Plan forward_;
  Plan backward_;
};

}  // namespace seiche::linear
