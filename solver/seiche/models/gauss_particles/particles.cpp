#include "seiche/models/gauss_particles/particles.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::gauss_particles {

void Particles::add(double at_x, double at_y, double of_mass) {
  x.push_back(at_x);
  y.push_back(at_y);
  mass.push_back(of_mass);
}

void require_particles(const Particles& particles) {
  require_that(particles.x.size() == particles.y.size() && particles.x.size() == particles.mass.size(),
               "particles: {} x, {} y, {} masses; allowed: as many of each", particles.x.size(), particles.y.size(),
               particles.mass.size());
  bool massive = false;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    require_that(std::isfinite(particles.x[k]) && std::isfinite(particles.y[k]),
                 "particle {} is at ({:g}, {:g}); allowed: finite", k, particles.x[k], particles.y[k]);
    require_that(particles.mass[k] >= 0 && std::isfinite(particles.mass[k]),
                 "mass of particle {} = {:g}; allowed: non-negative and finite, 0 for markers", k, particles.mass[k]);
    massive = massive || particles.mass[k] > 0;
  }
  require_that(massive, "{} particles, none of them with a mass; allowed: at least one", particles.size());
}

Particles layer(const Layer& layer) {
  require_finite("begin", layer.begin);
  require_finite("end", layer.end);
  require_at_least("columns", static_cast<long>(layer.columns), 1);
  require_at_least("rows", static_cast<long>(layer.rows), 1);
  require_positive("density", layer.density);
  require_positive("end - begin", layer.end - layer.begin);
  require_that(layer.surface && layer.bottom, "layer without a surface or without a bottom");
  if (layer.end_corrected) require_at_least("rows, for end-corrected masses,", static_cast<long>(layer.rows), 6);
  constexpr std::array<double, 3> end_weights{13.0 / 12, 7.0 / 8, 25.0 / 24};
  Particles particles;
  const double width = (layer.end - layer.begin) / static_cast<double>(layer.columns);
  for (std::size_t i = 0; i < layer.columns; ++i) {
    const double x = layer.begin + width * (static_cast<double>(i) + 0.5);
    const double bottom = layer.bottom(x);
    const double depth = layer.surface(x) - bottom;
    require_that(depth > 0, "depth = {:g} at x = {:g}; allowed: positive", depth, x);
    const double height = depth / static_cast<double>(layer.rows);
    for (std::size_t j = 0; j < layer.rows; ++j) {
      const std::size_t from_end = std::min(j, layer.rows - 1 - j);
      const double weight = layer.end_corrected && from_end < 3 ? end_weights[from_end] : 1.0;
      particles.add(x, bottom + height * (static_cast<double>(j) + 0.5), weight * layer.density * width * height);
    }
  }
  const double spacing = (layer.end - layer.begin) /
                         static_cast<double>(layer.markers - (layer.marker_at_end && layer.markers > 1 ? 1 : 0));
  for (std::size_t k = 0; k < layer.markers; ++k) {
    const double x = layer.begin + spacing * static_cast<double>(k);
    particles.add(x, layer.surface(x), 0);
  }
  return particles;
}

Particles disc(double radius, std::size_t rings, std::size_t markers, double density) {
  require_positive("radius", radius);
  require_at_least("rings", static_cast<long>(rings), 1);
  require_positive("density", density);
  Particles particles;
  const auto on_ring = [&](double r, std::size_t count, double mass) {
    for (std::size_t k = 0; k < count; ++k) {
      const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
      particles.add(r * std::cos(angle), r * std::sin(angle), mass);
    }
  };
  const double width = radius / static_cast<double>(rings);
  for (std::size_t i = 1; i <= rings; ++i) {
    const double inner = width * static_cast<double>(i - 1);
    const double outer = width * static_cast<double>(i);
    const double area = std::numbers::pi * (outer * outer - inner * inner);
    const std::size_t count = 3 * (2 * i - 1);
    on_ring(std::sqrt((inner * inner + outer * outer) / 2), count, density * area / static_cast<double>(count));
  }
  on_ring(radius, markers, 0);
  return particles;
}

}  // namespace seiche::gauss_particles
