/*
Regular waves break on an elliptic shoal (Vincent and Briggs 1989).

**What is compared.** Wave height over the incident height along a section behind the shoal: on its axis, beside it, and
the rms difference. The case accepts external results.

**What to look at.** Breaking on the shoal drives currents that defocus the waves: on the axis the waves are lower than
beside it. Models without that current predict the opposite.
*/
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::breaking_on_shoal {

using namespace laboratory;

Experiment experiment(const Values& /*values*/) {
  return {.source = "C. L. Vincent, M. J. Briggs, J. Waterway Port Coastal Ocean Eng. 115 (1989) 269-284",
          .parts = {{.name = "section",
                     .table = "vincent_briggs_1989_elliptic_shoal",
                     .kind = WantedTable::Kind::profile,
                     .abscissa = {"y", "m", "distance from the shoal's axis, 6.1 m behind its centre"},
                     .quantity = {"H", "1", "wave height over the incident one"},
                     .readings = {mean(0, {-1.6, 1.6}), mean(0, {-3.1, -2.2}), mean(0, {2.2, 3.1}), misfit(0, {})}}}};
}

void breaking_on_shoal(Case& c) {
  set_laboratory<experiment>(c, "Breaking of regular waves on an elliptic shoal");
}

}  // namespace seiche::validation::cases::breaking_on_shoal
