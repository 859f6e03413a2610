#include "seiche/exact/wavemaker.hpp"

#include <numbers>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution wavemaker_entry() {
  return {
      .name = "wavemaker",
      .title = "Waves of a piston or a bottom-hinged flap, with the near field",
      .citation = Wavemaker::provenance().citation,
      .formula = Wavemaker::provenance().formula,
      .parameters = {{"kind", "1", 0, 0, 1, "paddle", {"piston", "flap"}},
                     depth_parameter(1, 1e6),
                     gravity_parameter(1),
                     {"period", "s", 2 * std::numbers::pi, 0, 1e6, "period; 0: it follows from the wavelength"},
                     {"wavelength", "m", 0, 0, 1e9, "wavelength of the progressive wave, where period is 0"},
                     {"stroke", "m", 1, 0, 1e6, "stroke at the still-water level; 0: it follows from the height"},
                     {"height", "m", 0, 0, 1e6, "height of the progressive wave, where stroke is 0"}},
      .inputs = {{"x", "m", 0, "distance from the paddle"}, time_t},
      .outputs = {{"eta", "m", "surface elevation of the settled motion"},
                  {"progressive", "m", "the progressive wave alone"}},
      .scalars = {{"stroke_ratio", "1", "height of the progressive wave over the stroke, H/S"},
                  {"stroke", "m", "stroke"},
                  {"wave_height", "m", "height of the progressive wave"},
                  {"period", "s", "period"},
                  {"wavenumber", "1/m", "of the progressive wave"},
                  {"evanescent_1", "1/m", "k_1 of the near field"},
                  {"coefficient_1", "1", "C_1"},
                  {"evanescent_2", "1/m", "k_2 of the near field"},
                  {"coefficient_2", "1", "C_2"}},
      .factory =
          [](const Values& p) {
            const Paddle kind = p.at("kind") == 0 ? Paddle::piston : Paddle::flap;
            const auto with_stroke = [&](double stroke) {
              return p.at("period") > 0
                         ? Wavemaker::with_period(kind, p.at("gravity"), p.at("depth"), p.at("period"), stroke)
                         : Wavemaker::with_wavelength(kind, p.at("gravity"), p.at("depth"), p.at("wavelength"), stroke);
            };
            const double stroke = p.at("stroke") > 0 ? p.at("stroke") : with_stroke(1).stroke_for(p.at("height"));
            return evaluator_of(
                with_stroke(stroke),
                [](const Wavemaker& maker, std::span<const double> at) {
                  return Evaluator::Row{maker.elevation(at[0], at[1]), maker.progressive(at[0], at[1])};
                },
                [](const Wavemaker& maker) {
                  return Evaluator::Row{maker.height_per_stroke(), maker.stroke(),
                                        maker.wave_height(),       maker.period(),
                                        maker.wavenumber(),        maker.evanescent_wavenumber(1),
                                        maker.coefficient(1),      maker.evanescent_wavenumber(2),
                                        maker.coefficient(2)};
                });
          },
  };
}

}  // namespace seiche::exact
