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
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Bound;
using evidence::Roundoff;
using lagrangian_mesh_2d::Flow;
using lagrangian_mesh_2d::Mesh;
using lagrangian_mesh_2d::Stepping;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 2";

Point first_velocity(const Values& values, Point r) {
  return {values.real("u_0") + values.real("u_x") * r.x + values.real("u_y") * r.y + values.real("u_yy") * r.y * r.y,
          values.real("v_0") + values.real("v_x") * r.x + values.real("v_y") * r.y + values.real("v_xx") * r.x * r.x};
}

/// Started with the projected velocity itself: multipliers are not looked at.
Flow patch(const Run& run) {
  return Flow(
      lagrangian_mesh_2d::free_patch(static_cast<std::size_t>(run.integer("nx")),
                                     static_cast<std::size_t>(run.integer("ny")), {-1, -1}, {1, 1}),
      [&](Point r) { return first_velocity(run.values(), r); },
      {.stepping = mechanics::stepping_named(run.text("scheme"))}, {.gravity = 0}, {}, false);
}

/// What is kept, the size of what is rounded, and how far it is from the beginning.
class Kept {
 public:
  Kept(const Flow& flow, double tau) : tau_(tau), first_(read(flow)), first_modified_(modified_areas(flow)) {}

  struct Values {
    double energy = 0, momentum_x = 0, momentum_y = 0, angular_momentum = 0;
  };
  struct Defects {
    double energy = 0, momentum = 0, angular_momentum = 0, modified_area = 0, area = 0;
  };
  /// Largest so far of the sums of magnitudes.
  struct Scales {
    double momentum = 0, angular_momentum = 0, area = 0;
  };

  Defects observe(const Flow& flow) {
    const Values now = read(flow);
    Defects defects{.energy = std::abs(now.energy - first_.energy),
                    .momentum = std::max(std::abs(now.momentum_x - first_.momentum_x),
                                         std::abs(now.momentum_y - first_.momentum_y)),
                    .angular_momentum = std::abs(now.angular_momentum - first_.angular_momentum)};
    const std::vector<double> modified = modified_areas(flow);
    const Mesh& mesh = flow.model().mesh();
    for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
      const double area = cell_area(mesh, flow.x(), flow.y(), cell);
      defects.area = std::max(defects.area, std::abs(area - flow.model().first_areas()[cell]));
      defects.modified_area = std::max(defects.modified_area, std::abs(modified[cell] - first_modified_[cell]));
    }
    largest_.energy = std::max(largest_.energy, defects.energy);
    largest_.momentum = std::max(largest_.momentum, defects.momentum);
    largest_.angular_momentum = std::max(largest_.angular_momentum, defects.angular_momentum);
    largest_.modified_area = std::max(largest_.modified_area, defects.modified_area);
    largest_.area = std::max(largest_.area, defects.area);
    measure(flow);
    return defects;
  }

  [[nodiscard]] const Values& first() const { return first_; }
  [[nodiscard]] const Defects& largest() const { return largest_; }
  [[nodiscard]] const Scales& scales() const { return scales_; }

 private:
  static Values read(const Flow& flow) {
    const auto& [q, u] = std::tie(flow.state().q, flow.state().u);
    const auto momentum = flow.model().momentum(q, u);
    return {flow.model().kinetic_energy(q, u), momentum[0], momentum[1], flow.model().angular_momentum(q, u)[0]};
  }

  [[nodiscard]] std::vector<double> modified_areas(const Flow& flow) const {
    const Mesh& mesh = flow.model().mesh();
    std::vector<double> areas(mesh.cells());
    for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
      areas[cell] =
          cell_area(mesh, flow.x(), flow.y(), cell) - tau_ * tau_ / 4 * cell_area(mesh, flow.u(), flow.v(), cell);
    }
    return areas;
  }

  void measure(const Flow& flow) {
    Scales now;
    const Mesh& mesh = flow.model().mesh();
    for (std::size_t k = 0; k < mesh.nodes(); ++k) {
      const double distance = std::hypot(flow.x()[k], flow.y()[k]);
      const double impulse = flow.model().nodes().mass()[k] * std::hypot(flow.u()[k], flow.v()[k]);
      now.momentum += impulse;
      now.angular_momentum += distance * impulse;
      // A corner that is moved by the rounding of its place changes the area by that times half the diagonal.
      const double width = 2 / static_cast<double>(std::min(mesh.columns, mesh.rows));
      now.area = std::max(now.area, distance * width);
    }
    scales_.momentum = std::max(scales_.momentum, now.momentum);
    scales_.angular_momentum = std::max(scales_.angular_momentum, now.angular_momentum);
    scales_.area = std::max(scales_.area, now.area);
  }

  double tau_;
  Values first_;
  std::vector<double> first_modified_;
  Defects largest_;
  Scales scales_;
};

