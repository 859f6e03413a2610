#include "seiche/exact/gerstner.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution gerstner_entry() {
  return {
      .name = "gerstner",
      .title = "Gerstner's rotational wave in deep water: every particle moves on a circle",
      .citation = GerstnerWave::provenance().citation,
      .formula = GerstnerWave::provenance().formula,
      .parameters = {wavelength_parameter(),
                     gravity_parameter(1),
                     {"top", "m", -0.5, -1e6, 0, "label b of the surface; 0 is the cusped wave"}},
      .inputs = {position_x, height_y, time_t},
      .outputs = {{"eta", "m", "surface elevation"},
                  {"u", "m/s", "horizontal velocity"},
                  {"v", "m/s", "vertical velocity"},
                  {"p", "m^2/s^2", "pressure over density"},
                  {"a", "m", "label: centre of the particle's circle, along x"},
                  {"b", "m", "label: centre of the particle's circle, along y"}},
      .scalars = {{"c", "m/s", "phase speed"},
                  {"omega", "1/s", "angular frequency"},
                  {"height", "m", "crest above trough"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                GerstnerWave(p.at("wavelength"), p.at("gravity"), p.at("top")),
                [](const GerstnerWave& wave, std::span<const double> at) {
                  const double eta = wave.elevation(at[0], at[2]);
                  const auto label = wave.label(at[0], std::isnan(at[1]) ? eta : at[1], at[2]);
                  const auto velocity = wave.velocity(label, at[2]);
                  return Evaluator::Row{eta, velocity.u, velocity.v, wave.pressure(label), label.a, label.b};
                },
                [](const GerstnerWave& wave) {
                  return Evaluator::Row{wave.phase_speed(), wave.frequency(), wave.height()};
                });
          },
  };
}

}  // namespace seiche::exact
