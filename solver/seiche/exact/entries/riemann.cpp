#include "seiche/exact/riemann.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution riemann_entry() {
  return {
      .name = "riemann",
      .title = "Two uniform states of shallow water meet: dam breaks, bores, dry fronts",
      .citation = Riemann::provenance().citation,
      .formula = Riemann::provenance().formula,
      .parameters = {{"left_depth", "m", 1, 0, 1e6, "depth on the left; 0 is dry"},
                     {"left_velocity", "m/s", 0, -1e6, 1e6, "velocity on the left"},
                     {"right_depth", "m", 0.1, 0, 1e6, "depth on the right; 0 is dry"},
                     {"right_velocity", "m/s", 0, -1e6, 1e6, "velocity on the right"},
                     gravity_parameter(9.81),
                     {"jump", "m", 0, -1e9, 1e9, "position of the discontinuity at t = 0"}},
      .inputs = {position_x, time_t},
      .outputs = {{"h", "m", "depth"}, {"u", "m/s", "velocity, 0 where dry"}},
      .scalars = {{"star_depth", "m", "depth between the waves, 0 if dry"},
                  {"star_velocity", "m/s", "velocity between the waves, 0 if dry"},
                  {"left_wave_slowest", "m/s", "left end of the left wave"},
                  {"left_wave_fastest", "m/s", "right end of the left wave, equal for a jump"},
                  {"right_wave_slowest", "m/s", "left end of the right wave"},
                  {"right_wave_fastest", "m/s", "right end of the right wave, equal for a jump"},
                  {"discharge_at_jump", "m^2/s", "h u where the states met, t > 0"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                Riemann(p.at("gravity"), {p.at("left_depth"), p.at("left_velocity")},
                        {p.at("right_depth"), p.at("right_velocity")}, p.at("jump")),
                [](const Riemann& solution, std::span<const double> at) {
                  const auto state = solution.at(at[0], at[1]);
                  return Evaluator::Row{state.depth, state.velocity};
                },
                [](const Riemann& solution) {
                  const auto left = solution.left_wave();
                  const auto right = solution.right_wave();
                  return Evaluator::Row{
                      solution.star().depth, solution.star().velocity,    left.slowest, left.fastest, right.slowest,
                      right.fastest,         solution.discharge_at_jump()};
                });
          },
  };
}

}  // namespace seiche::exact
