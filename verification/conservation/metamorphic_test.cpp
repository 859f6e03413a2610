// Every model, its main options and its flow's twin (twin.hpp): what must not change a computation.
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/layer.hpp"
#include "seiche/models/overlapping_particles/flow.hpp"
#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "seiche/models/shallow_water_particles/initial.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "verification/check.hpp"
#include "verification/conservation/twin.hpp"
#include "verification/jittered_mesh.hpp"
#include "verification/noise.hpp"
#include "verification/wcsph_problems.hpp"

namespace metamorphic_test {

using namespace seiche;
using mechanics::Stepping;
using namespace seiche::verification;

constexpr int steps = 24;

template <class Flow>
void take_steps(Flow& flow, double tau) {
  for (int k = 0; k < steps; ++k) flow.advance(tau);
}

/// Bent, sheared and turned.
Point stirring(Point r) {
  return {0.4 * r.x - 0.7 * r.y + 0.1 * std::sin(2 * r.y) + 0.3, 0.5 * r.x - 0.4 * r.y + 0.1 * std::cos(3 * r.x) - 0.2};
}

double hump(double x, double at) {
  return std::exp(-(x - at) * (x - at));
}

// ---- Dispersive shallow water, one dimension ----

namespace channel {
using namespace dispersive_shallow_water_1d;

/// A hump that runs to the right, in water of depth 1 over [-12, 0], 48 cells.
Markers markers_of(const Twin& twin, bool tip) {
  Markers m;
  constexpr std::size_t n = 49;
  const std::size_t count = tip ? n : n - 1;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = 0.25 * static_cast<double>(twin.in_row(k, count)) - 12;
    const double h = 0.5 * hump(x, -6.5);
    const Point v = twin.velocity({h, -2 * h * (x + 6.5) * h});
    m.x.push_back(twin.place(x));
    m.y.push_back(twin.length * (x == 0 ? 0 : h));
    m.u.push_back(v.x);
    m.v.push_back(v.y);
  }
  return m;
}

Seen run(const Twin& twin, Channel base, bool beach, Stepping stepping) {
  // A beach 1:4 whose foot is under the wave's front.
  std::vector<double> x{-16, -4.125, 8.25};
  std::vector<double> z{-1, -1, 2};
  if (twin.mirrored) {
    std::reverse(x.begin(), x.end());
    std::reverse(z.begin(), z.end());
  }
  for (double& place : x) place = twin.place(place);
  for (double& level : z) level *= twin.length;
  if (beach) {
    base.bottom = std::make_shared<PiecewiseLinearBottom>(x, z);
    base.right = End::tip;
  } else {
    base.bottom = std::make_shared<LevelBottom>(twin.length);
    if (base.period > 0) base.period *= twin.length;
  }
  twin.swap_if_mirrored(base.left, base.right);
  base.gravity = twin.acceleration(1);
  base.density = twin.density;
  base.reference_depth = twin.length;
  Flow flow(base, markers_of(twin, beach || base.period == 0), {.stepping = stepping});
  take_steps(flow, 0.0625 * twin.time);
  Seen seen(flow.x().size());
  const auto u = flow.u(), v = flow.v();
  for (std::size_t k = 0; k < u.size(); ++k) {
    seen.at(twin.in_row(k, u.size()), twin, {flow.x()[k], flow.y()[k]}, {u[k], v[k]}, flow.time());
  }
  return seen;
}
}  // namespace channel

// ---- Lattices seen from above ----

template <class Side>
std::array<Side, 4> turned_sides(std::array<Side, 4> s, const Twin& twin) {  // west, east, south, north
  if (twin.mirrored) std::swap(s[0], s[1]);
  for (int k = 0; k < twin.turns; ++k) s = {s[3], s[2], s[0], s[1]};
  return s;
}

/// b = -1 + x/16 - y/8 + x y/64 + x^2/128, by its coefficients in the twin: of L (b in (x/L, y/L) less the origin).
std::shared_ptr<const PlanBottom> bottom_of(const Twin& twin, bool shore) {
  using Terms = std::map<std::array<int, 2>, double>;
  const auto times = [](const Terms& a, const Terms& b) {
    Terms product;
    for (const auto& [p, c] : a) {
      for (const auto& [q, d] : b) product[{p[0] + q[0], p[1] + q[1]}] += c * d;
    }
    return product;
  };
  // Places of the flow as polynomials in those of the twin.
  const auto coordinate = [&](int axis) {
    const auto along = [&](Point d) { return axis == 0 ? d.x : d.y; };
    return Terms{{{1, 0}, along(twin.undirected({1 / twin.length, 0}))},
                 {{0, 1}, along(twin.undirected({0, 1 / twin.length}))},
                 {{0, 0}, along(twin.undirected({-twin.origin.x, -twin.origin.y}))}};
  };
  const Terms x = coordinate(0), y = coordinate(1);
  Terms sum;
  const auto add = [&](double c, const Terms& terms) {
    for (const auto& [p, d] : terms) sum[p] += twin.length * c * d;
  };
  if (shore) {
    add(-0.25, y);
  } else {
    add(-1, {{{0, 0}, 1.0}});
    add(1.0 / 16, x);
    add(-1.0 / 8, y);
    add(1.0 / 64, times(x, y));
    add(1.0 / 128, times(x, x));
  }
  std::vector<PolynomialBottom::Term> terms;
  for (const auto& [p, c] : sum) terms.push_back({c, p[0], p[1]});
  return std::make_shared<PolynomialBottom>(terms);
}

