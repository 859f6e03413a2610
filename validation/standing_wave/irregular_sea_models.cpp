/*
Which model suits an irregular sea? Waves of many lengths with random phases in a tank, computed with six models, beside
the fully nonlinear potential flow.

**Set-up.** Depth, gravity and density are 1; the tank is 6 long. Seven modes, L/h = 6 to 1.5, share the energy of a
JONSWAP spectrum with its peak at L/h = 3; the significant height is 0.09. Their phases are random, drawn from `seed`.
They start with the surface and velocities of linear theory. The exact flow starts with the same surface and potential,
and is computed with Cauchy's integral to spectral accuracy (`seiche exact waves_in_tank`).

**What is compared.** Elevations along the tank after four periods of the peak: rms over the sum of the amplitudes.

**What to look at.** The error of linear theory itself, 1.5 %, measures the nonlinearity: a model with a larger error is
less accurate than linear theory. It is a third of the wave group's (`wave_group_models`), because the crests do not
meet; 16 rows of the mesh suffice for the group, the sea needs 64. Gauss-principle particles need four cells to the
depth. The error of the dispersive model, 40 %, is what its dispersion relation predicts for waves of $L/h = 1.5$ to 2.

**Limits of this test.** Breaking is not covered, because the sea is not steep enough; nor are the statistics of a sea,
for which four periods are too short. The mesh tangles in some seas: of five seeds in one, before four periods.
*/
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/standing_wave/tank_sea.hpp"

namespace seiche::validation::cases::irregular_sea_models {

tank_sea::Comparison comparison(const Values& values) {
  const double end = values.real("end");
  return {.sea = {.amplitude = values.real("amplitude"),
                  .last = 8,
                  .peak = 4,
                  .seed = static_cast<int>(values.integer("seed"))},
          .end = end,
          .last = end,
          .instant = "at the end",
          .resolved = 0.5,
          .soon = 20,
          .tangles = values.integer("seed") != 1};
}

void irregular_sea_models(Case& c) {
  c.title = "Model comparison: irregular sea in a tank";
  c.source = "K. Hasselmann et al., Dtsch. Hydrogr. Z. A 8(12) (1973); " + literature::longuet_higgins_cokelet;
  c.parameters = tank_sea::with_sizes(
      {
          real("amplitude", 0.1, "depth", {0.001, 0.2}, "sum of the amplitudes of the modes"),
          integer("seed", 1L, {1, 1e6}, "of the phases"),
          real("end", 18.0, "sqrt(depth/g)", {1, 100}, "time of the comparison"),
      },
      64L);
  c.study = tank_sea::study<comparison>();
}

}  // namespace seiche::validation::cases::irregular_sea_models
