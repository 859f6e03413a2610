// Pressures that are solved loosely, as iterative solvers leave them: what still holds exactly on a Lagrangian mesh.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include "seiche/compensated_sum.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"

namespace seiche::verification::lagrangian_mesh_loose_multipliers_test {

using namespace lagrangian_mesh_2d;
using namespace mechanics;

/// Every multiplier is wrong by a random fraction between -e and e.
class LooseModel : public Model {
 public:
  LooseModel(Model model, double e) : Model(std::move(model)), fraction_(e) {}

  void solve(Input right_hand_side, Output mu) {
    Model::solve(right_hand_side, mu);
    for (double& impulse : mu) impulse *= 1 + fraction_ * uniform_(random_);
  }

 private:
  double fraction_;
  std::minstd_rand random_{1};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

struct Defects {
  double energy = 0;
  double unexplained = 0;  ///< after the multipliers' work on the residual is booked
  double momentum = 0;     ///< angular momentum included
  double kinetic = 0;      ///< energy of the beginning
};

constexpr int steps = 1000;
constexpr double tau = 1e-3;

template <class Some>
Defects defects(Some& model, State state) {
  OneStep<Some> scheme(model);
  InvariantsWatch watch(model, state);
  const auto energy = [&] { return model.kinetic_energy(state.q, state.u); };
  const double first = energy();
  CompensatedSum work;
  Defects result{.kinetic = first};
  Worst unexplained;
  std::vector<double> residual(model.constraints());
  for (int n = 0; n < steps; ++n) {
    std::vector<double> mean = state.u;
    scheme.step(state, tau);
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5 * (mean[i] + state.u[i]);
    model.constraint_rates(mean, residual);
    for (std::size_t s = 0; s < model.constraints(); ++s) work.add(tau * state.multipliers[s] * residual[s]);
    watch.record(state);
    unexplained.add(energy() - first - work.value());
  }
  result.energy = watch.ledger().largest_defect("energy");
  result.unexplained = unexplained.value();
  result.momentum =
      worst(std::array{watch.ledger().largest_defect("momentum"), watch.ledger().largest_defect("angular_momentum")});
  return result;
}

TEST_CASE("loosely solved pressures: momenta of a free patch exact, energy changed by their work", "[conservation]") {
  Check check("lagrangian_mesh_loose_multipliers", "Loosely solved pressures on a Lagrangian mesh",
              "The pressure of a cell pushes its corners with forces that cancel in sum and moment, whatever it is: "
              "momenta of a free patch are exact for any error of the solver. The energy of a step changes by "
              "$\\tau\\lambda\\cdot(J\\tilde u)$, the pressures' work on what is left of the areas' rates. A patch "
              "with multipliers wrong by random fractions, and a layer without gravity whose multipliers conjugate "
              "gradients find to a tolerance.");
  evidence::Table table{
      .id = "loose",
      .title = "1000 steps of 1e-3",
      .caption = "Largest defects.",
      .columns = {{"water", ""}, {"error", "1"}, {"energy", "1"}, {"energy less work", "1"}, {"momenta", "1"}}};
  const auto rounding = [](double sum) { return Roundoff{steps, sum, "one rounding of the sum per step"}; };
  const auto explains = [&](const std::string& id, const Defects& d) {
    check.holds(id + ": Nothing else changes the energy.", {d.unexplained}, rounding(d.kinetic));
  };
  for (const double e : {1e-10, 1e-6, 1e-2}) {
    MeshProblem problem = moving_patch();
    LooseModel model(std::move(problem.model), e);
    const Defects d = defects(model, problem.start);
    table.rows.push_back({std::string("patch, random"), e, d.energy, d.unexplained, d.momentum});
    const std::string id = "patch-" + std::to_string(static_cast<int>(-std::log10(e)));
    explains(id + "-energy", d);
    check.holds(id + "-momentum: Momenta of the patch are exact for any multipliers.", {d.momentum}, rounding(1.5));
  }
  for (const double tolerance : {1e-13, 1e-10, 1e-6}) {
    const Settings settings{.gravity = 0, .solver = linear::SolverMethod::iterative, .tolerance = tolerance};
    const auto velocity = [](Point r) { return Point{0.3 * std::sin(std::numbers::pi * r.x / 3), 0.1 * r.y}; };
    MeshProblem problem(layer_mesh({.begin = 0, .end = 6, .columns = 16, .rows = 4, .elevation = cosine_elevation}),
                        velocity, settings);
    const Defects d = defects(problem.model, problem.start);
    table.rows.push_back({std::string("layer, conjugate gradients"), tolerance, d.energy, d.unexplained,
                          std::string("not kept: walls")});
    explains("layer-" + std::to_string(static_cast<int>(-std::log10(tolerance))) + "-energy", d);
  }
  check.table(table);
}

}  // namespace seiche::verification::lagrangian_mesh_loose_multipliers_test
