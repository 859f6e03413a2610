#include "seiche/models/wcsph/input_checks.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"

namespace seiche::wcsph {

void check_particles(const Particles& particles, std::span<const Paddle> paddles) {
  for (std::size_t k = 0; k < paddles.size(); ++k) {
    if (paddles[k].pose && paddles[k].rate) continue;
    throw std::invalid_argument(
        fmt::format("paddle {} has no {}: must have pose and rate", k, paddles[k].pose ? "rate" : "pose"));
  }
  const std::size_t n = particles.size();
  if (n == 0) throw std::invalid_argument("particles: there are none");
  for (const std::size_t size :
       {particles.z.size(), particles.u.size(), particles.w.size(), particles.density.size(), particles.mass.size(),
        particles.kind.size(), particles.body.size(), particles.identity.size()}) {
    if (size != n) throw std::invalid_argument(fmt::format("particles: an array of {} beside x of {}", size, n));
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
    if (particles.kind[i] == Kind::paddle && !(body >= 0 && static_cast<std::size_t>(body) < paddles.size())) {
      throw std::invalid_argument(
          fmt::format("particle {} belongs to paddle {}, but there are {} paddles", i, body, paddles.size()));
    }
  }
}

void check_period(const Settings& settings, double smoothing_length) {
  const double shortest = 3 * support * smoothing_length * (1 + skin);
  for (const auto& [name, period] :
       {std::pair{"period.x", settings.period.x}, std::pair{"period.z", settings.period.z}}) {
    if (period < shortest) {
      throw std::invalid_argument(
          fmt::format("{} = {:.17g} is out of range: must be at least three supports, {:g}", name, period, shortest));
    }
  }
}

void check_distances(const Particles& particles, std::span<const Image> images, std::span<const Cluster> clusters,
                     double spacing) {
  const std::size_t count = particles.size();
  // A lattice that stands exactly at the limit is all right.
  const double nearest_wall = 0.5 * spacing * (1 - 1e-9);
  const double nearest_fluid = 1e-6 * spacing;
  for (const Cluster& cluster : clusters) {
    for (std::int32_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
      const auto a = static_cast<std::size_t>(i);
      if (particles.kind[a] != Kind::fluid) continue;
      for (const std::int32_t* j = cluster.begin; j != cluster.end; ++j) {
        const auto record = static_cast<std::size_t>(*j);
        const Image other = record < count ? Image{*j, 0, 0} : images[record - count];
        const auto b = static_cast<std::size_t>(other.source);
        if (b == a) continue;
        const double x = particles.x[b] + other.shift_x;
        const double z = particles.z[b] + other.shift_z;
        const double distance = std::hypot(particles.x[a] - x, particles.z[a] - z);
        const bool wall = particles.kind[b] != Kind::fluid;
        if (distance >= (wall ? nearest_wall : nearest_fluid)) continue;
        throw std::invalid_argument(fmt::format(
            "particles {} at ({:.9g}, {:.9g}) and {} at ({:.9g}, {:.9g}) are {:.3g} apart: {}", particles.identity[a],
            particles.x[a], particles.z[a], particles.identity[b], x, z, distance,
            wall ? fmt::format("fluid must keep {:g}, half a spacing, from walls", 0.5 * spacing)
                 : fmt::format("two fluid particles must keep {:g}, a millionth of the spacing", nearest_fluid)));
      }
    }
  }
}

}  // namespace seiche::wcsph
