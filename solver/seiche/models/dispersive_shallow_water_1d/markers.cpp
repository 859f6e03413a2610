#include "seiche/models/dispersive_shallow_water_1d/markers.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/model_waves.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::dispersive_shallow_water_1d {

namespace {

/// A periodic channel needs a bottom that has its period, as far as the markers tell.
void require_periodic_bottom(const Channel& channel, const std::vector<double>& x, double deepest) {
  const BottomProfile& bottom = *channel.bottom;
  require_that(x.front() + channel.period <= bottom.end(),
               "bottom ends at x = {:.6g}; allowed: at or beyond x[0] + period = {:.6g} in a periodic channel",
               bottom.end(), x.front() + channel.period);
  for (const double place : x) {
    const double image = place + channel.period;
    if (image > bottom.end()) break;
    const double here = bottom.elevation(place);
    const double there = bottom.elevation(image);
    constexpr double roundings = 1e-10;
    require_that(std::abs(there - here) <= roundings * (deepest + std::abs(here)),
                 "bottom is {:.12g} at x = {:.6g} and {:.12g} one period = {:.6g} further; allowed: the same", here,
                 place, there, channel.period);
  }
}

}  // namespace

void Markers::validate(const Channel& channel) const {
  channel.validate();
  const std::size_t n = size();
  require_that(n >= 3, "{} markers; allowed: at least 3", n);
  require_that(y.size() == n && u.size() == n && v.size() == n,
               "markers: {} x, {} y, {} u, {} v; needed: as many of each", n, y.size(), u.size(), v.size());
  // Names are made where they are needed: made for every marker, they were a fifth of the set-up.
  const auto require_finite_at = [](const char* name, std::size_t i, double value) {
    if (!std::isfinite(value)) require_finite(fmt::format("{}[{}]", name, i), value);
  };
  for (std::size_t i = 0; i < n; ++i) {
    require_finite_at("x", i, x[i]);
    require_finite_at("y", i, y[i]);
    require_finite_at("u", i, u[i]);
    require_finite_at("v", i, v[i]);
    if (i > 0)
      require_that(x[i] > x[i - 1], "x[{}] = {:.17g}; allowed: above x[{}] = {:.17g}, markers ascend", i, x[i], i - 1,
                   x[i - 1]);
    require_that(x[i] >= channel.bottom->begin() && x[i] <= channel.bottom->end(),
                 "x[{}] = {:.6g}; allowed: [{:.6g}, {:.6g}], where the bottom is given", i, x[i],
                 channel.bottom->begin(), channel.bottom->end());
    require_finite_at("slope of the bottom at x", i, channel.bottom->slope(x[i]));
  }
  require_that(!channel.periodic() || x.back() - x.front() < channel.period,
               "x[{}] = {:.17g}; allowed: below x[0] + period = {:.17g}", n - 1, x.back(), x.front() + channel.period);
  double deepest = 0;
  for (std::size_t i = 0; i < n; ++i) deepest = std::max(deepest, y[i] - channel.bottom->elevation(x[i]));
  if (channel.periodic()) require_periodic_bottom(channel, x, deepest);
  for (std::size_t i = 0; i < n; ++i) {
    const double depth = y[i] - channel.bottom->elevation(x[i]);
    const bool tip =
        !channel.periodic() && ((i == 0 && channel.left == End::tip) || (i == n - 1 && channel.right == End::tip));
    require_that(!tip || std::abs(depth) <= 1e-12 * deepest,
                 "y[{}] = {:.17g}; allowed: the bottom's elevation {:.17g} to 1e-12 of the largest depth, it is a "
                 "tip",
                 i, y[i], y[i] - depth);
    require_that(tip || depth > 0, "y[{}] = {:.17g}; allowed: above the bottom, {:.17g}", i, y[i], y[i] - depth);
  }
}

Markers still_markers(const Channel& channel, std::vector<double> x) {
  Markers markers;
  markers.x = std::move(x);
  for (auto* array : {&markers.y, &markers.u, &markers.v}) array->assign(markers.size(), 0.0);
  markers.validate(channel);
  return markers;
}

std::vector<double> equal_labels(const Channel& channel, double begin, double end, std::size_t cells) {
  require_at_least("cells", static_cast<long>(cells), 2);
  std::vector<double> labels(channel.periodic() ? cells : cells + 1);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(cells);
    labels[i] = (1 - s) * begin + s * end;
  }
  return labels;
}

