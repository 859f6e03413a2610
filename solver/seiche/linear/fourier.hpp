/// Discrete Fourier transform of periodic samples (FFTW), with the wavenumbers in order.
///
///     c_k = (1/N) sum_j f_j exp(-i k s_j),   f(s) = sum_k c_k exp(i k s),   s_j = 2 pi j/N,  -N/2 < k <= N/2
///
/// Plans are made once, by estimation: measured plans differ from run to run, and so would the last digits.
/// One object is for one thread.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

struct fftw_plan_s;
struct fftwf_plan_s;

namespace seiche::linear {

// FFTW's planner is the one part of it that two threads must not enter together.

inline std::mutex& planner() {
  static std::mutex mutex;
  return mutex;
}

/// Memory for transforms, from the beginning of a line of the cache on.
template <class Real>
class FourierBuffer {
 public:
  explicit FourierBuffer(std::size_t size) : lines_((size + in_line - 1) / in_line) {}
  [[nodiscard]] std::complex<Real>* data() { return lines_.front().numbers; }

 private:
  static constexpr std::size_t in_line = 64 / sizeof(std::complex<Real>);
  struct alignas(64) Line {
    std::complex<Real> numbers[in_line];
  };
  std::vector<Line> lines_;
};

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
  using Plan = std::unique_ptr<fftw_plan_s, void (*)(fftw_plan_s*)>;

  void run(const Plan& plan, std::span<const std::complex<double>> in, std::span<std::complex<double>> out,
           double factor);

  std::size_t size_;
  FourierBuffer<double> buffer_;
  Plan forward_, backward_;
};

/// Discrete cosine transform (DCT-II) of rows of single-precision numbers, two rows at a time.
///
///     C_m = sum_n x_n cos(pi m (n + 1/2)/N),  m = 0..N-1,    x_n = (1/N) [C_0 + 2 sum_{m>0} C_m cos(pi m (n + 1/2)/N)]
///
/// The permutation v_n = x_2n, v_{N-1-n} = x_{2n+1} turns it into a Fourier transform V_m of length N, with
/// exp(-i pi m/2N) V_m = C_m - i C_{N-m} (Makhoul 1980). Two real rows are the real and imaginary parts of one complex
/// row. FFTW's own cosine transforms take four times as long: their innermost loops are scalar.
///
/// Coefficients are stored in the order m = 0, 1, .., N/2, N-1, N-2, .., N/2+1: see mode().
///
/// Plans are made by estimation: measured plans differ from run to run, and so would the last digits. All members are
/// const; threads share one object, each with a workspace of its own.
///
/// Reference: Makhoul, A fast cosine transform in one and two dimensions, IEEE Trans. ASSP 28 (1980) 27.
class CosineTransform {
 public:
  /// @param size  number of samples N, at least 1. Throws std::invalid_argument.
  explicit CosineTransform(std::size_t size);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Number m of the mode whose coefficient is stored at `position`.
  [[nodiscard]] std::size_t mode(std::size_t position) const {
    return position <= size_ / 2 ? position : size_ + size_ / 2 - position;
  }

  /// Memory that one thread needs for its transforms.
  struct Workspace {
    explicit Workspace(const CosineTransform& transform) : rows(transform.size()), spectrum(transform.size()) {}

    FourierBuffer<float> rows, spectrum;
  };

  /// Coefficients of two rows. The two may be the same row.
  void forward(std::array<const float*, 2> rows, std::array<float*, 2> coefficients, Workspace& workspace) const;
  /// N times the rows that have these coefficients.
  void backward(std::array<const float*, 2> coefficients, std::array<float*, 2> rows, Workspace& workspace) const;

 private:
  using Plan = std::unique_ptr<fftwf_plan_s, void (*)(fftwf_plan_s*)>;

  std::size_t size_;
  std::vector<float> cosine_;  // cos(pi m/2N), sin(pi m/2N), m = 0..N/2
  std::vector<float> sine_;
  Plan forward_, backward_;
};

}  // namespace seiche::linear
