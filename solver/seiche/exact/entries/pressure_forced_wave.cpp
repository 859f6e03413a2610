#include "seiche/exact/pressure_forced_wave.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/moving_surface_parts.hpp"

namespace seiche::exact {

ExactSolution pressure_forced_wave_entry() {
  return {
      .name = "pressure_forced_wave",
      .title = "A Stokes wave is pushed by a travelling pressure until it overturns: fully nonlinear potential flow",
      .citation = PressureForcedWave::provenance().citation,
      .formula = PressureForcedWave::provenance().formula,
      .parameters = {{"amplitude", "m", 0.3, 0, 1e6, "half the height of the Stokes wave; 0: water at rest"},
                     wavelength_parameter(),
                     depth_parameter(std::numbers::pi, infinite),
                     gravity_parameter(1),
                     {"pressure", "m^2/s^2", 0.1, -1e6, 1e6, "amplitude p0 of the pressure over the density"},
                     {"markers", "1", 256, 192, 4096, "markers per wavelength, even"},
                     {"last_time", "s", 0, 0, 1e9, "end of the computation; 0: 7.4/sqrt(g k)"},
                     points_of_profile},
      .inputs = {time_t},
      .outputs = points_of_surface,
      .scalars = {{"vertical_tangent_time", "s", "when the front is first vertical; NaN if it is not"},
                  {"touch_down_time", "s", "when the jet meets the water below; NaN if it does not"},
                  {"end_time", "s", "last time computed"},
                  {"energy", "m^4/s^2", "kinetic and potential, per wavelength at the start, density 1"},
                  {"work", "m^4/s^2", "of the pressure up to the end, per wavelength, density 1"}},
      .factory =
          [](const Values& p) {
            return moving_surface_evaluator(
                PressureForcedWave(
                    {.amplitude = p.at("amplitude"),
                     .wavelength = p.at("wavelength"),
                     .depth = p.at("depth"),
                     .gravity = p.at("gravity"),
                     .pressure = p.at("pressure"),
                     .markers = static_cast<std::size_t>(p.at("markers")),
                     .last_time = p.at("last_time") > 0 ? std::optional(p.at("last_time")) : std::nullopt}),
                static_cast<std::size_t>(p.at("points")), [](const PressureForcedWave& wave) {
                  const auto start = wave.integrals(0);
                  return Evaluator::Row{or_none(wave.vertical_tangent_time()), or_none(wave.touch_down_time()),
                                        wave.end_time(), start.kinetic_energy + start.potential_energy,
                                        wave.action(wave.end_time()).work};
                });
          },
  };
}

}  // namespace seiche::exact
