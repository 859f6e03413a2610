#include "seiche/exact/overturning_wave.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/moving_surface_parts.hpp"

namespace seiche::exact {
ExactSolution overturning_wave_entry() {
  return {
      .name = "overturning_wave",
      .title = "A wave steepens, overturns and plunges: fully nonlinear potential flow up to touch-down",
      .citation = OverturningWave::provenance().citation,
      .formula = OverturningWave::provenance().formula,
      .parameters = {{"amplitude", "m", 0.5, 1e-9, 1e6, "half the height of the cosine it starts from"},
                     wavelength_parameter(),
                     depth_parameter(infinite, infinite),
                     gravity_parameter(1),
                     {"markers", "1", 512, 64, 4096, "markers per wavelength, even"},
                     {"last_time", "s", 0, 0, 1e9, "end of the computation; 0: one period of the linear wave"},
                     points_of_profile},
      .inputs = {time_t},
      .outputs = points_of_surface,
      .scalars = {{"vertical_tangent_time", "s", "when the front is first vertical; NaN if it is not"},
                  {"touch_down_time", "s", "when the jet meets the water below; NaN if it does not"},
                  {"end_time", "s", "last time computed"},
                  {"kinetic", "m^4/s^2", "kinetic energy per wavelength at the start, density 1"},
                  {"potential", "m^4/s^2", "potential energy per wavelength at the start, density 1"}},
      .factory =
          [](const Values& p) {
            return moving_surface_evaluator(
                OverturningWave({.amplitude = p.at("amplitude"),
                                 .wavelength = p.at("wavelength"),
                                 .depth = p.at("depth"),
                                 .gravity = p.at("gravity"),
                                 .markers = static_cast<std::size_t>(p.at("markers")),
                                 .last_time = p.at("last_time") > 0 ? std::optional(p.at("last_time")) : std::nullopt}),
                static_cast<std::size_t>(p.at("points")), [](const OverturningWave& wave) {
                  const auto start = wave.integrals(0);
                  return Evaluator::Row{or_none(wave.vertical_tangent_time()), or_none(wave.touch_down_time()),
                                        wave.end_time(), start.kinetic_energy, start.potential_energy};
                });
          },
  };
}

}  // namespace seiche::exact
