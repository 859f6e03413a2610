// What no flow takes for the length of a step, or for a time to go to: one check for all models.
#include <memory>
#include <string>
#include <vector>

#include "seiche/model.hpp"
#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/models/overlapping_particles/flow.hpp"
#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "validation/instruments/plan/island_flow.hpp"
#include "verification/check.hpp"
#include "verification/jittered_mesh.hpp"
#include "verification/robustness/refusals.hpp"

namespace seiche::verification::bad_step_test {

/// What a refusal must not change.
template <AnyFlow M>
std::vector<double> seen(const M& flow) {
  std::vector<double> all{flow.time(), static_cast<double>(flow.steps())};
  for (const Invariant& invariant : flow.invariants()) {
    all.push_back(invariant.value);
    all.push_back(invariant.booked);
  }
  return all;
}

template <AnyFlow M>
void refuses(Check& check, const std::string& name, M&& flow) {
  flow.advance(std::min(1e-3, 0.5 * flow.stable_step()));
  const std::vector<double> before = seen(flow);
  Refusals refusals(check);
  for (const double bad : {0.0, -0.1, not_a_number, infinity}) {
    INFO(name << ", " << bad);
    refusals.refused({"tau", "positive and finite"}, [&] { flow.advance(bad); });
    refusals.refused({"tau", "positive and finite"}, [&] { march(flow, 1, bad); });
    refusals.refused({"time", "at least the present"}, [&] { march(flow, bad, 0.1); });
  }
  check.holds(name + ": all is as it was.", {seen(flow) == before && before.size() > 2 ? 1.0 : 0.0},
              Qualitative{"equal time, steps, invariants and books", "a caller may go on"});
}

TEST_CASE("every flow rejects steps that are not positive and finite, and times in the past", "[robustness]") {
  Check check("bad_steps", "Steps and times that no flow takes",
              "Zero, a negative number, NaN, infinity, as the length of one step, of equal steps, and as the end time "
              "of a flow, after a first step of every model.");
  const std::vector<double> depth(8, 1.0), still(8, 0.0);
  {
    using namespace dispersive_shallow_water_1d;
    const Channel channel{.bottom = std::make_shared<LevelBottom>(1.0)};
    refuses(check, "Dispersive 1D",
            Flow(channel, solitary_markers(channel, -20, 0, 0.5, {.amplitude = 0.1, .crest = -10})));
  }
  refuses(check, "Dispersive 2DH",
          dispersive_shallow_water_2d::Flow(
              dispersive_shallow_water_2d::rectangular_lattice({.end = 4, .north = 3, .columns = 8, .rows = 6})));
  refuses(check, "Dispersive 2DH, rezoned", validation::ConicalIsland({.height = 0.045, .spacing = 1}).rezoned_flow());
  refuses(check, "Lagrangian mesh",
          lagrangian_mesh_2d::Flow(lagrangian_mesh_2d::layer_mesh({.end = 3, .columns = 12, .rows = 4})));
  refuses(check, "Hexahedra",
          lagrangian_mesh_3d::Flow(
              lagrangian_mesh_3d::layer_mesh({.end = 3, .north = 2, .columns = 6, .rows = 4, .layers = 2})));
  const auto patch = free_lagrangian::jittered(free_lagrangian::free_patch(16, 8, {-1, -0.5}, {1, 0.5}), 0.2, 1);
  refuses(check, "Dirichlet cells", dirichlet_mesh::Flow(patch));
  refuses(check, "Variable masses",
          variable_mass::Flow(free_lagrangian::layer_mesh({.end = 3, .columns = 9, .rows = 4})));
  refuses(check, "Overlapping particles", overlapping_particles::Flow(overlapping_particles::staggered_disc(1, 0.125)));
  {
    using namespace gauss_particles;
    refuses(check, "Gauss-principle particles",
            Flow(disc(1, 12), std::make_unique<SplineSpace>(LatticePlan{.cell_x = 0.25}), {}, {.gravity = 0}));
  }
  refuses(check, "Finite volumes", shallow_water_finite_volume::FiniteVolumeFlow({}, 0, 1, depth, still));
  {
    using namespace shallow_water_particles;
    refuses(check, "Shallow-water particles", ParticleFlow(dam_break(0, 0.4, 1, {1, 0}, {0.5, 0}, 20)));
  }
  {
    using namespace wcsph;
    const Settings settings{.sound_speed = 15};
    const Scene scene = wcsph::dam_break(
        {.width = 0.1, .height = 0.2, .tank_length = 0.4, .wall_height = 0.3, .spacing = 0.01}, settings);
    refuses(check, "WCSPH", Flow(scene.particles, scene.spacing, settings));
  }
}

}  // namespace seiche::verification::bad_step_test
