#include "seiche/models/wcsph/particles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::wcsph {

void Particles::add(double x_, double z_, double mass_, double density_, Kind kind_, double u_, double w_,
                    std::int32_t body_) {
  identity.push_back(static_cast<std::int32_t>(size()));
  x.push_back(x_);
  z.push_back(z_);
  u.push_back(u_);
  w.push_back(w_);
  density.push_back(density_);
  mass.push_back(mass_);
  kind.push_back(kind_);
  body.push_back(body_);
}

std::size_t Particles::count(Kind wanted) const {
  return static_cast<std::size_t>(std::count(kind.begin(), kind.end(), wanted));
}

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

void check_particles(const Particles& particles, std::span<const Paddle> paddles) {
  for (std::size_t k = 0; k < paddles.size(); ++k) {
    if (paddles[k].pose && paddles[k].rate) continue;
    throw std::invalid_argument(
        fmt::format("paddle {} has no {}: must have pose and rate", k, paddles[k].pose ? "rate" : "pose"));
  }
  const std::size_t n = particles.size();
  require_that(n != 0, "particles: there are none");
  for (const std::size_t size :
       {particles.z.size(), particles.u.size(), particles.w.size(), particles.density.size(), particles.mass.size(),
        particles.kind.size(), particles.body.size(), particles.identity.size()}) {
    require_that(size == n, "particles: an array of {} beside x of {}", size, n);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto name = [i](std::string_view quantity) { return fmt::format("{} of particle {}", quantity, i); };
    for (const auto& [quantity, value] : {std::pair{"x", particles.x[i]}, std::pair{"z", particles.z[i]},
                                          std::pair{"u", particles.u[i]}, std::pair{"w", particles.w[i]}}) {
      if (!std::isfinite(value)) require_finite(name(quantity), value);
    }
    for (const auto& [quantity, value] :
         {std::pair{"density", particles.density[i]}, std::pair{"mass", particles.mass[i]}}) {
      if (!(value > 0 && std::isfinite(value))) require_positive(name(quantity), value);
    }
    const std::int32_t body = particles.body[i];
    require_that(
        !(particles.kind[i] == Kind::paddle && !(body >= 0 && static_cast<std::size_t>(body) < paddles.size())),
        "particle {} belongs to paddle {}, but there are {} paddles", i, body, paddles.size());
  }
}

}  // namespace seiche::wcsph
