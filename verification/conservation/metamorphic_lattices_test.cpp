// Columns and meshes, their main options, and the twins of their flows.
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "verification/check.hpp"
#include "verification/conservation/metamorphic.hpp"
#include "verification/noise.hpp"
#include "verification/polynomial_bottom.hpp"

namespace seiche::verification::metamorphic_lattices_test {

using namespace metamorphic;
using mechanics::Stepping;

namespace channel {
using namespace dispersive_shallow_water_1d;

/// A hump that runs to the right, in water of depth 1 over [-12, 0], 48 cells.
Markers markers_of(const Twin& twin, bool tip) {
  Markers m;
  constexpr std::size_t n = 49;
  const std::size_t count = tip ? n : n - 1;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = 0.25 * static_cast<double>(twin.in_row(k, count)) - 12, h = 0.5 * hump(x, -6.5);
    const Point v = twin.velocity({h, -2 * h * (x + 6.5) * h});
    const Point there = twin.place({x, x == 0 ? 0 : h});
    m.x.push_back(there.x);
    m.y.push_back(there.y);
    m.u.push_back(v.x);
    m.v.push_back(v.y);
  }
  return m;
}

Seen run(const Twin& twin, Channel base, bool beach, Stepping stepping) {
  if (beach) {
    // 1:4, its foot is under the wave's front.
    std::vector<double> x{-16, -4.125, 8.25}, z{-1, -1, 2};
    for (double& place : x) place = twin.place(place);
    for (double& level : z) level *= twin.length;
    if (twin.mirrored) {
      std::ranges::reverse(x);
      std::ranges::reverse(z);
    }
    base.bottom = std::make_shared<PiecewiseLinearBottom>(x, z);
    base.right = End::tip;
  } else {
    base.bottom = std::make_shared<LevelBottom>(-twin.place({0, -1}).y);
    if (base.period > 0) base.period *= twin.length;
  }
  twin.swap_if_mirrored(base.left, base.right);
  base.gravity = twin.acceleration(1);
  base.density = twin.density;
  base.reference_depth = twin.length;
  Flow flow(base, markers_of(twin, beach || base.period == 0), {.stepping = stepping});
  take_steps(flow, 0.0625 * twin.time);
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < flow.x().size(); ++k) order.push_back(twin.in_row(k, flow.x().size()));
  return seen_in_plane(twin, order, flow.x(), flow.y(), flow.u(), flow.v(), flow.time());
}
}  // namespace channel

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
  const Point right = twin.undirected({1 / twin.length, 0}), up = twin.undirected({0, 1 / twin.length});
  const Point origin = twin.undirected({-twin.origin.x, -twin.origin.y});
  const Terms x{{{1, 0}, right.x}, {{0, 1}, up.x}, {{0, 0}, origin.x}};
  const Terms y{{{1, 0}, right.y}, {{0, 1}, up.y}, {{0, 0}, origin.y}};
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
using plan_lattice::FreeSide, plan_lattice::ShoreSide, plan_lattice::Side, plan_lattice::WallSide;

enum class Where { box, free, slope, shore };

Seen run(const Twin& twin, Where where, Settings settings, Stepping stepping) {
  constexpr std::size_t columns = 10, rows = 8;
  const bool steep = settings.drag.breaking_slope > 0;
  constexpr double cell = 0.5;
  const TwinLattice nodes(columns, rows, twin);
  const Side usual = where == Where::free ? Side(FreeSide{}) : Side(WallSide{});
  const auto sides = turned_sides<Side>({usual, usual, where == Where::shore ? Side(ShoreSide{}) : usual, usual}, twin);
  Lattice lattice;
  lattice.shape = {nodes.columns, nodes.rows};
  lattice.sides = {sides[0], sides[1], sides[2], sides[3]};
  lattice.depth = twin.length;
  if (where == Where::slope || where == Where::shore) lattice.bottom = bottom_of(twin, where == Where::shore);
  std::vector<Velocity> velocities;
  for (const std::size_t k : nodes.node) {
    const std::size_t i = k % (columns + 1), j = k / (columns + 1);
    Noise noise(k + 1);
    const bool inside = i > 0 && i < columns && j > 0 && j < rows;
    const auto along = [&](std::size_t n) { return cell * (static_cast<double>(n) + (inside ? 0.1 * noise() : 0)); };
    const Point r{along(i), along(j)};
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
  return seen_in_space(twin, nodes, flow);
}
}  // namespace plan

