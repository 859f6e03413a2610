#include "seiche/geometry/curve.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/geometry/gauss_mean.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche {

Line::Line(Point origin, Point direction) : origin_(origin) {
  for (const double value : {origin.x, origin.y, direction.x, direction.y}) require_finite("line", value);
  const double length = std::hypot(direction.x, direction.y);
  require_positive("length of the line's direction", length);
  tangent_ = {direction.x / length, direction.y / length};
}

double Line::mean_moment_rate(double s0, double s1) const {
  const double y0 = origin_.y + s0 * tangent_.y;
  const double y1 = origin_.y + s1 * tangent_.y;
  return tangent_.x * (y0 * y0 + y0 * y1 + y1 * y1) / 6;
}

GraphCurve::GraphCurve(Function elevation, Function slope, Function second_derivative, double begin, double end,
                       std::size_t panels)
    : elevation_(std::move(elevation)),
      slope_(std::move(slope)),
      second_derivative_(std::move(second_derivative)),
      begin_(begin),
      end_(end) {
  require_that(elevation_ && slope_ && second_derivative_,
               "elevation, slope and second_derivative of a curve must be functions");
  require_finite("begin of the curve", begin);
  require_finite("end of the curve", end);
  require_positive("end - begin of the curve", end - begin);
  require_at_least("panels", static_cast<long>(panels), 1);
  width_ = (end - begin) / static_cast<double>(panels);
  knots_.push_back(0);
  moments_.push_back(0);
  for (std::size_t k = 0; k < panels; ++k) {
    const double from = panel_begin(k);
    knots_.push_back(knots_.back() + width_ * mean_stretch(from, from + width_));
    moments_.push_back(moments_.back() + width_ * mean_moment(from, from + width_));
    require_finite("arc length of the curve", knots_.back());
    require_finite("moment of the curve", moments_.back());
  }
}

double GraphCurve::mean_stretch(double from, double to) const {
  return gauss_mean([&](double x) { return std::hypot(1.0, slope_(x)); }, from, to);
}

double GraphCurve::mean_moment(double from, double to) const {
  return gauss_mean([&](double x) { return 0.5 * elevation_(x) * elevation_(x); }, from, to);
}

std::size_t GraphCurve::panel(double x) const {
  return static_cast<std::size_t>(std::min(std::floor((x - begin_) / width_), static_cast<double>(knots_.size() - 2)));
}

double GraphCurve::place(double s) const {
  if (!(s >= 0 && s <= length())) {
    const double x = s < 0 ? begin_ : end_;
    throw Infeasible(x, "a node has left its curve: arc length {:g}; allowed: {:g} to {:g}", s, 0.0, length());
  }
  const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, s);
  const auto k = static_cast<std::size_t>(above - knots_.begin()) - 1;
  const double from = panel_begin(k);
  double x = from + width_ * (s - knots_[k]) / (knots_[k + 1] - knots_[k]);
  constexpr int most = 20;
  for (int i = 0; i < most; ++i) {
    const double step = (s - knots_[k] - (x - from) * mean_stretch(from, x)) / std::hypot(1.0, slope_(x));
    x += step;
    if (std::abs(step) <= 1e-15 * (width_ + std::abs(x))) break;
  }
  return x;
}

Point GraphCurve::position(double s) const {
  const double x = place(s);
  return {x, elevation_(x)};
}

Point GraphCurve::tangent(double s) const {
  const double slope = slope_(place(s));
  const double stretch = std::hypot(1.0, slope);
  return {1 / stretch, slope / stretch};
}

Point GraphCurve::curvature(double s) const {
  const double x = place(s);
  const double slope = slope_(x);
  const double square = 1 + slope * slope;
  const double bend = second_derivative_(x) / (square * square);
  return {-slope * bend, bend};
}

Point GraphCurve::mean_tangent(double s0, double s1) const {
  const double from = place(s0);
  const double to = place(s1);
  const double stretch = mean_stretch(from, to);
  return {1 / stretch, gauss_mean(slope_, from, to) / stretch};
}

double GraphCurve::moment(double s) const {
  const double x = place(s);
  const std::size_t k = panel(x);
  return moments_[k] + (x - panel_begin(k)) * mean_moment(panel_begin(k), x);
}

double GraphCurve::mean_moment_rate(double s0, double s1) const {
  const double from = place(s0);
  const double to = place(s1);
  return mean_moment(from, to) / mean_stretch(from, to);
}

