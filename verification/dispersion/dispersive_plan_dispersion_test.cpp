// Standing waves of the plan model against its closed dispersion law: the linearised matrices, and runs.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/instruments/plan_standing_mode.hpp"
#include "verification/check.hpp"

namespace {

using namespace seiche;
using validation::PlanMode;
using validation::PlanTank;
using verification::Role;

constexpr double pi = std::numbers::pi;
const std::string source = "Frank, Discrete models of incompressible fluid (1994), formula 13 and section 4.2";

struct HalfWaves {
  std::size_t x, y;
};
constexpr std::array<HalfWaves, 6> modes{HalfWaves{1, 0}, HalfWaves{2, 1}, HalfWaves{3, 3},
                                         HalfWaves{0, 5}, HalfWaves{7, 6}, HalfWaves{9, 7}};

struct NamedTank {
  std::string id;
  PlanTank tank;
};

std::vector<NamedTank> tanks() {
  return {{"square", {.columns = 12, .rows = 12, .length = 6, .width = 6}},
          {"oblong", {.columns = 20, .rows = 8, .length = 5, .width = 4}},
          {"dimensional",
           {.columns = 10, .rows = 9, .length = 3, .width = 4, .depth = 0.7, .gravity = 9.81, .inertia = 0.4}}};
}

}  // namespace

TEST_CASE("the plan model's linearised matrices have the eigenvalues of the closed form", "[dispersion]") {
  verification::Check check("dispersion_dispersive_plan_symbol", "Dispersion of the plan model: eigenvalues",
                            "Modes of boxes of square and oblong cells, from one half-wave to nearly the shortest: "
                            "the acceleration that the linearised forces and constraints give a mode is $-\\omega^2$ "
                            "times the mode itself, with $\\omega$ of the closed form. No run, no time step, no "
                            "amplitude.");
  const std::string reason = "some 1e3 operations of a direct solution of 144 unknowns, amplified by its condition";
  for (const auto& [id, tank] : tanks()) {
    Worst worst;
    Largest rest;
    for (const HalfWaves& half_waves : modes) {
      const PlanMode mode(tank, half_waves.x, half_waves.y);
      const auto found = mode.eigenvalue();
      worst.add(found.square / std::pow(mode.linear_frequency(), 2) - 1);
      rest.add(found.rest);
    }
    check.that({.id = "eigenvalues-" + id,
                .text = "Eigenvalues of " + tank.text() + " are those of the closed form.",
                .quantity = "largest relative deviation of omega^2",
                .source = source},
               {.value = worst.value()}, evidence::Bound{1e-12, reason});
    check.that({.id = "eigenvectors-" + id,
                .text = "Modes of " + tank.text() + " are eigenvectors.",
                .quantity = "largest vertical acceleration off the mode, over omega^2",
                .source = source},
               {.value = rest.value()}, evidence::Bound{1e-11, reason});
  }
}

TEST_CASE("standing waves in plan have the frequencies of the closed form", "[dispersion]") {
  verification::Check check(
      "dispersion_dispersive_plan", "Dispersion of the plan model: runs",
      "Standing waves of a millionth of the depth in boxes of square and of oblong cells, from one half-wave to nearly "
      "the shortest. The one-step scheme is linear for them: $\\omega$ follows from three successive amplitudes, by "
      "least squares over the run, free of its time step.");
  auto& figure = check.figure("frequencies", "Frequencies of three boxes of cells in plan",
                              "Lines: closed form along the x axis. Points: runs, at any angle, divided by the closed "
                              "form of their wavenumber and multiplied by that along the axis.");
  auto& panel = figure.panel({.x = "k H", .y = "omega sqrt(H/g)"});
  for (const auto& [id, tank] : tanks()) {
    const auto law = tank.law();
    const double unit = std::sqrt(tank.gravity / tank.depth);
    const double shortest = pi * static_cast<double>(tank.columns) / tank.length;
    std::vector<double> kh, line, places, found;
    for (int i = 1; i <= 100; ++i) {
      kh.push_back(i * shortest / 100 * tank.depth);
      line.push_back(law.frequency(i * shortest / 100, 0) / unit);
    }
    panel.line(tank.text(), kh, line, Role::exact);
    Worst worst;
    for (const HalfWaves& half_waves : modes) {
      const PlanMode mode(tank, half_waves.x, half_waves.y);
      const double expected = mode.linear_frequency();
      const double amplitude = 1e-6 * std::sqrt(tank.gravity * tank.depth);
      const double measured = mode.measured_frequency(0.2 / expected, 200, amplitude);
      worst.add(measured / expected - 1);
      const double k = std::hypot(mode.kx(), mode.ky());
      if (k > shortest) continue;
      places.push_back(k * tank.depth);
      found.push_back(measured / expected * law.frequency(k, 0) / unit);
    }
    panel.points("runs, " + tank.text(), places, found, Role::data);
    check.that({.id = "frequencies-" + id,
                .text = "Frequencies of " + tank.text() + " are those of the closed form.",
                .quantity = "largest relative deviation of a frequency",
                .source = source},
               {.value = worst.value(), .resolution = "omega tau = 0.2, 200 steps"},
               evidence::Bound{1e-9,
                               "amplitudes of 1e-6 change frequencies by their square, 1e-12, and are kept to "
                               "1e-11 by the solver, which second differences with omega tau = 0.2 divide by "
                               "0.04"});
  }
}
