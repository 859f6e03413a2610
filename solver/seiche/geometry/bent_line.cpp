#include "seiche/geometry/bent_line.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "seiche/require.hpp"

namespace seiche {

namespace {

Point unit(Point direction) {
  return Line({0, 0}, direction).tangent(0);
}

/// Angle from one direction to another, to the left positive; throws unless they are unlike, and not opposite.
double turn(Point before, Point after) {
  const Point from = unit(before);
  const Point to = unit(after);
  const double angle = std::atan2(from.x * to.y - from.y * to.x, dot(from, to));
  constexpr double least = 1e-6;
  constexpr double most = 1.57;
  if (!(std::abs(angle) >= least && std::abs(angle) <= most)) {
    throw std::invalid_argument(
        fmt::format("a line turns by {:g} rad; allowed: {:g} to {:g}, to either side", angle, least, most));
  }
  return angle;
}

struct Vector {
  double x = 0;
  double y = 0;
  friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector operator*(double a, Vector b) { return {a * b.x, a * b.y}; }
};

double sinc(double angle) {
  return angle == 0 ? 1 : std::sin(angle) / angle;
}

}  // namespace

BentLine::BentLine(Point corner, Point before, Point after, double rounding)
    : radius_((require_positive("rounding", rounding), rounding / std::tan(0.5 * std::abs(turn(before, after))))),
      half_(0.5 * radius_ * std::abs(turn(before, after))),
      bend_(std::copysign(1 / radius_, turn(before, after))),
      before_({corner.x - (rounding - half_) * unit(before).x, corner.y - (rounding - half_) * unit(before).y}, before),
      after_({corner.x + (rounding - half_) * unit(after).x, corner.y + (rounding - half_) * unit(after).y}, after) {}

Point BentLine::position(double s) const {
  if (s <= -half_) return before_.position(s);
  if (s >= half_) return after_.position(s);
  const Point foot = before_.position(-half_);
  const Point chord = mean_tangent(-half_, s);
  return {foot.x + (s + half_) * chord.x, foot.y + (s + half_) * chord.y};
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
  const auto line = [](Point t) { return [=](double, double) { return Vector{t.x, t.y}; }; };
  const auto arc = [&](double from, double to) {
    const Point t = tangent(0.5 * (from + to));
    return sinc(0.5 * bend_ * (to - from)) * Vector{t.x, t.y};
  };
  const auto chord = mean<Vector>(s0, s1, line(before_.tangent(0)), arc, line(after_.tangent(0)));
  return {chord.x, chord.y};
}

double BentLine::mean_moment_on_arc(double s0, double s1) const {
  const double middle = 0.5 * (s0 + s1);
  const double half = 0.5 * (s1 - s0);
  return 0.5 * boost::math::quadrature::gauss<double, 10>::integrate(
                   [&](double part) {
                     const double s = middle + half * part;
                     const double y = position(s).y;
                     return 0.5 * y * y * tangent(s).x;
                   },
                   -1, 1);
}

double BentLine::mean_moment_rate(double s0, double s1) const {
  const auto on = [](const Line& line) {
    return [&](double from, double to) { return line.mean_moment_rate(from, to); };
  };
  const auto arc = [&](double from, double to) { return mean_moment_on_arc(from, to); };
  return mean<double>(s0, s1, on(before_), arc, on(after_));
}

double BentLine::moment(double s) const {
  return s * mean_moment_rate(0, s);
}

double BentLine::arc_length_at(Point near) const {
  const double s0 = before_.arc_length_at(near);
  if (s0 <= -half_) return s0;
  const double s1 = after_.arc_length_at(near);
  if (s1 >= half_) return s1;
  const Point foot = before_.position(-half_);
  const Point t = before_.tangent(0);
  const Point from_centre{near.x - foot.x + t.y / bend_, near.y - foot.y - t.x / bend_};
  // Angle at the centre from where the arc begins; outwards there is (t.y, -t.x), to the right.
  const double along = dot(t, from_centre);
  const double outwards = std::copysign(1.0, bend_) * (t.y * from_centre.x - t.x * from_centre.y);
  return std::clamp(radius_ * std::atan2(along, outwards) - half_, -half_, half_);
}

}  // namespace seiche
