#include "seiche/exact/macdonald.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution macdonald_entry() {
  return {
      .name = "macdonald",
      .title = "Steady flow with Manning friction over a bed made to fit a smooth rise of the depth",
      .citation = MacDonald::provenance().citation,
      .formula = MacDonald::provenance().formula,
      .parameters = {{"discharge", "m^2/s", 2, 1e-9, 1e6, "discharge per unit width"},
                     {"manning", "s/m^(1/3)", 0.033, 0, 1, "Manning's coefficient"},
                     {"length", "m", 1000, 1e-6, 1e9, "length of the channel [0, length]"},
                     {"crest", "1", 0.5, -0.9, 10, "relative rise of the depth in the middle"},
                     gravity_parameter(9.81)},
      .inputs = {position_x},
      .outputs = {{"h", "m", "depth"}, {"u", "m/s", "velocity"}, {"z", "m", "bed elevation, 0 at the outflow"}},
      .scalars = {{"fall", "m", "fall of the bed over the channel"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                MacDonald::smooth_rise(p.at("gravity"), p.at("discharge"), p.at("manning"), p.at("length"),
                                       p.at("crest")),
                [](const MacDonald& solution, std::span<const double> at) {
                  const auto state = solution.at(at[0]);
                  return Evaluator::Row{state.depth, state.velocity, solution.elevation(at[0])};
                },
                [](const MacDonald& solution) {
                  return Evaluator::Row{solution.elevation(0) - solution.elevation(solution.length())};
                });
          },
  };
}

}  // namespace seiche::exact
