#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"
#include "seiche/exact/solitary_wave.hpp"

namespace seiche::exact {

ExactSolution solitary_entry() {
  return {
      .name = "solitary",
      .title = "Solitary wave of the full Euler equations, with the velocities inside",
      .citation = SolitaryWave::provenance().citation,
      .formula = SolitaryWave::provenance().formula,
      .parameters = {{"amplitude", "m", 0.3, 1e-9, 1e6, "crest above still water, up to 0.8331 depth"},
                     depth_parameter(1, 1e6),
                     gravity_parameter(1)},
      .inputs = {position_x, height_y, time_t},
      .outputs = {{"eta", "m", "surface elevation"},
                  {"u", "m/s", "horizontal velocity"},
                  {"v", "m/s", "vertical velocity"}},
      .scalars = {{"speed", "m/s", "phase speed c"},
                  {"F", "1", "c/sqrt(gravity depth)"},
                  {"mass", "m^2", "int eta dx"},
                  {"kinetic", "m^4/s^2", "kinetic energy, density 1"},
                  {"potential", "m^4/s^2", "potential energy, density 1"},
                  {"circulation", "m^2/s", "int u dx along the bottom"},
                  {"impulse", "m^3/s", "c times the mass"},
                  {"crest_velocity", "m/s", "horizontal velocity at the crest"},
                  {"half_width", "m", "distance from the crest where eta is half the amplitude"},
                  {"maximum_slope", "rad", "largest inclination of the surface"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                SolitaryWave(p.at("amplitude"), p.at("depth"), p.at("gravity")),
                [](const SolitaryWave& wave, std::span<const double> at) {
                  const double eta = wave.elevation(at[0], at[2]);
                  const auto [u, v] = wave.velocity(at[0], std::isnan(at[1]) ? eta : at[1], at[2]);
                  return Evaluator::Row{eta, u, v};
                },
                [](const SolitaryWave& wave) {
                  return Evaluator::Row{wave.speed(),          wave.froude(),           wave.mass(),
                                        wave.kinetic_energy(), wave.potential_energy(), wave.circulation(),
                                        wave.impulse(),        wave.crest_velocity(),   wave.half_width(),
                                        wave.maximum_slope()};
                });
          },
  };
}

}  // namespace seiche::exact
