/*
A low bore over still water trails waves, Favre waves. Their first crest is at least twice as high as the bore, until it
breaks at a Froude number of about 1.21.

**What is compared.** The height of the first crest over the still depth, as a function of the Froude number, with
measurements of Favre (0.1 and 0.2 m of water) and Treske (0.16 m) up to a Froude number of 1.2. The case accepts
external results. The same claims score the one-dimensional dispersive model, which computes bores from a smooth step to
x/h = 320, as usual in the literature for these data. Reading uncertainties are 0.01 for a crest and 0.003 for the
Froude number; 1.11 and 1.15 are inside the range of all three series.

**What to look at.** The measured crests scatter by 10 to 30 % between depths, with friction, capillarity and distance
travelled. In the theory of modulated waves the first crest slowly grows beyond twice the bore height.
*/
#include <cmath>

#include "seiche/models/dispersive_shallow_water_1d/water_surface.hpp"
#include "seiche/samples.hpp"
#include "validation/laboratory/laboratory_case.hpp"
#include "validation/studies/dispersive_shallow_water/dispersive_flume.hpp"

namespace seiche::validation::cases::undular_bore_crests {

using namespace laboratory;

const std::vector<double> depths{0.1, 0.16, 0.2};

Submitted compute(const Run& run, double coarsening) {
  constexpr double depth = 0.2;
  std::vector<double> froude, crest;
  for (const double jump : {0.02, 0.06, 0.1, 0.15, 0.2, 0.25, 0.28}) {
    const double spacing = coarsening * run.real("spacing");
    const Flume flume{
        .bed_x = {-40, 80}, .bed_z = {-depth, -depth}, .spacing = spacing, .tau = spacing / 3, .gamma = improved};
    dispersive::Flow flow = smooth_bore(flume, depth, jump, 5 * depth);
    froude.push_back(std::sqrt((1 + jump) * (1 + jump / 2)));
    march(flow, 63.5 / (froude.back() * std::sqrt(flume.gravity * depth)), stable_steps(flow, flume.tau));
    crest.push_back(largest(dispersive::water_surface(flow)) / depth);
  }
  std::vector<SubmittedGroup> series;
  for (const double one : depths)
    series.push_back({.value = one, .abscissa = froude, .values = {{"a_over_depth", crest}}});
  return {{"crests", series}};
}

Experiment experiment(const Values& /*values*/) {
  Series part{.name = "crests",
              .table = "favre_treske_undular_bore",
              .kind = WantedTable::Kind::profile,
              .group = Column{"depth", "m", "still depth before the bore"},
              .groups = depths,
              .abscissa = {"Froude", "1", "speed of the bore over sqrt(g depth)"},
              .quantity = {"a_over_depth", "1", "first crest over the still depth"},
              .highest = 1.2};
  for (const double depth : depths) {
    part.readings.push_back(misfit(depth, {}));
    for (const double froude : {1.11, 1.15}) part.readings.push_back(at(depth, froude, Kind::height));
  }
  return {.source =
              "H. Favre, Etude theorique et experimentale des ondes de translation dans les canaux decouverts, Dunod, "
              "Paris (1935); A. Treske, J. Hydraul. Res. 32 (1994) 355-370",
          .parts = {part},
          .compute = compute,
          .model = "dispersive shallow water, improved dispersion"};
}

void undular_bore_crests(Case& c) {
  set_laboratory<experiment>(c, "The first crest of an undular bore",
                             {real("spacing", {0.06, 0.04, 0.04}, "m", {0.01, 0.1}, "of the nodes")});
}

}  // namespace seiche::validation::cases::undular_bore_crests