namespace plan {
using namespace dispersive_shallow_water_2d;
using plan_lattice::FreeSide;
using plan_lattice::ShoreSide;
using plan_lattice::Side;
using plan_lattice::WallSide;

enum class Where { box, free, slope, shore };

Seen run(const Twin& twin, Where where, Settings settings, Stepping stepping) {
  constexpr std::size_t columns = 10, rows = 8;
  const bool steep = settings.drag.breaking_slope > 0;
  constexpr double cell = 0.5;
  const TwinLattice nodes(columns, rows, twin);
  const Side usual = where == Where::free ? Side(FreeSide{}) : Side(WallSide{});
  const auto sides = turned_sides<Side>({usual, usual, where == Where::shore ? Side(ShoreSide{}) : usual, usual}, twin);
  Lattice lattice{.shape = {nodes.columns, nodes.rows},
                  .x = {},
                  .y = {},
                  .z = {},
                  .sides = {sides[0], sides[1], sides[2], sides[3]},
                  .depth = twin.length,
                  .bottom = {}};
  if (where == Where::slope || where == Where::shore) lattice.bottom = bottom_of(twin, where == Where::shore);
  std::vector<Velocity> velocities;
  for (const std::size_t k : nodes.node) {
    const std::size_t i = k % (columns + 1), j = k / (columns + 1);
    Noise noise(k + 1);
    const bool inside = i > 0 && i < columns && j > 0 && j < rows;
    const Point r{cell * (static_cast<double>(i) + (inside ? 0.1 * noise() : 0)),
                  cell * (static_cast<double>(j) + (inside ? 0.1 * noise() : 0))};
    const Point there = twin.place(r);
    lattice.x.push_back(there.x);
    lattice.y.push_back(there.y);
    const double h = steep ? 1.2 / (1 + std::exp(3 * (r.x + 0.4 * r.y - 2.5))) : 0.3 * hump(r.x, 2) * hump(r.y, 1.5);
    lattice.z.push_back(twin.length * (where == Where::shore && j == 0 ? 0.0 : h));
    const Point v = twin.velocity({(steep ? 1.0 : 0.5) * h + 0.02 * noise(), 0.2 * h + 0.02 * noise()});
    velocities.push_back({v.x, v.y, twin.speed() * 0.02 * noise()});
  }
  if (where == Where::shore) {
    for (std::size_t k = 0; k < lattice.x.size(); ++k) {
      if (nodes.node[k] > columns) continue;
      lattice.z[k] = lattice.bottom->slope(lattice.x[k], lattice.y[k]).elevation;
    }
  }
  settings.gravity = twin.acceleration(1);
  settings.drag.manning *= twin.time / std::cbrt(twin.length);
  for (double* rate : {&settings.drag.shore_rate, &settings.drag.lattice_rate}) *rate /= twin.time;
  Flow flow(lattice, velocities, {.stepping = stepping}, settings);
  take_steps(flow, 0.0625 * twin.time);
  Seen seen(2 * nodes.node.size());
  for (std::size_t k = 0; k < nodes.node.size(); ++k) {
    const std::size_t base = nodes.node[k];
    seen.at(2 * base, twin, {flow.x()[k], flow.y()[k]}, {flow.u()[k], flow.v()[k]}, flow.time());
    seen.at(2 * base + 1, {flow.z()[k] / twin.length, 0}, {flow.w()[k] / twin.speed(), 0});
  }
  return seen;
}
}  // namespace plan

