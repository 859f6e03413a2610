#include "validation/instruments/plan/plan_soliton.hpp"

#include <algorithm>
#include <cmath>

#include "seiche/exact/model_waves.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/oscillation.hpp"
#include "validation/instruments/plan/oblique_wave.hpp"

namespace seiche::validation {
namespace {

using exact::SerreSolitary;

constexpr double behind = 30;  // the wave's 4 a exp(-2 kappa s) is 1e-13 there for a = 0.3
constexpr double ahead = 30;

struct Tank {
  double begin, end;
  std::size_t columns;
};

Tank tank_of(const PlanSolitonRun& run) {
  const double length = behind + ahead + std::sqrt(1 + run.amplitude) * run.time;
  const auto columns = static_cast<std::size_t>(std::ceil(length / run.spacing));
  return {-behind, -behind + run.spacing * static_cast<double>(columns), columns};
}

/// At the surface.
dispersive_shallow_water_2d::Velocity velocity_at(const SerreSolitary& wave, double x) {
  const double u = wave.depth_averaged_velocity(x);
  return {u, 0, (u - wave.speed()) * wave.elevation_slope(x)};
}

/// Top of the parabola through the highest node of the south wall and its neighbours.
void add_crest(SolitonTravel& result, double time, const SurfaceLattice& surface) {
  const auto& [columns, rows, x, y, z] = surface;
  Largest highest;
  for (std::size_t k = 1; k < columns; ++k) highest.add(z[k], static_cast<double>(k));
  const auto i = static_cast<std::size_t>(highest.where());
  const double left = (z[i] - z[i - 1]) / (x[i] - x[i - 1]);
  const double curvature = ((z[i + 1] - z[i]) / (x[i + 1] - x[i]) - left) / (x[i + 1] - x[i - 1]);
  const double top = 0.5 * (x[i] + x[i - 1] - left / curvature);
  result.time.push_back(time);
  result.place.push_back(top);
  result.height.push_back(z[i] + (top - x[i]) * (left + curvature * (top - x[i - 1])));
}

template <class Flow>
SolitonTravel travelled(Flow& flow, const PlanSolitonRun& run) {
  SolitonTravel result{.settled = run.settled};
  long steps = 0;
  march(flow, run.time, run.tau, [&] {
    add_crest(result, flow.time(), surface_of(flow));
    if (++steps % 5 == 0) flow.observe();
  });
  flow.observe();
  const auto& energy = flow.ledger().entry("energy");
  result.energy_defect = energy.largest_defect / energy.initial;
  result.volume_defect = flow.ledger().entry("volume_worst").largest_defect /
                         (flow.ledger().entry("mass").initial / static_cast<double>(flow.model().constraints()));
  return result;
}

}  // namespace

std::span<const double> SolitonTravel::from_then(const std::vector<double>& values) const {
  const auto first = std::lower_bound(time.begin(), time.end(), settled);
  return std::span(values).subspan(static_cast<std::size_t>(first - time.begin()));
}

double SolitonTravel::mean_height() const {
  return mean(from_then(height));
}

dispersive_shallow_water_2d::Flow plan_soliton_flow(const PlanSolitonRun& run) {
  const Tank tank = tank_of(run);
  const SerreSolitary wave(run.amplitude);
  auto lattice = dispersive_shallow_water_2d::rectangular_lattice({.begin = tank.begin,
                                                                   .end = tank.end,
                                                                   .north = run.spacing * static_cast<double>(run.rows),
                                                                   .columns = tank.columns,
                                                                   .rows = run.rows});
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    lattice.x[k] = wave.place_of(lattice.x[k]);
    lattice.z[k] = wave.elevation(lattice.x[k]);
  }
  return dispersive_shallow_water_2d::Flow(std::move(lattice), [&](double x, double) { return velocity_at(wave, x); },
                                           run.scheme, {.tolerance = run.tolerance});
}

lagrangian_mesh_3d::Flow layered_soliton_flow(const PlanSolitonRun& run, std::size_t layers) {
  const Tank tank = tank_of(run);
  const SerreSolitary wave(run.amplitude);
  auto mesh = lagrangian_mesh_3d::layer_mesh({.begin = tank.begin,
                                              .end = tank.end,
                                              .north = run.spacing * static_cast<double>(run.rows),
                                              .columns = tank.columns,
                                              .rows = run.rows,
                                              .layers = layers});
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    mesh.x[k] = wave.place_of(mesh.x[k]);
    mesh.z[k] += wave.elevation(mesh.x[k]) * (1 + mesh.z[k]);
  }
  return lagrangian_mesh_3d::Flow(std::move(mesh),
                                  [&](lagrangian_mesh_3d::Place r) {
                                    const auto [u, v, w] = velocity_at(wave, r.x);
                                    return lagrangian_mesh_3d::Vector{u, v, w * (1 + r.z) / (1 + wave.elevation(r.x))};
                                  },
                                  run.scheme, {.tolerance = run.tolerance});
}

SolitonTravel travel(dispersive_shallow_water_2d::Flow& flow, const PlanSolitonRun& run) {
  return travelled(flow, run);
}

SolitonTravel travel(lagrangian_mesh_3d::Flow& flow, const PlanSolitonRun& run) {
  return travelled(flow, run);
}

}  // namespace seiche::validation
