#include "seiche/exact/serre_cnoidal.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution serre_cnoidal_entry() {
  return {
      .name = "serre_cnoidal",
      .title = "Periodic travelling wave of the equations of Serre (Green-Naghdi)",
      .citation = SerreCnoidal::provenance().citation,
      .formula = SerreCnoidal::provenance().formula,
      .parameters = {{"height", "m", 0.2, 1e-9, 1e6, "from trough to crest"},
                     wavelength_parameter(),
                     depth_parameter(1, 1e6),
                     gravity_parameter(1)},
      .inputs = {position_x, time_t},
      .outputs = {{"eta", "m", "surface elevation above the mean level"},
                  {"u", "m/s", "horizontal velocity, mean over the depth"}},
      .scalars = {{"c", "m/s", "phase speed"}, {"Q", "m^2/s", "discharge per unit of width, seen from the wave"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                SerreCnoidal(p.at("height"), p.at("wavelength"), p.at("depth"), p.at("gravity")),
                [](const SerreCnoidal& wave, std::span<const double> at) {
                  const double x = at[0] - wave.phase_speed() * at[1];
                  return Evaluator::Row{wave.elevation(x), wave.depth_averaged_velocity(x)};
                },
                [](const SerreCnoidal& wave) {
                  return Evaluator::Row{wave.phase_speed(), wave.discharge()};
                });
          },
  };
}

}  // namespace seiche::exact