namespace hexahedra {
using namespace lagrangian_mesh_3d;
using plan_lattice::FreeSide;
using plan_lattice::Side;
using plan_lattice::WallSide;

enum class Where { body, box, slope };

Seen run(const Twin& twin, Where where, Stepping stepping) {
  constexpr std::size_t columns = 6, rows = 5, layers = 2;
  constexpr double cell = 0.5;
  const TwinLattice nodes(columns, rows, twin);
  const Side side = where == Where::body ? Side(FreeSide{}) : Side(WallSide{});
  Mesh mesh{.plan = {nodes.columns, nodes.rows},
            .layers = layers,
            .x = {},
            .y = {},
            .z = {},
            .sides = {side, side, side, side},
            .free_bottom = where == Where::body};
  if (where == Where::slope) mesh.bottom = bottom_of(twin, false);
  std::vector<Vector> velocities;
  for (std::size_t l = 0; l <= layers; ++l) {
    for (const std::size_t k : nodes.node) {
      const std::size_t i = k % (columns + 1), j = k / (columns + 1);
      Noise noise(100 * l + k + 1);
      const bool inside = i > 0 && i < columns && j > 0 && j < rows && l > 0;
      const double jitter = inside ? 0.05 : 0;
      const Point r{cell * (static_cast<double>(i) + jitter * noise()),
                    cell * (static_cast<double>(j) + jitter * noise())};
      const Point there = twin.place(r);
      const double top = 0.2 * hump(r.x, 1) * hump(r.y, 1);
      const double height = static_cast<double>(l) / layers;
      const double bed = mesh.bottom ? mesh.bottom->slope(there.x, there.y).elevation : -twin.length;
      mesh.x.push_back(there.x);
      mesh.y.push_back(there.y);
      mesh.z.push_back(l == 0 ? bed : bed + height * (twin.length * top - bed));
      const Point v = twin.velocity({0.3 * stirring(r).x, 0.3 * stirring(r).y});
      velocities.push_back({v.x, v.y, twin.speed() * 0.1 * noise()});
    }
  }
  Flow flow(
      mesh, velocities, {.stepping = stepping},
      {.gravity = where == Where::body ? 0.0 : twin.acceleration(1), .density = twin.density, .tolerance = 1e-13});
  take_steps(flow, 0.03125 * twin.time);
  Seen seen(2 * flow.x().size());
  for (std::size_t k = 0; k < flow.x().size(); ++k) {
    const std::size_t n = nodes.node.size();
    const std::size_t base = k / n * n + nodes.node[k % n];
    seen.at(2 * base, twin, {flow.x()[k], flow.y()[k]}, {flow.u()[k], flow.v()[k]}, flow.time());
    seen.at(2 * base + 1, {flow.z()[k] / twin.length, 0}, {flow.w()[k] / twin.speed(), 0});
  }
  return seen;
}
}  // namespace hexahedra

// ---- Models of the vertical plane ----

namespace mesh {
using namespace lagrangian_mesh_2d;

Seen run(const Twin& twin, bool patch, Settings settings, Stepping stepping) {
  constexpr std::size_t columns = 8, rows = 4;
  const TwinLattice nodes(columns, rows, twin);
  Mesh m{.columns = nodes.columns, .rows = nodes.rows, .x = {}, .y = {}, .sides = {}};
  if (!patch) {
    m.sides.left = vertical_wall(twin.place(0));
    m.sides.right = vertical_wall(twin.place(4));
    m.sides.bottom = level_wall(twin.place({0, -1}).y);
    twin.swap_if_mirrored(m.sides.left, m.sides.right);
  }
  std::vector<Point> velocities;
  for (const std::size_t k : nodes.node) {
    const double x = 0.5 * static_cast<double>(k % (columns + 1));
    const double top = patch ? 0 : 0.2 * hump(x, 1);
    const Point r{x, -1 + (1 + top) * 0.25 * static_cast<double>(k / (columns + 1))};
    const Point there = twin.place(r);
    m.x.push_back(there.x);
    m.y.push_back(there.y);
    velocities.push_back(twin.velocity({0.3 * stirring(r).x, 0.3 * stirring(r).y}));
  }
  settings.gravity = patch ? 0 : twin.acceleration(1);
  settings.density = twin.density;
  Flow flow(m, velocities, {.stepping = stepping}, settings);
  take_steps(flow, 0.03125 * twin.time);
  Seen seen(flow.x().size());
  for (std::size_t k = 0; k < flow.x().size(); ++k) {
    seen.at(nodes.node[k], twin, {flow.x()[k], flow.y()[k]}, {flow.u()[k], flow.v()[k]}, flow.time());
  }
  return seen;
}
}  // namespace mesh

/// What flows of particles end with.
template <class Flow>
Seen seen_of(const Flow& flow, const Twin& twin, const std::vector<std::size_t>& order) {
  const std::vector<double>& q = flow.state().q;
  const std::vector<double>& u = flow.state().u;
  const std::size_t n = order.size();
  Seen seen(n);
  for (std::size_t k = 0; k < n; ++k) seen.at(order[k], twin, {q[k], q[n + k]}, {u[k], u[n + k]}, flow.time());
  return seen;
}

