#include "validation/instruments/shifted_front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/straight_line.hpp"

namespace seiche::validation {
namespace {

/// Where a front stood before it was let go.
double front_at(Curve computed, double time) {
  const double first = computed.x.front();
  return linear_at(computed, time < first ? first : time);
}

}  // namespace

double known_from(Curve computed, ShiftRange range) {
  constexpr double at_rest = 1.05;  // what is read off a figure is no better
  if (computed.y.front() <= at_rest) return -std::numeric_limits<double>::infinity();
  return computed.x.front() + std::max(range.highest, 0.0);
}

ShiftedFront shifted_front(Curve computed, Curve measured, double farthest, ShiftRange range) {
  const double latest = computed.x.back() + std::min(range.lowest, 0.0);
  const double earliest = known_from(computed, range);
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < measured.x.size(); ++i) {
    if (measured.y[i] <= farthest && measured.x[i] <= latest && measured.x[i] >= earliest) used.push_back(i);
  }
  if (used.size() < 2) {
    throw std::invalid_argument(
        fmt::format("{} of the published points lie before X = {:.4g} and T = {:.4g}: two are needed, run longer or "
                    "compare nothing",
                    used.size(), farthest, latest));
  }
  const auto rms = [&](double shift) {
    const auto off = [&](std::size_t i) { return front_at(computed, measured.x[i] - shift) - measured.y[i]; };
    return over<Mean>(used, off).rms();
  };
  const auto part_off = [&](std::size_t i) { return front_at(computed, measured.x[i]) / measured.y[i] - 1; };
  ShiftedFront result{.points = used.size(), .raw_rms = rms(0), .raw_off = each(used, part_off)};
  // A grid first: the rms may have several minima where the front is jagged.
  constexpr int grid = 200;
  double step = (range.highest - range.lowest) / grid;
  double best = range.lowest;
  for (int k = 0; k <= grid; ++k) {
    const double shift = range.lowest + k * step;
    if (rms(shift) < rms(best)) best = shift;
  }
  for (int halving = 0; halving < 20; ++halving) {
    for (const double shift : {best - step, best + step}) {
      if (shift >= range.lowest && shift <= range.highest && rms(shift) < rms(best)) best = shift;
    }
    step /= 2;
  }
  result.rms = rms(best);
  // Where the front is not known no shift is the best one.
  result.shift = std::isnan(result.rms) ? result.rms : best;
  return result;
}

double slope_between(Curve curve, double from, double to) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (curve.x[i] <= from || curve.x[i] >= to) continue;
    x.push_back(curve.x[i]);
    y.push_back(curve.y[i]);
  }
  return x.size() < 2 ? std::numeric_limits<double>::quiet_NaN() : straight_line(x, y).slope;
}

}  // namespace seiche::validation
