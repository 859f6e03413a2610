#include "seiche/exact/dispersive_standing_wave.hpp"
#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution dispersive_standing_entry() {
  return {
      .name = "dispersive_standing",
      .title = "Standing wave of the dispersive shallow-water model, its frequency to third order",
      .citation = DispersiveStandingWave::provenance().citation,
      .formula = DispersiveStandingWave::provenance().formula,
      .parameters = {{"amplitude", "m", 0.05, 1e-12, 1e6, "first harmonic of the elevation"},
                     wavelength_parameter(),
                     depth_parameter(1, 1e6),
                     gravity_parameter(1),
                     {"alpha", "1", 1.0 / 3, 1e-6, 10, "factor of the vertical kinetic energy"},
                     {"gamma", "1", 0, 0, 10, "added potential energy of slopes, below alpha"},
                     {"weight_exponent", "1", 2, -10, 10, "that energy is weighted with this power of the depth"}},
      .inputs = {{"label", "m", 0, "place of the particle at rest"}, time_t},
      .outputs = {{"x", "m", "place of the particle, to second order"}},
      .scalars = {{"omega", "1/s", "angular frequency, to third order"},
                  {"period", "s", "period"},
                  {"correction", "1", "C: omega = omega_0 (1 + C (amplitude/depth)^2)"},
                  {"critical_wavelength", "m", "wavelength for this depth at which C = 0; NaN if there is none"}},
      .factory =
          [](const Values& p) {
            const double depth = p.at("depth");
            const DispersiveStandingWave::Parameters parameters{p.at("alpha"), p.at("gamma"), p.at("weight_exponent")};
            const double kh = 2 * std::numbers::pi * depth / p.at("wavelength");
            return evaluator_of(
                DispersiveStandingWave(p.at("amplitude"), p.at("wavelength"), depth, p.at("gravity"), parameters),
                [](const DispersiveStandingWave& wave, std::span<const double> at) {
                  return Evaluator::Row{wave.position(at[0], at[1])};
                },
                [=](const DispersiveStandingWave& wave) {
                  const auto critical = DispersiveStandingWave::critical_wavelength(parameters);
                  return Evaluator::Row{wave.frequency(), wave.period(),
                                        DispersiveStandingWave::frequency_correction(kh, parameters),
                                        critical ? *critical * depth : std::numeric_limits<double>::quiet_NaN()};
                });
          },
  };
}

}  // namespace seiche::exact
