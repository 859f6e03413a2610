#include "seiche/exact/shallow_water/simple_wave.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace sw = shallow_water;

namespace {

/// Lengths of a hump that it may be away from x = 0: its places are known to eps times as many lengths.
constexpr double farthest = 1e6;

}  // namespace

SimpleWave::SimpleWave(double gravity, double still_depth, Profile profile)
    : gravity_(gravity), profile_(std::move(profile)) {
  require_all_positive({{"gravity", gravity}, {"still_depth", still_depth}});
  require_that(profile_.depth && profile_.slope, "profile: depth and slope must both be given");
  require_finite("profile start", profile_.start);
  require_finite("profile end", profile_.end);
  require_that(profile_.end > profile_.start, "profile end = {:.17g} is out of range: must exceed its start = {:g}",
               profile_.end, profile_.start);
  still_celerity_ = sw::celerity(gravity, still_depth);
  for (const double end : {profile_.start, profile_.end}) {
    // The profile must join the still water, or characteristics would cross at t = 0.
    require_within("depth at the end of the profile", profile_.depth(end), still_depth * (1 - 1e-12),
                   still_depth * (1 + 1e-12));
  }

  // Steepest fall of c: c' = g h'/(2 c), sampled, then refined by Brent's method around the smallest sample.
  const auto celerity_slope = [&](double s) {
    const double depth = profile_.depth(s);
    require_positive("depth of the profile", depth);
    return 0.5 * gravity_ * profile_.slope(s) / sw::celerity(gravity_, depth);
  };
  constexpr int samples = 4000;
  const double spacing = (profile_.end - profile_.start) / samples;
  Smallest steepest;
  for (int k = 0; k <= samples; ++k) {
    const double s = profile_.start + k * spacing;
    steepest.add(celerity_slope(s), s);
  }
  breaking_place_ = profile_.start;
  breaking_time_ = std::numeric_limits<double>::infinity();
  if (!(steepest.value() < 0)) return;
  const double low = std::max(steepest.where() - spacing, profile_.start);
  const double high = std::min(steepest.where() + spacing, profile_.end);
  const auto [s, slope] = boost::math::tools::brent_find_minima(celerity_slope, low, high, 40);
  steepest.add(slope, s);
  const double celerity = sw::celerity(gravity_, profile_.depth(steepest.where()));
  breaking_time_ = -1 / (3 * steepest.value());
  breaking_place_ = steepest.where() + (3 * celerity - 2 * still_celerity_) * breaking_time_;
}

SimpleWave SimpleWave::hump(double gravity, double still_depth, double amplitude, double centre, double length) {
  require_finite("amplitude", amplitude);
  require_finite("centre", centre);
  require_all_positive(
      {{"length", length}, {"still_depth", still_depth}, {"still_depth + amplitude", still_depth + amplitude}});
  require_that(std::abs(centre) <= farthest * length,
               "centre = {:.17g} is out of range: must be in [{:g}, {:g}], a million lengths of the hump; farther "
               "away its places have too few digits",
               centre, -farthest * length, farthest * length);
  const double wavenumber = std::numbers::pi / length;
  return {gravity, still_depth,
          Profile{[=](double x) {
                    const double cosine = std::cos(wavenumber * (x - centre));
                    return still_depth + amplitude * cosine * cosine * cosine * cosine * cosine * cosine;
                  },
                  [=](double x) {
                    const double cosine = std::cos(wavenumber * (x - centre));
                    return -6 * amplitude * wavenumber * cosine * cosine * cosine * cosine * cosine *
                           std::sin(wavenumber * (x - centre));
                  },
                  centre - 0.5 * length, centre + 0.5 * length}};
}

