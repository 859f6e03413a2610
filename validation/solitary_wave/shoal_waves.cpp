#include "validation/solitary_wave/shoal_waves.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "seiche/exact/solitary_asymptotic.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/layer.hpp"

namespace seiche::validation {
namespace {

/// Of a row of nodes at a place: the parabola through the three nearest.
double elevation_at(std::span<const double> x, std::span<const double> z, double place) {
  const auto after = std::upper_bound(x.begin() + 1, x.end() - 1, place);
  auto k = static_cast<std::size_t>(after - x.begin());
  if (place - x[k - 1] < x[k] - place) --k;
  k = std::clamp<std::size_t>(k, 1, x.size() - 2);
  const double left = (z[k] - z[k - 1]) / (x[k] - x[k - 1]);
  const double right = (z[k + 1] - z[k]) / (x[k + 1] - x[k]);
  const double bend = (right - left) / (x[k + 1] - x[k - 1]);
  return z[k] + (place - x[k]) * (left + bend * (place - x[k - 1]));
}

struct Cells {
  std::size_t columns, rows;
};

Cells cells_of(const ShoalWave& wave) {
  return {static_cast<std::size_t>(std::lround((ShoalWave::end - ShoalWave::begin) / wave.spacing())),
          static_cast<std::size_t>(std::lround(ShoalWave::width / wave.spacing()))};
}

/// @param surface  x and z of the surface nodes of a flow
template <class Flow, class Surface>
ShoalRun followed(Flow& flow, const ShoalWave& wave, const Surface& surface) {
  ShoalRun run;
  const double energy = flow.energy();
  const auto observe = [&] {
    const auto [x, z] = surface(flow);
    const std::size_t row = flow.shape().columns + 1;
    run.time.push_back(flow.time());
    for (std::size_t g = 0; g < shoal_gauges.size(); ++g) {
      const ShoalGauge& gauge = shoal_gauges[g];
      const double level = gauge.across ? elevation_at(x.last(row), z.last(row), gauge.x)
                                        : elevation_at(x.first(row), z.first(row), gauge.x);
      run.elevation[g].push_back(level);
      run.highest[g].add(flow.time(), level);
    }
    run.energy_defect.add(flow.energy() / energy - 1, flow.time());
  };
  observe();
  march(flow, wave.time, wave.tau(), observe);
  return run;
}

}  // namespace

std::shared_ptr<const PlanBottom> ShoalWave::bottom() const {
  constexpr double lines = 0.25;
  return std::make_shared<SplineBottom>(
      SplineBottom::sampled({.begin = begin - 1, .end = end + 1, .south = -1, .north = width + 1, .spacing = lines},
                            [this](double x, double y) {
                              const double inside = 1 - (std::pow(x - top, 2) + y * y) / (radius * radius);
                              return -1 + (inside > 0 ? height * inside * inside * inside : 0.0);
                            }));
}

ShoalRun run_hexahedra(const ShoalWave& wave) {
  const exact::SolitaryWave solitary(wave.amplitude);
  const Cells cells = cells_of(wave);
  lagrangian_mesh_3d::Mesh mesh = lagrangian_mesh_3d::layer_mesh(
      {.begin = ShoalWave::begin,
       .end = ShoalWave::end,
       .south = 0,
       .north = ShoalWave::width,
       .columns = cells.columns,
       .rows = cells.rows,
       .layers = wave.layers,
       .elevation = [&](double x, double) { return solitary.elevation(x - ShoalWave::crest); },
       .bottom = wave.bottom()});
  const std::vector<lagrangian_mesh_3d::Vector> velocities = lagrangian_mesh_3d::impulsive_start(
      mesh, [&](double x, double) { return solitary.surface_potential(x - ShoalWave::crest); });
  lagrangian_mesh_3d::Flow flow(std::move(mesh), velocities);
  return followed(flow, wave, [](const auto& f) { return std::pair{f.surface_x(), f.surface_z()}; });
}

ShoalRun run_plan(const ShoalWave& wave) {
  const exact::SerreSolitary solitary(wave.amplitude);
  const Cells cells = cells_of(wave);
  dispersive_shallow_water_2d::Flow flow(
      dispersive_shallow_water_2d::rectangular_lattice(
          {.begin = ShoalWave::begin,
           .end = ShoalWave::end,
           .south = 0,
           .north = ShoalWave::width,
           .columns = cells.columns,
           .rows = cells.rows,
           .elevation = [&](double x, double) { return solitary.elevation(x - ShoalWave::crest); },
           .bottom = wave.bottom()}),
      [&](double x, double) {
        const double u = solitary.depth_averaged_velocity(x - ShoalWave::crest);
        const double w = (u - solitary.speed()) * solitary.elevation_slope(x - ShoalWave::crest);
        return dispersive_shallow_water_2d::Velocity{u, 0, w};
      });
  return followed(flow, wave, [](const auto& f) { return std::pair{f.x(), f.z()}; });
}

}  // namespace seiche::validation
