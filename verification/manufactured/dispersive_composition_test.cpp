// Compositions of the dispersive shallow-water model's steps: fourth order in time, with the invariants of the base.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "seiche/exact/solitary_asymptotic.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/models/dispersive_shallow_water_1d/integrators.hpp"
#include "seiche/models/dispersive_shallow_water_1d/model.hpp"
#include "seiche/samples.hpp"
#include "validation/case/reference_table.hpp"
#include "verification/check.hpp"

namespace seiche::verification::dispersive_composition_test {

using namespace mechanics;
using Model = dispersive_shallow_water_1d::Model;

const std::string source = "Yoshida (1990), Suzuki (1990); Hairer, Lubich & Wanner (2006), II.4";
const std::string digits = "regression: computed once by an earlier program for the same equations";
constexpr double amplitude = 0.3;
constexpr double length = 60;
constexpr double end_time = 20;
constexpr std::size_t cells = 240;

/// Solitary wave in a periodic level channel, cells of equal volume.
dispersive_shallow_water_1d::Markers solitary_wave(const dispersive_shallow_water_1d::Channel& channel) {
  const exact::SerreSolitary wave(amplitude);
  constexpr double crest = 20;
  const double excess = wave.excess_up_to(length - crest) - wave.excess_up_to(-crest);
  return solitary_markers(channel, 0, length, (length + excess) / cells, {.amplitude = amplitude, .crest = crest});
}

struct Result {
  std::vector<double> x;
  double energy = 0;  ///< largest defect, relative to the wave's
  double volume = 0;  ///< largest defect of a cell [depth^2]
  long solves = 0;
};

template <template <class> class Base>
Result run(double tau, const std::vector<double>& stages) {
  const dispersive_shallow_water_1d::Channel channel{.bottom = std::make_shared<LevelBottom>(1.0), .period = length};
  const auto markers = solitary_wave(channel);
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
  std::vector<double> tau;
  double known;  ///< its code in the table of known errors; 0 where none are known
};

std::vector<Method> methods() {
  const std::vector<double> small = {0.4, 0.2, 0.1, 0.05};
  const std::vector<double> large = {0.8, 0.4, 0.2, 0.1};
  const auto single = Stages::single;
  return {
      {"one-step", "one-step", run<OneStep>, {1.0}, 2, small, 1},
      {"triple-jump", "one-step, triple jump", run<OneStep>, triple_jump_weights(single), 4, large, 2},
      {"suzuki", "one-step, Suzuki", run<OneStep>, suzuki_weights(single), 4, large, 3},
      {"conservative-suzuki", "conservative, Suzuki", run<ConservativeStep>, suzuki_weights(single), 4, large, 4},
      {"triple-jump-paired", "one-step, triple jump of pairs", run<OneStep>, triple_jump_weights(), 4, small, 0},
      {"suzuki-paired", "one-step, Suzuki of pairs", run<OneStep>, suzuki_weights(), 4, small, 0},
  };
}

/// Last digit of a value given with two.
double half_unit(double value) {
  return 0.5 * std::pow(10, std::floor(std::log10(value)) - 1);
}

TEST_CASE("compositions of the dispersive model's steps are of fourth order", "[manufactured]") {
  Check check("dispersive_composition", "Dispersive shallow water: compositions to fourth order in time",
              "Solitary wave of amplitude 0.3 in a periodic level channel of length 60, cells of 0.25, $t = 20$. The "
              "error is the largest of a marker's place against the limit of small steps on the same cells, so that it "
              "is all of time. Suzuki's composition of the conservative scheme is of fourth order and keeps energy, "
              "momentum and the volume of every cell to round-off.",
              source);
  auto& panel = check.figure("orders", "Orders in time", "Largest error of a marker against the step.")
                    .panel({.x = "tau", .y = "error", .log_x = true, .log_y = true});
  const std::vector<double> limit = run<OneStep>(0.01, suzuki_weights()).x;
  const auto known = validation::reference_table("regression_dispersive_composition", check.record().reference_data);
  for (const Method& method : methods()) {
    std::vector<double> error;
    Largest energy, volume, solves;
    for (const double tau : method.tau) {
      const Result result = method.run(tau, method.stages);
      Worst farthest;
      for (std::size_t i = 0; i < limit.size(); ++i) farthest.add(result.x[i] - limit[i]);
      error.push_back(farthest.value());
      energy.add(result.energy);
      volume.add(result.volume);
      solves.add(static_cast<double>(result.solves));
    }
    panel.line(method.name, method.tau, error, evidence::Role::computed);
    check.that("order-" + method.id,
               std::string("The error falls with order ") + (method.theory == 4 ? "4" : "2") +
                   " in the step: " + method.name + ".",
               "observed order of the largest error of a marker", observed_order(method.tau, error, 1e-12),
               Order{method.theory, method.theory == 4 ? 0.2 : 0.1,
                     "smooth motion on a level bottom; below 1e-12 the rounding of coordinates up to 60 counts"});
    if (method.known != 0) {
      Worst deviation;
      for (std::size_t row = 0; row < known.rows(); ++row) {
        if (known.column("method")[row] != method.known) continue;
        const auto k = static_cast<std::size_t>(
            std::find(method.tau.begin(), method.tau.end(), known.column("tau")[row]) - method.tau.begin());
        const double expected = known.column("error")[row];
        deviation.add((error.at(k) - expected) / half_unit(expected));
      }
      check.holds("digits-" + method.id + ": " + method.name + ": errors of an earlier program.", {deviation.value()},
                  Bound{1, "two digits are given"});
    }
    if (method.id != "conservative-suzuki") continue;
    check.from(digits + ": 6e-15")
        .that("energy", "Suzuki's composition of the conservative scheme keeps the energy.", "largest relative defect",
              {.value = energy.value(), .resolution = "tau = 0.8 .. 0.1"},
              Roundoff{solves.value(), 1, "one rounded energy per solve"});
    check.from(digits + ": 8e-13")
        .that("volume", "Suzuki's composition of the conservative scheme conserves every cell's volume.",
              "largest relative defect", {.value = volume.value() / (length / cells), .resolution = "tau = 0.8 .. 0.1"},
              Roundoff{solves.value(), cells,
                       "one rounded coordinate, up to the channel's length, per solve and width of a cell"});
  }
}

}  // namespace seiche::verification::dispersive_composition_test