sw::State SimpleWave::at(double x, double t) const {
  require_finite("x", x);
  require_not_negative("t", t);
  require_that(t < breaking_time_, "t = {:.17g} is out of range: the wave breaks at t = {:.9g}", t, breaking_time_);
  const double drift = still_celerity_ * t;
  if (x - drift <= profile_.start || x - drift >= profile_.end) {
    return {still_celerity_ * still_celerity_ / gravity_, 0};
  }
  // F(s) = s + (3 c(s) - 2 c0) t - x increases with s until the wave breaks and changes sign on [start, end].
  const auto characteristic = [&](double s) {
    const double c = sw::celerity(gravity_, profile_.depth(s));
    const double slope = 0.5 * gravity_ * profile_.slope(s) / c;
    return std::pair(s + (3 * c - 2 * still_celerity_) * t - x, 1 + 3 * slope * t);
  };
  std::uintmax_t iterations = 200;
  const double guess = std::min(std::max(x - drift, profile_.start), profile_.end);
  // Newton's last step doubles the digits, so 50 of the 53 bits asked for arrive as all.
  const double s =
      boost::math::tools::newton_raphson_iterate(characteristic, guess, profile_.start, profile_.end, 50, iterations);
  const double depth = profile_.depth(s);
  const double c = sw::celerity(gravity_, depth);
  // 2 (c - c0) with the difference of depths instead of the difference of roots.
  const double still_depth = still_celerity_ * still_celerity_ / gravity_;
  return {depth, 2 * gravity_ * (depth - still_depth) / (c + still_celerity_)};
}

// A root found to 50 bits and two formulas; a place is rounded by half an ulp of x, and the surface rises by up to six
// heights over a length.
double SimpleWave::uncertainty() const {
  const double far = std::max(std::abs(profile_.start), std::abs(profile_.end)) / (profile_.end - profile_.start);
  return (50 + 6 * far) * epsilon;
}

SelfTest SimpleWave::self_test() const {
  // The water of the hump is neither lost nor gained: its area at half the breaking time against that at t = 0.
  const double t =
      std::isfinite(breaking_time_) ? 0.5 * breaking_time_ : (profile_.end - profile_.start) / still_celerity_;
  const double still_depth = still_celerity_ * still_celerity_ / gravity_;
  const auto area = [&](double time) {
    const double left = profile_.start + still_celerity_ * time;
    return integral<30>([&](double x) { return at(x, time).depth - still_depth; }, left,
                        left + (profile_.end - profile_.start), 16);
  };
  const double depth =
      worst(0, 4, [&](int i) { return profile_.depth(profile_.start + 0.25 * i * (profile_.end - profile_.start)); });
  return {{"the area of the hump is constant, over the water's",
           std::abs(area(t) - area(0)) / (depth * (profile_.end - profile_.start)), 1e-12 + 2 * uncertainty(),
           "16 panels of 30 Gauss points; the profile at half the breaking time is smooth; twice the slope of t = 0 "
           "times the rounding of x"}};
}

static_assert(ReferenceSolution<SimpleWave>);

ExactSolution simple_wave_entry() {
  return Entry<SimpleWave>{
      .name = "simple_wave",
      .title = "A smooth hump cos^6 runs to the right and steepens until it breaks",
      .citation = "Stoker, Water Waves (1957), section 10.3; Whitham, Linear and Nonlinear Waves (1974), section 13.10",
      .formula = "u = 2 (c - c0), x = s + (3 c(s) - 2 c0) t; breaks at t = -1/(3 min c'(s))",
      .parameters = {{"still_depth", "m", 1, 1e-9, 1e6, "depth of the still water"},
                     {"amplitude", "m", 0.2, -1e6, 1e6, "height of the hump, above -still_depth"},
                     {"centre", "m", 6, -1e9, 1e9, "middle of the hump at t = 0"},
                     {"length", "m", 6, 1e-9, 1e9, "length of the hump"},
                     gravity_parameter()},
      .inputs = {position_x, time_t},
      .outputs = {depth_h, {"u", "m/s", "velocity"}},
      .scalars = {{"breaking_time", "s", "when the wave becomes vertical; no solution from then on",
                   &SimpleWave::breaking_time},
                  {"breaking_place", "m", "where it does", &SimpleWave::breaking_place}},
      .make = made_by(&SimpleWave::hump, "gravity", "still_depth", "amplitude", "centre", "length"),
      .row = state_row<SimpleWave>};
}

}  // namespace seiche::exact
