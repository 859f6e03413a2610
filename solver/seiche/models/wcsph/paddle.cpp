#include "seiche/models/wcsph/paddle.hpp"

#include <cmath>

#include "seiche/require.hpp"

namespace seiche::wcsph {

PointMotion carried(const Pose& pose, const Pose& rate, double hinge_x, double hinge_z, double x, double z) {
  const double cosine = std::cos(pose.angle);
  const double sine = std::sin(pose.angle);
  const double along = (x - hinge_x) * cosine + (z - hinge_z) * sine;
  const double up = (z - hinge_z) * cosine - (x - hinge_x) * sine;
  return {.x = hinge_x + along + pose.displacement,
          .z = hinge_z + up,
          .u = rate.angle * up + rate.displacement,
          .w = -rate.angle * along};
}

Paddle piston(double stroke, double frequency) {
  require_finite("stroke", stroke);
  require_positive("frequency", frequency);
  return {.hinge_x = 0,
          .hinge_z = 0,
          .pose = [=](double time) -> Pose { return {.displacement = stroke / 2 * std::sin(frequency * time)}; },
          .rate = [=](double time) -> Pose {
            return {.displacement = frequency * stroke / 2 * std::cos(frequency * time)};
          }};
}

Paddle flap(double hinge_x, double hinge_z, double depth, double stroke, double frequency) {
  require_finite("hinge_x", hinge_x);
  require_finite("hinge_z", hinge_z);
  require_positive("depth", depth);
  require_finite("stroke", stroke);
  require_positive("frequency", frequency);
  const auto slope = [=](double time) { return stroke / (2 * depth) * std::sin(frequency * time); };
  const auto slope_rate = [=](double time) { return frequency * stroke / (2 * depth) * std::cos(frequency * time); };
  return {.hinge_x = hinge_x,
          .hinge_z = hinge_z,
          .pose = [=](double time) -> Pose { return {.angle = std::atan(slope(time))}; },
          .rate = [=](double time) -> Pose { return {.angle = slope_rate(time) / (1 + slope(time) * slope(time))}; }};
}

}  // namespace seiche::wcsph
