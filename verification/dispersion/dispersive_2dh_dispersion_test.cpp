// Standing waves of the 2DH model against its closed dispersion law: the linearised matrices, and runs.
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "seiche/samples.hpp"
#include "validation/instruments/plan/plan_standing_mode.hpp"
#include "verification/check.hpp"
#include "verification/dispersion/tank_frequencies.hpp"

namespace seiche::verification::dispersive_2dh_dispersion_test {

using validation::PlanMode, validation::PlanTank;

constexpr double pi = std::numbers::pi;

const std::vector<std::pair<std::string, PlanTank>> tanks{
    {"square", {.columns = 12, .rows = 12, .length = 6, .width = 6}},
    {"oblong", {.columns = 20, .rows = 8, .length = 5, .width = 4}},
    {"dimensional", {.columns = 10, .rows = 9, .length = 3, .width = 4, .depth = 0.7, .gravity = 9.81, .inertia = 0.4}},
    {"improved", {.columns = 12, .rows = 9, .length = 5, .width = 4, .inertia = 0.4, .gamma = 1.0 / 15}}};

/// Of the equation for the pressure, 1 - H^2/3 times the differences of the cells.
double condition(const PlanTank& tank) {
  const double h1 = tank.length / static_cast<double>(tank.columns);
  const double h2 = tank.width / static_cast<double>(tank.rows);
  return 1 + tank.inertia * tank.depth * tank.depth * (4 / (h1 * h1) + 4 / (h2 * h2));
}

/// Of the shortest slopes of the surface, over that of its elevation.
double stiffness(const PlanTank& tank) {
  return 1 + tank.gamma / tank.inertia * (condition(tank) - 1);
}

TEST_CASE("the 2DH model's linearised matrices have the eigenvalues of the closed form", "[dispersion]") {
  Check check("dispersion_dispersive_2dh_symbol", "Dispersion of the two-dimensional horizontal model: eigenvalues",
              "Modes of boxes of square and oblong cells, from one half-wave to nearly the shortest: the acceleration "
              "that the linearised forces and constraints give a mode is $-\\omega^2$ times the mode itself, with "
              "$\\omega$ of the closed form. No run, no time step, no amplitude.");
  for (const auto& [id, tank] : tanks) {
    Worst worst;
    Largest rest, kick;  // kick: of gravity on the surface, over omega^2
    for (const HalfWaves& half_waves : tank_modes) {
      const PlanMode mode(tank, half_waves.x, half_waves.y);
      const auto found = mode.eigenvalue();
      kick.add(tank.gravity * stiffness(tank) / (tank.inertia * tank.depth * std::pow(mode.linear_frequency(), 2)));
      worst.add(found.square / std::pow(mode.linear_frequency(), 2) - 1);
      rest.add(found.rest);
    }
    check.holds("eigenvalues-" + id + ": Eigenvalues of " + tank.text() + " agree with the closed form.",
                {worst.value()},
                Roundoff{30, condition(tank),
                         "some thirty roundings of a row of a direct solution, amplified by the condition of the "
                         "equation for the pressure"});
    const auto cells = static_cast<double>(tank.columns * tank.rows);
    check.holds("Modes of " + tank.text() + " are eigenvectors.", {rest.value()},
                Roundoff{30, kick.value() * (1 + condition(tank) / std::sqrt(cells)),
                         "some thirty roundings of a row of a direct solution, in the units of gravity's kick, which "
                         "the pressure nearly balances in long waves; their smooth part, the mean over the cells, is "
                         "amplified by the condition"});
  }
}

TEST_CASE("standing waves in 2DH have the frequencies of the closed form", "[dispersion]") {
  Check check("dispersion_dispersive_2dh", "Dispersion of the two-dimensional horizontal model: runs",
              "Standing waves of some 1e-9 of the depth in boxes of square and of oblong cells, from one half-wave to "
              "nearly the shortest. The one-step scheme is linear for them: $\\omega$ follows from three successive "
              "amplitudes, by least squares over the run, free of its time step.");
  auto& figure = check.figure("frequencies", "Frequencies of three boxes of cells in 2DH",
                              "Lines: closed form along the x axis. Points: runs, at any angle, divided by the closed "
                              "form of their wavenumber and multiplied by the value along the axis.");
  auto& panel = figure.panel({.x = "k H", .y = "omega sqrt(H/g)"});
  constexpr double phase = 0.2;  // omega tau
  constexpr int steps = 200;
  for (const auto& [id, tank_] : tanks) {
    const PlanTank& tank = tank_;
    Largest third_order;
    const auto run = [&](HalfWaves half_waves) {
      const PlanMode mode(tank, half_waves.x, half_waves.y);
      const double expected = mode.linear_frequency();
      const double amplitude = 1e-9 * std::sqrt(tank.gravity * tank.depth);
      const double k = std::hypot(mode.kx(), mode.ky());
      third_order.add(std::pow(amplitude / expected, 2) * (1 / (tank.depth * tank.depth) + k * k));
      return std::pair{expected, mode.measured_frequency(phase / expected, steps, amplitude)};
    };
    const double error = draw_runs(
        panel, tank.text(), tank, [&](double k) { return tank.frequency(k, 0); }, run);
    check.holds(
        "frequencies-" + id + ": Frequencies of " + tank.text() + " agree with the closed form.", {error},
        Bound{third_order.value() + 1e-13 +
                  4 * std::numeric_limits<double>::epsilon() * std::sqrt(100 + 6 / (4 * std::pow(phase, 4) * steps)),
              "waves of finite height: the squares of the elevation in depths and of the steepness; the pressure is "
              "solved to the part 1e-13 of itself; second differences divide the rounding of amplitudes by (omega "
              "tau)^2, the mean over n steps that by sqrt(n); a hundred roundings of the rest"});
  }
}

}  // namespace seiche::verification::dispersive_2dh_dispersion_test
