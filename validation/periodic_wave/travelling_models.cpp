#include "validation/periodic_wave/travelling_models.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/instruments/processor_time.hpp"
#include "validation/instruments/surface_points.hpp"
#include "validation/periodic_wave/attenuation.hpp"
#include "validation/studies/wcsph/periodic_water.hpp"

namespace seiche::validation {
namespace {

using exact::StokesWave;

/// The surface itself is the end of the exact field: points above it by rounding are put on it.
Point velocity_at(const StokesWave& wave, Point at) {
  const auto v = wave.velocity(at.x, std::min(at.y, wave.elevation(at.x) - 1e-13));
  return {v.u, v.v};
}

/// Exact path of a particle from where it is at the beginning.
class Path {
 public:
  Path(const StokesWave& wave, Point from, long periods) : step_(period_of(wave) / steps) {
    // To a step beyond the last period, by the classical Runge-Kutta method.
    for (long n = 0; n <= steps * periods + 1; ++n) {
      const double t = static_cast<double>(n) * step_;
      const auto rate = [&](Point at, double later) {
        return velocity_at(wave, {at.x - wave.phase_speed() * (t + later), at.y});
      };
      const auto moved = [&](Point v, double h) { return Point{from.x + h * v.x, from.y + h * v.y}; };
      const Point k1 = rate(from, 0);
      const Point k2 = rate(moved(k1, step_ / 2), step_ / 2);
      const Point k3 = rate(moved(k2, step_ / 2), step_ / 2);
      const Point k4 = rate(moved(k3, step_), step_);
      places_.push_back(from);
      velocities_.push_back(k1);
      from = moved({(k1.x + 2 * k2.x + 2 * k3.x + k4.x) / 6, (k1.y + 2 * k2.y + 2 * k3.y + k4.y) / 6}, step_);
    }
  }

  [[nodiscard]] Point position(double t) const {
    const auto [k, s] = interval(t);
    const double a = (1 + 2 * s) * (1 - s) * (1 - s);
    const double b = s * (1 - s) * (1 - s) * step_;
    const double c = s * s * (3 - 2 * s);
    const double d = s * s * (s - 1) * step_;
    const auto cubic = [&, k = k](double Point::*of) {
      return a * places_[k].*of + b * velocities_[k].*of + c * places_[k + 1].*of + d * velocities_[k + 1].*of;
    };
    return {cubic(&Point::x), cubic(&Point::y)};
  }
  [[nodiscard]] Point velocity(double t) const {
    const auto [k, s] = interval(t);
    const double a = 6 * s * (s - 1) / step_;
    const double b = (1 - s) * (1 - 3 * s);
    const double d = s * (3 * s - 2);
    const auto slope = [&, k = k](double Point::*of) {
      return a * (places_[k].*of - places_[k + 1].*of) + b * velocities_[k].*of + d * velocities_[k + 1].*of;
    };
    return {slope(&Point::x), slope(&Point::y)};
  }

 private:
  static constexpr int steps = 400;

  [[nodiscard]] std::pair<std::size_t, double> interval(double t) const {
    const double at = std::max(0.0, t / step_);
    const std::size_t k = std::min(static_cast<std::size_t>(at), places_.size() - 2);
    return {k, at - static_cast<double>(k)};
  }