Seen overlapping(const Twin& twin, overlapping_particles::Settings settings, bool floor) {
  using namespace overlapping_particles;
  constexpr double spacing = 0.25;
  Particles blob = staggered_disc(1, spacing);
  Noise noise(1);
  for (std::size_t k = 0; k < blob.size(); ++k) {
    blob.x[k] += 0.1 * spacing * noise();
    blob.y[k] += 0.1 * spacing * noise();
  }
  const auto order = twin.order(blob.size());
  Particles particles;
  particles.spacing = spacing * twin.length;
  for (const std::size_t k : order) {
    const Point r = twin.place({blob.x[k], blob.y[k]});
    particles.x.push_back(r.x);
    particles.y.push_back(r.y);
    particles.mass.push_back(blob.mass[k] * twin.density * twin.length * twin.length);
  }
  if (floor) {
    settings.walls.push_back({twin.place({0, -1.25}), twin.direction({0, 1})});
    settings.gravity = twin.acceleration(1);
  }
  Flow flow(particles, twin.field(stirring), settings);
  take_steps(flow, 0.015625 * twin.time);
  return seen_of(flow, twin, order);
}

/// A rectangle of Dirichlet cells that nothing holds, or between walls under a level surface.
std::pair<free_lagrangian::Mesh, std::vector<std::size_t>> cells_of(const Twin& twin, bool layer) {
  using namespace free_lagrangian;
  const Mesh base = layer ? jittered(layer_mesh({.begin = 0, .end = 3, .columns = 9, .rows = 4}), 0.1, 1)
                          : jittered(free_patch(8, 6, {-1, -0.5}, {1, 0.5}), 0.2, 1);
  const auto order = twin.order(base.nodes());
  std::vector<int> number(order.size());
  Mesh mesh;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Point r = twin.place({base.x[order[k]], base.y[order[k]]});
    mesh.x.push_back(r.x);
    mesh.y.push_back(r.y);
    number[order[k]] = static_cast<int>(k);
    if (!base.held.empty()) mesh.held.push_back(base.held[order[k]]);
  }
  for (const int k : base.outline) mesh.outline.push_back(number[static_cast<std::size_t>(k)]);
  if (twin.mirrored) std::reverse(mesh.outline.begin(), mesh.outline.end());
  for (const Wall& wall : base.walls) mesh.walls.push_back({twin.place(wall.through), twin.direction(wall.direction)});
  return {mesh, order};
}

Point sloshing(Point r) {
  return {0.05 * std::sin(r.x) * std::cosh(r.y + 1), -0.05 * std::cos(r.x) * std::sinh(r.y + 1)};
}

free_lagrangian::Settings cell_settings(const Twin& twin, bool layer) {
  return {.gravity = layer ? twin.acceleration(1) : 0, .density = twin.density, .stabilisation = 0.05};
}

Seen dirichlet(const Twin& twin, bool layer) {
  const auto [mesh, order] = cells_of(twin, layer);
  dirichlet_mesh::Flow flow(mesh, twin.field(layer ? sloshing : stirring), cell_settings(twin, layer), 0.2);
  take_steps(flow, 0.015625 * twin.time);
  return seen_of(flow, twin, order);
}

Seen variable(const Twin& twin, variable_mass::Control control, bool layer) {
  const auto [mesh, order] = cells_of(twin, layer);
  control.rate /= twin.time;
  control.surface_rate /= twin.time;
  variable_mass::Flow flow(mesh, {.velocity = twin.field(layer ? sloshing : stirring)}, control,
                           cell_settings(twin, layer), 0.2);
  take_steps(flow, 0.015625 * twin.time);
  return seen_of(flow, twin, order);
}

Seen gauss(const Twin& twin, bool tank, gauss_particles::Stepping stepping) {
  using namespace gauss_particles;
  LatticePlan lattice{.cell_x = (tank ? 0.5 : 0.25) * twin.length};
  Particles base = tank ? layer({.begin = 0,
                                 .end = 2,
                                 .columns = 16,
                                 .rows = 8,
                                 .surface = [](double x) { return 0.2 * hump(x, 0.5); },
                                 .bottom = [](double) { return -1.0; },
                                 .markers = 8})
                        : disc(1, 14, 8);
  if (tank) {
    lattice.left_wall = twin.place(0);
    lattice.right_wall = twin.place(2);
    twin.swap_if_mirrored(lattice.left_wall, lattice.right_wall);
    lattice.bottom = true;
    lattice.ground = {.level = -twin.length};
  }
  const auto order = twin.order(base.size());
  Particles particles;
  for (const std::size_t k : order) {
    const Point r = twin.place({base.x[k], base.y[k]});
    particles.add(r.x, r.y, base.mass[k] * twin.density * twin.length * twin.length);
  }
  Flow flow(
      particles, std::make_unique<SplineSpace>(lattice.ground, lattice, SplineSpace::Settings{.density = twin.density}),
      twin.field(tank ? sloshing : stirring),
      {.gravity = tank ? twin.acceleration(1) : 0, .density = twin.density, .penalty = tank ? 0.01 : 0}, {}, stepping);
  take_steps(flow, 0.015625 * twin.time);
  return seen_of(flow, twin, order);
}

