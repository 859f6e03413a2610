// How the two-dimensional Lagrangian mesh breaks down: with time, step and place, and the state of before.
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "seiche/exact/solitary_wave.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"
#include "verification/robustness/breakdown.hpp"

namespace seiche::verification::lagrangian_mesh_breakdown_test {

using namespace lagrangian_mesh_2d;

const std::array schemes{std::pair{"one-step", Stepping::one_step}, std::pair{"conservative", Stepping::conservative}};

TEST_CASE("a wave that tangles the mesh at a wall stops with time, step and position", "[robustness]") {
  Check check("lagrangian_mesh_tangle", "A high wave inverts the mesh at a wall",
              "A solitary wave of height 0.6 is reflected by a vertical wall. Surface nodes beside the wall overtake "
              "the wall's: a corner of a cell is inverted. The run stops there, whatever the scheme.");
  const exact::SolitaryWave wave(0.6);
  const auto elevation = [&](double x) { return wave.elevation(x); };
  const auto velocity = [&](Point r) {
    const auto v = wave.velocity(r.x, r.y);
    return Point{v.u, v.v};
  };
  const Layer tank{.begin = -12, .end = 12, .columns = 48, .rows = 4, .elevation = elevation};
  for (const auto& [id, stepping] : schemes) {
    Flow flow(layer_mesh(tank), velocity, {.stepping = stepping});
    holds_of_breakdown(check, id, run_until_breakdown(flow, 30, 0.05), "mesh tangled", 10, 12);
  }
}

TEST_CASE("a node that leaves the curve of its wall stops with time, step and position", "[robustness]") {
  Check check("lagrangian_mesh_short_curve", "A node leaves the curve it slides along",
              "The curve of a wall of slope 1 ends 0.05 above the still-water level. A surge of 0.3 carries the "
              "contact point past its end, whatever the scheme.");
  for (const auto& [id, stepping] : schemes) {
    Flow flow(water_at_short_wall(), [](Point r) { return Point{0.3 * r.x / 4, 0}; }, {.stepping = stepping});
    holds_of_breakdown(check, id, run_until_breakdown(flow, 10, 0.05), "left its curve", 5.04, 5.06);
  }
}

TEST_CASE("implicit steps that do not converge stop", "[robustness]") {
  Check check("lagrangian_mesh_long_steps", "Too long steps of the Lagrangian mesh",
              "Implicit steps 5 % longer than the limit of linear waves do not converge, even of a low wave: the run "
              "stops with the state before the step.");
  const auto low = [](double x) { return 0.001 * std::cos(std::numbers::pi * x / 6); };
  Flow flow(layer_mesh({.end = 6, .columns = 16, .rows = 4, .elevation = low}), {},
            {.stepping = Stepping::conservative});
  holds_of_breakdown(check, "implicit", run_until_breakdown(flow, 100, 1.05 * flow.stable_step()), "not converged", 0,
                     6);
}

}  // namespace seiche::verification::lagrangian_mesh_breakdown_test
