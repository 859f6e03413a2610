#include "validation/instruments/plan/plan_standing_mode.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/models/dispersive_shallow_water_2d/model.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/oscillation.hpp"

namespace seiche::validation {

using dispersive_shallow_water_2d::Lattice;
using dispersive_shallow_water_2d::Model;
using dispersive_shallow_water_2d::Velocity;

exact::PlanDispersion PlanTank::law() const {
  return {gravity, depth, length / static_cast<double>(columns), width / static_cast<double>(rows), inertia};
}

double PlanTank::frequency(double kx, double ky) const {
  const exact::PlanSymbol symbol =
      exact::plan_symbol(kx, ky, length / static_cast<double>(columns), width / static_cast<double>(rows));
  const double steepened = gamma * std::pow(depth * symbol.gradient, 2) / symbol.potential;
  return law().frequency(kx, ky) * std::sqrt(1 + steepened);
}

std::string PlanTank::text() const {
  return fmt::format("{} x {} cells{}", columns, rows, gamma > 0 ? ", improved dispersion" : "");
}

PlanMode::PlanMode(const PlanTank& tank, std::size_t half_waves_x, std::size_t half_waves_y)
    : tank_(tank),
      kx_(std::numbers::pi * static_cast<double>(half_waves_x) / tank.length),
      ky_(std::numbers::pi * static_cast<double>(half_waves_y) / tank.width) {}

Lattice PlanMode::lattice() const {
  return dispersive_shallow_water_2d::rectangular_lattice(
      {.end = tank_.length, .north = tank_.width, .columns = tank_.columns, .rows = tank_.rows, .depth = tank_.depth});
}

double PlanMode::amplitude(const Lattice& lattice, std::span<const double> values) const {
  double sum = 0;
  double norm = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::size_t i = k % (tank_.columns + 1);
    const std::size_t j = k / (tank_.columns + 1);
    const double weight = (i % tank_.columns == 0 ? 0.5 : 1.0) * (j % tank_.rows == 0 ? 0.5 : 1.0);
    const double shape = at(lattice.x[k], lattice.y[k]);
    sum += weight * shape * values[k];
    norm += weight * shape * shape;
  }
  return sum / norm;
}

PlanMode::Eigenvalue PlanMode::eigenvalue() const {
  Model model(lattice(), {.gravity = tank_.gravity,
                          .inertia = tank_.inertia,
                          .gamma = tank_.gamma,
                          .solver = linear::SolverMethod::banded});
  const Lattice& first = model.lattice();
  const mechanics::State rest = model.state();
  const std::size_t n = model.nodes();
  const double height = 0.1 * tank_.depth;
  std::vector<double> acceleration(model.rates(), 0.0);
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> q = rest.q;
    for (std::size_t k = 0; k < n; ++k) q[2 * n + k] = sign * height * at(first.x[k], first.y[k]);
    model.linearise({0, 0}, q);
    model.kick(sign / (2 * height), acceleration);
  }
  model.linearise({0, 0}, rest.q);
  std::vector<double> multipliers(model.constraints(), 0.0);
  mechanics::Projection<Model>(model).project(acceleration, {}, multipliers);
  const std::span<const double> vertical(acceleration.data() + 2 * n, n);
  const double square = -amplitude(first, vertical);
  const auto rest_of_shape = [&](std::size_t k) { return vertical[k] / square + at(first.x[k], first.y[k]); };
  return {.square = square, .rest = over<Worst>(indices(n), rest_of_shape).value()};
}

double PlanMode::measured_frequency(double tau, int steps, double first_amplitude) const {
  Model model(lattice(),
              {.gravity = tank_.gravity, .inertia = tank_.inertia, .gamma = tank_.gamma, .tolerance = 1e-13});
  mechanics::State state = model.state([&](double x, double y) { return Velocity{0, 0, first_amplitude * at(x, y)}; });
  mechanics::Start(model).project(state);
  mechanics::OneStep<Model> stepper(model);
  std::vector<double> amplitudes;
  for (int n = 0; n <= steps; ++n) {
    if (n > 0) stepper.step(state, tau);
    amplitudes.push_back(amplitude(model.lattice(), std::span(state.q).subspan(2 * model.nodes(), model.nodes())));
  }
  return frequency_of(amplitudes, tau);
}

}  // namespace seiche::validation
