#include "seiche/exact/soliton_fission.hpp"

#include <cmath>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution soliton_fission_entry() {
  return {
      .name = "soliton_fission",
      .title = "A solitary wave passes onto a shelf and falls apart into several",
      .citation = SolitonFission::provenance().citation,
      .formula = SolitonFission::provenance().formula,
      .parameters = {{"amplitude", "1", 0.1, 1e-9, 1e6, "of the wave before the shelf, over the depth there"},
                     {"shelf_depth", "1", 0.5, 0.05, 1, "of the water on the shelf, over that depth"},
                     {"passage", "1", 0, 0, 1, "how it gets there", {"abrupt", "gradual"}}},
      .inputs = {{"n", "1", 1, "of the wave on the shelf, 1 for the highest"}},
      .outputs = {{"a_n", "1", "its amplitude, over that depth; error of the theory about a_n/shelf_depth, relative"}},
      .scalars = {{"solitons", "1", "how many there are"},
                  {"a_r", "1", "amplitude of the reflected wave, over that depth"},
                  {"transmission", "1", "amplitude at the beginning of the shelf, relative"}},
      .factory =
          [](const Values& p) {
            const double a = p.at("amplitude");
            return evaluator_of(
                SolitonFission(p.at("shelf_depth"), p.at("passage") == 0 ? SolitonFission::Passage::abrupt
                                                                         : SolitonFission::Passage::gradual),
                [a](const SolitonFission& fission, std::span<const double> at) {
                  return Evaluator::Row{a * fission.amplitude(static_cast<int>(std::lround(at[0])))};
                },
                [a](const SolitonFission& fission) {
                  return Evaluator::Row{static_cast<double>(fission.solitons()), a * fission.reflection(),
                                        fission.transmission()};
                });
          },
  };
}

}  // namespace seiche::exact
