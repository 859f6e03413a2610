// Particles, cells and finite volumes, their main options, and the twins of their flows.
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/models/overlapping_particles/flow.hpp"
#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "verification/check.hpp"
#include "verification/conservation/metamorphic.hpp"
#include "verification/jittered_mesh.hpp"
#include "verification/noise.hpp"
#include "verification/wcsph_problems.hpp"

namespace seiche::verification::metamorphic_particles_test {

using namespace metamorphic;

/// What flows of particles end with.
Seen seen_of(const auto& flow, const Twin& twin, const std::vector<std::size_t>& order) {
  const std::span<const double> q = flow.state().q, u = flow.state().u;
  const std::size_t n = order.size();
  return seen_in_plane(twin, order, q, q.subspan(n), u, u.subspan(n), flow.time());
}

/// Particles of the twin, in an order.
template <class Particles>
Particles twins_of(const Particles& base, const Twin& twin, const std::vector<std::size_t>& order) {
  Particles particles = base;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Point r = twin.place({base.x[order[k]], base.y[order[k]]});
    particles.x[k] = r.x;
    particles.y[k] = r.y;
    particles.mass[k] = base.mass[order[k]] * twin.density * twin.length * twin.length;
  }
  return particles;
}

Seen overlapping(const Twin& twin, overlapping_particles::Settings settings, bool floor) {
  using namespace overlapping_particles;
  constexpr double spacing = 0.25;
  const Particles blob = shaken(staggered_disc(1, spacing), 0.1 * spacing, 1);
  const auto order = twin.order(blob.size());
  Particles particles = twins_of(blob, twin, order);
  particles.spacing = spacing * twin.length;
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
  const Mesh base = layer ? jittered(layer_mesh({.end = 3, .columns = 9, .rows = 4}), 0.1, 1)
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

free_lagrangian::Settings cell_settings(const Twin& twin, bool layer) {
  return {.gravity = layer ? twin.acceleration(1) : 0, .density = twin.density, .stabilisation = 0.05};
}

Seen dirichlet(const Twin& twin, bool layer) {
  const auto [mesh, order] = cells_of(twin, layer);
  dirichlet_mesh::Flow flow(mesh, twin.field(layer ? sloshed : stirring), cell_settings(twin, layer), 0.2);
  take_steps(flow, 0.015625 * twin.time);
  return seen_of(flow, twin, order);
}

Seen variable(const Twin& twin, variable_mass::Control control, bool layer) {
  const auto [mesh, order] = cells_of(twin, layer);
  control.rate /= twin.time;
  control.surface_rate /= twin.time;
  variable_mass::Flow flow(mesh, {.velocity = twin.field(layer ? sloshed : stirring)}, control,
                           cell_settings(twin, layer), 0.2);
  take_steps(flow, 0.015625 * twin.time);
  return seen_of(flow, twin, order);
}

Seen gauss(const Twin& twin, bool tank, gauss_particles::Stepping stepping) {
  using namespace gauss_particles;
  LatticePlan lattice{.cell_x = (tank ? 0.5 : 0.25) * twin.length};
  const auto surface = [](double x) { return 0.2 * hump(x, 0.5); };
  const auto bottom = [](double) { return -1.0; };
  const Particles base =
      tank ? layer({.end = 2, .columns = 16, .rows = 8, .surface = surface, .bottom = bottom, .markers = 8})
           : gauss_particles::disc(1, 14, 8);
  if (tank) {
    lattice.left_wall = twin.place(0);
    lattice.right_wall = twin.place(2);
    twin.swap_if_mirrored(lattice.left_wall, lattice.right_wall);
    lattice.bottom = true;
    lattice.ground = {.level = -twin.length};
  }
  const auto order = twin.order(base.size());
  Flow flow(twins_of(base, twin, order),
            std::make_unique<SplineSpace>(lattice.ground, lattice, SplineSpace::Settings{.density = twin.density}),
            twin.field(tank ? sloshed : stirring),
            {.gravity = tank ? twin.acceleration(1) : 0, .density = twin.density, .penalty = tank ? 0.01 : 0}, {},
            stepping);
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
  const Particles& now = flow.particles();
  std::vector<std::size_t> places;
  for (const auto identity : now.identity) places.push_back(order[static_cast<std::size_t>(identity)]);
  return seen_in_plane(twin, places, now.x, now.z, now.u, now.w, flow.time());
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
    const auto times = [&](const std::function<double(double)>& f, double factor) {
      return f ? [f, factor, twin](double t) { return factor * f(t / twin.time); } : std::function<double(double)>();
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
  Forcing forcing{.gravity = twin.acceleration(1)};
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
    const double velocity = edge < n ? now.velocity[twin.in_row(edge, n)] : twin.velocity({0, 0}).x;
    seen.at(edge, twin, {now.edge[k], 0}, {velocity, 0}, flow.time());
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
  for (int k = 0; k < steps; ++k) flow.advance(0.03125 * twin.time);
  Seen seen(n);
  for (std::size_t k = 0; k < n; ++k) {
    seen.at(twin.in_row(k, n), {flow.depth()[k] / twin.length, 0}, twin.velocity_back({flow.velocity()[k], 0}));
  }
  return seen;
}
/// Of particles in any order: a free body, and water on walls under gravity.
const Which body{"mirror", "turned", "origin", "moving", "permuted"}, layer_of_water{"mirror", "along", "permuted"};

std::vector<Subject> bodies() {
  // Cut cells are continued along columns before rows, and cells stand still.
  const Which drop{"mirror", "origin", "permuted"};
  Subject overlaps{"overlapping", "overlapping particles"}, dirichlets{"dirichlet", "Dirichlet cells"},
      masses{"variable_mass", "variable-mass particles"}, gausses{"gauss", "Gauss-principle particles"},
      wcsphs{"wcsph", "WCSPH", 1, of_sums};
  overlaps.add("free blob", body, [](const Twin& t) { return overlapping(t, {}, false); });
  overlaps.add("over a floor", layer_of_water,
               [](const Twin& t) { return overlapping(t, {.stabilisation = 0.1}, true); });
  dirichlets.add("free patch", body, [](const Twin& t) { return dirichlet(t, false); });
  dirichlets.add("sloshing", layer_of_water, [](const Twin& t) { return dirichlet(t, true); });
  using enum variable_mass::ControlKind;
  for (const auto& [name, control, layer] : {std::tuple{"free patch", variable_mass::Control{centroid, 1, 0}, false},
                                             {"mapped", {mapped, 1, 0.5}, true},
                                             {"fixed in x", {fixed_x, 1, 0.5}, true}}) {
    masses.add(name, layer ? layer_of_water : body,
               [control = control, layer = layer](const Twin& t) { return variable(t, control, layer); });
  }
  using Gauss = gauss_particles::Stepping;
  gausses.add("drop", drop, [](const Twin& t) { return gauss(t, false, Gauss::conservative); });
  gausses.add("tank, penalty", layer_of_water, [](const Twin& t) { return gauss(t, true, Gauss::conservative); });
  gausses.add("drop, dissipative", drop, [](const Twin& t) { return gauss(t, false, Gauss::dissipative); });
  for (const auto& [name, settings] :
       {std::pair{"artificial viscosity", wcsph::Settings{.viscosity = wcsph::ArtificialViscosity{0.1}}},
        {"SPS stress, density diffusion", {.viscosity = wcsph::LaminarSps{}, .density_diffusion = 0.1}}}) {
    wcsphs.add(name, body, [settings = settings](const Twin& t) { return sph(t, settings); });
  }
  return {overlaps, dirichlets, masses, gausses, wcsphs};
}

Subject shallow_particles() {
  using namespace shallow_water_particles;
  Subject s{"particles", "shallow-water particles", 175,
            of_sums +
                ", of up to 300 steps 3.5 times as much; a position of a jump is a difference over its height of "
                "1/50 or more"};
  const auto add = [&](const std::string& name, const particles::Row& r, const Ends& ends, Level level, int many,
                       Which which = {}, bool rounds = false) {
    which.insert({"mirror", "along"});
    s.add(
        name, which, [=](const Twin& t) { return particles::run(t, r, ends, {.level = level}, many); }, rounds);
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
  Subject s{"finite_volumes", "shallow water, finite volumes", 1, of_sums};
  for (const Scheme scheme : {Scheme::lax_friedrichs, Scheme::mac_cormack, Scheme::roe, Scheme::muscl_hll}) {
    for (const bool inflow : {false, true}) {
      // MacCormack takes its differences to one side first.
      const Which which = scheme == Scheme::mac_cormack ? Which{"along"} : Which{"along", "mirror"};
      s.add(
          std::string(shallow_water_finite_volume::name(scheme)) + (inflow ? ", inflow" : ", walls"), which,
          [=](const Twin& t) { return volumes(t, scheme, inflow); }, scheme == Scheme::muscl_hll && !inflow);
    }
  }
  return s;
}

TEST_CASE(
    "flows of particles and cells are invariant under mirroring, rotation, change of units, translation, moving frames "
    "and renumbering",
    "[conservation]") {
  std::vector<Subject> subjects = bodies();
  subjects.push_back(shallow_particles());
  subjects.push_back(finite_volumes());
  judge(subjects);
}

}  // namespace seiche::verification::metamorphic_particles_test
