/*
Regular waves of 1 s are focused by an elliptic shoal on a slope (Berkhoff, Booij and Radder).

**What is compared.** Amplitude over the incident one along eight sections: the largest, where it is, and the root
mean square difference. The case scores others.

**What to look at.** The focus lies on the shallower side, y < 0: a result of another handedness is mirrored. Linear
theory has the pattern right and the peaks behind the focus a tenth too high; the waves are steep enough for that.
*/
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases {
namespace {

using namespace laboratory;

const std::string source = "J. C. W. Berkhoff, N. Booij, A. C. Radder, Coastal Eng. 6 (1982) 255-279";

Experiment experiment(const Values& /*values*/) {
  Series part{.name = "sections",
              .table = "berkhoff_1982_elliptic_shoal",
              .kind = WantedTable::Kind::profile,
              .group = Column{"section", "1", "number: 1 to 5 across, 6 to 8 along"},
              .abscissa = {"s", "m", "y on sections 1 to 5, x on 6 to 8, from the shoal's centre"},
              .quantity = {"a", "1", "amplitude over the incident one"},
              .telling = 2.5,
              .readings = {}};
  for (double section = 1; section <= 8; ++section) {
    part.readings.push_back(highest(section, {}));
    if (section > 2 && section != 6 && section != 8) part.readings.push_back(when_highest(section, {}, Kind::place));
    part.readings.push_back(misfit(section, {}));
  }
  return {.source = source, .parts = {part}, .files = {"berkhoff_1982_elliptic_shoal/bathymetry.asc"}};
}

}  // namespace

Case elliptic_shoal() {
  Case c;
  c.title = "Regular waves on an elliptic shoal";
  c.source = source;
  set_laboratory<experiment>(c);
  return c;
}

}  // namespace seiche::validation::cases
