#include "seiche/exact/kadomtsev_petviashvili.hpp"

#include <numbers>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution kadomtsev_petviashvili_entry() {
  constexpr double degree = std::numbers::pi / 180;
  return {
      .name = "kadomtsev_petviashvili",
      .title = "Surface of Mach and regular reflection by the Kadomtsev-Petviashvili equation",
      .citation = KadomtsevPetviashvili::provenance().citation,
      .formula = KadomtsevPetviashvili::provenance().formula,
      .parameters = {{"amplitude", "m", 0.1, 1e-9, 1e6, "amplitude of the incident wave"},
                     {"angle", "deg", 20, 1e-6, 89.999999, "between the incident wave's direction and the wall"},
                     depth_parameter(1, 1e6),
                     gravity_parameter(1),
                     {"pattern",
                      "1",
                      0,
                      0,
                      1,
                      "reflection at the wall y = 0, or the three crests of the stem's end alone",
                      {"wall_reflection", "resonant_triad"}}},
      .inputs = {position_x, {"y", "m", 0, "distance from the wall"}, time_t},
      .outputs = {{"eta", "m", "surface elevation"}},
      .scalars = {{"kappa", "1", "tan(angle)/sqrt(3 amplitude/depth); a stem below 1"},
                  {"a_w", "m", "amplitude at the wall after a long time"},
                  {"a_r", "m", "amplitude of the reflected wave"},
                  {"psi_r", "deg", "angle of the reflected wave"},
                  {"speed", "m/s", "of the crest along the wall"},
                  {"settling_rate", "1/s", "rate at which the wall amplitude approaches its limit; 0 without a stem"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                KadomtsevPetviashvili(p.at("amplitude"), p.at("angle") * degree, p.at("depth"), p.at("gravity"),
                                      p.at("pattern") == 0 ? KadomtsevPetviashvili::Pattern::wall_reflection
                                                           : KadomtsevPetviashvili::Pattern::resonant_triad),
                [](const KadomtsevPetviashvili& waves, std::span<const double> at) {
                  return Evaluator::Row{waves.elevation(at[0], at[1], at[2])};
                },
                [](const KadomtsevPetviashvili& waves) {
                  return Evaluator::Row{waves.kappa(),
                                        waves.wall().amplitude,
                                        waves.reflected().amplitude,
                                        waves.reflected().angle() / degree,
                                        waves.wall().speed,
                                        waves.settling_rate()};
                });
          },
  };
}

}  // namespace seiche::exact
