#include "validation/instruments/plan/wall_history.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <boost/math/tools/minima.hpp>

#include "seiche/samples.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/straight_line.hpp"

namespace seiche::validation {
namespace {

constexpr std::size_t fewest_values = 20;

void require_series(std::span<const double> time, std::span<const double> amplitude, std::size_t fewest) {
  if (time.size() != amplitude.size() || time.size() < fewest) {
    throw std::invalid_argument(fmt::format(
        "wall history of {} times and {} amplitudes; allowed: at least {} of each, which take a longer time",
        time.size(), amplitude.size(), fewest));
  }
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (!std::isfinite(time[k]) || !std::isfinite(amplitude[k])) {
      throw std::invalid_argument(
          fmt::format("wall history: value {} at time {} is not finite", amplitude[k], time[k]));
    }
    if (k > 0 && !(time[k] > time[k - 1])) {
      throw std::invalid_argument(fmt::format("wall history: time {} after {}, must increase", time[k], time[k - 1]));
    }
  }
}

struct Series {
  std::span<const double> time, amplitude;

  /// From a fraction of the whole time on.
  [[nodiscard]] Series since(double fraction) const {
    const double from = std::lerp(time.front(), time.back(), fraction);
    const auto first = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), from) - time.begin());
    return {time.subspan(first), amplitude.subspan(first)};
  }
};

/// Variable projection: for every rate of f the limit and C are a straight line's; the rate is the one that leaves
/// least.
/// @param decay  (time, rate) -> f
template <class Decay>
Approach best_approach(Series series, Decay decay, double slowest, double fastest) {
  std::vector<double> f(series.time.size());
  const auto at_rate = [&](double log_rate) {
    const double rate = std::exp(log_rate);
    std::transform(series.time.begin(), series.time.end(), f.begin(), [&](double t) { return decay(t, rate); });
    const StraightLine line = straight_line(f, series.amplitude);
    const auto left = [&](std::size_t k) { return series.amplitude[k] - line.at(f[k]); };
    return Approach{line.at(0), rate, over<Mean>(indices(f.size()), left).rms(), true};
  };
  // The misfit may have several minima in noise: the lowest of a scan, then refined.
  constexpr int scanned = 40;
  const double low = std::log(slowest);
  const double step = (std::log(fastest) - low) / scanned;
  Smallest least;
  for (int k = 0; k <= scanned; ++k) least.add(at_rate(low + k * step).misfit, k);
  const double best = least.where();
  const auto [log_rate, misfit] = boost::math::tools::brent_find_minima(
      [&](double s) { return at_rate(s).misfit; }, low + std::max(best - 1, 0.0) * step,
      low + std::min(best + 1, double{scanned}) * step, 30);
  Approach approach = at_rate(log_rate);
  approach.bends = log_rate > low + 0.5 * step;
  return approach;
}

Approach exponential(Series series) {
  const double start = series.time.front();
  const double length = series.time.back() - start;
  return best_approach(
      series, [start](double t, double rate) { return std::exp(-rate * (t - start)); }, 0.5 / length, 50 / length);
}

Approach algebraic(Series series) {
  const double start = series.time.front();
  if (!(start > 0))
    throw std::invalid_argument(fmt::format("wall history: time {} is out of range: must be positive", start));
  return best_approach(
      series, [start](double t, double power) { return std::pow(t / start, -power); }, 0.2, 10);
}

}  // namespace

double growth_of_last_fifth(std::span<const double> time, std::span<const double> amplitude) {
  require_series(time, amplitude, 2);
  return 1 - linear_at({time, amplitude}, std::lerp(time.front(), time.back(), 0.8)) / amplitude.back();
}

Approach exponential_approach(std::span<const double> time, std::span<const double> amplitude) {
  require_series(time, amplitude, 4);
  return exponential({time, amplitude});
}

WallLimit wall_limit(std::span<const double> time, std::span<const double> amplitude, std::optional<double> rate) {
  require_series(time, amplitude, fewest_values);
  if (rate && !(*rate >= 0)) {
    throw std::invalid_argument(fmt::format("wall history: rate = {} is out of range: must be >= 0", *rate));
  }
  const Series series{time, amplitude};
  WallLimit result;
  result.growth = growth_of_last_fifth(time, amplitude);
  result.exponential = exponential(series.since(0.5));
  result.algebraic = algebraic(series.since(0.5));
  const double limit = result.exponential.limit;
  Worst uncertainty;
  uncertainty.add(result.exponential.misfit);
  const auto differs = [&](double other) { uncertainty.add(other - limit); };
  differs(exponential(series.since(1.0 / 3)).limit);
  differs(exponential(series.since(2.0 / 3)).limit);
  if (result.algebraic.misfit <= 3 * result.exponential.misfit) differs(result.algebraic.limit);
  if (!result.exponential.bends) differs(amplitude.back());
  if (rate) {
    differs(amplitude.back());
    differs(amplitude.back() / -std::expm1(-*rate * time.back()));
  }
  result.amplitude = {.value = limit, .resolution = fmt::format("until t = {:g}", time.back())};
  if (rate != 0.0) result.amplitude.uncertainty = uncertainty.value();
  return result;
}

evidence::Measurement stem_angle(std::span<const double> wall_x, std::span<const double> stem_length) {
  const StraightLine line = wall_x.size() >= 4 && wall_x.size() == stem_length.size()
                                ? straight_line_of_curve(wall_x, stem_length)
                                : straight_line(wall_x, stem_length);
  evidence::Measurement angle = line.angle();
  angle.value = std::copysign(angle.value, line.slope);
  return angle;
}

}  // namespace seiche::validation
