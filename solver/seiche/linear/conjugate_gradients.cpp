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
double sum_over_chunks(std::size_t size, const Kernel& kernel) {
  const std::size_t chunks = (size + chunk - 1) / chunk;
  std::vector<double> partial(chunks);
  share_out(chunks, size >= worth_threads,
            [&](std::size_t c) { partial[c] = kernel(c * chunk, std::min(chunk, size - c * chunk)); });
  double sum = 0;
  for (const double p : partial) sum += p;
  return sum;
}

SEICHE_SIMD_CLONES double dot_chunk(const double* x, const double* y, std::size_t n) {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < n; ++i) sum += x[i] * y[i];
  return sum;
}

SEICHE_SIMD_CLONES void scale_and_add_chunk(const double* x, double factor, double* y, std::size_t n) {
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) y[i] = x[i] + factor * y[i];
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

void scale_and_add(std::span<const double> x, double factor, std::span<double> y) {
  sum_over_chunks(y.size(), [&](std::size_t first, std::size_t n) {
    scale_and_add_chunk(&x[first], factor, &y[first], n);
    return 0.0;
  });
}

double advance(double step, std::span<const double> p, std::span<const double> q, std::span<double> x,
               std::span<double> r) {
  return sum_over_chunks(x.size(), [&](std::size_t first, std::size_t n) {
    return advance_chunk(step, &p[first], &q[first], &x[first], &r[first], n);
  });
}

}  // namespace seiche::linear
