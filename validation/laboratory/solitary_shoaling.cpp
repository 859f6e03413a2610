/*
A solitary wave of H/h = 0.2 climbs a 1:34.7 slope until its front is vertical (Grilli and others 1994).

**What is compared.** The elevation at six gauges: maximum, its time, and the rms difference within 1.5 of the crest in
T. The crest passes the gauge before the slope at T = 13.64, in the measured points and, by one time shift, in the
computation. Against the other gauges that time is known to 0.1: the paper states 13.56, the best fit is 13.75. The case
accepts external results, and the same claims score the one-dimensional dispersive model, from a solitary wave of the
stated height, without friction, which the source calls negligible.

**What to look at.** The last gauge, in the breaking zone, where long-wave models overestimate the elevation.
*/
#include <cmath>

#include "validation/laboratory/laboratory_case.hpp"
#include "validation/studies/dispersive_shallow_water/dispersive_flume.hpp"

namespace seiche::validation::cases::solitary_shoaling {

using namespace laboratory;

const std::vector<double> gauges{-5, 20.96, 22.55, 23.68, 24.68, 25.91};
const std::vector<double> crests{13.64, 38.81, 40.56, 41.70, 42.82, 44.28};

Submitted compute(const Run& run, double coarsening) {
  const double spacing = coarsening * run.real("spacing");
  const Flume flume{.bed_x = {-60, -34.7, 0, 20},
                    .bed_z = {-1, -1, 0, 20 / 34.7},
                    .spacing = spacing,
                    .tau = spacing / 3,
                    .shoreline = true,
                    .gravity = 1};
  const double crest = -52;
  dispersive::Flow flow = solitary_waves(flume, {{.depth = 1, .amplitude = 0.2, .crest = crest}});
  const std::vector<double> places = each(gauges, [](double x) { return x - 34.7; });  // from the shoreline
  const double start = crests.front() - (places.front() - crest) / std::sqrt(1.2);
  return {{"gauges", gauge_records(flow, flume, gauges, places, 0.025, 45.5 - start, -start)}};
}

Experiment experiment(const Values& /*values*/) {
  Series part{.table = "grilli_1994_solitary_shoaling",
              .group = Column{"x", "1", "distance from the toe of the slope, in depths"},
              .abscissa = {"T", "1", "time t sqrt(g/depth)"},
              .quantity = {"eta", "1", "elevation over the depth"},
              .input = 0.01,
              .input_reason = "height of the incident wave, estimated",
              .telling = 0.8,
              .origin = crests.front(),
              .clock = Clock{.group = -5, .range = 0.5, .by = when_highest(-5, {11, 17})}};
  for (std::size_t k = 0; k < gauges.size(); ++k) {
    const Window window{crests[k] - 1.5, crests[k] + (k + 1 == gauges.size() ? 0.5 : 1.5)};
    part.readings.push_back(highest(gauges[k], window));
    if (k > 0) part.readings.push_back(when_highest(gauges[k], window));
    part.readings.push_back(misfit(gauges[k], window));
  }
  return {.source =
              "S. T. Grilli, R. Subramanya, I. A. Svendsen, J. Veeramony, J. Waterway Port Coastal Ocean Eng. 120 "
              "(1994) 609-628",
          .parts = {part},
          .files = {"grilli_1994_solitary_shoaling/bed.csv"},
          .compute = compute,
          .model = "dispersive shallow water"};
}

void solitary_shoaling(Case& c) {
  set_laboratory<experiment>(c, "Shoaling of a solitary wave until breaking",
                             {real("spacing", 0.1, "depth", {0.02, 0.4}, "of the nodes")});
}

}  // namespace seiche::validation::cases::solitary_shoaling
