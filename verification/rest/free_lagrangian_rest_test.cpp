// Still water in Dirichlet cells and in particles of variable mass stays still on any mesh.
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/jittered_mesh.hpp"

namespace seiche::verification::free_lagrangian_rest_test {

using namespace free_lagrangian;
using variable_mass::Control, variable_mass::ControlKind;

/// 200 steps. With the surface at y = 0 every force is exactly zero.
template <class Flow>
Flow still(Check& check, const std::string& what, Flow flow, double level) {
  Worst speed, pressure;
  for (int k = 0; k < 200; ++k) {
    flow.advance(0.05);
    for (const double u : flow.state().u) speed.add(u, flow.time());
    for (const double lambda : flow.state().multipliers) pressure.add(lambda - level, flow.time());
  }
  const evidence::Criterion zero = Bound{0, "every force is exactly zero"};
  const evidence::Criterion kicks = Roundoff{200 * 20, 0.4,
                                             "200 velocity increments of tau times the acceleration g/h = 8, of "
                                             "pressure and gravity, sums of some twenty terms"};
  check.holds(what + ": displacements and velocities are zero.", {speed.value()}, level == 0 ? zero : kicks);
  if constexpr (std::is_same_v<Flow, dirichlet_mesh::Flow>) {
    const evidence::Criterion taken_out =
        Roundoff{200 * 20, 8,
                 "the rounding of a velocity is taken out within half a step: over tau/2 = 1/40, and half a spacing"};
    check.holds(what + ": the pressure is hydrostatic.", {pressure.value()}, level == 0 ? zero : taken_out);
  }
  return flow;
}

TEST_CASE("water at rest in cells and particles stays at rest on any mesh", "[rest]") {
  Check check("free_lagrangian_rest", "Still water on meshes whose neighbours may change",
              "Dirichlet cells: 24 x 8 in a box 3 x 1, nodes inside moved at random by up to a fifth of the spacing, "
              "nodes on walls along them; 200 steps of 0.05, without stabilisation. Particles of variable mass: "
              "jittered meshes over a flat bottom and over a step, whose nodes inside are drawn to the centroids of "
              "their cells, and regular ones under mapped and fixed_x, stabilisation 0.1. With the surface at y = 0 "
              "the gradient of the potential energy of the polygon of water is zero. At y = 1 gravity and the pressure "
              "rho g balance to rounding, for any exchange of mass: the areas of all cells add up to the polygon.");
  for (const double level : {0.0, 1.0}) {
    const std::string at = level == 0 ? " at y = 0" : " at y = 1";
    const Mesh flat = layer_mesh({.end = 3, .bottom = level - 1, .level = level, .columns = 24, .rows = 8});
    const Mesh stepped = stepped_channel_mesh(
        {.begin = 0, .step = 2, .end = 4, .bottom = level - 1, .shelf = level - 0.5, .level = level, .rows = 8});
    for (const unsigned long seed : {1UL, 2UL, 3UL}) {
      const auto flow = still(check, "Dirichlet cells" + at,
                              dirichlet_mesh::Flow(jittered(flat, 0.2, seed), {}, {.stabilisation = 0}), level);
      check.holds("The number of flipped edges is zero.", {static_cast<double>(flow.flips())},
                  Bound{0, "displacements do not exceed rounding"});
    }
    using enum ControlKind;
    for (const auto& [name, mesh, control] :
         {std::tuple{"a flat bottom, to centroids", jittered(flat, 0.2, 1), Control{centroid, 1, 0.5}},
          {"a step, to centroids", jittered(stepped, 0.2, 2), {centroid, 1, 0.5}},
          {"a step, mapped", jittered(stepped, 0.2, 3), {mapped, 1, 0.5}},
          {"a step, fixed in x", stepped, {fixed_x, 1, 1}}}) {
      variable_mass::Flow start(mesh, {}, control, {.stabilisation = 0.1});
      const std::vector<double> first(start.masses().begin(), start.masses().end());
      const auto flow = still(check, std::string("Variable masses over ") + name + at, std::move(start), level);
      if (control.kind != centroid) continue;
      Worst change;
      for (std::size_t k = 0; k < first.size(); ++k) change.add(flow.masses()[k] / first[k] - 1);
      check.holds("Nodes move through the water.", {std::abs(change.value()) > 0.1 ? 1.0 : 0.0},
                  Qualitative{"a mass changes by more than a tenth", "otherwise exchanges are not tested"});
    }
  }
}

}  // namespace seiche::verification::free_lagrangian_rest_test
