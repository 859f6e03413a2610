#include "seiche/linear/conjugate_gradients.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "seiche/linear/worth_threads.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::linear {
namespace {

constexpr std::size_t chunk = 4096;
/// Calls kernel(first, length) for every chunk and adds up what it returns.
template <class Kernel>
auto sum_over_chunks(std::size_t size, const Kernel& kernel) {
  using Sum = decltype(kernel(std::size_t{}, std::size_t{}));
  const std::size_t chunks = (size + chunk - 1) / chunk;
  std::vector<Sum> partial(chunks);
  share_out(chunks, size >= worth_threads,
            [&](std::size_t c) { partial[c] = kernel(c * chunk, std::min(chunk, size - c * chunk)); });
  Sum sum{};
  for (const Sum& p : partial) sum += p;
  return sum;
}

struct TwoSums {
  double first = 0, second = 0;
  TwoSums& operator+=(const TwoSums& other) {
    first += other.first;
    second += other.second;
    return *this;
  }
};

SEICHE_SIMD_CLONES double dot_chunk(const double* x, const double* y, std::size_t n) {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < n; ++i) sum += x[i] * y[i];
  return sum;
}

SEICHE_SIMD_CLONES TwoSums dots_chunk(const double* x, const double* y, const double* z, std::size_t n) {
  double xy = 0;
  double xz = 0;
#pragma omp simd reduction(+ : xy, xz)
  for (std::size_t i = 0; i < n; ++i) {
    xy += x[i] * y[i];
    xz += x[i] * z[i];
  }
  return {xy, xz};
}

SEICHE_SIMD_CLONES void scale_and_add_chunk(const double* x, double factor, double* y, std::size_t n) {
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) y[i] = x[i] + factor * y[i];
}

SEICHE_SIMD_CLONES double subtract_chunk(const double* x, double* difference, std::size_t n) {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < n; ++i) {
    difference[i] = x[i] - difference[i];
    sum += difference[i] * difference[i];
  }
  return sum;
}

SEICHE_SIMD_CLONES double advance_chunk(double step, const double* p, const double* q, double* x, double* r,
                                        std::size_t n) {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < n; ++i) {
    x[i] += step * p[i];
    r[i] -= step * q[i];
    sum += r[i] * r[i];
  }
  return sum;
}

}  // namespace

double dot(std::span<const double> x, std::span<const double> y) {
  return sum_over_chunks(x.size(),
                         [&](std::size_t first, std::size_t n) { return dot_chunk(&x[first], &y[first], n); });
}

std::array<double, 2> dots(std::span<const double> x, std::span<const double> y, std::span<const double> z) {
  const TwoSums sums = sum_over_chunks(
      x.size(), [&](std::size_t first, std::size_t n) { return dots_chunk(&x[first], &y[first], &z[first], n); });
  return {sums.first, sums.second};
}

void scale_and_add(std::span<const double> x, double factor, std::span<double> y) {
  const std::size_t size = y.size();
  share_out((size + chunk - 1) / chunk, size >= worth_threads, [&](std::size_t c) {
    const std::size_t first = c * chunk;
    scale_and_add_chunk(&x[first], factor, &y[first], std::min(chunk, size - first));
  });
}

double subtract_from(std::span<const double> x, std::span<double> difference) {
  return sum_over_chunks(
      x.size(), [&](std::size_t first, std::size_t n) { return subtract_chunk(&x[first], &difference[first], n); });
}

double advance(double step, std::span<const double> p, std::span<const double> q, std::span<double> x,
               std::span<double> r) {
  return sum_over_chunks(x.size(), [&](std::size_t first, std::size_t n) {
    return advance_chunk(step, &p[first], &q[first], &x[first], &r[first], n);
  });
}

}  // namespace seiche::linear
