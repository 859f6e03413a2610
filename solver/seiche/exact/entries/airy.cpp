#include <numbers>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"
#include "seiche/exact/linear_wave.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

ExactSolution airy_entry() {
  return {
      .name = "airy",
      .title = "Progressive wave of small amplitude",
      .citation = AiryWave::provenance().citation,
      .formula = AiryWave::provenance().formula,
      .parameters = {{"amplitude", "m", 0.01, 1e-12, 1e6, "half the height"},
                     {"wavelength", "m", 2 * std::numbers::pi, 0, 1e9, "wavelength; 0: it follows from the period"},
                     {"period", "s", 0, 0, 1e9, "period, where wavelength is 0"},
                     depth_parameter(1, infinite),
                     gravity_parameter(1)},
      .inputs = {position_x, height_y, time_t},
      .outputs = {{"eta", "m", "surface elevation"},
                  {"u", "m/s", "horizontal velocity"},
                  {"v", "m/s", "vertical velocity"},
                  {"p", "m^2/s^2", "pressure over density"}},
      .scalars = {{"omega", "1/s", "angular frequency"},
                  {"period", "s", "period"},
                  {"wavenumber", "1/m", "2 pi/wavelength"},
                  {"wavelength", "m", "wavelength"},
                  {"phase_speed", "m/s", "omega/k"},
                  {"group_speed", "m/s", "d omega/d k"}},
      .factory =
          [](const Values& p) {
            double wavelength = p.at("wavelength");
            if (wavelength == 0) {
              require_positive("period", p.at("period"));
              const AiryDispersion law(p.at("gravity"), p.at("depth"));
              wavelength = 2 * std::numbers::pi / law.wavenumber(2 * std::numbers::pi / p.at("period"));
            }
            return evaluator_of(
                AiryWave(p.at("amplitude"), wavelength, p.at("depth"), p.at("gravity")),
                [](const AiryWave& wave, std::span<const double> at) {
                  const double eta = wave.elevation(at[0], at[2]);
                  const double y = std::isnan(at[1]) ? eta : at[1];
                  const auto [u, v] = wave.velocity(at[0], y, at[2]);
                  return Evaluator::Row{eta, u, v, wave.pressure(at[0], y, at[2])};
                },
                [](const AiryWave& wave) {
                  return Evaluator::Row{wave.frequency(),   wave.period(),
                                        wave.wavenumber(),  2 * std::numbers::pi / wave.wavenumber(),
                                        wave.phase_speed(), wave.group_speed()};
                });
          },
  };
}

}  // namespace seiche::exact
