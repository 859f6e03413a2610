#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/overlapping_particles/flow.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "validation/drop/drop_contenders.hpp"
#include "validation/drop/round_patch.hpp"

namespace seiche::validation {
namespace {

using exact::StretchingDrop;

/// Of the pressures of cells: regular rings may be singular.
constexpr double stabilisation = 0.01;
constexpr double courant = 0.2;  ///< steps over the spacing: the drop's rim moves at the speed 1

Point first_velocity(Point r) {
  return {drop_drift.x + r.x, drop_drift.y - r.y};
}

/// Points of the rim: where they began, and how far from the exact place one is at a time.
class Rim {
 public:
  explicit Rim(const StretchingDrop& drop) : drop_(&drop) {}

  void add(std::size_t index, Point label) {
    indices_.push_back(index);
    labels_.push_back(label);
  }

  /// @param place  of the point of an index
  template <class Place>
  [[nodiscard]] std::vector<double> off(double time, const Place& place) const {
    const double a = drop_->semi_axis(time);
    const double b = drop_->other_axis(time);
    std::vector<double> distances;
    for (std::size_t k = 0; k < labels_.size(); ++k) {
      const Point at = place(indices_[k]);
      distances.push_back(
          std::hypot(at.x - drop_drift.x * time - a * labels_[k].x, at.y - drop_drift.y * time - b * labels_[k].y));
    }
    return distances;
  }

 private:
  const StretchingDrop* drop_;
  std::vector<std::size_t> indices_;
  std::vector<Point> labels_;
};

/// Of particles that were within so much of the rim.
Rim outer_particles(const StretchingDrop& drop, std::span<const double> x, std::span<const double> y, double within) {
  Rim rim(drop);
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (std::hypot(x[k], y[k]) > 1 - within) rim.add(k, {x[k], y[k]});
  }
  return rim;
}

/// A flow in equal steps; `momentum` and `places` are read off it.
template <class Flow, class Momentum, class PlacesOf>
Racer racer_of(const std::shared_ptr<Flow>& flow, const Rim& rim, double tau, Momentum momentum, PlacesOf places) {
  return {[flow, tau](double time) { march(*flow, time, tau); },
          [flow, rim, momentum, places] {
            const Places at = places(*flow);
            const auto [along, across] = momentum(*flow);
            return Sight{.off = rim.off(flow->time(),
                                        [&](std::size_t k) {
                                          return Point{at.x[k], at.y[k]};
                                        }),
                         .energy = flow->energy(),
                         .momentum = std::hypot(along, across)};
          }};
}

template <class Flow>
Places places_of(const Flow& flow) {
  return {flow.x(), flow.y()};
}
template <class Flow>
std::array<double, 2> momentum_of(const Flow& flow) {
  return flow.model().momentum(flow.state().q, flow.state().u);
}

Racer start_mesh(const StretchingDrop& drop, long cells) {
  const auto n = static_cast<std::size_t>(cells);
  lagrangian_mesh_2d::Mesh mesh = lagrangian_mesh_2d::free_patch(n, n, {-1, -1}, {1, 1});
  make_round(mesh.x, mesh.y);
  Rim rim(drop);
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i <= n; ++i) {
      if (i % n != 0 && j % n != 0) continue;
      const std::size_t k = mesh.node(i, j);
      rim.add(k, {mesh.x[k], mesh.y[k]});
    }
  }
  const auto flow = std::make_shared<lagrangian_mesh_2d::Flow>(mesh, first_velocity, lagrangian_mesh_2d::Scheme{},
                                                               lagrangian_mesh_2d::Settings{.gravity = 0},
                                                               lagrangian_mesh_2d::Forcing{}, false);
  using Flow = lagrangian_mesh_2d::Flow;
  return racer_of(flow, rim, courant * 2 / static_cast<double>(n), momentum_of<Flow>, places_of<Flow>);
}

Racer start_free_particles(const StretchingDrop& drop, long rings) {
  using gauss_particles::Flow;
  using gauss_particles::SplineSpace;
  const double spacing = 1 / static_cast<double>(rings);
  const gauss_particles::Particles particles = gauss_particles::disc(1, static_cast<std::size_t>(rings), 128);
  Rim rim(drop);
  for (std::size_t k = 0; k < particles.size(); ++k) {
    if (particles.mass[k] == 0) rim.add(k, {particles.x[k], particles.y[k]});
  }
  const auto flow =
      std::make_shared<Flow>(particles,
                             std::make_unique<SplineSpace>(gauss_particles::LatticePlan{.cell_x = 4 * spacing},
                                                           SplineSpace::Settings{.inner_fraction = 0.4}),
                             first_velocity, gauss_particles::Settings{.gravity = 0, .penalty = 0});
  return racer_of(flow, rim, courant * spacing, momentum_of<Flow>, places_of<Flow>);
}

Racer start_overlapping(const StretchingDrop& drop, long spacings) {
  using overlapping_particles::Flow;
  const double spacing = 1 / static_cast<double>(spacings);
  const overlapping_particles::Particles particles = overlapping_particles::staggered_disc(1, spacing);
  const Rim rim = outer_particles(drop, particles.x, particles.y, spacing);
  const auto flow = std::make_shared<Flow>(particles, first_velocity, overlapping_particles::Settings{});
  return racer_of(flow, rim, courant * spacing, momentum_of<Flow>, places_of<Flow>);
}

