/*
A rectangle of water flies freely: no gravity, nothing around it. Its velocity at the beginning is

$$u = u_0 + u_x x + u_y y + u_{yy} y^2, \qquad v = v_0 + v_x x + v_y y + v_{xx} x^2,$$

projected on the velocities that keep the area of every cell. From then on a conservative scheme must keep energy,
momentum and angular momentum, and it must do so to rounding, not to some order.

**Set-up.** The square $|x|, |y| \le 1$ in `nx` by `ny` cells.

**What is compared.** With what is there at the beginning: kinetic energy, momentum, angular momentum about the origin,
and the areas $V$ of the cells. Frank's one-step scheme keeps energy and momenta, and for each cell

$$V[r] - \tfrac{\tau^2}{4} V[\dot r],$$

where $V[\dot r]$ is the formula of the area applied to the velocities. Areas themselves therefore change by
$O(\tau^2)$, in proportion to the change of $V[\dot r]$, and never drift. The conservative scheme keeps areas exactly.
One step with feedback gives up the energy to bring areas back.

**What to look at.** The defects in time: rounding, which wanders, below the limit of a random walk.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <tuple>

#include <fmt/format.h>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"

namespace seiche::validation::cases::free_patch_mesh {
namespace {

using lagrangian_mesh_2d::Flow;
using lagrangian_mesh_2d::Mesh;
using lagrangian_mesh_2d::Stepping;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 2";

Point first_velocity(const Values& values, Point r) {
  return {values.real("u_0") + values.real("u_x") * r.x + values.real("u_y") * r.y + values.real("u_yy") * r.y * r.y,
          values.real("v_0") + values.real("v_x") * r.x + values.real("v_y") * r.y + values.real("v_xx") * r.x * r.x};
}

/// Started with the projected velocity itself: multipliers are not looked at.
Flow patch(const Values& values) {
  return Flow(
      lagrangian_mesh_2d::free_patch(static_cast<std::size_t>(values.integer("nx")),
                                     static_cast<std::size_t>(values.integer("ny")), {-1, -1}, {1, 1}),
      [&](Point r) { return first_velocity(values, r); },
      {.stepping = mechanics::stepping_named(values.text("scheme"))}, {.gravity = 0}, {}, false);
}

/// What is kept.
struct Invariants {
  double energy, momentum_x, momentum_y, angular_momentum;
  std::vector<double> modified_areas;
};

Invariants invariants_of(const Flow& flow, double tau) {
  const auto& [q, u] = std::tie(flow.state().q, flow.state().u);
  const auto momentum = flow.model().momentum(q, u);
  const Mesh& mesh = flow.model().mesh();
  std::vector<double> areas(mesh.cells());
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    areas[cell] = cell_area(mesh, flow.x(), flow.y(), cell) - tau * tau / 4 * cell_area(mesh, flow.u(), flow.v(), cell);
  }
  return {flow.model().kinetic_energy(q, u), momentum[0], momentum[1], flow.model().angular_momentum(q, u)[0], areas};
}

/// How far it is from the beginning.
struct Defects {
  double energy, momentum, angular_momentum, modified_area, area;
};

Defects defects_of(const Flow& flow, double tau, const Invariants& first) {
  const Invariants now = invariants_of(flow, tau);
  const Mesh& mesh = flow.model().mesh();
  Worst area;
  Worst modified;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    area.add(cell_area(mesh, flow.x(), flow.y(), cell) - flow.model().first_volumes()[cell]);
    modified.add(now.modified_areas[cell] - first.modified_areas[cell]);
  }
  return {.energy = std::abs(now.energy - first.energy),
          .momentum = worst(std::array{now.momentum_x - first.momentum_x, now.momentum_y - first.momentum_y}),
          .angular_momentum = std::abs(now.angular_momentum - first.angular_momentum),
          .modified_area = modified.value(),
          .area = area.value()};
}

/// Sizes of what is rounded: sums of magnitudes.
struct Scales {
  double momentum = 0, angular_momentum = 0, area = 0;
};

Scales scales_of(const Flow& flow) {
  Scales now;
  Largest area;
  const Mesh& mesh = flow.model().mesh();
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const double distance = std::hypot(flow.x()[k], flow.y()[k]);
    const double impulse = flow.model().nodes().mass()[k] * std::hypot(flow.u()[k], flow.v()[k]);
    now.momentum += impulse;
    now.angular_momentum += distance * impulse;
    // A corner that is moved by the rounding of its place changes the area by that times half the diagonal.
    area.add(distance * 2 / static_cast<double>(std::min(mesh.columns, mesh.rows)));
  }
  now.area = area.value();
  return now;
}

struct Results {
  Invariants first;
  std::vector<double> time;
  std::vector<Defects> defects;
  std::vector<Scales> scales;
  Flow flow;  ///< at the end

  [[nodiscard]] Worst largest(double Defects::*defect) const {
    Worst found;
    for (std::size_t i = 0; i < time.size(); ++i) found.add(defects[i].*defect, time[i]);
    return found;
  }
  [[nodiscard]] double largest(double Scales::*scale) const {
    Largest found;
    for (const Scales& one : scales) found.add(one.*scale);
    return found.value();
  }
};

/// Bounds of energy and scales, for twice the energy of the given velocity, which the projection can only lessen. In
/// the norm of the masses, |r| grows no faster than |u| = sqrt(2 E), and sums of products are no more than products
/// of norms; a single node may have all of the energy.
struct Most {
  double energy;
  Scales scales;
};

Most most(const Values& values) {
  const auto size = [&](std::initializer_list<const char*> coefficients) {
    double sum = 0;
    for (const char* name : coefficients) sum += std::abs(values.real(name));
    return sum;
  };
  constexpr double mass = 4;
  constexpr double farthest = std::numbers::sqrt2;
  const double speed = std::hypot(size({"u_0", "u_x", "u_y", "u_yy"}), size({"v_0", "v_x", "v_y", "v_xx"}));
  const double energy = mass * speed * speed;
  const double u = std::sqrt(2 * energy);
  const double time = values.real("tau") * static_cast<double>(values.integer("steps"));
  const auto cells = static_cast<double>(values.integer("nx") * values.integer("ny"));
  const double width = 2 / static_cast<double>(std::min(values.integer("nx"), values.integer("ny")));
  return {.energy = energy,
          .scales = {.momentum = std::sqrt(mass) * u,
                     .angular_momentum = (std::sqrt(mass) * farthest + time * u) * u,
                     .area = (farthest + time * u * std::sqrt(cells)) * width}};
}

void claims(const Values& values, const Claims<Results>& claims) {
  const auto steps = static_cast<double>(values.integer("steps"));
  const Most cap = most(values);
  const auto nodes = static_cast<double>((values.integer("nx") + 1) * (values.integer("ny") + 1));
  constexpr double formula = 16;  // operations of the area of a cell
  const auto kept = [&](const Claims<Results>& to, const std::string& id, const std::string& text,
                        double Defects::*defect, double summed, double largest,
                        std::function<double(const Results&)> scale, const std::string& reason) {
    to.at(fmt::format("{} x {} cells, tau = {:g}, {:g} steps", values.integer("nx"), values.integer("ny"),
                      values.real("tau"), steps))
        .check(
            id, text, "largest defect",
            [defect, scale](const Results& r) -> Measurement {
              const Worst found = r.largest(defect);
              return {
                  .value = found.value(), .where = fmt::format("t = {:g}", found.where()), .told = {.scale = scale(r)}};
            },
            Roundoff{.operations = steps + summed,
                     .scale = Amount::told_by_run(largest),
                     .reason = reason + ", once per step"});
  };
  const auto of = [](double Scales::*scale) { return [scale](const Results& r) { return r.largest(scale); }; };
  const Stepping stepping = mechanics::stepping_named(values.text("scheme"));
  kept(
      claims.only_if(stepping != Stepping::one_step_feedback, "the feedback gives up the energy"), "energy",
      "Kinetic energy of the free patch is conserved.", &Defects::energy, nodes, cap.energy,
      [](const Results& r) { return r.first.energy; }, "rounding of the energy, a sum over the nodes");
  kept(claims, "momentum", "Momentum of the free patch is conserved to round-off.", &Defects::momentum, nodes,
       cap.scales.momentum, of(&Scales::momentum), "rounding of sum m|u| over the nodes");
  kept(claims, "angular-momentum", "Angular momentum of the free patch is conserved to round-off.",
       &Defects::angular_momentum, nodes, cap.scales.angular_momentum, of(&Scales::angular_momentum),
       "rounding of sum m|r||u| over the nodes");
  const std::string rounding = "rounding of a corner's place, times the width of a cell";
  kept(claims.only_if(stepping == Stepping::one_step, "it is what one step without feedback keeps"), "modified-area",
       "Every cell keeps V[r] - (tau^2/4) V[r'].", &Defects::modified_area, formula, cap.scales.area, of(&Scales::area),
       rounding);
  kept(claims.only_if(stepping == Stepping::conservative, "one step changes areas by O(tau^2)"), "area",
       "Areas of all cells are conserved to round-off.", &Defects::area, formula, cap.scales.area, of(&Scales::area),
       rounding);
}

Results compute(const Run& run) {
  const double tau = run.real("tau");
  const long steps = run.integer("steps");
  const long every = steps < 400 ? 1 : steps / 400;
  Flow flow = patch(run);
  Results r{.first = invariants_of(flow, tau), .time = {}, .defects = {}, .scales = {}, .flow = std::move(flow)};
  for (long n = 1; n <= steps; ++n) {
    r.flow.advance(tau);
    if (n % every != 0 && n < steps) continue;
    r.time.push_back(r.flow.time());
    r.defects.push_back(defects_of(r.flow, tau, r.first));
    r.scales.push_back(scales_of(r.flow));
    run.progress(static_cast<double>(n) / static_cast<double>(steps));
  }
  return r;
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  draw_mesh(exhibit.figure("patch", "The patch at the end", "Its mesh; it began as a square of equal cells.")
                .panel({.x = "x", .y = "y", .equal_aspect = true}),
            "mesh", r.flow);
  auto& panel = exhibit.figure("defects", "Defects in time", "What is exactly zero is not drawn.")
                    .panel({.x = "t", .y = "defect", .log_y = true});
  const auto defect = [&](const std::string& id, const std::string& label, double Defects::*member) {
    exhibit.measure(id + "_defect", r.largest(member).value());
    std::vector<double> time;
    std::vector<double> values_above_zero;
    for (std::size_t i = 0; i < r.time.size(); ++i) {
      if (!(r.defects[i].*member > 0)) continue;
      time.push_back(r.time[i]);
      values_above_zero.push_back(r.defects[i].*member);
    }
    panel.line(label, time, values_above_zero);
  };
  defect("energy", "energy", &Defects::energy);
  defect("momentum", "momentum", &Defects::momentum);
  defect("angular_momentum", "angular momentum", &Defects::angular_momentum);
  defect("modified_area", "modified areas", &Defects::modified_area);
  defect("area", "areas", &Defects::area);
  exhibit.measure("kinetic_energy", r.first.energy);
  exhibit.measure("angular_momentum", r.first.angular_momentum);
  if (values.text("scheme") != "one_step") return;
  const Mesh& mesh = r.flow.model().mesh();
  Worst fastest;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    fastest.add(cell_area(mesh, r.flow.u(), r.flow.v(), cell));
  }
  exhibit.measure("area_of_velocities", fastest.value());
}

}  // namespace

Case free_patch_mesh() {
  Case c;
  c.former_names = {"free_patch_2d"};
  c.title = "What a free patch of water keeps";
  c.source = "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapters 1 and 2";
  c.tiers = {Tier::quick, Tier::full};
  const auto coefficient = [](const std::string& name, double standard, const std::string& of) {
    return real(name, standard, "1", {-10, 10}, "coefficient of " + of + " in the first velocity");
  };
  c.parameters = {
      integer("nx", 8L, {1, 512}, "columns of cells"),
      integer("ny", 8L, {1, 512}, "rows of cells"),
      coefficient("u_0", 0.3, "1 in u"),
      coefficient("u_x", 0.4, "x in u"),
      coefficient("u_y", -0.7, "y in u"),
      coefficient("u_yy", 0.1, "y^2 in u"),
      coefficient("v_0", -0.2, "1 in v"),
      coefficient("v_x", 0.5, "x in v"),
      coefficient("v_y", -0.4, "y in v"),
      coefficient("v_xx", -0.1, "x^2 in v"),
      real("tau", {1e-3, 1e-4, 1e-5}, "1", {1e-7, 1}, "time step"),
      integer("steps", {1000, 10000, 100000}, {1, 1e8}, "number of steps"),
      choice("scheme", std::string("one_step"), {"one_step", "one_step_feedback", "conservative"}, "time stepping"),
  };
  c.study = Study(claims, compute, show, source);
  return c;
}

}  // namespace seiche::validation::cases::free_patch_mesh