Seen sph(const Twin& twin, wcsph::Settings settings) {
  using namespace wcsph;
  constexpr double spacing = 0.1;
  const Particles blob = verification::random_blob(spacing, 1000, 1);
  const auto order = twin.order(blob.size());
  Particles particles;
  for (const std::size_t k : order) {
    const Point r = twin.place({blob.x[k], blob.z[k]});
    const Point v = twin.velocity({blob.u[k], blob.w[k]});
    particles.add(r.x, r.y, blob.mass[k] * twin.density * twin.length * twin.length, blob.density[k] * twin.density,
                  Kind::fluid, v.x, v.y);
  }
  settings.gravity = 0;
  settings.density = 1000 * twin.density;
  settings.sound_speed = 20 * twin.speed();
  if (auto* laminar = std::get_if<LaminarSps>(&settings.viscosity)) {
    laminar->kinematic_viscosity = 0.01 * twin.speed() * twin.length;
  }
  Flow flow(particles, spacing * twin.length, settings);
  take_steps(flow, twin.time / 1024);
  Seen seen(order.size());
  const Particles& now = flow.particles();
  for (std::size_t a = 0; a < now.size(); ++a) {
    seen.at(order[static_cast<std::size_t>(now.identity[a])], twin, {now.x[a], now.z[a]}, {now.u[a], now.w[a]},
            flow.time());
  }
  return seen;
}

// ---- Shallow water ----

Bed sinusoidal_bed(const Twin& twin) {
  const auto inside = [twin](double x) { return twin.place_back({x, 0}).x; };
  const double l = twin.length;
  return {[=](double x) { return l * 0.1 * std::sin(inside(x)); },
          [=](double x) { return twin.sign() * l * l * -0.1 * std::cos(inside(x)); }};
}

namespace particles {
using namespace shallow_water_particles;

struct Row {
  double left_depth = 1, left_velocity = 0, right_depth = 0.4, right_velocity = 0;
  bool uneven = false;
};

Seen run(const Twin& twin, Row row, const Ends& ends, Scheme scheme, int many) {
  constexpr std::size_t count = 40;
  const Particles base =
      dam_break(0, 4, 10, {row.left_depth, row.left_velocity}, {row.right_depth, row.right_velocity}, count);
  Particles p;
  for (std::size_t k = 0; k <= count; ++k) p.edge.push_back(twin.place(base.edge[twin.in_row(k, count + 1)]));
  for (std::size_t k = 0; k < count; ++k) {
    p.mass.push_back(base.mass[twin.in_row(k, count)] * twin.length * twin.length);
    p.velocity.push_back(twin.velocity({base.velocity[twin.in_row(k, count)], 0}).x);
  }
  const auto in_twin = [&](const End& end) -> End {
    const auto times = [&](const std::function<double(double)>& f, double factor) -> std::function<double(double)> {
      if (!f) return {};
      return [f, factor, twin](double t) { return factor * f(t / twin.time); };
    };
    if (const auto* open = std::get_if<Open>(&end)) {
      return Open{times(open->discharge, twin.sign() * twin.length * twin.speed()), times(open->depth, twin.length)};
    }
    if (const auto* piston = std::get_if<Piston>(&end)) {
      return Piston{[f = piston->velocity, twin](double t) { return twin.velocity({f(t / twin.time), 0}).x; }};
    }
    return end;
  };
  Ends there{in_twin(ends.left), in_twin(ends.right)};
  twin.swap_if_mirrored(there.left, there.right);
  Forcing forcing{.gravity = twin.acceleration(1), .bed = {}, .manning = 0, .body_force = {}};
  if (row.uneven) {
    forcing.bed = sinusoidal_bed(twin);
    forcing.manning = 0.05 * twin.time / std::cbrt(twin.length);
  }
  ParticleFlow flow(p, there, forcing, scheme);
  for (int k = 0; k < many; ++k) flow.advance(flow.largest_step().tau);
  const Particles& now = flow.particles();
  const std::size_t n = now.size();
  Seen seen(n + 1);
  for (std::size_t k = 0; k <= n; ++k) {
    const std::size_t edge = twin.in_row(k, n + 1);
    const bool is_particle = edge < n;
    const std::size_t there_k = is_particle ? twin.in_row(edge, n) : 0;
    seen.at(edge, twin, {now.edge[k], 0}, {is_particle ? now.velocity[there_k] : twin.velocity({0, 0}).x, 0},
            flow.time());
  }
  return seen;
}
}  // namespace particles

