/*
Which model suits a wave group? A group crosses a tank and focuses at its wall, computed with six models, beside the
fully nonlinear potential flow.

**Set-up.** Depth, gravity and density are 1; the tank is 6 long. Six modes of equal amplitude, L/h = 6 to 1.7, start
with the surface and velocities of linear theory so that all crests would meet at the wall $x = 0$ at the time `focus`,
as in laboratories since Baldock, Swan and Taylor (1996). The exact flow starts with the same surface and potential, and
is computed with Cauchy's integral to spectral accuracy (`seiche exact waves_in_tank`).

**What is compared.** Elevations along the tank at the focus, when every phase error counts: rms over the linear height
of the focus. Each model continues for half as long again.

**What to look at.** The error of linear theory itself measures the nonlinearity: a model with a larger error is less
accurate than linear theory. The dispersive model has the wrong celerity for waves of $L/h = 2$, as predicted by its
dispersion relation. With Gauss-principle particles and the mesh every component arrives in phase.

**Limits of this test.** Breaking is not covered, because the group is not steep enough; nor are long runs, the time to
focus being some three periods.
*/
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/standing_wave/tank_sea.hpp"

namespace seiche::validation::cases::wave_group_models {

tank_sea::Comparison comparison(const Values& values) {
  return {.sea = {.amplitude = values.real("amplitude"), .focus = values.real("focus")},
          .end = values.real("focus"),
          .last = 1.5 * values.real("focus"),
          .instant = "at the focus"};
}

void wave_group_models(Case& c) {
  c.title = "Model comparison: focus of a wave group at a wall";
  c.source = "T. E. Baldock, C. Swan, P. H. Taylor, Phil. Trans. R. Soc. Lond. A 354 (1996) 649; " +
             literature::longuet_higgins_cokelet;
  c.parameters = tank_sea::with_sizes(
      {
          real("amplitude", 0.1, "depth", {0.001, 0.2}, "of the crest at the focus by linear theory"),
          real("focus", 9.0, "sqrt(depth/g)", {1, 40}, "time at which the crests meet at the wall"),
      },
      {16, 32, 32});
  c.study = tank_sea::study<comparison>();
}

}  // namespace seiche::validation::cases::wave_group_models