double GraphCurve::arc_length_at(Point near) const {
  const double x = std::clamp(near.x, begin_, end_);
  const std::size_t k = panel(x);
  // The end's may round to more than the curve is long.
  return std::min(knots_[k] + (x - panel_begin(k)) * mean_stretch(panel_begin(k), x), length());
}

namespace {

Point unit(Point direction) {
  return Line({0, 0}, direction).tangent(0);
}

/// Angle from one direction to another, to the left positive; throws unless they are unlike, and not opposite.
double turn(Point before, Point after) {
  const Point from = unit(before);
  const Point to = unit(after);
  const double angle = std::atan2(cross(from, to), dot(from, to));
  constexpr double least = 1e-6;
  constexpr double most = 1.57;
  require_that(std::abs(angle) >= least && std::abs(angle) <= most,
               "a line turns by {:g} rad; allowed: {:g} to {:g}, to either side", angle, least, most);
  return angle;
}

double sinc(double angle) {
  return angle == 0 ? 1 : std::sin(angle) / angle;
}

}  // namespace

BentLine::BentLine(Point corner, Point before, Point after, double rounding)
    : radius_((require_positive("rounding", rounding), rounding / std::tan(0.5 * std::abs(turn(before, after))))),
      half_(0.5 * radius_ * std::abs(turn(before, after))),
      bend_(std::copysign(1 / radius_, turn(before, after))),
      before_(corner - (rounding - half_) * unit(before), before),
      after_(corner + (rounding - half_) * unit(after), after) {}

Point BentLine::position(double s) const {
  if (s <= -half_) return before_.position(s);
  if (s >= half_) return after_.position(s);
  return before_.position(-half_) + (s + half_) * mean_tangent(-half_, s);
}

Point BentLine::tangent(double s) const {
  const Point t = before_.tangent(0);
  if (s <= -half_) return t;
  if (s >= half_) return after_.tangent(0);
  const double angle = bend_ * (s + half_);
  return {t.x * std::cos(angle) - t.y * std::sin(angle), t.y * std::cos(angle) + t.x * std::sin(angle)};
}

Point BentLine::curvature(double s) const {
  if (std::abs(s) >= half_) return {0, 0};
  const Point t = tangent(s);
  return {-bend_ * t.y, bend_ * t.x};
}

template <class Value, class Before, class Arc, class After>
Value BentLine::mean(double s0, double s1, const Before& before, const Arc& arc, const After& after) const {
  const double low = std::min(s0, s1);
  const double high = std::max(s0, s1);
  if (high <= -half_) return before(s0, s1);
  if (low >= half_) return after(s0, s1);
  if (low >= -half_ && high <= half_) return arc(s0, s1);
  Value sum{};
  const auto add = [&](double from, double to, const auto& part) {
    if (to > from) sum = sum + (to - from) / (high - low) * part(from, to);
  };
  add(low, std::min(high, -half_), before);
  add(std::max(low, -half_), std::min(high, half_), arc);
  add(std::max(low, half_), high, after);
  return sum;
}

Point BentLine::mean_tangent(double s0, double s1) const {
  const auto line = [](Point t) { return [=](double, double) { return t; }; };
  const auto arc = [&](double from, double to) { return sinc(0.5 * bend_ * (to - from)) * tangent(0.5 * (from + to)); };
  return mean<Point>(s0, s1, line(before_.tangent(0)), arc, line(after_.tangent(0)));
}

double BentLine::mean_moment_rate(double s0, double s1) const {
  const auto on = [](const Line& line) {
    return [&](double from, double to) { return line.mean_moment_rate(from, to); };
  };
  const auto rate = [&](double s) {
    const double y = position(s).y;
    return 0.5 * y * y * tangent(s).x;
  };
  const auto arc = [&](double from, double to) { return gauss_mean(rate, from, to); };
  return mean<double>(s0, s1, on(before_), arc, on(after_));
}

double BentLine::arc_length_at(Point near) const {
  const double s0 = before_.arc_length_at(near);
  if (s0 <= -half_) return s0;
  const double s1 = after_.arc_length_at(near);
  if (s1 >= half_) return s1;
  const Point t = before_.tangent(0);
  const Point from_centre = near - before_.position(-half_) + Point{t.y / bend_, -t.x / bend_};
  // Angle at the centre from where the arc begins; outwards there is (t.y, -t.x), to the right.
  const double along = dot(t, from_centre);
  const double outwards = std::copysign(1.0, bend_) * (t.y * from_centre.x - t.x * from_centre.y);
  return std::clamp(radius_ * std::atan2(along, outwards) - half_, -half_, half_);
}

}  // namespace seiche
