// Compositions of the dispersive shallow-water model's steps: fourth order in time, with the invariants of the base.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/model_waves.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/models/dispersive_shallow_water_1d/model.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/mechanical_problem.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::dispersive_composition_test {

using namespace mechanics;
using Model = dispersive_shallow_water_1d::Model;

constexpr double amplitude = 0.3;
constexpr double length = 60;
constexpr double end_time = 20;
constexpr std::size_t cells = 240;

struct Result {
  std::vector<double> x;
  double energy = 0;  ///< largest defect, relative to the wave's
  double volume = 0;  ///< largest defect of a cell [depth^2]
  long solves = 0;
};

/// Solitary wave in a periodic level channel, cells of equal volume.
template <template <class> class Base>
Result run(double tau, const std::vector<double>& stages) {
  const exact::SerreSolitary wave(amplitude);
  constexpr double crest = 20;
  const double excess = wave.excess_up_to(length - crest) - wave.excess_up_to(-crest);
  const dispersive_shallow_water_1d::Channel channel{.bottom = std::make_shared<LevelBottom>(1.0), .period = length};
  const auto markers =
      solitary_markers(channel, 0, length, (length + excess) / cells, {.amplitude = amplitude, .crest = crest});
  Model model(channel, markers);
  State state = model.state_of(markers);
  Start(model).project(state);
  Base<Model> base(model);
  Composition composed(base, stages);
  InvariantsWatch watch(model, state);
  const long steps = std::lround(end_time / tau);
  for (long n = 0; n < steps; ++n) {
    composed.step(state, end_time / static_cast<double>(steps));
    watch.record(state);
  }
  return {{state.q.begin(), state.q.begin() + static_cast<std::ptrdiff_t>(model.size())},
          watch.ledger().largest_defect("energy") / watch.ledger().entry("energy").initial,
          watch.ledger().largest_defect("volume_worst"),
          model.solves()};
}

struct Method {
  std::string id, name;
  Result (*run)(double tau, const std::vector<double>& stages);
  std::vector<double> stages;
  double theory;
  double longest;
};

const std::vector<Method> methods{
    {"one-step", "one-step", run<OneStep>, {1.0}, 2, 0.4},
    {"conservative-suzuki", "conservative, Suzuki", run<ConservativeStep>, suzuki_weights(), 4, 0.8},
    {"triple-jump", "one-step, triple jump", run<OneStep>, triple_jump_weights(), 4, 0.4},
    {"suzuki", "one-step, Suzuki", run<OneStep>, suzuki_weights(), 4, 0.4}};

TEST_CASE("compositions of the dispersive model's steps are fourth-order accurate", "[manufactured]") {
  Check check("dispersive_composition", "Dispersive shallow water: compositions to fourth order in time",
              "Solitary wave of amplitude 0.3 in a periodic level channel of length 60, cells of 0.25, $t = 20$. The "
              "error is the maximum of a node's position against the limit of small steps on the same cells, and "
              "therefore the error in time. Suzuki's composition of the conservative scheme is fourth-order accurate "
              "and conserves energy, momentum and the volume of every cell to round-off.",
              "Yoshida (1990), Suzuki (1990); Hairer, Lubich & Wanner (2006), II.4");
  const std::vector<double> limit = run<OneStep>(0.01, suzuki_weights()).x;
  for (const Method& method : methods) {
    Largest energy, volume, solves;
    refine(check, {"step", falling(method.longest, 4), "order-" + method.id, method.name, 1e-12},
           {{"order-" + method.id,
             fmt::format("The error falls with order {:g} in the step: {}.", method.theory, method.name),
             Order{method.theory, method.theory == 4 ? 0.2 : 0.1,
                   "smooth motion on a level bottom; below 1e-12 the rounding of coordinates up to 60 counts"}}},
           [&](double tau) {
             const Result result = method.run(tau, method.stages);
             energy.add(result.energy);
             volume.add(result.volume);
             solves.add(static_cast<double>(result.solves));
             return largest_difference(Input(result.x), limit);
           });
    if (method.id != "conservative-suzuki") continue;
    check.at("tau = 0.8 .. 0.1");
    check.that("energy", "The energy is conserved by Suzuki's composition of the conservative scheme.",
               "largest relative error", {energy.value()}, Roundoff{solves.value(), 1, "one rounded energy per solve"});
    check.that("volume", "Suzuki's composition of the conservative scheme conserves every cell's volume.",
               "largest relative error", {volume.value() / (length / cells)},
               Roundoff{solves.value(), cells,
                        "one rounded coordinate, up to the channel's length, per solve and width of a cell"});
  }
}

}  // namespace seiche::verification::dispersive_composition_test
