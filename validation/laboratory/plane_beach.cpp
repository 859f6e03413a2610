/*
Solitary waves on a 1:19.85 plane beach (Synolakis 1987; NTHMP benchmark problem 4): a non-breaking one, H/h = 0.0185,
and a breaking one, 0.3.

**What is compared.** The surface at four or five instants: rms difference, and crest elevation at the first two, more
than a depth off the shore; the maximum run-up. Lengths are over the depth $d$, times over $\sqrt{d/g}$ since the crest
was $\operatorname{arccosh}(\sqrt{20})/\sqrt{3A/4}$ before the toe of the beach at $x = 19.85$; $x$ from the still-water
shoreline, positive offshore. Where the beach is dry the surface is the beach, $-x/19.85$. The case accepts external
results; the suite's model is evaluated in `synolakis_beach`.

**What to look at.** Run-up without friction and surface tension is 15 % above the measurement for the smaller wave: the
measured run-up needs either. The exact solution for the smaller wave is the reference in `synolakis_beach`.
*/
#include "validation/case/literature.hpp"
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::plane_beach {

using namespace laboratory;

/// Heights are known to half a unit of the third decimal: of the profiles to `input`, of the run-up, of a wave as high
/// to that, to `run_up_input` by the laws of run-up.
struct Wave {
  std::string table;
  double input, run_up_amplitude, run_up_input;
  std::vector<double> instants, with_crest;
};

Wave wave_of(const Values& values) {
  if (values.text("wave") == "0.0185")
    return {"synolakis_1987_profiles_0_0185", 0.027, 0.019, 0.034, {30, 40, 50, 60, 70}, {30, 40}};
  return {"synolakis_1987_profiles_0_3", 0.002, 0.298, 0.005, {15, 20, 25, 30}, {15, 20}};
}

Experiment experiment(const Values& values) {
  const Wave wave = wave_of(values);
  Series profiles{.name = "profiles",
                  .table = wave.table,
                  .kind = WantedTable::Kind::profile,
                  .group = Column{"t", "1", "time t sqrt(g/d)"},
                  .abscissa = {"x_over_d", "1", "distance from the shoreline at rest, positive offshore"},
                  .quantity = {"eta_over_d", "1", "surface elevation (the beach where dry)"},
                  .input = wave.input,
                  .input_reason = "0.0005 h in the wave height"};
  for (const double t : wave.instants) profiles.readings.push_back(misfit(t, {}));
  // Off the shore, where the beach that stands for a dry surface lies below the water.
  for (const double t : wave.with_crest) profiles.readings.push_back(highest(t, {1, 20}));
  Series runup{.name = "runup",
               .table = "synolakis_1987_runup",
               .kind = WantedTable::Kind::scalars,
               .abscissa = {"A_over_d", "1", "height of the wave"},
               .quantity = {"R_over_d", "1", "maximum run-up"},
               .rows = {{"A_over_d", wave.run_up_amplitude}},
               .input = wave.run_up_input,
               .input_reason = "0.05 % of the wave height, by the run-up laws",
               .readings = {at(0, wave.run_up_amplitude, Kind::run_up)}};
  return {.source = literature::synolakis + "-545; thesis, California Institute of Technology (1986)",
          .parts = {profiles, runup}};
}

void plane_beach(Case& c) {
  set_laboratory<experiment>(c, "Solitary waves on a plane beach 1 : 19.85: surfaces and run-up",
                             {choice("wave", "0.0185", {"0.0185", "0.3"}, "wave height over depth, H/h")});
}

}  // namespace seiche::validation::cases::plane_beach