Seen volumes(const Twin& twin, shallow_water_finite_volume::Scheme scheme, bool inflow) {
  using namespace shallow_water_finite_volume;
  constexpr std::size_t n = 40;
  std::vector<double> depth(n), discharge(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double x = 0.25 * (static_cast<double>(twin.in_row(k, n)) + 0.5);
    depth[k] = twin.length * (x < 4 ? 1 : 0.8) * (1 + 0.05 * std::sin(x));
    discharge[k] = twin.length * twin.velocity({0.1 * std::cos(x), 0}).x;
  }
  FiniteVolumeFlow::Settings settings{.scheme = scheme, .gravity = twin.acceleration(1)};
  settings.dry_depth *= twin.length;
  if (inflow) settings.left = End::inflow({twin.length, twin.velocity({0.5, 0}).x}), settings.right = End::free();
  twin.swap_if_mirrored(settings.left, settings.right);
  std::optional<Bed> bed;
  if (scheme == Scheme::muscl_hll && !inflow) {
    bed = sinusoidal_bed(twin);
    settings.manning = 0.05 * twin.time / std::cbrt(twin.length);
  }
  const double a = twin.place(0.0), b = twin.place(10.0);
  FiniteVolumeFlow flow(settings, std::min(a, b), std::max(a, b), depth, discharge, bed);
  for (int k = 0; k < steps; ++k) flow.step(0.03125 * twin.time);
  Seen seen(n);
  for (std::size_t k = 0; k < n; ++k) {
    seen.at(twin.in_row(k, n), {flow.depth()[k] / twin.length, 0}, twin.velocity_back({flow.velocity()[k], 0}));
  }
  return seen;
}

// ---- The table ----

struct Transformation {
  std::string id, what;
  Twin twin;
  bool binary = false;  ///< powers of two only
};

const std::vector<Transformation> transformations{
    {"mirror", "in a mirror", {.mirrored = true}},
    {"turned", "turned by 90 degrees", {.turns = 1}},
    {"units-128",
     "in units 1/128 as long, 1/16 as lasting, 1/4 as dense",
     {.length = 128, .time = 16, .density = 4},
     true},
    {"units-4096", "in units 4096 as long, 64 as lasting", {.length = 1.0 / 4096, .time = 1.0 / 64}, true},
    {"units-100",
     "in units 1/100 as long, 1/10 as lasting, 1/1000 as dense",
     {.length = 100, .time = 10, .density = 1000}},
    {"origin", "64 to the right and 32 below", {.origin = {64, -32}}},
    {"along", "64 to the right", {.origin = {64, 0}}},
    {"moving", "from a frame that moves at 1/4", {.drift = 0.25}},
    {"permuted", "with its particles in another order", {.permuted = true}},
};

using Which = std::set<std::string>;
Which and_units(Which some) {
  some.insert({"units-128", "units-4096", "units-100"});
  return some;
}

struct Option {
  std::string name;
  std::function<Seen(const Twin&)> run;
  Which which;          ///< transformations
  bool rounds = false;  ///< by powers and roots that take a power of two apart
};

struct Subject {
  std::string id, name;
  double growth;
  std::string reason;
  std::vector<Option> options;
};

const std::string of_solves = "each of 24 steps some hundred roundings, times 20 for the solution of its equations";
const std::string of_sums = "each of 24 steps some hundred roundings";

Subject dispersive_1d() {
  using namespace dispersive_shallow_water_1d;
  Subject s{"dispersive-1d", "dispersive 1D", 320, of_solves + " and 16 for the feedback of a drift over a step", {}};
  const auto add = [&](const std::string& name, const Channel& c, bool beach, Stepping stepping, const Which& which,
                       bool rounds = false) {
    s.options.push_back({name, [=](const Twin& t) { return channel::run(t, c, beach, stepping); }, which, rounds});
  };
  const Which row = and_units({"mirror", "along"}), ring = and_units({"mirror", "along", "moving"});
  add("periodic, one-step", {.period = 12}, false, Stepping::one_step, ring);
  add("periodic, feedback", {.period = 12}, false, Stepping::one_step_feedback, ring);
  add("periodic, conservative", {.period = 12}, false, Stepping::conservative, ring);
  add("walls, improved", {.alpha = 0.4, .gamma = 1.0 / 15}, false, Stepping::one_step, row);
  add("beach, conservative", {}, true, Stepping::conservative, row);
  add("beach, Green-Naghdi", {.kinetics = Kinetics::green_naghdi, .tip_mass = TipMass::consistent}, true,
      Stepping::one_step, row);
  add("beach, friction and breaking",
      {.friction = {FrictionLaw::quadratic, 0.01}, .breaking = Breaking{.onset_slope = 0.2, .ceasing_froude = 1.05}},
      true, Stepping::one_step, row, true);
  return s;
}

Subject dispersive_2dh() {
  using plan::Where;
  Subject s{"dispersive-2dh", "dispersive 2DH", 20, of_solves, {}};
  const auto add = [&](const std::string& name, Where where, const plan::Settings& settings, Stepping stepping,
                       Which which = {}, bool rounds = false) {
    which.insert({"mirror", "turned", "origin"});
    s.options.push_back(
        {name, [=](const Twin& t) { return plan::run(t, where, settings, stepping); }, and_units(which), rounds});
  };
  add("box, improved", Where::box, {.inertia = 0.4, .gamma = 1.0 / 15}, Stepping::one_step);
  add("free, conservative", Where::free, {}, Stepping::conservative, {"moving"});
  add("uneven bottom, conservative", Where::slope, {}, Stepping::conservative);
  add("damped pattern", Where::box, {.drag = {.lattice_rate = 2}}, Stepping::one_step);
  add("breaking", Where::box, {.drag = {.breaking_slope = 0.1}}, Stepping::one_step, {}, true);
  add("friction", Where::slope, {.drag = {.manning = 0.1}}, Stepping::one_step, {}, true);
  add("shoreline", Where::shore, {}, Stepping::one_step);
  return s;
}

