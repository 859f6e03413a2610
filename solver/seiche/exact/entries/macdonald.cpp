#include "seiche/exact/macdonald.hpp"

#include "seiche/exact/entries/entries.hpp"

namespace seiche::exact {

ExactSolution macdonald_entry() {
  return {
      .name = "macdonald",
      .title = "Steady flow with Manning friction over a bed made to fit a smooth rise of the depth",
      .citation = MacDonald::provenance().citation,
      .formula = MacDonald::provenance().formula,
      .parameters = {{"discharge", "m^2/s", 2, 1e-9, 1e6, "discharge per unit width"},
                     {"manning", "s/m^(1/3)", 0.033, 0, 1, "Manning's coefficient"},
                     {"length", "m", 1000, 1e-6, 1e9, "length of the channel [0, length]"},
                     {"crest", "1", 0.5, -0.9, 10, "relative rise of the depth in the middle"},
                     {"gravity", "m/s^2", 9.81, 1e-6, 1e6, "acceleration of gravity"}},
      .inputs = {"x"},
      .outputs = {{"h", "m", "depth"}, {"u", "m/s", "velocity"}, {"z", "m", "bed elevation, 0 at the outflow"}},
      .scalars = {{"fall", "m", "fall of the bed over the channel"}},
      .factory =
          [](const std::map<std::string, double>& p) {
            const auto solution = MacDonald::smooth_rise(p.at("gravity"), p.at("discharge"), p.at("manning"),
                                                         p.at("length"), p.at("crest"));
            return Evaluator{
                [solution](double x, double, double) {
                  const auto state = solution.at(x);
                  return std::vector<double>{state.depth, state.velocity, solution.elevation(x)};
                },
                [solution] {
                  return std::vector<double>{solution.elevation(0) - solution.elevation(solution.length())};
                }};
          },
  };
}

}  // namespace seiche::exact
