/*
Which model suits a collapsing column? A water column twice as high as wide collapses at a wall and runs over a dry bed,
computed with six models: Gauss-principle particles, the Lagrangian mesh, Dirichlet cells, variable-mass particles,
overlapping particles, and weakly compressible SPH. The reference is the front measured by Martin and Moyce (1952).

**Set-up.** Width $a$, gravity and density are 1; $T = t\sqrt{2g/a}$. Gauss-principle particles are set as in
`collapse_gauss`; SPH has the settings of `dam_break_sph_front` with a sound speed of ten times the free-fall velocity
over the column height. Mesh and cells are rectangles with a wall and a bed, free elsewhere; overlapping particles have
mirror images behind both. Each model is refined in space and time together.

**What is compared.** The front with the measured points, after the best shift of the time origin (the experiment
released the column by melting a diaphragm of waxed paper): rms difference over the width, for points up to T = 3.4.
Each model then continues to T = 5, unless it breaks down or its front is in error by half of the width.

**What to look at.** Two models complete: Gauss-principle particles agree with the points within their uncertainty, on
eight cells over the width; SPH approaches the points as its viscosity falls with the spacing, and loses 20 % of the
energy. The other models fail. The mesh tangles at the upper corner of the column, whose right angle opens until it is
straight. A triangle of the Dirichlet cells inverts at the toe, where velocities are highest. Overlapping particles pass
through the bed, because single pressures are chequered. Variable-mass particles need a single-valued surface elevation
and cannot represent a column. Each of these fails earlier at finer resolution.

**Limits of this test.** No comparison is meaningful once the tongue is thinner than a cell or spacing. Dispersive
shallow water has no vertical front.
*/
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/overlapping_particles/flow.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/dam_break/column_front.hpp"
#include "validation/dam_break/gauss_column.hpp"
#include "validation/instruments/particles/sph_front.hpp"
#include "validation/studies/side_by_side/contest.hpp"

namespace seiche::validation::cases::dam_break_models {

// A column of water twice as high as wide collapses over a dry bed, by six models, for a contest. Its width, gravity
// and density are 1.

constexpr double column_aspect = 2;

constexpr double column_tank = 8;  ///< length of the tank of SPH, in widths; the others have none

const double unit = std::sqrt(column_aspect);  // T/t; NOLINT(modernize-use-std-numbers): it happens to be 2
constexpr double courant = 0.2;                ///< steps over the spacing, which a fall of the column's height takes

/// The front in time, and how far it is from the measured points.
struct History {
  ColumnFront measured;
  std::vector<double> T = {}, X = {};

  void add(double time, double front) {
    if (!T.empty() && !(time * unit > T.back())) return;
    T.push_back(time * unit);
    X.push_back(front);
  }

