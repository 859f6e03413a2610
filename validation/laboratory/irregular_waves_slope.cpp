/*
Irregular waves climb a slope of 1:20 and break (Mase and Kirby, run 2; spectral peak at 1 Hz).

**What is compared.** Standard deviation, skewness and asymmetry of the elevation against the still depth, of the
whole record of 750 s; their standard errors are those of ten blocks. The case scores others. Drive the model with the
record over 0.47 m of water, which the template names.

**What to look at.** Skewness grows as the waves steepen and falls behind; asymmetry grows until the shore.
*/
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases {
namespace {

using namespace laboratory;

const std::string source = "H. Mase, J. T. Kirby, Proc. 23rd Int. Conf. Coastal Eng. (1992) 474-487";

Series statistic(const std::string& name, const Column& quantity, const std::vector<double>& depths) {
  Series part{.name = name,
              .table = "mase_kirby_1992_irregular_slope",
              .kind = WantedTable::Kind::profile,
              .abscissa = {"depth", "m", "still depth"},
              .quantity = quantity,
              .spread = quantity.name + "_se",
              .readings = {}};
  for (const double depth : depths) part.readings.push_back(at(0, depth, Kind::statistic));
  return part;
}

Experiment experiment(const Values& /*values*/) {
  const std::vector<double> everywhere{0.025, 0.05, 0.075, 0.1, 0.15, 0.2, 0.35};
  return {.source = source,
          .parts = {statistic("std", {"std", "m", "standard deviation of the elevation"}, everywhere),
                    statistic("skewness", {"skewness", "1", "skewness of the elevation"}, everywhere),
                    statistic("asymmetry", {"asymmetry", "1", "asymmetry: less the skewness of the Hilbert transform"},
                              {0.025, 0.05, 0.075, 0.1})},
          .files = {"mase_kirby_1992_irregular_slope/incident.csv", "mase_kirby_1992_irregular_slope/bed.csv"}};
}

}  // namespace

Case irregular_waves_slope() {
  Case c;
  c.title = "Irregular waves shoal and break on a slope";
  c.source = source;
  set_laboratory<experiment>(c);
  return c;
}

}  // namespace seiche::validation::cases
