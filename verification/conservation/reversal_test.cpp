// Symmetric schemes do not know the direction of time: one check for all models.
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "validation/instruments/cosine_bottom.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"
#include "verification/conservation/dispersive_2dh_problems.hpp"
#include "verification/conservation/lagrangian_mesh_3d_problems.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"

namespace seiche::verification::reversal_test {

using namespace mechanics;
namespace line = dispersive_shallow_water_1d;

TEST_CASE("flows return when their velocities are reversed", "[conservation]") {
  Check check("reversal", "Time reversal",
              "Steps forward, velocities reversed, as many steps, velocities reversed: the start returns. The one-step "
              "scheme is symmetric where frames do not turn, which over an uneven bottom move the middle of a step by "
              "$O(\\tau^3)$ on the way back; the fully conservative one is symmetric over any bottom. Solvers are "
              "direct or tight, so that results do not depend on tolerances.");
  const auto returns = [&](const std::string& flow, auto& model, const State& start, Stepping stepping, double tau,
                           int steps, double roundings, double scale) {
    check.holds(flow + ": every coordinate and rate returns.",
                {there_and_back(model, start, {.stepping = stepping}, tau, steps)},
                Roundoff{roundings * steps, scale,
                         "every position, up to the largest, and its increment are rounded so often in a step, there "
                         "and back; sweeps begin anew"});
  };
  for (const double cubic : {0.0, 0.3}) {
    for (const bool pinned : {false, true}) {
      rigid_chain::RigidChain chain({.masses = rigid_chain::alternating_masses(4),
                                     .pinned = pinned,
                                     .gravity = pinned ? 1.0 : 0.0,
                                     .cubic = cubic});
      returns("Rigid chain", chain, rigid_chain::spiral_start(chain), Stepping::one_step, 0.01, 100, 2 * 12, 4);
    }
  }
  const auto markers = [&](const std::string& flow, const line::Channel& channel, const line::Markers& m,
                           Stepping stepping) {
    line::Model model(channel, m);
    State start = model.state_of(m);
    Start(model).project(start);
    returns("Dispersive 1D, " + flow, model, start, stepping, 0.05, 1000, 4, 60);
  };
  const line::Channel walls{.bottom = std::make_shared<LevelBottom>(1.0)};
  const line::Channel periodic{.bottom = walls.bottom, .period = 60};
  const line::Channel uneven{.bottom = std::make_shared<CosineBottom>(1.0, 0.2, 2 * std::numbers::pi / 10)};
  const auto solitary = [](const line::Channel& channel) {
    return line::solitary_markers(channel, 0, 60, 0.25, {.amplitude = 0.3, .crest = 30});
  };
  line::Markers pushed = line::still_markers(uneven, line::equal_labels(uneven, 0, 60, 240));
  for (std::size_t i = 0; i < pushed.size(); ++i) pushed.u[i] = 0.2 * std::exp(-std::pow((pushed.x[i] - 30) / 4, 2));
  markers("periodic", periodic, solitary(periodic), Stepping::one_step);
  markers("walls", walls, solitary(walls), Stepping::one_step);
  markers("conservative, periodic", periodic, solitary(periodic), Stepping::conservative);
  markers("conservative, walls on an uneven bottom", uneven, pushed, Stepping::conservative);
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    const bool conservative = stepping == Stepping::conservative;
    const std::string scheme = conservative ? "conservative" : "one-step";
    MeshProblem patch = moving_patch(), box = sloshing();
    returns("Lagrangian mesh, patch, " + scheme, patch.model, patch.start, stepping, 0.01, 100, 2 * 65, 1);
    returns("Lagrangian mesh, sloshing, " + scheme, box.model, box.start, stepping, 0.05, 200, 2 * (1 + 64.0 / 36), 6);
    PlanProblem level(plan_hump_in_box(), {}, {.solver = linear::SolverMethod::banded});
    returns("Dispersive 2DH, level bottom, " + scheme, level.model, level.start, stepping, 0.1, 50, 2, 10);
    if (conservative) {
      PlanProblem bump(hump_over_bump(), {}, {.solver = linear::SolverMethod::banded});
      returns("Dispersive 2DH, bump, " + scheme, bump.model, bump.start, stepping, 0.1, 50, 2, 20);
      continue;
    }
    HexahedralProblem hump(hump_in_box(), {}, {.tolerance = 1e-15}), over(hump_over_bottom(), {}, {.tolerance = 1e-15});
    returns("Hexahedra, level bottom", hump.model, hump.start, stepping, 0.1, 100, 2, 10);
    returns("Hexahedra, uneven bottom", over.model, over.start, stepping, 0.1, 60, 2, 6);
  }
}

}  // namespace seiche::verification::reversal_test
