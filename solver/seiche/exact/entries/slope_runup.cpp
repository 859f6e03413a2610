#include "seiche/exact/slope_runup.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution slope_runup_entry() {
  return {
      .name = "slope_runup",
      .title = "Run-up of an exact solitary wave on a plane slope",
      .citation = SlopeRunup::provenance().citation,
      .formula = SlopeRunup::provenance().formula,
      .parameters = {{"amplitude", "m", 0.3, 1e-9, 1e6, "of the incident wave, 0.02 to 0.5 depth"},
                     {"cotangent", "1", 1, 0, 3, "of the slope; 0: a vertical wall"},
                     depth_parameter(1, 1e6),
                     {"markers", "1", 200, 160, 2048, "markers of the computation, even"}},
      .inputs =
          {{"t", "1", 0,
            "time from when the crest would pass the toe if there were no slope, times sqrt(g/depth); known until "
            "the largest run-up"}},
      .outputs = {{"level", "m", "elevation of the shore above still water"}},
      .scalars = {{"runup", "m", "highest elevation of the shore"},
                  {"time_of_runup", "1", "when it is reached, times sqrt(g/depth)"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                SlopeRunup(p.at("amplitude"), p.at("cotangent"), p.at("depth"),
                           static_cast<std::size_t>(p.at("markers"))),
                [](const SlopeRunup& slope, std::span<const double> at) { return Evaluator::Row{slope.level(at[0])}; },
                [](const SlopeRunup& slope) {
                  return Evaluator::Row{slope.runup(), slope.runup_time()};
                });
          },
  };
}

}  // namespace seiche::exact
