/*
Which model suits an irregular sea over bars? Waves of many lengths with random phases over a barred bottom, computed
with three models, beside the fully nonlinear potential flow over the same bottom.

**Set-up.** Depth, gravity and density are 1; the tank is 6 long. The bottom has trochoidal bars, 3 apart and
`bar_height` high, with crests in the middle and at both walls: waves of $L = 6$, the peak of the spectrum, are
reflected by them in phase (Bragg's law, half a wavelength from bar to bar). Five modes, L/h = 12 to 2.4, share the
energy of a JONSWAP spectrum; their phases are random, drawn from `seed`. The surface follows linear theory;
velocities keep to the bottom. The exact flow starts with the same surface and potential; a conformal map takes the bars
to a level bottom, and Cauchy's integral there is accurate to spectral order (`seiche exact waves_in_tank`).

**What is compared.** Elevations along the tank after three periods of the peak: rms over the sum of the amplitudes.

**What to look at.** The exact sea over the bars differs from the sea over a level bottom by 4.5 % (rms): a model with a
larger error does not resolve the bars. Gauss-principle particles resolve them with three cells to the depth; the error
of the dispersive model comes from its celerities and does not fall with the node spacing.

**Limits of this test.** Breaking is not covered, nor are bars higher than one over their wavenumber, whose crests are
sharper. The Lagrangian mesh tangles over the bars before the end, fine meshes sooner than coarse ones. Dirichlet cells,
variable masses and SPH are absent: their tanks have level bottoms.
*/
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/standing_wave/tank_sea.hpp"

namespace seiche::validation::cases::irregular_sea_bars {

tank_sea::Comparison comparison(const Values& values) {
  const double end = values.real("end");
  return {.sea = {.amplitude = values.real("amplitude"),
                  .first = 1,
                  .last = 5,
                  .peak = 2,
                  .seed = static_cast<int>(values.integer("seed")),
                  .bar_height = values.real("bar_height"),
                  .bars = 4},
          .end = end,
          .last = end,
          .instant = "at the end",
          .soon = 25,
          .tangles = true};
}

void irregular_sea_bars(Case& c) {
  c.title = "Model comparison: irregular sea over bars";
  c.source =
      "K. Hasselmann et al., Dtsch. Hydrogr. Z. A 8(12) (1973); A. G. Davies, A. D. Heathershaw, J. Fluid Mech. "
      "144 (1984) 419; " +
      literature::longuet_higgins_cokelet;
  c.parameters = tank_sea::with_sizes(
      {
          real("amplitude", 0.1, "depth", {0.001, 0.2}, "sum of the amplitudes of the modes"),
          real("bar_height", 0.3, "depth", {0.001, 0.477}, "from trough to crest"),
          integer("seed", 1L, {1, 1e6}, "of the phases"),
          real("end", 21.0, "sqrt(depth/g)", {1, 100}, "time of the comparison"),
      },
      {16, 32, 32}, true);
  c.study = tank_sea::study<comparison>();
}

}  // namespace seiche::validation::cases::irregular_sea_bars