/// A node in the middle and six more in every ring than in the one within it, every other ring turned by half a
/// spacing.
free_lagrangian::Mesh round_cells(long rings) {
  free_lagrangian::Mesh mesh{.x = {0}, .y = {0}, .outline = {}};
  for (long ring = 1; ring <= rings; ++ring) {
    const double radius = static_cast<double>(ring) / static_cast<double>(rings);
    for (long k = 0; k < 6 * ring; ++k) {
      const double turned = static_cast<double>(k) + (ring % 2 == 0 ? 0 : 0.5);
      const double angle = 2 * std::numbers::pi * turned / static_cast<double>(6 * ring);
      if (ring == rings) mesh.outline.push_back(static_cast<int>(mesh.x.size()));
      mesh.x.push_back(radius * std::cos(angle));
      mesh.y.push_back(radius * std::sin(angle));
    }
  }
  mesh.held.resize(mesh.nodes());
  return mesh;
}

Rim outline_of(const StretchingDrop& drop, const free_lagrangian::Mesh& mesh) {
  Rim rim(drop);
  for (const int node : mesh.outline) rim.add(static_cast<std::size_t>(node), mesh.places()[node]);
  return rim;
}

Racer start_dirichlet(const StretchingDrop& drop, long rings) {
  using dirichlet_mesh::Flow;
  const free_lagrangian::Mesh mesh = round_cells(rings);
  const auto flow = std::make_shared<Flow>(mesh, first_velocity,
                                           dirichlet_mesh::Settings{.gravity = 0, .stabilisation = stabilisation});
  return racer_of(flow, outline_of(drop, mesh), courant / static_cast<double>(rings), momentum_of<Flow>,
                  places_of<Flow>);
}

/// Nodes inside go to the middle of their cells; those of the outline are particles.
Racer start_variable_mass(const StretchingDrop& drop, long rings) {
  using variable_mass::Flow;
  const free_lagrangian::Mesh mesh = round_cells(rings);
  const auto flow = std::make_shared<Flow>(
      mesh, variable_mass::Start{.velocity = first_velocity},
      variable_mass::Control{.kind = variable_mass::ControlKind::centroid, .rate = 1, .surface_rate = 0},
      variable_mass::Settings{.gravity = 0, .stabilisation = stabilisation});
  return racer_of(
      flow, outline_of(drop, mesh), courant / static_cast<double>(rings),
      [](const Flow& f) { return f.water().momentum(f.state().q, f.state().u); },
      [](const Flow& f) { return f.nodes(); });
}

Racer start_sph(const StretchingDrop& drop, long spacings) {
  using wcsph::Flow;
  const wcsph::Settings settings{.kernel = wcsph::KernelName::wendland_c2,
                                 .smoothing = 2,
                                 .gravity = 0,
                                 .density = 1,
                                 .sound_speed = 14,
                                 .viscosity = wcsph::Inviscid{},
                                 .xsph = 0.5};
  const double spacing = 1 / static_cast<double>(spacings);
  const wcsph::Scene scene =
      wcsph::patch({.radius = 1,
                    .velocity =
                        [](double x, double y) {
                          const Point v = first_velocity({x, y});
                          return wcsph::Velocity{v.x, v.y};
                        },
                    .pressure = [&](double x, double y) { return 0.5 * std::max(0.0, 1 - x * x - y * y); },
                    .spacing = spacing},
                   settings);
  const Rim rim = outer_particles(drop, scene.particles.x, scene.particles.z, spacing);
  const auto flow = std::make_shared<Flow>(scene.particles, scene.spacing, settings);
  return {[flow](double time) { march(*flow, time); },
          [flow, rim] {
            const wcsph::Particles& p = flow->particles();
            std::vector<Point> places(p.size());
            for (std::size_t k = 0; k < p.size(); ++k) {
              places.at(static_cast<std::size_t>(p.identity[k])) = {p.x[k], p.z[k]};
            }
            const wcsph::Totals totals = flow->totals();
            return Sight{.off = rim.off(flow->time(), [&](std::size_t k) { return places[k]; }),
                         .energy = totals.energy(),
                         .momentum = std::hypot(totals.momentum[0], totals.momentum[1])};
          }};
}

}  // namespace

std::vector<Contender> drop_contenders(const StretchingDrop& drop, const DropSizes& sizes) {
  const auto over = [](double whole) { return [whole](long n) { return whole / static_cast<double>(n); }; };
  const auto starting = [&drop](Racer (*start)(const StretchingDrop&, long)) {
    return [&drop, start](long n) { return start(drop, n); };
  };
  const std::vector<double> quarters{0.25, 0.5, 0.75, 1};
  return {
      {"particles", "free particles", "ring", Role::computed, ladder_to(sizes.rings, {0.357, 0.5, 0.714, 1}), over(1),
       starting(start_free_particles)},
      {"mesh", "Lagrangian mesh", "cell", Role::peer, ladder_to(sizes.mesh, quarters), over(2), starting(start_mesh)},
      {"dirichlet", "Dirichlet cells", "ring", Role::peer, ladder_to(sizes.cells, quarters), over(1),
       starting(start_dirichlet)},
      {"variable-mass", "variable mass", "ring", Role::peer, ladder_to(sizes.cells, quarters), over(1),
       starting(start_variable_mass)},
      {"overlapping", "overlapping particles", "particle spacing", Role::data,
       ladder_to(sizes.overlapping, {0.25, 0.5, 0.75, 1}), over(1), starting(start_overlapping)},
      {"sph", "SPH", "particle spacing", Role::peer, ladder_to(sizes.sph, {0.5, 0.7071, 1}), over(1),
       starting(start_sph)}};
}

}  // namespace seiche::validation
