#include "seiche/exact/thacker.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution thacker_entry() {
  return {
      .name = "thacker",
      .title = "Water oscillates in a parabolic bowl with a plane surface",
      .citation = Thacker::provenance().citation,
      .formula = Thacker::provenance().formula,
      .parameters = {{"radius", "m", 1, 1e-9, 1e9, "half-width of the water"},
                     {"depth", "m", 0.5, 1e-9, 1e6, "depth of the bowl below the shoreline at rest"},
                     {"displacement", "m", 0.5, 1e-12, 1e9, "amplitude of the motion; at most length/2 - radius"},
                     gravity_parameter(9.81),
                     {"length", "m", 4, 1e-9, 1e9, "length of the channel, the bowl in its middle"}},
      .inputs = {position_x, time_t},
      .outputs = {{"h", "m", "depth"}, {"u", "m/s", "velocity, 0 where dry"}, {"z", "m", "bed elevation"}},
      .scalars = {{"period", "s", "period of the oscillation"},
                  {"angular_frequency", "1/s", "sqrt(2 g depth)/radius"},
                  {"velocity_amplitude", "m/s", "largest velocity"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                Thacker(p.at("gravity"), p.at("radius"), p.at("depth"), p.at("length"), p.at("displacement")),
                [](const Thacker& solution, std::span<const double> at) {
                  const auto state = solution.at(at[0], at[1]);
                  return Evaluator::Row{state.depth, state.velocity, solution.elevation(at[0])};
                },
                [](const Thacker& solution) {
                  return Evaluator::Row{solution.period(), solution.angular_frequency(), solution.velocity_amplitude()};
                });
          },
  };
}

}  // namespace seiche::exact
