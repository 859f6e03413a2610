/*
A wave of 20 s runs up a 1:200 shelf and splits into solitons (Matsuyama and others 2007), in a flume of 205 m.

**What is compared.** Surface elevation at six gauges: maximum of the first waves, its time, and the rms difference.
Time counts from the start of the wavemaker, whose motion comes with the data. The case accepts external results.

**What to look at.** The first soliton breaks near x = -31 m. Walls and bed damp the solitons by some per cent over 160
m; models without friction overestimate them.
*/
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::fission_on_shelf {

using namespace laboratory;

Experiment experiment(const Values& /*values*/) {
  Series part{.table = "matsuyama_2007_fission",
              .group = Column{"x", "m", "distance from the still-water shoreline, negative offshore"},
              .abscissa = {"t", "s", "time since the wavemaker starts"},
              .input = 0.02,
              .input_reason = "motion of the paddle, estimated",
              .telling = 1.5};
  const std::vector<std::pair<double, Window>> first{{-80, {15, 30}},   {-50, {25, 45}}, {-40, {35, 50}},
                                                     {-30.8, {40, 55}}, {-20, {50, 62}}, {-5, {62, 75}}};
  for (const auto& [x, window] : first) {
    part.read({highest(x, window), when_highest(x, window), misfit(x, window)});
  }
  return {.source = "M. Matsuyama, M. Ikeno, T. Sakakiyama, T. Takeda, Pure Appl. Geophys. 164 (2007) 617-631",
          .parts = {part},
          .files = {"matsuyama_2007_fission/bed.csv"}};
}

void fission_on_shelf(Case& c) {
  set_laboratory<experiment>(c, "Fission of a long wave into solitons on a shelf");
}

}  // namespace seiche::validation::cases::fission_on_shelf
