#include "seiche/exact/wall_load.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution wall_load_entry() {
  return {
      .name = "wall_load",
      .title = "Pressure and force of an exact solitary wave on a vertical wall",
      .citation = WallLoad::provenance().citation,
      .formula = WallLoad::provenance().formula,
      .parameters = {{"amplitude", "m", 0.3, 1e-9, 1e6, "of the incident wave, 0.05 to 0.6 depth"},
                     depth_parameter(1, 1e6),
                     {"markers", "1", 384, 128, 4096, "markers of the computation, even"}},
      .inputs = {{"t", "1", 0, "time since the crest was the separation from the wall, times sqrt(g/depth)"}},
      .outputs = {{"level", "m", "elevation of the water at the wall"},
                  {"still", "m", "pressure over rho g at the undisturbed level"},
                  {"bottom", "m", "pressure over rho g at the foot of the wall"},
                  {"force", "m^2", "force over rho g per unit width"}},
      .scalars = {{"largest_still", "m", "largest pressure over rho g at the undisturbed level"},
                  {"largest_bottom", "m", "largest pressure over rho g at the foot of the wall"},
                  {"largest_force", "m^2", "largest force over rho g per unit width"},
                  {"time_of_still", "1", "when the pressure at the undisturbed level is largest, times sqrt(g/depth)"},
                  {"time_of_bottom", "1", "when the pressure at the foot is largest, times sqrt(g/depth)"},
                  {"time_of_force", "1", "when the force is largest, times sqrt(g/depth)"},
                  {"separation", "m", "distance of the crest from the wall at t = 0"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                WallLoad(p.at("amplitude"), p.at("depth"), static_cast<std::size_t>(p.at("markers"))),
                [](const WallLoad& wall, std::span<const double> at) {
                  const WallLoad::Load load = wall.at(at[0]);
                  return Evaluator::Row{load.level, load.still, load.bottom, load.force};
                },
                [](const WallLoad& wall) {
                  return Evaluator::Row{wall.largest_still().value, wall.largest_bottom().value,
                                        wall.largest_force().value, wall.largest_still().time,
                                        wall.largest_bottom().time, wall.largest_force().time,
                                        wall.separation()};
                });
          },
  };
}

}  // namespace seiche::exact
