/*
Which model suits a stretching drop? A round drop without gravity is stretched and drifts, computed with six models:
Gauss-principle particles, the Lagrangian mesh, Dirichlet cells, variable-mass particles, overlapping particles, and
weakly compressible SPH. The reference is Dirichlet's ellipse.

**Set-up.** Radius, density and strain rate are 1: initially $u = 0.3 + x$, $v = 0.2 - y$. The drift does not change the
relative motion, but gives the drop a momentum to conserve and moves it off the initial grid of the Gauss-principle
particles. Each model has its usual arrangement: rings of Gauss-principle particles with markers on the rim, a square
mesh made round, rings of Dirichlet cells, staggered rows, a square arrangement for SPH. The pressure stabilisation of
cells is 0.01; inner nodes of the variable-mass model move to the centres of their cells, outline nodes move with the
water. Steps are a fifth of the spacing, except SPH, which chooses its own. Each model is refined in space and time
together.

**What is compared.** Positions on the rim (markers, outline nodes, particles initially within a spacing of it) with the
exact positions at t = 1, when the drop is five times as long as wide; the processor time until then; the change of
energy and momentum. Each model then continues to t = 3, unless it breaks down or its rim error exceeds the minor
semi-axis.

**What to look at.** The exact velocities are linear, and the space of the Gauss-principle particles contains them:
their error is smaller by a factor of a hundred than all others, and they complete. The mesh error is first-order along
the outline; the mesh takes the least time and completes. Dirichlet and variable-mass cells are more accurate than the
mesh while they last; they end when two outline nodes meet or an inner cell has lost all its water, and refinement does
not extend their life. The error of overlapping particles is nearly a spacing, at a hundred times the cost of the mesh.
SPH completes, at ten times the cost of the Gauss-principle particles and with a hundred times their error. All models
conserve momentum; cells and SPH change the energy, the others conserve it.

**Limits of this test.** Linear fields favour the Gauss-principle particles, and the test has neither walls nor gravity.
Dispersive shallow water cannot represent a drop, because its water columns stand on a bed.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/affine_drop.hpp"
#include "seiche/geometry/curve.hpp"
#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/overlapping_particles/flow.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/side_by_side/contest.hpp"

namespace seiche::validation::cases::drop_models {

using exact::StretchingDrop;

// The square |xi|, |eta| <= 1 mapped on the disc of radius 1, by which meshes of squares become those of a round drop.

/// x = xi sqrt(1 - eta^2/2), y = eta sqrt(1 - xi^2/2): the four corners get a straight angle on the outline.
inline void make_round(std::vector<double>& x, std::vector<double>& y) {
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double xi = x[k];
    const double eta = y[k];
    x[k] = xi * std::sqrt(1 - eta * eta / 2);
    y[k] = eta * std::sqrt(1 - xi * xi / 2);
  }
}

// A round drop that is stretched, by six models, for a contest: gravity is 0, density, radius and strain rate are 1.

/// Velocity of the drop's middle: without it there would be no momentum to be kept, and fixed lattices would not notice
/// that the drop moves.
constexpr Point drop_drift{0.3, 0.2};

/// The finest resolution of each model.
struct DropSizes {
  long mesh = 32;         ///< cells across
  long rings = 28;        ///< of free particles to the radius
  long overlapping = 20;  ///< spacings to the radius
  long cells = 16;        ///< rings of Dirichlet cells and of variable masses
  long sph = 40;          ///< spacings to the radius
};

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

/// Each on a few resolutions up to the finest. `drop` is kept by reference.
std::vector<Contender> drop_contenders(const StretchingDrop& drop, const DropSizes& sizes) {
  const auto over = [](double whole) { return [whole](long n) { return whole / static_cast<double>(n); }; };
  const auto starting = [&drop](Racer (*start)(const StretchingDrop&, long)) {
    return [&drop, start](long n) { return start(drop, n); };
  };
  const std::vector<double> quarters{0.25, 0.5, 0.75, 1};
  return {{"particles", "Gauss particles", "ring", Role::computed, ladder_to(sizes.rings, {0.357, 0.5, 0.714, 1}),
           over(1), starting(start_free_particles)},
          {"mesh", "Lagrangian mesh", "cell size", Role::peer, ladder_to(sizes.mesh, quarters), over(2),
           starting(start_mesh)},
          {"dirichlet", "Dirichlet cells", "ring", Role::peer, ladder_to(sizes.cells, quarters), over(1),
           starting(start_dirichlet)},
          {"variable-mass", "variable mass", "ring", Role::peer, ladder_to(sizes.cells, quarters), over(1),
           starting(start_variable_mass)},
          {"overlapping", "overlapping particles", "particle spacing", Role::data,
           ladder_to(sizes.overlapping, {0.25, 0.5, 0.75, 1}), over(1), starting(start_overlapping)},
          {"sph", "SPH", "particle spacing", Role::peer, ladder_to(sizes.sph, {0.5, 0.7071, 1}), over(1),
           starting(start_sph)}};
}

const std::string source = "Dirichlet (1860); Frank, Discrete models of incompressible fluid (1994)";

const std::array<Named, 6> names{{{"particles", "Gauss particles"},
                                  {"mesh", "the Lagrangian mesh"},
                                  {"dirichlet", "Dirichlet cells"},
                                  {"variable-mass", "variable mass"},
                                  {"overlapping", "overlapping particles"},
                                  {"sph", "SPH"}}};

StretchingDrop the_drop() {
  return {1, 1, 1};
}

Trial trial_of(const Values& values) {
  const double last = values.real("last");
  return {.end = values.real("time"),
          .last = last,
          .looks = 12,
          .useless = the_drop().other_axis(last),
          .useless_in_words = "the surface error exceeds the minor semi-axis",
          .energy_scale = std::numbers::pi / 4,
          .momentum_scale = std::numbers::pi * std::numbers::sqrt2 / 2};
}

/// Steps of the finest resolution until errors are compared.
double steps_of(const Values& values, const std::string& id) {
  const double spacings = 5 * values.real("time");
  if (id == "particles") return spacings * values.number("rings");
  if (id == "mesh") return spacings * values.number("mesh") / 2;
  if (id == "overlapping") return spacings * values.number("overlapping");
  if (id == "sph") return values.real("time") * 14 / (0.3 * 2) * values.number("sph");
  return spacings * values.number("cells");
}

void claim_kept(const Claims<Contest>& all, const Values& values) {
  const double drift = 2 * (drop_drift.x * drop_drift.x + drop_drift.y * drop_drift.y);
  for (const Named& model : {names[0], names[1], names[4]}) {
    claim_energy(claims_of(all, model.id), model, 40 * steps_of(values, model.id), 1 + drift,
                 "in every step the reactions of a particle's or node's neighbours, forty at most, are rounded; scale: "
                 "the kinetic energy with the drift, over the energy of the stretching",
                 "Frank (1994), chapters 1 and 6");
  }
  for (const Named& model : names) {
    claims_of(all, model.id)
        .from("Frank (1994), chapter 1; forces of pairs are opposite")
        .check(
            model.id + "-momentum", fmt::format("The momentum of {} is conserved to round-off.", model.name),
            "change over the sum of all momenta", [](const Entry& entry) { return entry.finest().momentum; },
            Roundoff{.operations = steps_of(values, model.id),
                     .scale = 1,
                     .reason = "the sum of all momenta is rounded once in each step"});
  }
  for (const Named& model : {names[2], names[3]}) {
    claim_dissipates(claims_of(all, model.id), model,
                     "in each step the stabilisation takes a square of differences of the multipliers", source);
  }
  claims_of(all, "sph")
      .from("Monaghan (1994)")
      .check("sph-energy",
             "The energy change of SPH, compression included, is below the initial energy of compression, 1/(6 c^2).",
             "change over the energy of the stretching", energy_of_finest,
             Bound{.limit = 1.0 / (6 * 14 * 14),
                   .reason = "the initial energy of compression, 1/(6 c^2): the time-step error must be below the "
                             "resolution of the steps"});
}

void claim_accuracy(const Claims<Contest>& all, const Values& values) {
  claims_of(all, "particles")
      .check("particles-rim", "The outline error of Gauss-principle particles is below 1 % of the ring spacing.",
             "rms distance from the exact positions [radius]", error_of_finest,
             Bound{.limit = 0.01 / values.number("rings"),
                   .reason = "1 % of the ring spacing, below which particles do not define a surface position"});
  claims_of(all, "mesh")
      .check("mesh-order", "The outline error of the Lagrangian mesh converges at first order.",
             "order of the rms distance from the exact positions", &Entry::order,
             Order{.theory = 1,
                   .tolerance = 0.25,
                   .reason = "outline nodes slip along it at first order; the coarsest mesh has cells of a quarter of "
                             "the radius, where terms of other orders are as large"});
  for (const Named& model : {names[2], names[3], names[5]}) {
    claims_of(all, model.id)
        .check(
            model.id + "-rim", fmt::format("The outline error of {} is below one spacing.", model.name),
            "rms distance from the exact positions over the spacing",
            [](const Entry& entry) { return entry.finest().error / entry.finest().size; },
            Bound{.limit = 1, .reason = "a surface is uncertain by one spacing"});
  }
  claims_of(all, "overlapping")
      .at(fmt::format("{} spacings per radius", values.integer("overlapping") / 2))
      .check(
          "overlapping-rim",
          "The drop outline of overlapping particles, at half as many rows, is within one particle spacing of the "
          "exact ellipse.",
          "rms distance from the exact positions over the spacing",
          [](const Entry& entry) { return entry.attempts.at(1).error / entry.attempts.at(1).size; },
          Bound{.limit = 1,
                .reason = "a surface is uncertain by one spacing; at finer resolution the error contains unpredictable "
                          "noise of single particles"});
  all.check(
      "nearest", "Gauss-principle particles give the smallest outline error of all models.",
      "their error is the smallest",
      [](const Contest& contest) {
        const double least = contest.of("particles").finest().error;
        return std::ranges::all_of(contest.entries(),
                                   [least](const Entry& one) { return !(one.finest().error < least); });
      },
      Qualitative{.detector = "error of the finest resolution of each",
                  .reason = "their space contains the linear fields of the exact motion"});
}

void claim_ends(const Claims<Contest>& all, const Values& values) {
  const auto lasting =
      all.only_if(values.real("last") <= 3, "the smallest drop thickness that the particles resolve is unknown");
  for (const Named& model : {names[0], names[1]}) {
    claim_lasts(claims_of(lasting, model.id), model, values.real("last"), source);
  }
  claim_breaks(claims_of(all.only_if(values.real("last") >= 3, "they complete until the drop is thin"), "dirichlet"),
               names[2], "the outline is stretched, and no force restores the position of a node in its cell", source);
}

void claims(const Values& values, const Claims<Contest>& all) {
  const Claims<Contest> claims = all.at(fmt::format("the finest, t = {:g}", values.real("time")));
  claim_accuracy(claims, values);
  claim_kept(claims, values);
  claim_ends(claims, values);
}

Contest compute(const Run& run) {
  const StretchingDrop drop = the_drop();
  return contest(run,
                 drop_contenders(drop, {.mesh = run.integer("mesh"),
                                        .rings = run.integer("rings"),
                                        .overlapping = run.integer("overlapping"),
                                        .cells = run.integer("cells"),
                                        .sph = run.integer("sph")}),
                 trial_of(run));
}

void show(const Contest& contest, const Values& /*values*/, evidence::Exhibit& exhibit) {
  contest.show(exhibit, {.size = "radius", .error = "radius", .time = "1/strain rate"});
}

void drop_models(Case& c) {
  c.title = "Model comparison: a stretched drop";
  c.source = "P. G. L. Dirichlet, Abh. Kgl. Ges. Wiss. Goettingen 8 (1860) 3; A. M. Frank, doctoral thesis (1994)";
  c.parameters = {
      real("time", 1.0, "1/strain rate", {0.1, 5}, "at which errors are compared"),
      real("last", 3.0, "1/strain rate", {0.1, 20}, "until which the models are followed"),
      integer("mesh", {32, 64, 64}, {16, 256}, "cells across the Lagrangian mesh, finest of four"),
      integer("rings", {28, 56, 56}, {14, 140}, "of Gauss-principle particles per radius, finest of four"),
      integer("cells", {16, 32, 32}, {8, 64}, "rings of Dirichlet cells and of variable masses, finest of four"),
      integer("overlapping", {16, 40, 40}, {12, 80}, "spacings of overlapping particles per radius, finest of four"),
      integer("sph", {28, 80, 80}, {12, 400}, "spacings of SPH particles per radius, finest of three"),
  };
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::drop_models
