#include "validation/instruments/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/instruments/oscillation.hpp"

namespace seiche::validation {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double range(std::span<const double> values) {
  return largest(values) - smallest(values);
}

double ratio(double numerator, double denominator) {
  return denominator > 0 ? numerator / denominator : unknown;
}

/// The longest stretch on which the reference stays above a level.
double longest_above(const Agreement& a, double level) {
  Largest longest;
  longest.add(0);
  double since = unknown;
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    if (!(a.reference[i] >= level))
      since = unknown;
    else if (std::isnan(since))
      since = a.x[i];
    if (!std::isnan(since)) longest.add(a.x[i] - since);
  }
  return longest.value();
}

/// Correlation of s(x) with r(x - lag), lag in spacings.
double lagged(std::span<const double> s, std::span<const double> r, long lag) {
  const std::size_t count = s.size() - static_cast<std::size_t>(std::abs(lag));
  const auto late_s = static_cast<std::size_t>(std::max(lag, 0L));
  const auto late_r = static_cast<std::size_t>(std::max(-lag, 0L));
  return correlation(s.subspan(late_s, count), r.subspan(late_r, count));
}

struct LocalPeak {
  double place;  ///< in samples
  double height;
};

/// Local maxima, each by the parabola through a sample and its neighbours.
std::vector<LocalPeak> peaks_of(const std::vector<double>& samples) {
  std::vector<LocalPeak> peaks;
  for (std::size_t k = 1; k + 1 < samples.size(); ++k) {
    const double before = samples[k - 1];
    const double here = samples[k];
    const double after = samples[k + 1];
    const double curvature = before - 2 * here + after;
    if (here < before || here < after || !(curvature < 0)) continue;
    const double offset = 0.5 * (before - after) / curvature;
    peaks.push_back({static_cast<double>(k) + offset, here - 0.25 * (before - after) * offset});
  }
  return peaks;
}

}  // namespace

double linear_at(Curve curve, double x) {
  if (!(x >= curve.x.front() && x <= curve.x.back())) return unknown;
  const auto above = std::lower_bound(curve.x.begin(), curve.x.end(), x) - curve.x.begin();
  const auto k = static_cast<std::size_t>(above);
  if (curve.x[k] == x) return curve.y[k];
  return std::lerp(curve.y[k - 1], curve.y[k], (x - curve.x[k - 1]) / (curve.x[k] - curve.x[k - 1]));
}

double shift_between(std::span<const double> x, std::span<const double> submitted, std::span<const double> reference) {
  const std::size_t n = x.size();
  const long farthest = static_cast<long>(n) / 4;
  if (farthest < 1) return unknown;
  const double spacing = (x.back() - x.front()) / static_cast<double>(n - 1);
  std::vector<double> s, r;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = i + 1 == n ? x.back() : x.front() + static_cast<double>(i) * spacing;
    s.push_back(linear_at({x, submitted}, at));
    r.push_back(linear_at({x, reference}, at));
  }
  std::vector<double> agreement_at;
  for (long lag = -farthest; lag <= farthest; ++lag) {
    const double here = lagged(s, r, lag);
    agreement_at.push_back(std::isnan(here) ? -1 : here);
  }
  const std::vector<LocalPeak> peaks = peaks_of(agreement_at);
  Largest best;
  for (const LocalPeak& peak : peaks) best.add(peak.height);
  double lag = unknown;
  for (const LocalPeak& peak : peaks) {
    const double candidate = peak.place - static_cast<double>(farthest);
    if (peak.height > 0 && peak.height >= 0.99 * best.value() && !(std::abs(candidate) >= std::abs(lag)))
      lag = candidate;
  }
  return lag * spacing;
}

double first_crossing(Curve curve, double level) {
  const auto found = std::find_if(curve.y.begin(), curve.y.end(), [&](double y) { return y >= level; });
  if (found == curve.y.end()) return unknown;
  const auto k = static_cast<std::size_t>(found - curve.y.begin());
  if (k == 0) return curve.x.front();
  return std::lerp(curve.x[k - 1], curve.x[k], (level - curve.y[k - 1]) / (curve.y[k] - curve.y[k - 1]));
}

double willmott_skill(std::span<const double> submitted, std::span<const double> reference) {
  const double middle = mean(reference);
  double error = 0;
  double potential = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    error += std::pow(submitted[i] - reference[i], 2);
    potential += std::pow(std::abs(submitted[i] - middle) + std::abs(reference[i] - middle), 2);
  }
  return 1 - ratio(error, potential);
}

Agreement agreement(Curve submitted, Curve reference) {
  Agreement a;
  std::size_t known = 0;
  for (std::size_t i = 0; i < reference.x.size(); ++i) {
    if (std::isnan(reference.y[i])) continue;
    ++known;
    const double value = linear_at(submitted, reference.x[i]);
    if (std::isnan(value)) continue;
    a.x.push_back(reference.x[i]);
    a.submitted.push_back(value);
    a.reference.push_back(reference.y[i]);
  }
  if (a.x.empty()) {
    throw std::invalid_argument(
        fmt::format("values in [{:g}, {:g}] cover none of the {} reference points in [{:g}, {:g}]", submitted.x.front(),
                    submitted.x.back(), known, reference.x.front(), reference.x.back()));
  }
  a.coverage = static_cast<double>(a.x.size()) / static_cast<double>(known);

  double l1 = 0;
  double l2 = 0;
  Largest linf;
  double size_l1 = 0;
  double size_l2 = 0;
  Largest size_linf;
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    const double error = std::abs(a.submitted[i] - a.reference[i]);
    const double size = std::abs(a.reference[i]);
    l1 += error;
    l2 += error * error;
    linf.add(error);
    size_l1 += size;
    size_l2 += size * size;
    size_linf.add(size);
  }
  a.largest_error = linf.value();
  a.relative_l1 = ratio(l1, size_l1);
  a.relative_l2 = std::sqrt(ratio(l2, size_l2));
  a.relative_linf = ratio(linf.value(), size_linf.value());
  a.amplitude_ratio = ratio(range(a.submitted), range(a.reference));
  a.skill = willmott_skill(a.submitted, a.reference);
  a.shift = shift_between(a.x, a.submitted, a.reference);
  const auto highest = [&](const std::vector<double>& y) {
    Largest found;
    for (std::size_t i = 0; i < y.size(); ++i) found.add(y[i], a.x[i]);
    return found;
  };
  a.peak = highest(a.submitted).value();
  a.reference_peak = highest(a.reference).value();
  const bool level = longest_above(a, a.reference_peak - 0.01 * range(a.reference)) > 0.1 * (a.x.back() - a.x.front());
  a.peak_at = level ? unknown : highest(a.submitted).where();
  a.reference_peak_at = level ? unknown : highest(a.reference).where();
  return a;
}

}  // namespace seiche::validation
