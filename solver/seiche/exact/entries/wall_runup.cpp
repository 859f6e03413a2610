#include "seiche/exact/wall_runup.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution wall_runup_entry() {
  return {
      .name = "wall_runup",
      .title = "Run-up of an exact solitary wave on a vertical wall",
      .citation = WallRunup::provenance().citation,
      .formula = WallRunup::provenance().formula,
      .parameters = {{"amplitude", "m", 0.3, 1e-9, 1e6, "of the incident wave, 0.05 to 0.6 depth"},
                     depth_parameter(1, 1e6),
                     {"markers", "1", 384, 128, 4096, "markers of the computation, even"}},
      .inputs = {},
      .outputs = {{"runup", "m", "highest elevation at the wall"}},
      .scalars = {{"su_mirie", "m", "series 2 a + a^2/2 + 3 a^3/4 of Su and Mirie, in depths"},
                  {"byatt_smith", "m", "series 2 a + a^2/2 of Byatt-Smith, in depths"}},
      .factory =
          [](const Values& p) {
            const double depth = p.at("depth");
            return evaluator_of(
                WallRunup(p.at("amplitude"), depth, static_cast<std::size_t>(p.at("markers"))),
                [](const WallRunup& wall, std::span<const double>) { return Evaluator::Row{wall.runup()}; },
                [depth](const WallRunup& wall) {
                  return Evaluator::Row{WallRunup::su_mirie(wall.wave_amplitude(), depth),
                                        WallRunup::byatt_smith(wall.wave_amplitude(), depth)};
                });
          },
  };
}

}  // namespace seiche::exact
