#include "validation/run_up/mesh_climb.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/instruments/mesh/impulsive_start.hpp"
#include "validation/instruments/peak.hpp"
#include "validation/run_up/solitary_climb.hpp"

namespace seiche::validation {

using lagrangian_mesh_2d::Flow;
using lagrangian_mesh_2d::Mesh;

namespace {

constexpr double length = 2 * MeshClimb::distance;  // of the tank before a wall
constexpr double reach = 2;                         // of columns of another width at the wall

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

MeshClimb MeshClimb::with_rows(const exact::SolitaryWave& wave, long rows) {
  const double h2 = 1 / static_cast<double>(rows);
  return {.wave = wave, .spacing = 2 * h2, .rows = rows, .tau = h2 / 5};
}

MeshClimb MeshClimb::refined(double times) const {
  MeshClimb finer = *this;
  finer.spacing /= times;
  finer.rows = std::lround(static_cast<double>(rows) * times);
  finer.tau /= times;
  return finer;
}

Flow MeshClimb::start() const {
  const double from = wall() ? -distance : crest;
  const auto elevation = [&](double x) { return wave.elevation(x - from); };
  const double tank = wall() ? length : toe;
  lagrangian_mesh_2d::Layer layer{.begin = wall() ? -length : 0,
                                  .end = wall() ? 0 : toe,
                                  .depth = 1,
                                  .columns = static_cast<std::size_t>(std::max(1L, std::lround(tank / spacing))),
                                  .rows = static_cast<std::size_t>(rows),
                                  .elevation = elevation};
  std::vector<double> graded;
  if (wall_columns != 1) {
    graded = graded_columns(spacing, wall_columns);
    layer.columns = graded.size() - 1;
  }
  Mesh mesh = wall() ? layer_mesh(layer) : layer_mesh_with_slope(layer, tan_slope, 0, rounding * spacing);
  if (!graded.empty()) set_columns(mesh, graded, elevation);
  lagrangian_mesh_2d::Settings own = settings;
  if (!wall() && beyond_tangling) own.lowest_corner = -std::numeric_limits<double>::infinity();
  const mechanics::Scheme scheme{.stepping = stepping};
  if (surface_impulse) {
    const std::vector<Point> velocities =
        impulsive_start(mesh, [&](double x) { return wave.surface_potential(x - from); });
    return Flow(std::move(mesh), velocities, scheme, own);
  }
  const auto velocity = [&](Point r) {
    // Sheared columns reach above the surface where it falls.
    const exact::Velocity v = wave.velocity(r.x - from, wall() ? r.y : std::min(r.y, elevation(r.x)));
    return Point{v.u, v.v};
  };
  return Flow(std::move(mesh), velocity, scheme, own);
}

std::string MeshClimb::resolution() const {
  return fmt::format("h1 = {:g}, {} rows, tau = {:g}", spacing, rows, tau);
}

std::string MeshRun::Tangle::where() const {
  return fmt::format("t = {:.2f}, x = {:.2f}", time, place);
}

MeshRun climb_on_mesh(const MeshClimb& climb, const std::function<void(const Flow&)>& after_step) {
  MeshRun run{.flow = climb.start()};
  Flow& flow = run.flow;
  if (climb.rezone > 0) flow.keep_upright(climb.rezone);
  const double energy = flow.energy();
  Worst defect;
  Peak level, still, bottom, force;
  WallGauge gauge;
  bool away = false;  // loads count while the wave is at the wall
  const auto observe = [&] {
    const double contact = flow.surface_y().back();
    const lagrangian_mesh_2d::Corner corner = flow.worst_corner();
    defect.add(flow.energy() / energy - 1, flow.time());
    if (!(contact <= level.value())) {  // the level is NaN before the first step
      run.energy_defect = defect;
      run.worst_shape.add(corner.shape, flow.time());
      run.x.assign(flow.x().begin(), flow.x().end());
      run.y.assign(flow.y().begin(), flow.y().end());
    }
    level.add(flow.time(), contact);
    run.times.push_back(flow.time());
    run.levels.push_back(contact);
    if (!run.tangle && corner.shape <= 0) {
      run.tangle = {.time = flow.time(), .place = flow.x()[flow.model().mesh().corners(corner.cell)[0]]};
    }
    if (contact < level.value() / 2 && level.value() > climb.wave.amplitude()) away = true;
    const auto load = climb.wall() ? gauge.read(flow) : std::nullopt;
    if (load) run.loads.push_back(*load);
    if (load && !away) {
      if (load->contact > 0) still.add(load->time, load->pressure_at(0));
      bottom.add(load->time, load->pressure_at(-1));
      force.add(load->time, load->force);
    }
    if (after_step) after_step(flow);
  };
  if (climb.wall()) {
    try {
      march(flow, 1.5 * MeshClimb::distance / climb.wave.speed(), climb.tau, observe);
    } catch (const Divergence& failure) {
      run.tangle = {.time = failure.time(), .place = failure.place()};
    }
    run.fell = flow.surface_y().back() < level.value() && flow.time() > level.time();
  } else {
    constexpr double fallen = 0.98;
    while (flow.time() < 3 * climb.toe && !run.fell) {
      flow.advance(climb.tau);
      observe();
      run.fell = level.value() >= 0.5 * climb.wave.amplitude() && flow.surface_y().back() <= fallen * level.value();
    }
  }
  run.highest = {level.value(), still.value(), bottom.value(), force.value()};
  run.time_of_highest = level.time();
  return run;
}

std::vector<Parameter> mesh_method_parameters() {
  return {scheme_parameter(),
          real("hourglass", 0, "1", {0, 2}, "kappa_0 of the hourglass potential; Frank's model has none")};
}

std::vector<Parameter> mesh_parameters(ByTier<double> spacing, ByTier<long> rows, ByTier<double> tau) {
  return joined(
      {{real("h1", spacing, "depth", {0.02, 2}, "width of the columns"),
        integer("rows", rows, {1, 64}, "rows of cells"), real("tau", tau, "sqrt(depth/g)", {1e-4, 0.5}, "time step")},
       mesh_method_parameters()});
}

MeshClimb mesh_climb_from(const Values& values, const exact::SolitaryWave& wave) {
  return {.wave = wave,
          .spacing = values.real("h1"),
          .rows = values.integer("rows"),
          .tau = values.real("tau"),
          .stepping = mechanics::stepping_named(values.text("scheme")),
          .settings = {.hourglass = values.real("hourglass")}};
}

}  // namespace seiche::validation