  double step_;
  std::vector<Point> places_, velocities_;
};

/// Both ends of a mesh, on exact paths.
lagrangian_mesh_2d::PrescribedSide led(const StokesWave& wave, long periods) {
  const auto paths = std::make_shared<std::map<std::pair<double, double>, Path>>();
  const auto path = [paths, wave, periods](Point from) -> const Path& {
    return paths->try_emplace({from.x, from.y}, wave, from, periods).first->second;
  };
  return {.position = [path](Point from, double t) { return path(from).position(t); },
          .velocity = [path](Point from, double t) { return path(from).velocity(t); }};
}

PeriodicWater water_of(const StokesWave& wave) {
  return {.period = wave.wavelength(),
          .depth = wave.mean_depth(),
          .gravity = wave.gravity(),
          .highest = 4 * wave.amplitude(),
          .elevation = [wave](double x) { return wave.elevation(x); },
          .velocity = [wave](Point at) { return velocity_at(wave, at); },
          .pressure =
              [wave](Point at) {
                const Point v = velocity_at(wave, at);
                const double relative = v.x - wave.phase_speed();
                return wave.bernoulli_constant() - 0.5 * (relative * relative + v.y * v.y) - wave.gravity() * at.y;
              }};
}

/// @param began    processor time
/// @param station  advances to an instant and looks
/// @param waves    that the model computed
Followed followed(double began, double size, const std::vector<double>& instants,
                  const std::function<Station(double instant)>& station, double waves = 1) {
  Followed all{.size = size};
  for (const double instant : instants) all.stations.push_back(station(instant));
  all.seconds = (processor_seconds() - began) / waves;
  return all;
}

}  // namespace

double excess_speed(const StokesWave& wave) {
  const double k = wave.wavenumber();
  return wave.phase_speed() / std::sqrt(std::tanh(k) / k) - 1;
}

Followed follow_particles(const StokesWave& wave, long cells, const std::vector<double>& instants) {
  using gauss_particles::SplineSpace;
  const double began = processor_seconds();
  const double length = wave.wavelength();
  const double cell = length / static_cast<double>(cells);
  constexpr long side = 6;
  gauss_particles::Flow flow(
      gauss_particles::layer(
          {.end = length,
           .columns = static_cast<std::size_t>(cells * side),
           .rows = static_cast<std::size_t>(std::lround(wave.mean_depth() / cell * static_cast<double>(side))),
           .surface = [&](double x) { return wave.elevation(x); },
           .bottom = [&](double) { return -wave.mean_depth(); },
           .markers = 20 * static_cast<std::size_t>(cells)}),
      std::make_unique<SplineSpace>(gauss_particles::LatticePlan{.cell_x = cell,
                                                                 .left_wall = 0.0,
                                                                 .period = length,
                                                                 .bottom = true,
                                                                 .ground = {.level = -wave.mean_depth()}},
                                    SplineSpace::Settings{.inner_fraction = 0.9}),
      [&](Point r) { return velocity_at(wave, r); },
      {.gravity = wave.gravity(),
       .penalty = 0,
       .surface = gauss_particles::SurfaceLine{.period = length, .exact_energy = true}});
  const double kinetic = flow.energy();
  return followed(began, cell, instants, [&](double n) -> Station {
    march(flow, n * period_of(wave), particles_courant * cell / wave.phase_speed());
    std::vector<Point> surface = flow.markers();
    for (Point& marker : surface) marker.x = length + std::remainder(marker.x, length);
    std::ranges::sort(surface, {}, &Point::x);
    return {flow.time(), std::move(surface), flow.energy() / kinetic - 1};
  });
}

Followed follow_mesh(const StokesWave& wave, long rows, const std::vector<double>& instants) {
  const double began = processor_seconds();
  const double length = wave.wavelength();
  const double h = wave.mean_depth() / static_cast<double>(rows);
  const long periods = std::lround(std::ceil(instants.back()));
  const long waves = periods == 1 ? 3 : periods + 2 + periods / 2;
  lagrangian_mesh_2d::Mesh mesh = lagrangian_mesh_2d::layer_mesh(
      {.begin = -length,
       .end = static_cast<double>(waves - 1) * length,
       .depth = wave.mean_depth(),
       .columns = static_cast<std::size_t>(std::lround(static_cast<double>(waves) * length / (2 * h))),
       .rows = static_cast<std::size_t>(rows),
       .elevation = [&](double x) { return wave.elevation(x); }});
  mesh.sides.left = mesh.sides.right = led(wave, periods);
  lagrangian_mesh_2d::Flow flow(mesh, [&](Point r) { return velocity_at(wave, r); });
  const auto station = [&](double n) -> Station {
    march(flow, n * period_of(wave), 0.4 * h / std::sqrt(wave.gravity() * wave.mean_depth()));
    std::vector<Point> surface = joined({flow.surface_x(), flow.surface_y()});
    std::erase_if(surface, [&](Point at) { return std::abs(at.x - n * length) > 0.5 * length; });
    return {flow.time(), std::move(surface), nan};
  };
  return followed(began, h, instants, station, static_cast<double>(waves));
}

Followed follow_dispersive(const exact::SerreCnoidal& wave, double period, long cells,
                           const std::vector<double>& instants) {
  using namespace dispersive_shallow_water_1d;
  const double began = processor_seconds();
  const double length = wave.wavelength();
  const double spacing = length / static_cast<double>(cells);
  const Channel channel{
      .bottom = std::make_shared<LevelBottom>(wave.depth()), .period = length, .gravity = wave.gravity()};
  const auto motion = [&](double x) {
    const double depth = wave.depth() + wave.elevation(x);
    // Mass is steady in the frame of the wave: D(depth) = (u - c) depth_x = -Q depth_x/depth.
    return SurfaceMotion{wave.elevation(x), wave.depth_averaged_velocity(x),
                         -wave.discharge() / depth * wave.elevation_slope(x)};
  };
  Flow flow(channel, moved_markers(
                         channel, equal_labels(channel, 0, length, static_cast<std::size_t>(cells)), motion,
                         [&](double x) { return wave.excess_up_to(x); }, 0));
  return followed(began, spacing, instants, [&](double n) -> Station {
    march(flow, n * period, 0.25 * spacing / std::sqrt(wave.gravity() * wave.depth()));
    return {flow.time(), joined({flow.x(), flow.y()}), nan};
  });
}

Followed follow_sph(const StokesWave& wave, long rows, const std::vector<double>& instants) {
  const double began = processor_seconds();
  const PeriodicWater water = water_of(wave);
  wcsph::Flow flow = start_sph(water, wave.mean_depth() / static_cast<double>(rows));
  const double length = wave.wavelength();
  return followed(began, flow.spacing(), instants, [&](double n) -> Station {
    march(flow, n * period_of(wave));
    return {flow.time(), surface_of(flow, water, 0.5 * length, 1.5 * length), nan};
  });
}

}  // namespace seiche::validation