Subject mesh_2d() {
  Subject s{"mesh-2d", "Lagrangian mesh 2D", 20, of_solves, {}};
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    const bool one = stepping == Stepping::one_step;
    const std::string name = one ? ", one-step" : ", conservative";
    const lagrangian_mesh_2d::Settings improved{.hourglass = 0.2, .tuned_surface_inertia = true};
    s.options.push_back({"free patch" + name, [=](const Twin& t) { return mesh::run(t, true, {}, stepping); },
                         and_units({"mirror", "turned", "origin", "moving"})});
    s.options.push_back(
        {"sloshing" + name,
         [=](const Twin& t) { return mesh::run(t, false, one ? improved : lagrangian_mesh_2d::Settings{}, stepping); },
         and_units({"mirror", "along"})});
  }
  return s;
}

Subject mesh_3d() {
  using hexahedra::Where;
  Subject s{"mesh-3d", "Lagrangian mesh 3D", 20, of_solves, {}};
  const auto add = [&](const std::string& name, Where where, Stepping stepping, Which which = {}) {
    which.insert({"mirror", "turned", "origin"});
    s.options.push_back({name, [=](const Twin& t) { return hexahedra::run(t, where, stepping); }, and_units(which),
                         stepping == Stepping::one_step});
  };
  add("free body", Where::body, Stepping::one_step, {"moving"});
  add("box, conservative", Where::box, Stepping::conservative);
  add("uneven bottom", Where::slope, Stepping::one_step);
  return s;
}

/// Of particles in any order: a free body, and water on walls under gravity.
const Which body = and_units({"mirror", "turned", "origin", "moving", "permuted"});
const Which layer_of_water = and_units({"mirror", "along", "permuted"});

std::vector<Subject> bodies() {
  using variable_mass::ControlKind;
  const auto cells = [](ControlKind kind) {
    return [kind](const Twin& t) { return variable(t, {kind, 1, 0.5}, true); };
  };
  using Gauss = gauss_particles::Stepping;
  // Cut cells are continued along columns before rows, and cells stand still.
  const Which drop = and_units({"mirror", "origin", "permuted"});
  return {
      {"overlapping",
       "overlapping particles",
       20,
       of_solves,
       {{"free blob", [](const Twin& t) { return overlapping(t, {}, false); }, body},
        {"over a floor", [](const Twin& t) { return overlapping(t, {.stabilisation = 0.1}, true); }, layer_of_water}}},
      {"dirichlet",
       "Dirichlet cells",
       20,
       of_solves,
       {{"free patch", [](const Twin& t) { return dirichlet(t, false); }, body},
        {"sloshing", [](const Twin& t) { return dirichlet(t, true); }, layer_of_water}}},
      {"variable-mass",
       "variable-mass particles",
       20,
       of_solves,
       {{"free patch",
         [](const Twin& t) {
           return variable(t, {ControlKind::centroid, 1, 0}, false);
         },
         body},
        {"mapped", cells(ControlKind::mapped), layer_of_water},
        {"fixed in x", cells(ControlKind::fixed_x), layer_of_water}}},
      {"gauss",
       "Gauss-principle particles",
       20,
       of_solves,
       {{"drop", [](const Twin& t) { return gauss(t, false, Gauss::conservative); }, drop},
        {"tank, penalty", [](const Twin& t) { return gauss(t, true, Gauss::conservative); }, layer_of_water},
        {"drop, dissipative", [](const Twin& t) { return gauss(t, false, Gauss::dissipative); }, drop}}},
      {"wcsph",
       "WCSPH",
       1,
       of_sums,
       {{"artificial viscosity", [](const Twin& t) { return sph(t, {.viscosity = wcsph::ArtificialViscosity{0.1}}); },
         body},
        {"SPS stress, density diffusion",
         [](const Twin& t) { return sph(t, {.viscosity = wcsph::LaminarSps{}, .density_diffusion = 0.1}); }, body}}},
  };
}

