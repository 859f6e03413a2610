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
#include "validation/instruments/each.hpp"
#include "validation/studies/side_by_side/contest.hpp"

namespace seiche::validation::cases::drop_models {

const std::string source = "Dirichlet (1860); Frank, Discrete models of incompressible fluid (1994)";

/// Gravity is 0, density, radius and strain rate are 1.
const exact::StretchingDrop drop(1, 1, 1);

/// Velocity of the drop's middle: without it there would be no momentum to be kept, and fixed lattices would not notice
/// that the drop moves.
constexpr Point drift{0.3, 0.2};

/// Of the pressures of cells: regular rings may be singular.
constexpr double stabilisation = 0.01;
constexpr double courant = 0.2;  ///< steps over the spacing: the drop's rim moves at the speed 1

Point first_velocity(Point r) {
  return {drift.x + r.x, drift.y - r.y};
}

/// A point of the rim, and where it began.
struct RimPoint {
  std::size_t index;
  Point label;
};
using Rim = std::vector<RimPoint>;

/// @param at_rim  whether the point of an index belongs to it
template <class AtRim>
Rim rim_of(std::span<const double> x, std::span<const double> y, const AtRim& at_rim) {
  Rim rim;
  for (const std::size_t k : indices(x.size())) {
    if (at_rim(k)) rim.push_back({k, {x[k], y[k]}});
  }
  return rim;
}

/// Of particles that were within so much of the rim.
Rim outer_particles(std::span<const double> x, std::span<const double> y, double within) {
  return rim_of(x, y, [&](std::size_t k) { return std::hypot(x[k], y[k]) > 1 - within; });
}

/// How far the rim is from where it should be. @param place  of the point of an index
template <class Place>
std::vector<double> distances(const Rim& rim, double time, const Place& place) {
  const double a = drop.semi_axis(time);
  const double b = drop.other_axis(time);
  return each(rim, [&](const RimPoint& point) {
    const Point at = place(point.index);
    return std::hypot(at.x - drift.x * time - a * point.label.x, at.y - drift.y * time - b * point.label.y);
  });
}

/// A flow in equal steps.
template <class Flow>
Racer racer_of(const std::shared_ptr<Flow>& flow, const Rim& rim, double tau) {
  return {[flow, tau](double time) { march(*flow, time, tau); },
          [flow, rim] {
            const auto place = [&](std::size_t k) { return Point{flow->x()[k], flow->y()[k]}; };
            const auto [along, across] = flow->model().momentum(flow->state().q, flow->state().u);
            return Sight{.off = distances(rim, flow->time(), place),
                         .energy = flow->energy(),
                         .momentum = std::hypot(along, across)};
          }};
}

/// The square |xi|, |eta| <= 1 of square cells, mapped on the disc of radius 1 by x = xi sqrt(1 - eta^2/2),
/// y = eta sqrt(1 - xi^2/2): the four corners get a straight angle on the outline.
Racer start_mesh(long cells) {
  using lagrangian_mesh_2d::Flow;
  const auto n = static_cast<std::size_t>(cells);
  lagrangian_mesh_2d::Mesh mesh = lagrangian_mesh_2d::free_patch(n, n, {-1, -1}, {1, 1});
  for (std::size_t k = 0; k < mesh.x.size(); ++k) {
    const double xi = mesh.x[k];
    const double eta = mesh.y[k];
    mesh.x[k] = xi * std::sqrt(1 - eta * eta / 2);
    mesh.y[k] = eta * std::sqrt(1 - xi * xi / 2);
  }
  const Rim rim = rim_of(mesh.x, mesh.y, [n](std::size_t k) { return k % (n + 1) % n == 0 || k / (n + 1) % n == 0; });
  const auto flow =
      std::make_shared<Flow>(mesh, first_velocity, lagrangian_mesh_2d::Scheme{},
                             lagrangian_mesh_2d::Settings{.gravity = 0}, lagrangian_mesh_2d::Forcing{}, false);
  return racer_of(flow, rim, courant * 2 / static_cast<double>(n));
}

Racer start_free_particles(long rings) {
  using gauss_particles::SplineSpace;
  const double spacing = 1 / static_cast<double>(rings);
  const gauss_particles::Particles particles = gauss_particles::disc(1, static_cast<std::size_t>(rings), 128);
  const Rim rim = rim_of(particles.x, particles.y, [&](std::size_t k) { return particles.mass[k] == 0; });
  const auto flow = std::make_shared<gauss_particles::Flow>(
      particles,
      std::make_unique<SplineSpace>(gauss_particles::LatticePlan{.cell_x = 4 * spacing},
                                    SplineSpace::Settings{.inner_fraction = 0.4}),
      first_velocity, gauss_particles::Settings{.gravity = 0, .penalty = 0});
  return racer_of(flow, rim, courant * spacing);
}

Racer start_overlapping(long spacings) {
  const double spacing = 1 / static_cast<double>(spacings);
  const overlapping_particles::Particles particles = overlapping_particles::staggered_disc(1, spacing);
  const auto flow =
      std::make_shared<overlapping_particles::Flow>(particles, first_velocity, overlapping_particles::Settings{});
  return racer_of(flow, outer_particles(particles.x, particles.y, spacing), courant * spacing);
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

template <class Flow>
Racer racer_of_cells(const std::shared_ptr<Flow>& flow, const free_lagrangian::Mesh& mesh, long rings) {
  const auto at_rim = [&](std::size_t k) { return std::ranges::count(mesh.outline, static_cast<int>(k)) > 0; };
  return racer_of(flow, rim_of(mesh.x, mesh.y, at_rim), courant / static_cast<double>(rings));
}

Racer start_dirichlet(long rings) {
  const free_lagrangian::Mesh mesh = round_cells(rings);
  return racer_of_cells(
      std::make_shared<dirichlet_mesh::Flow>(mesh, first_velocity,
                                             dirichlet_mesh::Settings{.gravity = 0, .stabilisation = stabilisation}),
      mesh, rings);
}

/// Nodes inside go to the middle of their cells; those of the outline are particles.
Racer start_variable_mass(long rings) {
  const free_lagrangian::Mesh mesh = round_cells(rings);
  return racer_of_cells(
      std::make_shared<variable_mass::Flow>(
          mesh, variable_mass::Start{.velocity = first_velocity},
          variable_mass::Control{.kind = variable_mass::ControlKind::centroid, .rate = 1, .surface_rate = 0},
          variable_mass::Settings{.gravity = 0, .stabilisation = stabilisation}),
      mesh, rings);
}

Racer start_sph(long spacings) {
  const wcsph::Settings settings{.kernel = wcsph::KernelName::wendland_c2,
                                 .smoothing = 2,
                                 .gravity = 0,
                                 .density = 1,
                                 .sound_speed = 14,
                                 .viscosity = wcsph::Inviscid{},
                                 .xsph = 0.5};
  const double spacing = 1 / static_cast<double>(spacings);
  const auto velocity = [](double x, double y) {
    const Point v = first_velocity({x, y});
    return wcsph::Velocity{v.x, v.y};
  };
  const auto pressure = [](double x, double y) { return 0.5 * std::max(0.0, 1 - x * x - y * y); };
  const wcsph::Scene scene =
      wcsph::patch({.radius = 1, .velocity = velocity, .pressure = pressure, .spacing = spacing}, settings);
  const Rim rim = outer_particles(scene.particles.x, scene.particles.z, spacing);
  const auto flow = std::make_shared<wcsph::Flow>(scene.particles, scene.spacing, settings);
  return {[flow](double time) { march(*flow, time); },
          [flow, rim] {
            const wcsph::Particles& p = flow->particles();
            std::vector<Point> places(p.size());
            for (std::size_t k = 0; k < p.size(); ++k) {
              places.at(static_cast<std::size_t>(p.identity[k])) = {p.x[k], p.z[k]};
            }
            const wcsph::Totals totals = flow->totals();
            return Sight{.off = distances(rim, flow->time(), [&](std::size_t k) { return places[k]; }),
                         .energy = totals.energy(),
                         .momentum = std::hypot(totals.momentum[0], totals.momentum[1])};
          }};
}

/// A model, and how finely it is computed.
struct Model {
  Named named;
  std::string title;  ///< in tables and figures
  std::string size_of;
  Role role;
  std::string finest;         ///< parameter: sizes on its finest resolution
  std::vector<double> parts;  ///< of them, on all resolutions
  double whole;               ///< over so many radii
  Racer (*start)(long);

  /// Steps of the finest resolution until errors are compared.
  [[nodiscard]] double steps(const Values& values) const {
    const double time = values.real("time");
    return named.id == "sph" ? time * 14 / (0.3 * 2) * values.number(finest) : 5 * time * values.number(finest) / whole;
  }
  [[nodiscard]] Contender contender(const Values& values) const {
    const auto size = [over = whole](long n) { return over / static_cast<double>(n); };
    return {named.id, title, size_of, role, ladder_to(values.integer(finest), parts), size, start};
  }
};

const std::vector<double> quarters{0.25, 0.5, 0.75, 1};
const std::array<Model, 6> models{
    {{{"particles", "Gauss particles"},
      "Gauss particles",
      "ring",
      Role::computed,
      "rings",
      {0.357, 0.5, 0.714, 1},
      1,
      start_free_particles},
     {{"mesh", "the Lagrangian mesh"}, "Lagrangian mesh", "cell size", Role::peer, "mesh", quarters, 2, start_mesh},
     {{"dirichlet", "Dirichlet cells"}, "Dirichlet cells", "ring", Role::peer, "cells", quarters, 1, start_dirichlet},
     {{"variable-mass", "variable mass"},
      "variable mass",
      "ring",
      Role::peer,
      "cells",
      quarters,
      1,
      start_variable_mass},
     {{"overlapping", "overlapping particles"},
      "overlapping particles",
      "particle spacing",
      Role::data,
      "overlapping",
      quarters,
      1,
      start_overlapping},
     {{"sph", "SPH"}, "SPH", "particle spacing", Role::peer, "sph", {0.5, 0.7071, 1}, 1, start_sph}}};

Claims<Entry> claims_of(const Claims<Contest>& claims, const Model& model) {
  return validation::claims_of(claims, model.named.id);
}

void claim_kept(const Claims<Contest>& all, const Values& values) {
  const double kinetic_of_drift = 2 * (drift.x * drift.x + drift.y * drift.y);
  for (const Model& model : {models[0], models[1], models[4]}) {
    claim_energy(claims_of(all, model), model.named, 40 * model.steps(values), 1 + kinetic_of_drift,
                 "in every step the reactions of a particle's or node's neighbours, forty at most, are rounded; scale: "
                 "the kinetic energy with the drift, over the energy of the stretching",
                 "Frank (1994), chapters 1 and 6");
  }
  for (const Model& model : models) {
    claims_of(all, model)
        .from("Frank (1994), chapter 1; forces of pairs are opposite")
        .check(
            model.named.id + "-momentum",
            fmt::format("The momentum of {} is conserved to round-off.", model.named.name),
            "change over the sum of all momenta", [](const Entry& entry) { return entry.finest().momentum; },
            Roundoff{.operations = model.steps(values),
                     .scale = 1,
                     .reason = "the sum of all momenta is rounded once in each step"});
  }
  for (const Model& model : {models[2], models[3]}) {
    claim_dissipates(claims_of(all, model), model.named,
                     "in each step the stabilisation takes a square of differences of the multipliers", source);
  }
  claims_of(all, models[5])
      .from("Monaghan (1994)")
      .check("sph-energy",
             "The energy change of SPH, compression included, is below the initial energy of compression, 1/(6 c^2).",
             "change over the energy of the stretching", energy_of_finest,
             Bound{.limit = 1.0 / (6 * 14 * 14),
                   .reason = "the initial energy of compression, 1/(6 c^2): the time-step error must be below the "
                             "resolution of the steps"});
}

void claim_accuracy(const Claims<Contest>& all, const Values& values) {
  claims_of(all, models[0])
      .check("particles-rim", "The outline error of Gauss-principle particles is below 1 % of the ring spacing.",
             "rms distance from the exact positions [radius]", error_of_finest,
             Bound{.limit = 0.01 / values.number("rings"),
                   .reason = "1 % of the ring spacing, below which particles do not define a surface position"});
  claims_of(all, models[1])
      .check("mesh-order", "The outline error of the Lagrangian mesh converges at first order.",
             "order of the rms distance from the exact positions", &Entry::order,
             Order{.theory = 1,
                   .tolerance = 0.25,
                   .reason = "outline nodes slip along it at first order; the coarsest mesh has cells of a quarter of "
                             "the radius, where terms of other orders are as large"});
  const auto spacings_off = [](const Attempt& attempt) { return attempt.error / attempt.size; };
  const std::string quantity = "rms distance from the exact positions over the spacing";
  for (const Model& model : {models[2], models[3], models[5]}) {
    claims_of(all, model)
        .check(
            model.named.id + "-rim", fmt::format("The outline error of {} is below one spacing.", model.named.name),
            quantity, [=](const Entry& entry) { return spacings_off(entry.finest()); },
            Bound{.limit = 1, .reason = "a surface is uncertain by one spacing"});
  }
  claims_of(all, models[4])
      .at(fmt::format("{} spacings per radius", values.integer("overlapping") / 2))
      .check(
          "overlapping-rim",
          "The drop outline of overlapping particles, at half as many rows, is within one particle spacing of the "
          "exact ellipse.",
          quantity, [=](const Entry& entry) { return spacings_off(entry.attempts.at(1)); },
          Bound{.limit = 1,
                .reason = "a surface is uncertain by one spacing; at finer resolution the error contains "
                          "unpredictable noise of single particles"});
  all.check(
      "nearest", "Gauss-principle particles give the smallest outline error of all models.",
      "their error is the smallest",
      [](const Contest& contest) {
        const double least = contest.of("particles").finest().error;
        return std::ranges::none_of(contest.entries(), [=](const Entry& one) { return one.finest().error < least; });
      },
      Qualitative{.detector = "error of the finest resolution of each",
                  .reason = "their space contains the linear fields of the exact motion"});
}

void claims(const Values& values, const Claims<Contest>& all) {
  const Claims<Contest> claims = all.at(fmt::format("the finest, t = {:g}", values.real("time")));
  const double last = values.real("last");
  claim_accuracy(claims, values);
  claim_kept(claims, values);
  for (const Model& model : {models[0], models[1]}) {
    claim_lasts(claims_of(claims, model)
                    .only_if(last <= 3, "the smallest drop thickness that the particles resolve is unknown"),
                model.named, last, source);
  }
  claim_breaks(claims_of(claims, models[2]).only_if(last >= 3, "they complete until the drop is thin"), models[2].named,
               "the outline is stretched, and no force restores the position of a node in its cell", source);
}

Contest compute(const Run& run) {
  const double last = run.real("last");
  std::vector<Contender> contenders;
  for (const Model& model : models) contenders.push_back(model.contender(run));
  return contest(run, contenders,
                 {.end = run.real("time"),
                  .last = last,
                  .looks = 12,
                  .useless = drop.other_axis(last),
                  .useless_in_words = "the surface error exceeds the minor semi-axis",
                  .energy_scale = std::numbers::pi / 4,
                  .momentum_scale = std::numbers::pi * std::numbers::sqrt2 / 2});
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
