// Discrete Fourier transforms against their sums, and their wavenumbers against derivatives.
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "seiche/linear/fourier.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::fourier_test {

using Complex = std::complex<double>;
using linear::Fourier;

/// (1/N) sum_j f_j exp(-i k s_j), term by term.
Complex coefficient(const std::vector<Complex>& samples, double k) {
  const auto n = static_cast<double>(samples.size());
  Complex sum = 0;
  for (std::size_t j = 0; j < samples.size(); ++j) {
    sum += samples[j] * std::polar(1.0, -2 * std::numbers::pi * k * static_cast<double>(j) / n);
  }
  return sum / n;
}

TEST_CASE("Fourier coefficients are their sums, in the order of their wavenumbers", "[linear]") {
  verification::Check check(
      "fourier", "Discrete Fourier transform",
      "Coefficients against their sums, samples against the original ones, in place too; the derivative by $i k c_k$ "
      "of a trigonometric polynomial with all wavenumbers below $N/2$; the sawtooth $k = N/2$ of even $N$ is named.");
  for (const std::size_t n : {16U, 15U, 1U}) {
    Fourier fourier(n);
    std::vector<Complex> samples(n), coefficients(n), again(n);
    for (std::size_t j = 0; j < n; ++j) {
      const auto x = static_cast<double>(j);
      samples[j] = {std::sin(1 + 2 * x) + 0.1 * x, std::cos(x * x)};
    }
    fourier.coefficients(samples, coefficients);
    Worst sums, back, slopes;
    for (std::size_t i = 0; i < n; ++i) {
      sums.add(std::abs(coefficients[i] - coefficient(samples, fourier.wavenumber(i))));
    }
    again = coefficients;
    fourier.samples(again, again);
    for (std::size_t j = 0; j < n; ++j) back.add(std::abs(again[j] - samples[j]));
    // sum of k sin(k s)/K and its derivative, K the greatest wavenumber that is no sawtooth.
    const auto greatest = static_cast<long>((n - 1) / 2);
    const double scale = std::max(1.0, static_cast<double>(greatest));
    std::vector<Complex> slope(n);
    for (std::size_t j = 0; j < n; ++j) {
      const double s = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
      samples[j] = slope[j] = 0;
      for (long k = 1; k <= greatest; ++k) {
        const auto wave = static_cast<double>(k);
        samples[j] += wave / scale * std::sin(wave * s);
        slope[j] += wave * wave / scale * std::cos(wave * s);
      }
    }
    fourier.coefficients(samples, coefficients);
    for (std::size_t i = 0; i < n; ++i)
      coefficients[i] *= Complex(0, fourier.is_sawtooth(i) ? 0 : fourier.wavenumber(i));
    fourier.samples(coefficients, again);
    for (std::size_t j = 0; j < n; ++j) slopes.add(std::abs(again[j] - slope[j]));
    for (const auto& [text, error, size] :
         {std::tuple{"sums-{}: Coefficients of the fast transform equal their defining sums.", sums, 3.0},
          {"back-{}: The samples are recovered by the inverse transform, in the same memory.", back, 3.0},
          {"slope-{}: Wavenumbers of the transform agree with the derivative.", slopes, scale * scale}}) {
      check.holds(fmt::format(fmt::runtime(text), n), {error.value()},
                  Roundoff{20.0 * static_cast<double>(n), size, "a sum of N products of rounded angles up to 2 pi N"});
    }
  }
  Fourier even(8);
  Count sawtooths;
  for (std::size_t i = 0; i < 8; ++i)
    sawtooths.add(static_cast<double>(i), [&](double k) { return even.is_sawtooth(static_cast<std::size_t>(k)); });
  check.holds("The highest of eight coefficients is a sawtooth, of wavenumber four.",
              {even.is_sawtooth(4) ? sawtooths.value() * even.wavenumber(4) : 0},
              evidence::Bound{0, "small whole numbers", 4});
}

}  // namespace seiche::verification::fourier_test