namespace hexahedra {
using namespace lagrangian_mesh_3d;
using plan_lattice::FreeSide, plan_lattice::Side, plan_lattice::WallSide;

enum class Where { body, box, slope };

Seen run(const Twin& twin, Where where, Stepping stepping) {
  constexpr std::size_t columns = 6, rows = 5, layers = 2;
  constexpr double cell = 0.5;
  const TwinLattice nodes(columns, rows, twin);
  const Side side = where == Where::body ? Side(FreeSide{}) : Side(WallSide{});
  Mesh mesh;
  mesh.plan = {nodes.columns, nodes.rows};
  mesh.layers = layers;
  mesh.sides = {side, side, side, side};
  mesh.free_bottom = where == Where::body;
  if (where == Where::slope) mesh.bottom = bottom_of(twin, false);
  std::vector<Vector> velocities;
  for (std::size_t l = 0; l <= layers; ++l) {
    for (const std::size_t k : nodes.node) {
      const std::size_t i = k % (columns + 1), j = k / (columns + 1);
      Noise noise(100 * l + k + 1);
      const double jitter = i > 0 && i < columns && j > 0 && j < rows && l > 0 ? 0.05 : 0;
      const auto along = [&](std::size_t n) { return cell * (static_cast<double>(n) + jitter * noise()); };
      const Point r{along(i), along(j)};
      const Point there = twin.place(r);
      const double top = 0.2 * hump(r.x, 1) * hump(r.y, 1), height = static_cast<double>(l) / layers;
      const double bed = mesh.bottom ? mesh.bottom->slope(there.x, there.y).elevation : -twin.length;
      mesh.x.push_back(there.x);
      mesh.y.push_back(there.y);
      mesh.z.push_back(l == 0 ? bed : bed + height * (twin.length * top - bed));
      const Point v = twin.velocity({0.3 * stirring(r).x, 0.3 * stirring(r).y});
      velocities.push_back({v.x, v.y, twin.speed() * 0.1 * noise()});
    }
  }
  const double gravity = where == Where::body ? 0.0 : twin.acceleration(1);
  Flow flow(mesh, velocities, {.stepping = stepping},
            {.gravity = gravity, .density = twin.density, .tolerance = 1e-13});
  take_steps(flow, 0.03125 * twin.time);
  return seen_in_space(twin, nodes, flow);
}
}  // namespace hexahedra

namespace mesh {
using namespace lagrangian_mesh_2d;

Seen run(const Twin& twin, bool patch, Settings settings, Stepping stepping) {
  constexpr std::size_t columns = 8, rows = 4;
  const TwinLattice nodes(columns, rows, twin);
  Mesh m{{nodes.columns, nodes.rows}};
  if (!patch) {
    m.sides.left = vertical_wall(twin.place(0));
    m.sides.right = vertical_wall(twin.place(4));
    m.sides.bottom = level_wall(twin.place({0, -1}).y);
    twin.swap_if_mirrored(m.sides.left, m.sides.right);
  }
  std::vector<Point> velocities;
  for (const std::size_t k : nodes.node) {
    const double x = 0.5 * static_cast<double>(k % (columns + 1)), top = patch ? 0 : 0.2 * hump(x, 1);
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
  return seen_in_plane(twin, nodes.node, flow.x(), flow.y(), flow.u(), flow.v(), flow.time());
}
}  // namespace mesh

Subject dispersive_1d() {
  using namespace dispersive_shallow_water_1d;
  Subject s{"dispersive_1d", "dispersive 1D", 320, of_solves + " and 16 for the feedback of a drift over a step"};
  const auto add = [&](const std::string& name, const Channel& c, bool beach, Stepping stepping, const Which& which,
                       bool rounds = false) {
    s.add(
        name, which, [=](const Twin& t) { return channel::run(t, c, beach, stepping); }, rounds);
  };
  const Which row{"mirror", "along"}, ring{"mirror", "along", "origin", "moving"};
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
  Subject s{"dispersive_2dh", "dispersive 2DH"};
  const auto add = [&](const std::string& name, Where where, const plan::Settings& settings, Stepping stepping,
                       Which which = {}, bool rounds = false) {
    which.insert({"mirror", "turned", "origin"});
    s.add(
        name, which, [=](const Twin& t) { return plan::run(t, where, settings, stepping); }, rounds);
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
  Subject s{"mesh_2d", "Lagrangian mesh 2D"};
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    const std::string name = stepping == Stepping::one_step ? ", one-step" : ", conservative";
    lagrangian_mesh_2d::Settings settings;
    if (stepping == Stepping::one_step) settings = {.hourglass = 0.2, .tuned_surface_inertia = true};
    s.add("free patch" + name, {"mirror", "turned", "origin", "moving"},
          [=](const Twin& t) { return mesh::run(t, true, {}, stepping); });
    s.add("sloshing" + name, {"mirror", "along"},
          [=](const Twin& t) { return mesh::run(t, false, settings, stepping); });
  }
  return s;
}

Subject mesh_3d() {
  using hexahedra::Where;
  Subject s{"mesh_3d", "Lagrangian mesh 3D"};
  const auto add = [&](const std::string& name, Where where, Stepping stepping, Which which = {}) {
    which.insert({"mirror", "turned", "origin"});
    s.add(
        name, which, [=](const Twin& t) { return hexahedra::run(t, where, stepping); }, stepping == Stepping::one_step);
  };
  add("free body", Where::body, Stepping::one_step, {"moving"});
  add("box, conservative", Where::box, Stepping::conservative);
  add("uneven bottom", Where::slope, Stepping::one_step);
  return s;
}

TEST_CASE(
    "flows of columns and meshes are invariant under mirroring, rotation, change of units, translation and moving "
    "frames",
    "[conservation]") {
  judge({dispersive_1d(), dispersive_2dh(), mesh_2d(), mesh_3d()});
}

}  // namespace seiche::verification::metamorphic_lattices_test
