#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"
#include "seiche/exact/standing_wave.hpp"

namespace seiche::exact {

ExactSolution standing_entry() {
  return {
      .name = "standing",
      .title = "Standing wave between walls, to second order, its frequency to third",
      .citation = StandingWave::provenance().citation,
      .formula = StandingWave::provenance().formula,
      .parameters = {{"amplitude", "m", 0.05, 1e-12, 1e6, "coefficient of cos(k x) at first order"},
                     wavelength_parameter(),
                     depth_parameter(1, infinite),
                     gravity_parameter(9.81)},
      .inputs = {position_x, height_y, time_t},
      .outputs = {{"eta", "m", "surface elevation"},
                  {"phi", "m^2/s", "velocity potential"},
                  {"u", "m/s", "horizontal velocity"},
                  {"v", "m/s", "vertical velocity"}},
      .scalars = {{"omega", "1/s", "angular frequency, to third order"},
                  {"omega2", "1", "its correction: omega/sqrt(g k) = w + (k amplitude)^2 omega2/2"},
                  {"second_harmonic", "1", "B: eta holds k amplitude^2 B cos(2 k x) at its highest"},
                  {"period", "s", "period"},
                  {"critical_depth", "m", "depth for this wavelength at which omega2 is zero"}},
      .factory =
          [](const Values& p) {
            const double depth = p.at("depth");
            return evaluator_of(
                StandingWave(p.at("amplitude"), p.at("wavelength"), depth, p.at("gravity")),
                [](const StandingWave& wave, std::span<const double> at) {
                  const double eta = wave.elevation(at[0], at[2]);
                  const double y = std::isnan(at[1]) ? eta : at[1];
                  const auto [u, v] = wave.velocity(at[0], y, at[2]);
                  return Evaluator::Row{eta, wave.potential(at[0], y, at[2]), u, v};
                },
                [depth](const StandingWave& wave) {
                  const double kh = wave.wavenumber() * depth;
                  return Evaluator::Row{wave.frequency(), StandingWave::frequency_correction(kh),
                                        StandingWave::second_harmonic(kh), wave.period(),
                                        StandingWave::critical_depth() / wave.wavenumber()};
                });
          },
  };
}

}  // namespace seiche::exact
