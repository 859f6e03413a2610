#include "seiche/exact/hall_watts.hpp"

#include <utility>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution hall_watts_entry() {
  using Beach = std::pair<HallWatts, double>;
  return {
      .name = "hall_watts",
      .title = "Correlation of measured solitary-wave run-up on plane beaches",
      .citation = HallWatts::provenance().citation,
      .formula = HallWatts::provenance().formula,
      .parameters = {{"amplitude", "m", 0.1, 1e-9, 1e6, "crest height of the incident wave"},
                     depth_parameter(1, 1e6),
                     {"cot_slope", "1", 1, 1, 11.430052302761343, "cotangent of the beach's angle, 5 to 45 degrees"}},
      .inputs = {},
      .outputs = {{"runup", "m", "run-up; standard uncertainty of the correlation 5 per cent"}},
      .scalars = {},
      .factory =
          [](const Values& p) {
            const auto kept =
                std::make_shared<const Beach>(HallWatts(p.at("depth"), 1 / p.at("cot_slope")), p.at("amplitude"));
            return Evaluator{
                .eval = [kept](std::span<const double>) { return Evaluator::Row{kept->first.runup(kept->second)}; },
                .scalars = [] { return Evaluator::Row{}; },
                .uncertainty = [kept] { return kept->first.uncertainty(); },
                .self_test = [kept] { return kept->first.self_test(); }};
          },
  };
}

}  // namespace seiche::exact