namespace {

/// x with  int_anchor^x elevation = int_x^label depth at rest:  Newton, whose derivative is the depth of the water.
double place_of_label(const BottomProfile& bottom, double label, const std::function<SurfaceMotion(double)>& motion,
                      const std::function<double(double)>& excess_from_anchor) {
  double x = label;
  constexpr int most_iterations = 60;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const double depth = motion(x).elevation - bottom.elevation(x);
    if (!(depth > 0)) break;
    const double missing = excess_from_anchor(x) - (x - label) * bottom.mean(label, x);
    const double change = missing / depth;
    x -= change;
    if (std::abs(change) <= 4e-16 * (std::abs(x) + depth)) break;
  }
  return x;
}

}  // namespace

Markers moved_markers(const Channel& channel, std::span<const double> labels,
                      const std::function<SurfaceMotion(double)>& motion, const std::function<double(double)>& excess,
                      double anchor) {
  channel.validate();
  const BottomProfile& bottom = *channel.bottom;
  const double excess_at_anchor = excess(anchor);
  Markers markers;
  for (const double label : labels) {
    const double x =
        label == anchor ? label
                        : place_of_label(bottom, label, motion, [&](double s) { return excess(s) - excess_at_anchor; });
    const SurfaceMotion surface = motion(x);
    markers.x.push_back(x);
    markers.y.push_back(surface.elevation);
    markers.u.push_back(surface.velocity);
    markers.v.push_back(bottom.slope(x) * surface.velocity + surface.thickening);
  }
  if (!channel.periodic()) {
    const auto settle = [&](End end, std::size_t i) {
      if (end == End::tip) markers.y[i] = bottom.elevation(markers.x[i]);
      if (end == End::wall) markers.u[i] = 0;
    };
    settle(channel.left, 0);
    settle(channel.right, markers.size() - 1);
  }
  markers.validate(channel);
  return markers;
}

Markers solitary_markers(const Channel& channel, double begin, double end, double spacing, SolitaryStart wave) {
  channel.validate();
  require_positive("spacing", spacing);
  require_that(end - begin > 3 * spacing, "end = {:.6g}; allowed: above begin + 3 spacing = {:.6g}", end,
               begin + 3 * spacing);
  require_within("crest", wave.crest, begin, end);
  const exact::SerreSolitary solitary(wave.amplitude, wave.depth, channel.gravity, channel.alpha);
  const auto motion = [&](double x) {
    const double s = x - wave.crest;
    const double elevation = solitary.elevation(s);
    const double depth = wave.depth + elevation;
    const double velocity = solitary.speed() * elevation / depth;
    const double direction = wave.direction >= 0 ? 1.0 : -1.0;
    // Mass is steady in the frame of the wave: D(depth) = -depth u_x = -c (depth_0/depth) elevation_x.
    const double thickening = -solitary.speed() * wave.depth / depth * solitary.elevation_slope(s);
    return SurfaceMotion{elevation, direction * velocity, direction * thickening};
  };
  const auto excess = [&](double x) { return solitary.excess_up_to(x - wave.crest); };
  const auto cells_over = [&](double length) {
    return static_cast<std::size_t>(std::max(3.0, std::round(length / spacing)));
  };
  const bool right_tip = !channel.periodic() && channel.right == End::tip;
  const bool left_tip = !channel.periodic() && channel.left == End::tip;
  require_that(
      !(right_tip && left_tip),
      "a solitary wave between two tips; allowed: one tip at most, the other end gives way to the wave's volume");
  if (right_tip || left_tip) {
    const double shore = right_tip ? end : begin;
    const std::size_t cells = cells_over(end - begin);
    const double length = spacing * static_cast<double>(cells);
    const std::vector<double> labels = right_tip ? equal_labels(channel, shore - length, shore, cells)
                                                 : equal_labels(channel, shore, shore + length, cells);
    return moved_markers(channel, labels, motion, excess, shore);
  }
  // Labels of the ends: what the wave adds to the water between them and its crest.
  const double left = begin + (excess(begin) - excess(wave.crest)) / wave.depth;
  const double right = end + (excess(end) - excess(wave.crest)) / wave.depth;
  return moved_markers(channel, equal_labels(channel, left, right, cells_over(right - left)), motion, excess,
                       wave.crest);
}

}  // namespace seiche::dispersive_shallow_water_1d