  [[nodiscard]] std::vector<double> off() const {
    constexpr ShiftRange range;
    const double latest = T.back() + range.lowest;
    if (std::ranges::count_if(measured.T, [latest](double at) { return at <= latest; }) < 2) return {};
    const ShiftedFront fit = shifted_front({T, X}, measured.curve(), column_tank, range);
    std::vector<double> all;
    for (std::size_t k = 0; k < measured.T.size() && measured.T[k] <= latest; ++k) {
      all.push_back(linear_at({T, X}, std::max(measured.T[k] - fit.shift, T.front())) - measured.X[k]);
    }
    return all;
  }
};

/// A flow in equal steps, whose front is read after each.
template <class Flow, class Front>
Racer racer_of(const std::shared_ptr<Flow>& flow, const ColumnFront& measured, double tau, Front front) {
  const auto history = std::make_shared<History>(History{measured});
  history->add(0, front(*flow));
  return {[=](double time) { march(*flow, time, tau, [=] { history->add(flow->time(), front(*flow)); }); },
          [=] { return Sight{.off = history->off(), .energy = flow->energy()}; }};
}

Racer start_particles(const ColumnFront& measured, long cells) {
  using gauss_particles::Flow;
  const GaussColumn column{.aspect = column_aspect, .cells = cells};
  // make_shared would move what cannot move.
  return racer_of(std::shared_ptr<Flow>(new Flow(column.start())),  // NOLINT(modernize-make-shared)
                  measured, column.tau(), [](const Flow& f) { return std::ranges::max(f.markers(), {}, &Point::x).x; });
}

const auto farthest_node = [](const auto& flow) { return largest(flow.x()); };

Racer start_mesh(const ColumnFront& measured, long columns) {
  const auto n = static_cast<std::size_t>(columns);
  lagrangian_mesh_2d::Mesh mesh = lagrangian_mesh_2d::free_patch(n, 2 * n, {0, 0}, {1, column_aspect});
  mesh.sides.left = lagrangian_mesh_2d::vertical_wall(0);
  mesh.sides.bottom = lagrangian_mesh_2d::level_wall(0);
  return racer_of(std::make_shared<lagrangian_mesh_2d::Flow>(mesh), measured, courant / static_cast<double>(n),
                  farthest_node);
}

free_lagrangian::Mesh cells_at_wall(long columns) {
  const int n = static_cast<int>(columns);
  return free_lagrangian::layer_mesh(
      {.end = 1, .bottom = 0, .level = column_aspect, .columns = n, .rows = 2 * n, .right_wall = false});
}

constexpr double stabilisation = 0.01;  ///< of the pressures of cells

Racer start_dirichlet(const ColumnFront& measured, long columns) {
  using dirichlet_mesh::Flow;
  return racer_of(std::make_shared<Flow>(cells_at_wall(columns), free_lagrangian::VelocityAt{},
                                         dirichlet_mesh::Settings{.stabilisation = stabilisation}),
                  measured, courant / static_cast<double>(columns), farthest_node);
}

/// Nodes inside go to the middle of their cells; those of the surface are particles.
Racer start_variable_mass(const ColumnFront& measured, long columns) {
  using variable_mass::Flow;
  const variable_mass::Control control{.kind = variable_mass::ControlKind::centroid, .rate = 1, .surface_rate = 0};
  return racer_of(std::make_shared<Flow>(cells_at_wall(columns), variable_mass::Start{}, control,
                                         variable_mass::Settings{.stabilisation = stabilisation}),
                  measured, courant / static_cast<double>(columns), [](const Flow& f) { return largest(f.nodes().x); });
}

/// Rows half a spacing from wall and bed, behind which there are their mirror images.
Racer start_overlapping(const ColumnFront& measured, long across) {
  using overlapping_particles::Flow;
  const double h = 1 / static_cast<double>(across);
  const double row = h * std::numbers::sqrt3 / 4;
  const auto flow = std::make_shared<Flow>(
      overlapping_particles::staggered(
          {.spacing = h, .lower = {0.2 * h, 0.5 * row}, .upper = {1, column_aspect}, .through = {h / 2, row}}),
      overlapping_particles::VelocityAt{},
      overlapping_particles::Settings{
          .gravity = 1, .stabilisation = 0.01, .walls = {{{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}}});
  return racer_of(flow, measured, courant * h, [h](const Flow& f) { return largest(f.x()) + h / 2; });
}

/// As of the publication of dam_break_sph_front: cubic spline, artificial viscosity 0.3, XSPH.
Racer start_sph(const ColumnFront& measured, long across) {
  using wcsph::Flow;
  const wcsph::Settings settings{.kernel = wcsph::KernelName::cubic_spline,
                                 .smoothing = 1.3,
                                 .gravity = 1,
                                 .density = 1,
                                 .sound_speed = 10 * std::sqrt(2 * column_aspect),
                                 .viscosity = wcsph::ArtificialViscosity{0.3},
                                 .xsph = 0.5};
  const wcsph::Scene scene = wcsph::dam_break({.width = 1,
                                               .height = column_aspect,
                                               .tank_length = column_tank,
                                               .wall_height = 1.5 * column_aspect,
                                               .spacing = 1 / static_cast<double>(across)},
                                              settings);
  const auto flow = std::make_shared<Flow>(scene.particles, scene.spacing, settings);
  const auto history = std::make_shared<History>(History{measured});
  const auto look = [=, wall = scene.rear_wall] {
    history->add(flow->time(), wcsph::front_position(flow->particles(), flow->smoothing_length()) - wall);
  };
  look();
  return {[=](double time) {
            const double interval = 0.02 / unit;
            while (flow->time() < time) {
              march(*flow, std::min(time, flow->time() + interval));
              look();
            }
          },
          [=] { return Sight{.off = history->off(), .energy = flow->totals().energy()}; }};
}

const std::string source = "Frank, Discrete models of incompressible fluid (1994); Martin and Moyce (1952)";
const Named particles{"particles", "Gauss particles"};
const Named sph{"sph", "SPH"};

ColumnFront data_of(const Values& values) {
  return column_front("martin_moyce_tall_wide", values);
}

Trial trial_of(const Values& values) {
  const ColumnFront data = data_of(values);
  const auto points =
      static_cast<double>(std::ranges::count_if(data.T, [&](double T) { return T < values.real("time") - 0.2; }));
  return {.end = values.real("time") / unit,
          .last = values.real("last") / unit,
          .looks = 20,
          .useless = 0.5,
          .useless_in_words = "the front error exceeds half of the column width",
          .energy_scale = column_aspect * column_aspect / 2,
          .reference_uncertainty = data.uncertainty * std::sqrt(2 / points)};
}

void claims(const Values& values, const Claims<Contest>& all) {
  const Claims<Contest> claims = all.at(fmt::format("the finest, T = {:g}", values.real("time")));
  const ColumnFront data = data_of(values);
  for (const Named& model : {particles, sph}) {
    claims_of(claims.only_if(values.real("time") <= 3.6, "the tongue is thin at later times"), model.id)
        .from(data.citation)
        .check(model.id + "-front",
               fmt::format("The front position after one time shift agrees with the measured points: {}.", model.name),
               "rms difference of X/a", error_of_finest, through_points(data));
    claim_dissipates(claims_of(claims, model.id), model,
                     "the penalty of the Gauss-principle particles and the viscosity of SPH are purely dissipative",
                     source);
    claim_lasts(claims_of(claims.only_if(values.real("last") <= 5,
                                         "the smallest tongue thickness that the particles resolve is unknown"),
                          model.id),
                model, trial_of(values).last, source);
  }
  claims_of(claims, "particles")
      .check("particles-energy-loss",
             "The dissipation of the penalty on Gauss-principle particles is below the energy of eddies at the front, "
             "one cell high.",
             "change over the initial energy", energy_of_finest,
             Bound{.limit = 0.01 / values.number("particles"),
                   .reason = "1 %, for eddies of one cell at the front, which is one cell high: one cell of the number "
                             "over the width, of a column that falls as a whole"});
  const auto breaks = [&](const Named& model, const std::string& reason) {
    claim_breaks(claims_of(claims, model.id), model, reason, source);
  };
  breaks({"mesh", "the Lagrangian mesh"},
         "the right angle between top and face opens until it is straight, where a cell corner inverts");
  breaks({"dirichlet", "Dirichlet cells"}, "the outline meets the bed at the toe, and cells cannot change the outline");
  breaks({"overlapping", "overlapping particles"},
         "chequered multipliers of many times the pressure drive single particles at the bed");
  breaks({"variable-mass", "particles of variable mass"},
         "surface nodes represent the elevation as a function of x, which a vertical face is not");
}

/// What is off are fronts at the times of the measured points, with the one shift of the time origin that fits them
/// best.
Contest compute(const Run& run) {
  const auto contender = [measured = data_of(run)](const std::string& id, const std::string& name, Role role,
                                                   const std::vector<long>& resolutions,
                                                   Racer (*start)(const ColumnFront&, long),
                                                   const std::string& size_of = "cell size") {
    return Contender{.id = id,
                     .name = name,
                     .size_of = size_of,
                     .role = role,
                     .resolutions = resolutions,
                     .size = [](long n) { return 1 / static_cast<double>(n); },
                     .start = [=](long n) { return start(measured, n); },
                     .may_refuse = start == start_variable_mass};
  };
  const auto three = [&](const std::string& finest) { return ladder_to(run.integer(finest), {0.5, 0.75, 1}); };
  return contest(run,
                 {contender("particles", "Gauss particles", Role::computed, three("particles"), start_particles),
                  contender("mesh", "Lagrangian mesh", Role::peer, three("mesh"), start_mesh),
                  contender("dirichlet", "Dirichlet cells", Role::peer, three("cells"), start_dirichlet),
                  contender("variable-mass", "variable mass", Role::peer, {run.integer("cells")}, start_variable_mass),
                  contender("overlapping", "overlapping particles", Role::data, three("overlapping"), start_overlapping,
                            "particle spacing"),
                  contender("sph", "SPH", Role::peer, three("sph"), start_sph, "particle spacing")},
                 trial_of(run));
}

void show(const Contest& contest, const Values& /*values*/, evidence::Exhibit& exhibit) {
  contest.show(exhibit, {.size = "width", .error = "width", .time = "sqrt(width/g)"});
}

void dam_break_models(Case& c) {
  c.title = "Model comparison: a collapsing column";
  c.source = literature::martin_moyce + "; " + literature::frank;
  c.parameters = {
      real("time", 3.6, "sqrt(width/2g)", {2.3, 6}, "at which errors are compared"),
      real("last", 5.0, "sqrt(width/2g)", {2.3, 6}, "until which the models are followed"),
      integer("particles", {8, 16, 16}, {4, 32}, "cells of the Gauss-principle particles per width, finest of three"),
      integer("mesh", {16, 32, 32}, {4, 64}, "columns of the Lagrangian mesh, finest of three"),
      integer("cells", {16, 32, 32}, {4, 64}, "columns of Dirichlet cells and variable masses, finest of three"),
      integer("overlapping", {16, 32, 32}, {8, 64}, "overlapping particles per width, finest of three"),
      integer("sph", {24, 60, 60}, {10, 200}, "SPH particles per width, finest of three"),
  };
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::dam_break_models