struct History {
  std::vector<double> time;
  std::vector<Kept::Defects> defects;
};

void claim(Running& run, const Kept& kept, const Flow& flow) {
  const auto steps = static_cast<double>(run.integer("steps"));
  const std::string resolution = fmt::format("{} x {} cells, tau = {:g}, {:g} steps", run.integer("nx"),
                                             run.integer("ny"), run.real("tau"), steps);
  const auto judge = [&](const std::string& id, const std::string& text, double value, double scale,
                         const std::string& reason) {
    run.record.measure(id + "_defect", value);
    std::string claim_id = id;
    std::replace(claim_id.begin(), claim_id.end(), '_', '-');
    run.record.check({.id = claim_id, .text = text, .quantity = "largest defect", .source = source},
                     {.value = value, .resolution = resolution},
                     Roundoff{.operations = steps + 16, .scale = scale, .reason = reason + ", once per step"});
  };
  const Kept::Defects& defects = kept.largest();
  run.record.measure("kinetic_energy", kept.first().energy);
  run.record.measure("angular_momentum", kept.first().angular_momentum);
  const Stepping stepping = mechanics::stepping_named(run.text("scheme"));
  if (stepping == Stepping::one_step_feedback) {
    run.record.measure("energy_defect", defects.energy);
  } else {
    judge("energy", "The kinetic energy is kept.", defects.energy, kept.first().energy, "rounding of the energy");
  }
  judge("momentum", "The momentum is kept.", defects.momentum, kept.scales().momentum, "rounding of sum m|u|");
  judge("angular_momentum", "So is the angular momentum.", defects.angular_momentum, kept.scales().angular_momentum,
        "rounding of sum m|r||u|");
  const std::string rounding = "rounding of a corner's place, times the width of a cell";
  if (stepping == Stepping::one_step) {
    judge("modified_area", "Every cell keeps V[r] - (tau^2/4) V[r'].", defects.modified_area, kept.scales().area,
          rounding);
    run.record.measure("area_defect", defects.area);
    double fastest = 0;
    for (std::size_t cell = 0; cell < flow.model().mesh().cells(); ++cell) {
      fastest = std::max(fastest, std::abs(cell_area(flow.model().mesh(), flow.u(), flow.v(), cell)));
    }
    run.record.measure("area_of_velocities", fastest);
  } else {
    run.record.measure("modified_area_defect", defects.modified_area);
    if (stepping == Stepping::conservative) {
      judge("area", "Every cell keeps its area.", defects.area, kept.scales().area, rounding);
    } else {
      run.record.measure("area_defect", defects.area);
    }
  }
}

void draw(Running& run, const History& history, const Flow& flow) {
  auto& figure = run.record.figure("patch", "The patch at the end", "Its mesh; it began as a square of equal cells.");
  draw_mesh(figure.panel({.x = "x", .y = "y", .equal_aspect = true}), "mesh", flow);
  auto& drifts = run.record.figure("defects", "Defects in time", "What is exactly zero is not drawn.");
  auto& panel = drifts.panel({.x = "t", .y = "defect", .log_y = true});
  const auto line = [&](const std::string& label, double Kept::Defects::*defect) {
    std::vector<double> time;
    std::vector<double> values;
    for (std::size_t i = 0; i < history.time.size(); ++i) {
      if (!(history.defects[i].*defect > 0)) continue;
      time.push_back(history.time[i]);
      values.push_back(history.defects[i].*defect);
    }
    panel.line(label, time, values);
  };
  line("energy", &Kept::Defects::energy);
  line("momentum", &Kept::Defects::momentum);
  line("angular momentum", &Kept::Defects::angular_momentum);
  line("modified areas", &Kept::Defects::modified_area);
  line("areas", &Kept::Defects::area);
}

void run(Running& run) {
  Flow flow = patch(run);
  const double tau = run.real("tau");
  const long steps = run.integer("steps");
  const long every = std::max(1L, steps / 400);
  Kept kept(flow, tau);
  History history;
  for (long n = 1; n <= steps; ++n) {
    flow.advance(tau);
    if (n % every != 0 && n < steps) continue;
    history.defects.push_back(kept.observe(flow));
    history.time.push_back(flow.time());
    run.progress(static_cast<double>(n) / static_cast<double>(steps));
  }
  claim(run, kept, flow);
  draw(run, history, flow);
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
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
