/*
A dam break of 0.15 m over 0.038 m of water (Janosi and others 2004). The water behind the gate ejects a jet that
overturns.

**What is compared.** The front position, where the surface first exceeds 0.055 m. One time shift is fitted to the first
four of the eight frames and reported: a gate that clears the water in 0.1 s delays the front. The other four frames are
compared. The case accepts external results, and the same claims score shallow water with a second-order finite-volume
scheme, shallow-water particles in `gated_dam_break_particles`, and weakly compressible SPH in `gated_dam_break_sph`.

**What to look at.** The front speed. The level ahead is read with an error of up to 7 mm; heights are not scored.
*/
#include "validation/laboratory/gated_dam_break_experiment.hpp"
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::gated_dam_break {

using namespace laboratory;

void gated_dam_break(Case& c) {
  set_laboratory<[](const Values&) {
    return gated_dam_break_in_shallow_water("muscl", "shallow water, finite volumes");
  }>(c, "Dam break over water behind a gate", {real("cell", 0.005, "m", {0.0005, 0.02}, "size")});
}

}  // namespace seiche::validation::cases::gated_dam_break
