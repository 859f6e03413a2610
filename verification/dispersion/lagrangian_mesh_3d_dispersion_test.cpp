// Standing waves of the hexahedral mesh against its closed dispersion law.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/oscillation.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_3d_problems.hpp"
#include "verification/dispersion/tank_frequencies.hpp"

namespace seiche::verification::lagrangian_mesh_3d_dispersion_test {

using namespace lagrangian_mesh_3d;

constexpr double pi = std::numbers::pi;

struct Tank {
  std::size_t columns, rows, layers;
  double length, width, depth, gravity;

  [[nodiscard]] Mesh mesh() const {
    return layer_mesh(
        {.end = length, .north = width, .depth = depth, .columns = columns, .rows = rows, .layers = layers});
  }
  [[nodiscard]] exact::HexahedralDispersion law() const {
    return {gravity, depth, length / static_cast<double>(columns), width / static_cast<double>(rows), layers};
  }
};

/// Frequency of the linearised model from a run of the one-step scheme.
double measured_frequency(const Tank& tank, double kx, double ky, double tau, int steps) {
  const double amplitude = 1e-6 * std::sqrt(tank.gravity * tank.depth);
  const auto rising = [&](Place r) {
    return Vector{0, 0, amplitude * (1 + r.z / tank.depth) * std::cos(kx * r.x) * std::cos(ky * r.y)};
  };
  HexahedralProblem problem(tank.mesh(), rising, {.gravity = tank.gravity, .density = 1.3, .tolerance = 1e-13});
  mechanics::OneStep<Model> stepper(problem.model);
  const Mesh& mesh = problem.model.mesh();
  const std::size_t top = mesh.node(0, 0, mesh.layers);
  std::vector<double> amplitudes;
  for (int n = 0; n <= steps; ++n) {
    if (n > 0) stepper.step(problem.start, tau);
    double sum = 0;
    for (std::size_t k = 0; k < mesh.plan.nodes(); ++k) {
      const std::size_t i = k % (tank.columns + 1), j = k / (tank.columns + 1);
      const double weight = (i % tank.columns == 0 ? 0.5 : 1.0) * (j % tank.rows == 0 ? 0.5 : 1.0);
      sum += weight * problem.start.q[2 * mesh.nodes() + top + k] * std::cos(kx * mesh.x[k]) * std::cos(ky * mesh.y[k]);
    }
    amplitudes.push_back(sum);
  }
  return validation::frequency_of(amplitudes, tau);
}

TEST_CASE("standing waves in a box of hexahedra have the frequencies of the closed form", "[dispersion]") {
  Check check("dispersion_lagrangian_mesh_3d", "Dispersion of the hexahedral mesh",
              "Standing waves of a millionth of the depth, one to three layers, in boxes of square and of oblong "
              "cells, from one half-wave to nearly the shortest. The one-step scheme is linear for them: $\\omega$ "
              "follows from three successive amplitudes, by least squares over the run, free of its time step.");
  const std::array tanks{Tank{12, 12, 1, 6, 6, 1, 1}, Tank{12, 12, 2, 6, 6, 1, 1}, Tank{12, 12, 3, 6, 6, 1, 1},
                         Tank{10, 8, 2, 3, 4, 0.7, 9.81}};
  auto& figure = check.figure("frequencies", "Frequencies of four boxes of hexahedra",
                              "Lines: closed form along the x axis. Points: runs, at any angle, divided by the closed "
                              "form of their wavenumber and multiplied by the value along the axis.");
  auto& panel = figure.panel({.x = "k H", .y = "omega sqrt(H/g)"});
  for (const Tank& tank : tanks) {
    const auto law = tank.law();
    const std::string id = fmt::format("{}x{}x{}", tank.columns, tank.rows, tank.layers);
    const auto run = [&](HalfWaves mode) {
      const double kx = pi * static_cast<double>(mode.x) / tank.length;
      const double ky = pi * static_cast<double>(mode.y) / tank.width;
      const double expected = law.frequency(kx, ky);
      return std::pair{expected, measured_frequency(tank, kx, ky, 0.2 / expected, 200)};
    };
    const double error = draw_runs(
        panel, id, tank, [&](double k) { return law.frequency(k, 0); }, run);
    check.holds("frequencies-" + id + ": " +
                    fmt::format("Frequencies of {} x {} x {} cells agree with the closed form.", tank.columns,
                                tank.rows, tank.layers),
                {error},
                Bound{1e-9,
                      "amplitudes of 1e-6 change frequencies by their square, 1e-12, and are resolved to 1e-11 by the "
                      "solver, which second differences with omega tau = 0.2 divide by 0.04"});
  }
}

}  // namespace seiche::verification::lagrangian_mesh_3d_dispersion_test
