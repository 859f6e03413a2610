#include "validation/dam_break/column_contenders.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/overlapping_particles/flow.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "validation/dam_break/gauss_column.hpp"
#include "validation/instruments/sph_front.hpp"

namespace seiche::validation {
namespace {

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
      const double found = linear_at({T, X}, std::max(measured.T[k] - fit.shift, T.front()));
      all.push_back(found - measured.X[k]);
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

Racer start_mesh(const ColumnFront& measured, long columns) {
  using lagrangian_mesh_2d::Flow;
  const auto n = static_cast<std::size_t>(columns);
  lagrangian_mesh_2d::Mesh mesh = lagrangian_mesh_2d::free_patch(n, 2 * n, {0, 0}, {1, column_aspect});
  mesh.sides.left = lagrangian_mesh_2d::vertical_wall(0);
  mesh.sides.bottom = lagrangian_mesh_2d::level_wall(0);
  return racer_of(std::make_shared<Flow>(mesh), measured, courant / static_cast<double>(n),
                  [](const Flow& f) { return largest(f.x()); });
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
                  measured, courant / static_cast<double>(columns), [](const Flow& f) { return largest(f.x()); });
}

/// Nodes inside go to the middle of their cells; those of the surface are particles.
Racer start_variable_mass(const ColumnFront& measured, long columns) {
  using variable_mass::Flow;
  return racer_of(
      std::make_shared<Flow>(
          cells_at_wall(columns), variable_mass::Start{},
          variable_mass::Control{.kind = variable_mass::ControlKind::centroid, .rate = 1, .surface_rate = 0},
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

}  // namespace

std::vector<Contender> column_contenders(const ColumnFront& measured, const ColumnSizes& sizes) {
  const auto over = [](long n) { return 1 / static_cast<double>(n); };
  const auto starting = [measured](Racer (*start)(const ColumnFront&, long)) {
    return [measured, start](long n) { return start(measured, n); };
  };
  const std::vector<double> three{0.5, 0.75, 1};
  return {
      {"particles", "free particles", "cell", Role::computed, ladder_to(sizes.particles, three), over,
       starting(start_particles)},
      {"mesh", "Lagrangian mesh", "cell", Role::peer, ladder_to(sizes.mesh, three), over, starting(start_mesh)},
      {"dirichlet", "Dirichlet cells", "cell", Role::peer, ladder_to(sizes.cells, three), over,
       starting(start_dirichlet)},
      {"variable-mass", "variable mass", "cell", Role::peer, {sizes.cells}, over, starting(start_variable_mass), true},
      {"overlapping", "overlapping particles", "particle spacing", Role::data, ladder_to(sizes.overlapping, three),
       over, starting(start_overlapping)},
      {"sph", "SPH", "particle spacing", Role::peer, ladder_to(sizes.sph, three), over, starting(start_sph)}};
}

}  // namespace seiche::validation
