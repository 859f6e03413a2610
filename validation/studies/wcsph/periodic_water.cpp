#include "validation/studies/wcsph/periodic_water.hpp"

#include <algorithm>
#include <cmath>

#include "seiche/divergence.hpp"
#include "validation/instruments/particles/sph_free_surface.hpp"

namespace seiche::validation {

wcsph::Flow start_sph(const PeriodicWater& water, double spacing) {
  const double depth = water.depth;
  wcsph::Settings settings{.kernel = wcsph::KernelName::wendland_c2,
                           .smoothing = 2,
                           .gravity = water.gravity,
                           .density = 1,
                           .sound_speed = 10 * std::sqrt(water.gravity * depth),
                           .viscosity = wcsph::ArtificialViscosity{0.01}};
  const auto pressure = [&](double x, double z) {
    const double inside = water.pressure({x, std::max(z - depth, -depth)});
    return settings.density * (inside + water.gravity * std::max(0.0, -z));
  };
  wcsph::Scene scene = wcsph::periodic_layer({.period = water.period,
                                              .depth = depth,
                                              .elevation = water.elevation,
                                              .velocity =
                                                  [&](double x, double z) {
                                                    const Point v = water.velocity({x, z - depth});
                                                    return wcsph::Velocity{v.x, v.y};
                                                  },
                                              .pressure = pressure,
                                              .spacing = water.period / std::round(water.period / spacing)},
                                             settings);
  const wcsph::TaitFluid fluid(settings.density, settings.sound_speed);
  wcsph::Particles& p = scene.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.kind[i] == wcsph::Kind::wall) p.density[i] = fluid.density_at(pressure(p.x[i], p.z[i]));
  }
  settings.period = scene.period;
  return {scene.particles, scene.spacing, settings, scene.paddles};
}

std::vector<Point> surface_of(const wcsph::Flow& flow, const PeriodicWater& water, double from, double to) {
  wcsph::Box basin = wcsph::unbounded;
  basin.bottom = 0;
  const wcsph::VolumeFraction fraction(flow.particles(), flow.smoothing_length(), basin, flow.settings().kernel,
                                       {.x = water.period});
  const std::vector<wcsph::Contour> curves =
      wcsph::free_surface(fraction, {from, to, 0.5 * water.depth, water.depth + water.highest}, 0.5 * flow.spacing());
  const wcsph::Contour* main = wcsph::main_surface(curves);
  if (main == nullptr) throw Divergence("there is no water surface", flow.time(), flow.steps(), from);
  std::vector<Point> points;
  for (std::size_t k = 0; k < main->x.size(); ++k) points.push_back({main->x[k], main->z[k] - water.depth});
  return points;
}

}  // namespace seiche::validation
