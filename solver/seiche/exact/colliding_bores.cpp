#include "seiche/exact/colliding_bores.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"

namespace seiche::exact {

namespace {

double checked_gap(double left_start, double right_start) {
  if (!(right_start > left_start)) {
    throw std::invalid_argument(
        fmt::format("right_start = {:.17g} is out of range: must exceed left_start = {:g}", right_start, left_start));
  }
  return right_start - left_start;
}

}  // namespace

CollidingBores::CollidingBores(double gravity, double left, double middle, double right, double left_start,
                               double right_start)
    : left_(gravity, middle, left, 0, left_start),
      right_(gravity, middle, right, 0, -right_start),
      time_(checked_gap(left_start, right_start) / (left_.speed() + right_.speed())),
      after_(gravity, left_.behind(), {right, -right_.behind_velocity()}, left_.position(time_)) {}

shallow_water::State CollidingBores::at(double x, double t) const {
  require_finite("x", x);
  require_not_negative("t", t);
  if (t >= time_) return after_.at(x, t - time_);
  if (x < left_.position(t)) return after_.left();
  return x > -right_.position(t) ? after_.right() : left_.ahead();
}

std::vector<double> CollidingBores::breakpoints(double t) const {
  if (t >= time_) return after_.breakpoints(t - time_);
  return {left_.position(t), -right_.position(t)};
}

Provenance CollidingBores::provenance() {
  return {
      "Stoker, Water Waves (1957), sections 10.6-10.8",
      "two bores until (right_start - left_start)/(a_left + a_right), then the Riemann problem of the states behind"};
}

}  // namespace seiche::exact