Subject shallow_particles() {
  using namespace shallow_water_particles;
  Subject s{
      "particles",
      "shallow-water particles",
      175,
      of_sums +
          ", of up to 300 steps 3.5 times as much; a place of a jump is a difference over its height of 1/50 or more",
      {}};
  const auto add = [&](const std::string& name, const particles::Row& r, const Ends& ends, Level level, int many,
                       Which which = {}, bool rounds = false) {
    Scheme scheme;
    scheme.level = level;
    which.insert({"mirror", "along"});
    s.options.push_back(
        {name, [=](const Twin& t) { return particles::run(t, r, ends, scheme, many); }, and_units(which), rounds});
  };
  const auto still = [](double) { return 0.8; };
  const auto supercritical = [](double) { return 3.0; };
  const auto one = [](double) { return 1.0; };
  const auto accelerating = [](double t) { return std::min(2.0, 2 * t); };
  const auto varying = [](double t) { return 0.3 + 0.2 * std::sin(t); };
  add("G1, box", {}, {}, Level::godunov, 60);
  add("M2, box", {}, {}, Level::muscl, 60);
  add("H2, box", {.right_depth = 0.7}, {}, Level::hand_over, 300);
  add("bores that meet", {.left_velocity = 0.25, .right_depth = 1, .right_velocity = -0.25}, {}, Level::hand_over, 200);
  add("free ends", {}, {Free{}, Free{}}, Level::hand_over, 60, {"moving"});
  add("dry bed", {.right_depth = 1}, {Wall{}, Vacuum{}}, Level::hand_over, 60);
  add("piston", {.right_depth = 1}, {Piston{accelerating}, Wall{}}, Level::hand_over, 60);
  add("open ends", {.left_velocity = 0.3, .right_depth = 0.8, .right_velocity = 0.3},
      {Open{varying, {}}, Open{{}, still}}, Level::hand_over, 120);
  add("open end and wall", {.left_velocity = 0.3, .right_depth = 0.8, .right_velocity = 0.3},
      {Open{varying, {}}, Wall{}}, Level::hand_over, 120);
  add("supercritical", {.left_velocity = 3, .right_depth = 1, .right_velocity = 3}, {Open{supercritical, one}, Open{}},
      Level::hand_over, 60);
  add("bed and friction", {.right_depth = 0.8, .uneven = true}, {}, Level::muscl, 60, {}, true);
  return s;
}

Subject finite_volumes() {
  using shallow_water_finite_volume::Scheme;
  Subject s{"finite-volumes", "shallow water, finite volumes", 1, of_sums, {}};
  for (const Scheme scheme : {Scheme::lax_friedrichs, Scheme::mac_cormack, Scheme::roe, Scheme::muscl_hll}) {
    for (const bool inflow : {false, true}) {
      // MacCormack takes its differences to one side first.
      Which which = and_units({"along"});
      if (scheme != Scheme::mac_cormack) which.insert("mirror");
      s.options.push_back({std::string(shallow_water_finite_volume::name(scheme)) + (inflow ? ", inflow" : ", walls"),
                           [=](const Twin& t) { return volumes(t, scheme, inflow); }, which,
                           scheme == Scheme::muscl_hll && !inflow});
    }
  }
  return s;
}

/// Of what throws: more than any limit.
double difference(const Option& option, const Twin& twin) {
  try {
    return option.run({}).difference(option.run(twin));
  } catch (const std::exception& failure) {
    UNSCOPED_INFO(option.name << ": " << failure.what());
    return 1;
  }
}

TEST_CASE("flows do not know mirrors, directions, units, places, frames and the order of particles", "[conservation]") {
  std::vector<Subject> subjects = bodies();
  for (auto* make : {dispersive_1d, dispersive_2dh, mesh_2d, mesh_3d, shallow_particles, finite_volumes}) {
    subjects.push_back(make());
  }
  for (const Subject& subject : subjects) {
    std::string id = subject.id;
    std::replace(id.begin(), id.end(), '-', '_');
    Check check(
        "metamorphic_" + id, fmt::format("The flow of {} and its twin", subject.name),
        "A small flow with each main option of the model, some 24 steps, and its twin: in a mirror; turned by 90 "
        "degrees; in other units; at another place; from a moving frame; with its particles in another order. What "
        "the twin gives, brought back, is what the flow gives: with powers of two as units bit by bit, but where a "
        "power or a root takes one apart (friction after Manning, viscosity of breaking fronts, the side of a cube); "
        "else to round-off. Left out: mirrors of MacCormack's scheme, which takes its differences to one side first; "
        "turns and moving frames of Gauss-principle particles, whose cells stand still and are continued along "
        "columns before rows. Differences are those of a place over the extent or of a velocity over the largest.");
    for (const Transformation& t : transformations) {
      const double far = 1 + std::hypot(t.twin.origin.x, t.twin.origin.y);
      const evidence::Criterion rounded =
          Roundoff{100.0 * steps, subject.growth * far, subject.reason + "; places as far from the origin as they are"};
      const evidence::Criterion bits = Bound{0, "the same operations on the same mantissas"};
      for (const Option& option : subject.options) {
        if (!option.which.contains(t.id)) continue;
        check.holds(fmt::format("{}: the same {}.", option.name, t.what), {difference(option, t.twin)},
                    t.binary && !option.rounds ? bits : rounded);
      }
    }
  }
}

}  // namespace metamorphic_test
