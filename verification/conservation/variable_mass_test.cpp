// Particles of variable mass: neutral exchanges, rest under a moving mesh, and what is kept to second
// order.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "seiche/free_lagrangian/mesh.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/jittered_mesh.hpp"
#include "verification/noise.hpp"

namespace variable_mass_test {

using namespace seiche;
using namespace seiche::free_lagrangian;
using namespace seiche::variable_mass;
using namespace seiche::verification;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 5.3";

/// Water in a box that sloshes by its first velocity.
Flow sloshing(Control control, double stabilisation) {
  const auto velocity = [](Point r) {
    const double k = std::numbers::pi / 3;
    return Point{0.05 * std::sin(k * r.x) * std::cosh(k * (r.y + 1)),
                 -0.05 * std::cos(k * r.x) * std::sinh(k * (r.y + 1))};
  };
  return Flow(layer_mesh({.begin = 0, .end = 3, .columns = 12, .rows = 4}), {.velocity = velocity}, control,
              {.stabilisation = stabilisation});
}

Worst change_of_masses(const Flow& flow, const std::vector<double>& first) {
  Worst change;
  for (std::size_t k = 0; k < first.size(); ++k) change.add(flow.masses()[k] / first[k] - 1);
  return change;
}

std::vector<double> copied(std::span<const double> values) {
  return {values.begin(), values.end()};
}

TEST_CASE("masses exchanged between moving bodies leave mass, momentum and kinetic energy alone", "[conservation]") {
  Check check(
      "variable_mass_exchanges", "Finite exchanges of mass are neutral",
      "64 bodies of masses between 1 and 3 and random velocities hand one another masses, up to a tenth of their "
      "own, in a thousand rounds of 100 exchanges. Velocities change by the convective term alone.");
  Noise noise(7);
  constexpr std::size_t n = 64;
  constexpr int rounds = 1000;
  std::vector<double> mass;
  std::vector<double> u;
  for (std::size_t k = 0; k < n; ++k) mass.push_back(2 + noise());
  for (std::size_t k = 0; k < 2 * n; ++k) u.push_back(noise());
  const std::vector<double> zeros(n, 0.0);
  const auto sums = [&] {
    std::array<CompensatedSum, 4> all;
    for (std::size_t k = 0; k < n; ++k) {
      all[0].add(mass[k]);
      all[1].add(mass[k] * u[k]);
      all[2].add(mass[k] * u[n + k]);
      all[3].add(mass[k] * (u[k] * u[k] + u[n + k] * u[n + k]) / 2);
    }
    return std::array{all[0].value(), all[1].value(), all[2].value(), all[3].value()};
  };
  const auto first = sums();
  Convection convection;
  std::vector<double> mean = u;
  std::vector<double> next;
  Worst handed_on;
  for (int round = 0; round < rounds; ++round) {
    std::vector<Exchange> exchanges;
    for (int e = 0; e < 100; ++e) {
      const auto i = static_cast<int>(n * 0.5 * (noise() + 1)) % static_cast<int>(n);
      const auto j = static_cast<int>(n * 0.5 * (noise() + 1)) % static_cast<int>(n);
      const double least = std::min(mass[static_cast<std::size_t>(i)], mass[static_cast<std::size_t>(j)]);
      if (i != j) exchanges.push_back({i, j, 0.1 * least * noise()});
    }
    convection.begin(mass, exchanges, {zeros, zeros});
    const auto respond = [&](std::span<double> momenta) {
      for (std::size_t i = 0; i < 2 * n; ++i) momenta[i] /= convection.mean_masses()[i % n];
    };
    convection.settle(u, respond, 0, mean);
    convection.finish(u, mean, next);
    for (std::size_t k = 0; k < n; ++k) handed_on.add(convection.next_masses()[k] / mass[k] - 1);
    u = next;
    mass = copied(convection.next_masses());
  }
  const auto last = sums();
  const auto keeps = [&](const std::string& id, const std::string& text, double defect, double scale) {
    check.holds(id + ": " + text, {defect},
                Roundoff{rounds * 264.0, scale,
                         "each round rounds 64 bodies and 200 sides of exchanges, of this size at most: "
                         "masses to 10, momenta to 10, energies to 5"});
  };
  keeps("mass", "Mass is conserved by the exchanges to round-off.", last[0] - first[0], 10);
  keeps("momentum-x", "Momentum along x is conserved by the exchanges to round-off.", last[1] - first[1], 10);
  keeps("momentum-y", "Momentum along y is conserved by the exchanges to round-off.", last[2] - first[2], 10);
  keeps("energy", "Kinetic energy is conserved by the exchanges to round-off.", last[3] - first[3], 5);
  check.that({.id = "finite",
              .text = "The largest change of a mass in a round exceeds a tenth.",
              .quantity = "largest change of a mass in a round, relative",
              .source = source},
             {.value = std::abs(handed_on.value()) > 0.1 ? 1.0 : 0.0},
             Qualitative{"more than a tenth", "neutrality to first order in small exchanges would not be enough"});
}

TEST_CASE("water at rest stays at rest while its nodes move", "[conservation]") {
  Check check(
      "variable_mass_rest", "Still water on meshes of variable mass",
      "Jittered meshes over a flat bottom, 3 long, and over a step, whose nodes inside are drawn to the centroids "
      "of their cells; and regular ones under mapped and fixed_x. 200 steps of 0.05, stabilisation 0.1. With the "
      "surface at y = 0 the gradient of the potential energy of the polygon of water is zero; at y = 1 gravity "
      "and pressure balance to rounding, whatever mass is handed on.");
  struct Still {
    std::string id;
    Mesh mesh;
    Control control;
    double level;
  };
  std::vector<Still> all;
  for (const double level : {0.0, 1.0}) {
    const std::string at = level == 0 ? "0" : "1";
    const Mesh flat = layer_mesh({.begin = 0, .end = 3, .bottom = level - 1, .level = level, .columns = 24, .rows = 8});
    const Mesh stepped = stepped_channel_mesh(
        {.begin = 0, .step = 2, .end = 4, .bottom = level - 1, .shelf = level - 0.5, .level = level, .rows = 8});
    all.push_back({"flat-centroid-" + at, jittered(flat, 0.2, 1), {ControlKind::centroid, 1, 0.5}, level});
    all.push_back({"step-centroid-" + at, jittered(stepped, 0.2, 2), {ControlKind::centroid, 1, 0.5}, level});
    all.push_back({"step-mapped-" + at, jittered(stepped, 0.2, 3), {ControlKind::mapped, 1, 0.5}, level});
    all.push_back({"step-fixed-" + at, stepped, {ControlKind::fixed_x, 1, 1}, level});
  }
  for (const auto& [id, mesh, control, level] : all) {
    Flow flow(mesh, {}, control, {.stabilisation = 0.1});
    const std::vector<double> masses = copied(flow.masses());
    Worst speed;
    for (int k = 0; k < 200; ++k) {
      flow.advance(0.05);
      for (const double u : flow.state().u) speed.add(u, flow.time());
    }
    const double change = std::abs(change_of_masses(flow, masses).value());
    if (control.kind == ControlKind::centroid) {
      check.holds(id + "-moves: Nodes move through the water.", {change > 0.1 ? 1.0 : 0.0},
                  Qualitative{"more than a tenth", "otherwise nothing is shown of exchanges"});
    }
    const evidence::Claim claim{.id = id,
                                .text = "The velocity of the water at rest stays zero.",
                                .quantity = "largest velocity of the water",
                                .source = source};
    if (level == 0) {
      check.that(claim, {.value = speed.value()}, Bound{0, "every force is exactly zero"});
    } else {
      check.that(claim, {.value = speed.value()},
                 Roundoff{200 * 20, 0.4,
                          "200 kicks of tau times the acceleration g/h = 8, that of the pressure and of "
                          "gravity, sums of some twenty terms"});
    }
  }
}

TEST_CASE("energy under gravity and the drift of areas are of second order in the step", "[conservation]") {
  Check check(
      "variable_mass_drift", "What variable masses keep to second order only",
      "Water in a box that sloshes under gravity until t = 1, 12 x 4 cells, stabilisation 0.01: kinetic and "
      "potential energy with what the stabilisation took, and the largest A_i - m_i/rho without it. Steps halved "
      "four times, for nodes mapped with the surface and for nodes at fixed x.");
  const Order second{2, 0.2, "the geometry of a step is that of its middle: second order"};
  for (const auto& [id, control] : {std::pair{std::string("mapped"), Control{ControlKind::mapped, 1, 1}},
                                    {std::string("fixed-x"), Control{ControlKind::fixed_x, 1, 1}}}) {
    std::vector<double> steps;
    std::vector<double> energies;
    std::vector<double> drifts;
    for (const int n : {10, 20, 40, 80, 160}) {
      steps.push_back(1.0 / n);
      Flow flow = sloshing(control, 0.01);
      const double energy = flow.energy();
      flow.advance_to(1, 1.0 / n);
      energies.push_back(std::abs(flow.energy() + flow.stabilisation_loss() - energy));
      Flow plain = sloshing(control, 0);
      plain.advance_to(1, 1.0 / n);
      drifts.push_back(plain.largest_drift());
    }
    check.that({.id = id + "-energy",
                .text = "Energy under gravity, with what was booked: order 2.",
                .quantity = "order of the energy's defect",
                .source = source},
               observed_order(steps, energies), second);
    check.that({.id = id + "-areas",
                .text = "Areas of the masses: order 2.",
                .quantity = "order of the largest A_i - m_i/rho",
                .source = source},
               observed_order(steps, drifts), second);
  }
}

}  // namespace variable_mass_test
