#include "seiche/exact/bore_reflection.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution bore_reflection_entry() {
  return {
      .name = "bore_reflection",
      .title = "A bore runs into still water and reflects from a wall",
      .citation = BoreReflection::provenance().citation,
      .formula = BoreReflection::provenance().formula,
      .parameters = {{"behind_depth", "m", 1, 1e-9, 1e6, "depth behind the incident bore"},
                     {"behind_velocity", "m/s", 1.3, 1e-9, 1e6, "velocity behind the incident bore"},
                     gravity_parameter(9.81),
                     {"start", "m", 5, -1e9, 1e9, "position of the bore at t = 0"},
                     {"wall", "m", 10, -1e9, 1e9, "position of the wall, beyond start"}},
      .inputs = {position_x, time_t},
      .outputs = {{"h", "m", "depth"}, {"u", "m/s", "velocity"}},
      .scalars = {{"ahead_depth", "m", "depth of the still water"},
                  {"incident_speed", "m/s", "velocity of the incident bore"},
                  {"reflection_time", "s", "when the bore meets the wall"},
                  {"reflected_depth", "m", "depth at the wall afterwards"},
                  {"reflected_speed", "m/s", "velocity of the reflected jump"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                BoreReflection::from_velocity(p.at("gravity"), p.at("behind_depth"), p.at("behind_velocity"),
                                              p.at("start"), p.at("wall")),
                [](const BoreReflection& solution, std::span<const double> at) {
                  const auto state = solution.at(at[0], at[1]);
                  return Evaluator::Row{state.depth, state.velocity};
                },
                [](const BoreReflection& solution) {
                  return Evaluator::Row{solution.incident().ahead().depth, solution.incident().speed(),
                                        solution.reflection_time(), solution.reflected_depth(),
                                        solution.reflected_speed()};
                });
          },
  };
}

}  // namespace seiche::exact
