#include "validation/instruments/oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "seiche/samples.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/peak.hpp"

namespace seiche::validation {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

std::vector<CurveCrest> crests_above(double threshold, std::span<const double> x, std::span<const double> y) {
  std::vector<CurveCrest> crests;
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    if (!(y[k] > y[k - 1] && y[k] >= y[k + 1])) continue;
    Peak top;
    for (const std::size_t i : {k - 1, k, k + 1}) top.add(x[i], y[i]);
    if (top.value() > threshold) crests.push_back({top.time(), top.value()});
  }
  return crests;
}

double correlation(std::span<const double> a, std::span<const double> b) {
  const double mean_a = mean(a);
  const double mean_b = mean(b);
  double ab = 0;
  double aa = 0;
  double bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  const double scale = std::sqrt(aa) * std::sqrt(bb);
  return scale > 0 ? ab / scale : no_value;
}

Period period_of(std::span<const double> samples, double interval) {
  std::vector<double> lag, likeness;
  bool crossed = false;
  for (std::size_t k = 1; k <= samples.size() / 2; ++k) {
    const std::size_t overlap = samples.size() - k;
    const double c = correlation(samples.first(overlap), samples.subspan(k));
    crossed = crossed || c < 0;
    if (!crossed) continue;
    lag.push_back(static_cast<double>(k) * interval);
    likeness.push_back(c);
  }
  const std::vector<CurveCrest> peaks = crests_above(0, lag, likeness);
  const double highest = largest(each(peaks, &CurveCrest::height));
  const auto first = std::ranges::find_if(
      peaks, [&](double height) { return height >= 0.9 * highest; }, &CurveCrest::height);
  if (first == peaks.end()) return {no_value, no_value};
  return {first->place, first->height};
}

double frequency_of(std::span<const double> amplitudes, double tau) {
  double squares = 0, products = 0;
  for (std::size_t n = 1; n + 1 < amplitudes.size(); ++n) {
    squares += amplitudes[n] * amplitudes[n];
    products += amplitudes[n] * (2 * amplitudes[n] - amplitudes[n + 1] - amplitudes[n - 1]);
  }
  return std::sqrt(products / squares) / tau;
}

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<double> distances(std::span<const CurveCrest> crests) {
  std::vector<double> result;
  for (std::size_t k = 1; k < crests.size(); ++k) result.push_back(crests[k].place - crests[k - 1].place);
  return result;
}

double relative_spread(std::span<const double> values) {
  if (values.size() < 2) return no_value;
  const double middle = mean(values);
  return over<Worst>(values, [&](double value) { return value - middle; }).value() / std::abs(middle);
}

}  // namespace seiche::validation
