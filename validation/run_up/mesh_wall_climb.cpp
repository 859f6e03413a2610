#include "validation/run_up/mesh_wall_climb.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/instruments/mesh/impulsive_start.hpp"
#include "validation/instruments/mesh/mesh_gauges.hpp"
#include "validation/instruments/peak.hpp"

namespace seiche::validation {

using lagrangian_mesh_2d::Flow;
using lagrangian_mesh_2d::Mesh;

namespace {

constexpr double length = 2 * MeshWallClimb::distance;
constexpr double reach = 2;  // of columns of another width at the wall

/// Ends of columns whose width goes from `spacing` to `at_wall` times that at x = 0, from left to right.
std::vector<double> graded_columns(double spacing, double at_wall) {
  const auto width = [&](double x) { return spacing * (1 + (at_wall - 1) / std::pow(std::cosh(x / reach), 2)); };
  std::vector<double> x{0};
  while (x.back() > -length + width(-length) / 2) x.push_back(x.back() - width(x.back() - width(x.back()) / 2));
  const double scale = -length / x.back();
  for (double& end : x) end *= scale;
  std::reverse(x.begin(), x.end());
  x.front() = -length;
  return x;
}

void set_columns(Mesh& mesh, const std::vector<double>& x, const std::function<double(double)>& elevation) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double top = elevation(x[i]);
    for (std::size_t j = 0; j <= mesh.rows; ++j) {
      const double part = static_cast<double>(j) / static_cast<double>(mesh.rows);
      mesh.x[mesh.node(i, j)] = x[i];
      mesh.y[mesh.node(i, j)] = j == mesh.rows ? top : -1 + (1 + top) * part;
    }
  }
}

}  // namespace

MeshWallClimb MeshWallClimb::with_rows(const exact::SolitaryWave& wave, long rows) {
  const double h2 = 1 / static_cast<double>(rows);
  return {.wave = wave, .spacing = 2 * h2, .rows = rows, .tau = h2 / 5};
}

MeshWallClimb MeshWallClimb::refined(double times) const {
  MeshWallClimb finer = *this;
  finer.spacing /= times;
  finer.rows = std::lround(static_cast<double>(rows) * times);
  finer.tau /= times;
  return finer;
}

Flow MeshWallClimb::start() const {
  const auto elevation = [&](double x) { return wave.elevation(x + distance); };
  const std::vector<double> graded = wall_columns == 1 ? std::vector<double>{} : graded_columns(spacing, wall_columns);
  const auto columns =
      graded.empty() ? static_cast<std::size_t>(std::max(1L, std::lround(length / spacing))) : graded.size() - 1;
  Mesh mesh = lagrangian_mesh_2d::layer_mesh({.begin = -length,
                                              .end = 0,
                                              .depth = 1,
                                              .columns = columns,
                                              .rows = static_cast<std::size_t>(rows),
                                              .elevation = elevation});
  if (!graded.empty()) set_columns(mesh, graded, elevation);
  const mechanics::Scheme scheme{.stepping = stepping};
  if (surface_impulse) {
    const std::vector<Point> velocities =
        impulsive_start(mesh, [&](double x) { return wave.surface_potential(x + distance); });
    return Flow(std::move(mesh), velocities, scheme, settings);
  }
  const auto velocity = [&](Point r) {
    const exact::Velocity v = wave.velocity(r.x + distance, r.y);
    return Point{v.u, v.v};
  };
  return Flow(std::move(mesh), velocity, scheme, settings);
}

std::string MeshWallClimb::resolution() const {
  return fmt::format("h1 = {:g}, {} rows, tau = {:g}", spacing, rows, tau);
}

MeshWallRun climb_wall(const MeshWallClimb& climb, const std::function<void(const Flow&)>& after_step) {
  MeshWallRun run{.flow = climb.start()};
  Flow& flow = run.flow;
  if (climb.rezone > 0) flow.keep_upright(climb.rezone);
  const double energy = flow.energy();
  Peak level, still, bottom, force;
  WallGauge gauge;
  bool fallen = false;  // loads count while the wave is at the wall
  const auto observe = [&] {
    const double contact = flow.surface_y().back();
    run.energy_defect.add(flow.energy() / energy - 1, flow.time());
    if (contact > level.value()) {
      run.worst_shape.add(flow.worst_corner().shape, flow.time());
      run.climb_energy_defect = run.energy_defect;
    }
    level.add(flow.time(), contact);
    if (contact < level.value() / 2 && level.value() > climb.wave.amplitude()) fallen = true;
    if (const auto load = gauge.read(flow); load && !fallen) {
      if (load->contact > 0) still.add(load->time, load->pressure_at(0));
      bottom.add(load->time, load->pressure_at(-1));
      force.add(load->time, load->force);
    }
    if (after_step) after_step(flow);
  };
  try {
    march(flow, climb.end(), climb.tau, observe);
  } catch (const Divergence& failure) {
    run.tangle = {.time = failure.time(), .place = failure.place(), .what = failure.what()};
  }
  run.highest = level.value();
  run.time_of_runup = level.time();
  run.fell = flow.surface_y().back() < level.value() && flow.time() > level.time();
  run.pressure_still = still.value();
  run.pressure_bottom = bottom.value();
  run.force = force.value();
  return run;
}

std::vector<Parameter> mesh_parameters(ByTier<double> spacing, ByTier<long> rows, ByTier<double> tau) {
  return {
      real("h1", spacing, "depth", {0.02, 2}, "width of the columns"),
      integer("rows", rows, {1, 64}, "rows of cells"),
      real("tau", tau, "sqrt(depth/g)", {1e-4, 0.5}, "time step"),
      choice("scheme", "one_step", {"one_step", "one_step_feedback", "conservative"},
             "time stepping; the first is Frank's"),
      real("hourglass", 0, "1", {0, 2}, "kappa_0 of the hourglass potential; Frank's model has none"),
  };
}

MeshWallClimb mesh_climb_from(const Values& values, const exact::SolitaryWave& wave) {
  return {.wave = wave,
          .spacing = values.real("h1"),
          .rows = values.integer("rows"),
          .tau = values.real("tau"),
          .stepping = mechanics::stepping_named(values.text("scheme")),
          .settings = {.hourglass = values.real("hourglass")}};
}

}  // namespace seiche::validation
