#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"
#include "seiche/exact/solitary_asymptotic.hpp"

namespace seiche::exact {

ExactSolution serre_solitary_entry() {
  return {
      .name = "serre_solitary",
      .title = "Solitary wave of Rayleigh, exact for the equations of Serre (Green-Naghdi)",
      .citation = SerreSolitary::provenance().citation,
      .formula = SerreSolitary::provenance().formula,
      .parameters = {{"amplitude", "m", 0.3, 1e-9, 1e6, "crest above still water"},
                     depth_parameter(1, 1e6),
                     gravity_parameter(1),
                     {"alpha", "1", 1.0 / 3, 1e-6, 10, "factor of the vertical kinetic energy, 1/3 for Serre"}},
      .inputs = {position_x, time_t},
      .outputs = {{"eta", "m", "surface elevation"}, {"u", "m/s", "horizontal velocity, mean over the depth"}},
      .scalars = {{"speed", "m/s", "phase speed"}, {"mass", "m^2", "int eta dx"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                SerreSolitary(p.at("amplitude"), p.at("depth"), p.at("gravity"), p.at("alpha")),
                [](const SerreSolitary& wave, std::span<const double> at) {
                  const double x = at[0] - wave.speed() * at[1];
                  return Evaluator::Row{wave.elevation(x), wave.depth_averaged_velocity(x)};
                },
                [](const SerreSolitary& wave) {
                  return Evaluator::Row{wave.speed(), wave.area()};
                });
          },
  };
}

}  // namespace seiche::exact
