// What the one-step scheme does not keep errs by the square of the step: one table for all models.
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/models/overlapping_particles/flow.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "verification/check.hpp"
#include "verification/conservation/dispersive_2dh_problems.hpp"
#include "verification/conservation/lagrangian_mesh_3d_problems.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"
#include "verification/jittered_mesh.hpp"
#include "verification/noise.hpp"

namespace seiche::verification::conserved_to_second_order_test {

using namespace mechanics;

/// Names of what errs, and the errors with a step.
using Names = std::vector<std::string>;
using Errors = std::vector<double>;

struct Row {
  std::string flow;
  Names what;
  std::vector<double> taus;
  std::function<Errors(double tau)> errors;
  Order order{2, 0.3, "a symmetric second-order scheme; the maximum over time is not a smooth function of the step"};
};

/// Orders of every row, and a figure.
void judge(Check& check, const std::vector<Row>& rows) {
  auto& panel =
      check.figure("orders", "What errs by the square of the step", "Largest conservation error against the step.")
          .panel({.x = "tau", .y = "defect", .log_x = true, .log_y = true});
  for (const Row& row : rows) {
    std::vector<Errors> all(row.what.size());
    for (const double tau : row.taus) {
      const Errors errors = row.errors(tau);
      for (std::size_t i = 0; i < all.size(); ++i) all[i].push_back(errors[i]);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::string what = row.flow + ", " + row.what[i];
      check.holds(what + ": the largest conservation error is second-order in the step.",
                  observed_order(row.taus, all[i]), row.order);
      panel.line(what, row.taus, all[i]);
    }
  }
}

/// Largest defects of energy and of a cell, relative to the energy at the beginning and to a mean cell.
Errors defects(auto&& problem, double tau, double time, double energy) {
  const auto ledger = watched_run(problem, {}, tau, std::lround(time / tau));
  return {ledger.largest_defect("energy") / energy, ledger.largest_defect("volume_worst") / problem.cell()};
}

/// Water in a box that sloshes by its first velocity.
Point sloshing_velocity(Point r) {
  const double k = std::numbers::pi / 3;
  return {0.05 * std::sin(k * r.x) * std::cosh(k * (r.y + 1)), -0.05 * std::cos(k * r.x) * std::sinh(k * (r.y + 1))};
}

/// Energy with what stabilisation took until t = 1.
double energy_defect(auto flow, double tau) {
  const double energy = flow.energy();
  march(flow, 1, tau);
  return std::abs(flow.energy() + flow.stabilisation_loss() - energy);
}

TEST_CASE("conservation errors of the one-step scheme are second-order in the step", "[conservation]") {
  Check check(
      "second_order_defects", "Quantities that the one-step scheme conserves to second order only",
      "Potentials that are not linear and volumes that are not quadratic are conserved to $O(\\tau^2)$ by the one-step "
      "scheme. On meshes, water that sloshes in basins of all kinds until t = 8, a hump of hexahedra in a box until t "
      "= 20 and over an uneven bottom until t = 6: energy, volumes, and the distance of nodes from the bottom. "
      "Particles: cells of a free rectangle of Dirichlet cells and control volumes of a free blob of overlapping "
      "particles until t = 0.2; water that sloshes in a box until t = 1, including the energy removed by the "
      "stabilisation, of Dirichlet cells and of variable masses, nodes mapped with the surface or at fixed x, and the "
      "difference between areas and masses of the latter. With the hourglass potential, which prevents tangling of the "
      "mesh, the errors up to t = 400 do not exceed the errors of the first few periods.");
  std::vector<Row> rows;
  for (const auto& [basin, make] : basins()) {
    rows.push_back({"Lagrangian mesh, " + basin,
                    {"energy", "areas"},
                    {0.1, 0.05, 0.025, 0.0125},
                    [make = make](double tau) { return defects(make(), tau, 8, wave_energy); },
                    {2, 0.01,
                     "a symmetric scheme errs in even powers of the step: the next term is (2 omega tau)^2 = 0.01 of "
                     "the first at the largest step, squares of a wave of omega = 0.5 oscillating twice as fast"}});
  }
  const auto in_box = [](double tau) {
    HexahedralProblem hump(hump_in_box(), {}, {.tolerance = 1e-10});
    return defects(hump, tau, 20, hump.model.potential_energy(hump.start.q));
  };
  rows.push_back({"Hexahedra in a box", {"energy", "volumes"}, {0.4, 0.2, 0.1, 0.05}, in_box});
  const auto over_bottom = [](double tau) {
    HexahedralProblem hump(hump_over_bottom(), {}, {.tolerance = 1e-15});
    OffTheBottom off(hump);
    const auto ledger = watched_run(hump, {}, tau, std::lround(6 / tau), off);
    return Errors{ledger.largest_defect("energy") / ledger.entry("energy").initial,
                  ledger.largest_defect("volume_worst") / hump.cell(), off.bottom.value()};
  };
  const Names with_bottom{"energy", "volumes", "distance of nodes from the bottom"};
  rows.push_back({"Hexahedra over an uneven bottom", with_bottom, {0.2, 0.1, 0.05, 0.025}, over_bottom});
  const Order second{2, 0.2, "second order of the one-step scheme: the geometry of a step is taken at its middle"};
  const std::vector<double> tenths{0.1, 0.05, 0.025, 0.0125, 0.00625}, fiftieths{0.02, 0.01, 0.005, 0.0025, 0.00125};
  const auto box = free_lagrangian::layer_mesh({.end = 3, .columns = 12, .rows = 4});
  const auto free_cells = [](double tau) {
    dirichlet_mesh::Flow patch(jittered(free_lagrangian::free_patch(16, 8, {-1, -0.5}, {1, 0.5}), 0.2, 1), stirring,
                               {.gravity = 0, .stabilisation = 0});
    march(patch, 0.2, tau);
    return Errors{patch.largest_drift()};
  };
  const auto cells = [&](double tau) {
    return Errors{energy_defect(dirichlet_mesh::Flow(box, sloshing_velocity, {.stabilisation = 0.01}), tau)};
  };
  rows.push_back({"Dirichlet cells", {"areas"}, fiftieths, free_cells, second});
  rows.push_back({"Dirichlet cells under gravity", {"energy"}, tenths, cells, second});
  using variable_mass::ControlKind;
  for (const auto& [name, kind] : {std::pair{"mapped", ControlKind::mapped}, {"at fixed x", ControlKind::fixed_x}}) {
    const auto masses = [&box, kind = kind](double tau) {
      const auto flow_of = [&](double stabilisation) {
        return variable_mass::Flow(box, {.velocity = sloshing_velocity}, {kind, 1, 1},
                                   {.stabilisation = stabilisation});
      };
      variable_mass::Flow plain = flow_of(0);
      march(plain, 1, tau);
      return Errors{energy_defect(flow_of(0.01), tau), plain.largest_drift()};
    };
    rows.push_back(
        {std::string("Variable masses, nodes ") + name, {"energy", "areas of the masses"}, tenths, masses, second});
  }
  const auto overlaps = [](double tau) {
    overlapping_particles::Flow flow(shaken(overlapping_particles::staggered_disc(1, 0.125), 0.0125, 1), stirring);
    march(flow, 0.2, tau);
    flow.observe();
    return Errors{flow.ledger().largest_defect("volume_worst")};
  };
  const std::vector<double> hundredths{0.04, 0.02, 0.01, 0.005, 0.0025};
  rows.push_back({"Overlapping particles", {"masses in control volumes"}, hundredths, overlaps, second});
  judge(check, rows);
  const auto held = basins().back().second;
  const Errors early = defects(held(), 0.05, 40, wave_energy), late = defects(held(), 0.05, 400, wave_energy);
  for (const std::size_t i : {0U, 1U}) {
    check.holds(std::string(i == 0 ? "Energy" : "Areas") + " do not drift over ten times the time.",
                {late[i] / early[i]},
                Bound{1.25,
                      "a drift would multiply the error by 10, a random walk by 3; more crests raise the maximum by a "
                      "few per cent"});
  }
}

TEST_CASE("energy and volumes of the one-step scheme in 2DH err by the square of the step", "[conservation][full]") {
  Check check("dispersive_2dh_energy_order", "Two-dimensional horizontal model: energy of the one-step scheme",
              "A hump of 0.3 in a box until t = 200 over a level bottom, and a hump of 0.15 beside a bump until t = "
              "30. The energy errs by a bounded amount that shrinks with $\\tau^2$, and does not drift; so do the "
              "volumes of the cells. Over the bump this holds because velocities are carried along with the bottom's "
              "tangent plane to second order.");
  const auto row = [&](const std::string& flow, const dispersive_shallow_water_2d::Lattice& lattice, double time,
                       const std::vector<double>& taus) {
    return Row{flow, {"energy", "volumes"}, taus, [=, &check](double tau) {
                 PlanProblem problem(lattice, {}, {.tolerance = 1e-10});
                 const double energy = problem.model.potential_energy(problem.start.q);
                 const Errors found = defects(problem, tau, time, energy);
                 if (tau == taus.back()) {
                   check.holds(flow + ": the energy has no drift.",
                               {found[0] / defects(problem, tau, time / 2, energy)[0]},
                               Bound{0.5, "a drift would double it", 1});
                 }
                 return found;
               }};
  };
  judge(check, {row("Level bottom", plan_hump_in_box(), 200, {0.4, 0.2, 0.1, 0.05}),
                row("Bump", hump_over_bump(), 30, {0.2, 0.1, 0.05, 0.025})});
}

}  // namespace seiche::verification::conserved_to_second_order_test
