// The longest stable step of the one-step scheme on the two-dimensional Lagrangian mesh.
#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "seiche/mechanics/one_step.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/lagrangian_mesh_2d/model.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mesh/mesh_linear_modes.hpp"
#include "verification/check.hpp"

namespace seiche::verification::lagrangian_mesh_stability_test {

using namespace lagrangian_mesh_2d;
using mechanics::State, validation::LinearModes;

struct Tank {
  std::string text;
  double length;
  std::size_t columns, rows;
  Settings settings = {};

  [[nodiscard]] Model model() const {
    return Model(layer_mesh({.end = length, .columns = columns, .rows = rows}), settings);
  }
};

LinearModes modes_of(const Tank& tank) {
  Model model = tank.model();
  return validation::linear_modes(model, 1.0 / 64);
}

/// Largest share of the fastest mode in the displacements over the initial one, released with an amplitude of 1e-8.
/// What the mode does to the motions without force is of second order in the amplitude.
double growth(const Tank& tank, const LinearModes& modes, double share_of_limit, int steps) {
  Model model = tank.model();
  const State rest = model.state();
  const double amplitude = 1e-8;
  const auto mode = modes.rates.rightCols<1>();
  State state = rest;
  for (std::size_t i = 0; i < state.q.size(); ++i) state.q[i] += amplitude * mode[static_cast<Eigen::Index>(i)];
  const std::size_t n = model.nodes().size();
  const auto share = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < 2 * n; ++i) {
      const double inertia = (i < n ? model.nodes().mass() : model.nodes().inertia_y())[i % n];
      sum += inertia * mode[static_cast<Eigen::Index>(i)] * (state.q[i] - rest.q[i]);
    }
    return std::abs(sum) / amplitude;
  };
  mechanics::OneStep<Model> scheme(model);
  Largest largest;
  for (int step = 0; step < steps && !(largest.value() >= 1e3); ++step) {
    scheme.step(state, share_of_limit * 2 / modes.frequencies.back());
    largest.add(share());
  }
  return largest.value();
}

const std::vector<Tank> tanks{{"6 x 2 cells", 6, 6, 2},
                              {"8 x 3 cells", 4, 8, 3},
                              {"16 x 4 cells", 6, 16, 4},
                              {"tuned surface inertia", 6, 16, 4, {.tuned_surface_inertia = true}},
                              {"weak hourglass potential", 6, 16, 4, {.hourglass = 0.1}},
                              {"strong hourglass potential", 6, 16, 4, {.hourglass = 0.6}}};

TEST_CASE("the one-step scheme on the Lagrangian mesh is stable up to 2/omega of the fastest mode", "[dispersion]") {
  Check check("lagrangian_mesh_stability", "Longest stable step of the Lagrangian mesh",
              "The fastest mode of the linearised mesh is released with an amplitude of 1e-8. The scheme gives a mode "
              "of frequency $\\Omega$ the frequency $\\omega$ with $\\sin(\\omega\\tau/2) = \\Omega\\tau/2$: bounded 2 "
              "% below $\\tau = 2/\\Omega$, exploding 2 % above. The limit that a flow reports is the closed law's: "
              "the true one, or below it where the fastest wave does not fit the tank or potentials add.");
  for (const Tank& tank : std::span(tanks).first(3)) {
    const LinearModes found = modes_of(tank);
    check.holds(tank.text + ": bounded at 0.98 of the limit.", {growth(tank, found, 0.98, 10000)},
                Bound{1.01,
                      "a mode released from rest oscillates between its ends; squares of the amplitude and rounding "
                      "add up to a thousandth of it"});
    check.holds(
        tank.text + ": explodes at 1.02 of it.", {growth(tank, found, 1.02, 100) >= 1e3 ? 1.0 : 0.0},
        Qualitative{"share of the mode >= 1000 times the initial", "it grows by cosh(100 * 2 arcosh 1.02) = 1e17"});
  }
  for (const Tank& tank : tanks) {
    const double limit = 2 / modes_of(tank).frequencies.back();
    const double reported = longest_stable_step(tank.model());
    check.holds(tank.text + ": the reported limit is safe.", {std::max(reported / limit - 1, 0.0)},
                Bound{1e-6, "the search for the fastest wave's length"});
  }
}

}  // namespace seiche::verification::lagrangian_mesh_stability_test
