#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"
#include "seiche/exact/stokes_wave.hpp"

namespace seiche::exact {

ExactSolution stokes_entry() {
  return {
      .name = "stokes",
      .title = "Periodic progressive wave of the full Euler equations, with the velocities inside",
      .citation = StokesWave::provenance().citation,
      .formula = StokesWave::provenance().formula,
      .parameters = {{"amplitude", "m", 0.1, 1e-9, 1e6, "half the height from trough to crest"},
                     wavelength_parameter(),
                     depth_parameter(infinite, infinite),
                     {"conformal_depth", "m", 0, 0, infinite,
                      "discharge under the wave over its speed; where positive it "
                      "takes the place of depth"},
                     gravity_parameter(1)},
      .inputs = {position_x, height_y, time_t},
      .outputs = {{"eta", "m", "surface elevation above the mean level"},
                  {"u", "m/s", "horizontal velocity"},
                  {"v", "m/s", "vertical velocity"}},
      .scalars = {{"c", "m/s", "phase speed, mean velocity below the troughs zero"},
                  {"mean_depth", "m", "mean depth"},
                  {"conformal_depth", "m", "conformal depth"},
                  {"crest_elevation", "m", "crest above the mean level"},
                  {"trough_elevation", "m", "trough, negative"},
                  {"bernoulli_constant", "m^2/s^2", "q^2/2 + g eta on the surface, seen from the wave"},
                  {"impulse", "m^2/s", "mean impulse, density 1"},
                  {"kinetic", "m^3/s^2", "mean kinetic energy, density 1"},
                  {"potential", "m^3/s^2", "mean potential energy, density 1"},
                  {"crest_velocity", "m/s", "horizontal velocity at the crest"},
                  {"maximum_slope", "rad", "largest inclination of the surface"}},
      .factory =
          [](const Values& p) {
            const double conformal = p.at("conformal_depth");
            return evaluator_of(
                conformal > 0 ? StokesWave::from_conformal_depth(p.at("amplitude"), p.at("wavelength"), conformal,
                                                                 p.at("gravity"))
                              : StokesWave(p.at("amplitude"), p.at("wavelength"), p.at("depth"), p.at("gravity")),
                [](const StokesWave& wave, std::span<const double> at) {
                  const double eta = wave.elevation(at[0], at[2]);
                  const auto [u, v] = wave.velocity(at[0], std::isnan(at[1]) ? eta : at[1], at[2]);
                  return Evaluator::Row{eta, u, v};
                },
                [](const StokesWave& wave) {
                  return Evaluator::Row{wave.phase_speed(),     wave.mean_depth(),       wave.conformal_depth(),
                                        wave.crest_elevation(), wave.trough_elevation(), wave.bernoulli_constant(),
                                        wave.impulse(),         wave.kinetic_energy(),   wave.potential_energy(),
                                        wave.crest_velocity(),  wave.maximum_slope()};
                });
          },
  };
}

}  // namespace seiche::exact
