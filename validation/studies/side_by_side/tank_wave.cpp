#include "validation/studies/side_by_side/tank_wave.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "validation/instruments/surface_points.hpp"

namespace seiche::validation {
namespace {

template <class Flow>
double momentum_of(const Flow& flow) {
  const std::vector<Invariant> all = flow.invariants();
  return std::ranges::find(all, "momentum_x", &Invariant::name)->value;
}

/// A flow in equal steps; `surface` reads its surface.
template <class Flow, class Surface>
Racer racer_of(const std::shared_ptr<Flow>& flow, const TankWave& wave, double tau, Surface surface) {
  return {
      [flow, tau](double time) { march(*flow, time, tau); },
      [flow, &wave, surface] { return Sight{.off = wave.off(surface(*flow), flow->time()), .energy = flow->energy()}; },
      [flow] { return momentum_of(*flow); }};
}

Racer start_mesh(const TankWave& wave, long rows) {
  using lagrangian_mesh_2d::Flow;
  const double h = 1 / static_cast<double>(rows);
  const auto columns = static_cast<std::size_t>(std::lround(wave.length / (2 * h)));
  const auto bottom = [&](const TankWave::Bottom& b) {
    return std::make_shared<GraphCurve>(b.elevation, b.slope, b.curvature, 0, wave.length, columns);
  };
  const auto flow =
      std::make_shared<Flow>(lagrangian_mesh_2d::layer_mesh({.end = wave.length,
                                                             .columns = columns,
                                                             .rows = static_cast<std::size_t>(rows),
                                                             .elevation = wave.water.elevation,
                                                             .bottom = wave.bottom ? bottom(*wave.bottom) : nullptr}),
                             wave.water.velocity);
  return racer_of(flow, wave, 0.4 * h, [](const Flow& f) { return joined({f.surface_x(), f.surface_y()}); });
}

/// Square cells, in staggered rows.
free_lagrangian::Mesh cells_at_rest(const TankWave& wave, long rows) {
  return free_lagrangian::layer_mesh({.end = wave.length,
                                      .columns = static_cast<int>(std::lround(wave.length * static_cast<double>(rows))),
                                      .rows = static_cast<int>(rows)});
}

constexpr double stabilisation = 0.01;  ///< of the pressures of cells: what travelling waves are to have
constexpr variable_mass::Control control{.kind = variable_mass::ControlKind::mapped, .rate = 1, .surface_rate = 0.5};

Racer start_dirichlet(const TankWave& wave, long rows) {
  using dirichlet_mesh::Flow;
  const free_lagrangian::Mesh rest = cells_at_rest(wave, rows);
  const auto top = std::make_shared<variable_mass::Surface>(rest);
  const auto flow =
      std::make_shared<Flow>(variable_mass::ControlVelocity(rest, control).raised(wave.water.elevation),
                             wave.water.velocity, dirichlet_mesh::Settings{.stabilisation = stabilisation});
  return racer_of(flow, wave, 0.4 / static_cast<double>(rows), [top](const Flow& f) {
    return chosen(top->nodes(), {f.x(), f.y()});
  });
}

Racer start_variable_mass(const TankWave& wave, long rows) {
  using variable_mass::Flow;
  const free_lagrangian::Mesh rest = cells_at_rest(wave, rows);
  const auto top = std::make_shared<variable_mass::Surface>(rest);
  const auto flow = std::make_shared<Flow>(
      rest, variable_mass::Start{.elevation = wave.water.elevation, .velocity = wave.water.velocity}, control,
      variable_mass::Settings{.stabilisation = stabilisation});
  return racer_of(flow, wave, 0.4 / static_cast<double>(rows),
                  [top](const Flow& f) { return chosen(top->nodes(), f.nodes()); });
}

Racer start_particles(const TankWave& wave, long cells) {
  using gauss_particles::Flow;
  using gauss_particles::SplineSpace;
  const double cell = 1 / static_cast<double>(cells);
  constexpr double side = 6;  // particles to a cell's
  const auto across = static_cast<std::size_t>(std::lround(wave.length * static_cast<double>(cells)));
  gauss_particles::Ground ground{.level = -1};
  if (wave.bottom) {
    ground.profile = std::make_shared<SmoothBottom>(wave.bottom->elevation, wave.bottom->slope, 0, wave.length);
  }
  const auto flow = std::make_shared<Flow>(
      gauss_particles::layer({.end = wave.length,
                              .columns = across * static_cast<std::size_t>(side),
                              .rows = static_cast<std::size_t>(cells) * static_cast<std::size_t>(side),
                              .surface = wave.water.elevation,
                              .bottom = wave.bottom ? wave.bottom->elevation : [](double) { return -1.0; },
                              .markers = 20 * across,
                              .marker_at_end = true}),
      std::make_unique<SplineSpace>(
          gauss_particles::LatticePlan{
              .cell_x = cell, .left_wall = 0.0, .right_wall = wave.length, .bottom = true, .ground = ground},
          SplineSpace::Settings{.inner_fraction = 0.9}),
      wave.water.velocity,
      gauss_particles::Settings{
          .gravity = 1, .penalty = 0, .surface = gauss_particles::SurfaceLine{.exact_energy = true}});
  return racer_of(flow, wave, 0.15 * cell / wave.speed, [](const Flow& f) { return f.markers(); });
}

Racer start_in_box(const TankWave& wave, long rows) {
  const auto flow = std::make_shared<wcsph::Flow>(start_sph(wave.water, 1 / static_cast<double>(rows)));
  const double share = wave.length / wave.water.period;  // of the box, whose parts are mirror images
  return {[flow](double time) { march(*flow, time); },
          [flow, &wave, share] {
            return Sight{.off = wave.off(surface_of(*flow, wave.water, 0, wave.length), flow->time()),
                         .energy = share * flow->totals().energy()};
          },
          [flow, length = wave.length] {
            const wcsph::Particles& p = flow->particles();
            double sum = 0;
            for (std::size_t i = 0; i < p.size(); ++i) {
              if (p.kind[i] == wcsph::Kind::fluid && p.x[i] < length) sum += p.mass[i] * p.u[i];
            }
            return sum;
          }};
}

Racer start_dispersive(const TankWave& wave, const DispersiveStart& start, long markers) {
  using dispersive_shallow_water_1d::Flow;
  const double spacing = 1 / static_cast<double>(markers);
  const auto flow = std::make_shared<Flow>(start(spacing));
  return racer_of(flow, wave, 0.25 * spacing, [](const Flow& f) { return joined({f.x(), f.y()}); });
}

}  // namespace

TankWave solitary_tank(const exact::SolitaryWave& wave, double start, double length, double period) {
  const auto image = [length](double x) { return x > length ? 2 * length - x : x; };
  const auto elevation = [=](double x) { return wave.elevation(image(x) - start); };
  const auto velocity = [=](Point at) {
    // The surface itself is the end of the exact field: points above it are put on it.
    const auto v = wave.velocity(image(at.x) - start, std::min(at.y, elevation(at.x) - 1e-13));
    return Point{at.x > length ? -v.u : v.u, v.v};
  };
  const auto pressure = [=, c = wave.speed()](Point at) {
    const Point v = velocity({image(at.x), at.y});
    return 0.5 * (c * c - (v.x - c) * (v.x - c) - v.y * v.y) - at.y;
  };
  return {.length = length,
          .water = {.period = period,
                    .highest = 3 * wave.amplitude(),  // a wave of 0.6 depths runs up 2.8 amplitudes on a wall
                    .elevation = elevation,
                    .velocity = velocity,
                    .pressure = pressure},
          .speed = wave.speed(),
          .amplitude = wave.amplitude(),
          .surface = [wave, start](double x, double t) { return wave.elevation(x - start, t); }};
}

std::vector<double> TankWave::off(const std::vector<Point>& points, double time) const {
  std::vector<double> heights;
  if (!part) return heights;
  const auto [from, to] = part(time);
  for (const Point& point : points) {
    if (point.x < from || point.x > to) continue;
    heights.push_back((point.y - surface(point.x, time)) / amplitude);
  }
  return heights;
}

TankSizes tank_sizes(const Values& values) {
  const auto size = [&](const char* name) { return values.all().contains(name) ? values.integer(name) : 0; };
  return {size("particles"), size("mesh"), size("cells"), size("sph"), size("markers")};
}

std::vector<Contender> tank_contenders(const TankWave& wave, const DispersiveStart& dispersive,
                                       const TankSizes& sizes) {
  const auto over = [](long n) { return 1 / static_cast<double>(n); };
  const auto starting = [&wave](Racer (*start)(const TankWave&, long)) {
    return [&wave, start](long n) { return start(wave, n); };
  };
  const std::vector<double> four{0.375, 0.5, 0.75, 1};
  std::vector<Contender> all{
      {"particles", "Gauss particles", "cell size", Role::computed, ladder_to(sizes.particles, {0.5, 0.75, 1}), over,
       starting(start_particles)},
      {"mesh", "Lagrangian mesh", "row height", Role::peer, ladder_to(sizes.mesh, four), over, starting(start_mesh)},
      {"dirichlet", "Dirichlet cells", "row height", Role::peer, ladder_to(sizes.cells, {0.5, 1}), over,
       starting(start_dirichlet)},
      {"variable-mass", "variable mass", "row height", Role::peer, ladder_to(sizes.cells, {0.333, 0.5, 0.667, 1}), over,
       starting(start_variable_mass)},
      {"dispersive", "dispersive shallow water", "node spacing", Role::data,
       ladder_to(sizes.markers, {0.125, 0.25, 0.5, 1}), over,
       [&wave, dispersive](long n) { return start_dispersive(wave, dispersive, n); }},
      {"sph", "SPH", "particle spacing", Role::peer, ladder_to(sizes.sph, {0.5, 0.75, 1}), over,
       starting(start_in_box)}};
  std::erase_if(all, [](const Contender& one) { return one.resolutions.back() == 0; });
  return all;
}

}  // namespace seiche::validation
