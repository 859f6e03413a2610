/// Small standing waves of the plan model in a box between four walls: their frequencies from the linearised model, and
/// from runs.
#pragma once

#include <cmath>

#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/models/dispersive_shallow_water_2d/model.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/oscillation.hpp"

namespace seiche::validation {

struct PlanTank {
  std::size_t columns = 12;
  std::size_t rows = 12;
  double length = 6;  ///< along x [m]
  double width = 6;
  double depth = 1;
  double gravity = 1;
  double inertia = 1.0 / 3;
  double gamma = 0;  ///< of improved dispersion

  /// Of the lattice, without improved dispersion.
  [[nodiscard]] exact::PlanDispersion law() const {
    return {gravity, depth, length / static_cast<double>(columns), width / static_cast<double>(rows), inertia};
  }
  /// omega [1/s] in closed form, with improved dispersion.
  [[nodiscard]] double frequency(double kx, double ky) const {
    const exact::PlanSymbol symbol =
        exact::plan_symbol(kx, ky, length / static_cast<double>(columns), width / static_cast<double>(rows));
    const double steepened = gamma * std::pow(depth * symbol.gradient, 2) / symbol.potential;
    return law().frequency(kx, ky) * std::sqrt(1 + steepened);
  }
  /// "12 x 12 cells".
  [[nodiscard]] std::string text() const {
    return fmt::format("{} x {} cells{}", columns, rows, gamma > 0 ? ", improved dispersion" : "");
  }
};

/// cos(kx x) cos(ky y) with whole numbers of half-waves between the walls.
class PlanMode {
 public:
  PlanMode(const PlanTank& tank, std::size_t half_waves_x, std::size_t half_waves_y)
      : tank_(tank),
        kx_(std::numbers::pi * static_cast<double>(half_waves_x) / tank.length),
        ky_(std::numbers::pi * static_cast<double>(half_waves_y) / tank.width) {}

  [[nodiscard]] double kx() const { return kx_; }
  [[nodiscard]] double ky() const { return ky_; }
  /// Of the closed form.
  [[nodiscard]] double linear_frequency() const { return tank_.frequency(kx_, ky_); }
  [[nodiscard]] double at(double x, double y) const { return std::cos(kx_ * x) * std::cos(ky_ * y); }

  /// What the linearised model makes of the mode: omega^2, and the largest vertical acceleration off the mode's shape,
  /// over omega^2. No run, no amplitude: forces are linear in z but for terms that change no sign with it, so that half
  /// the difference of those at elevations of either sign is the linearised one.
  struct Eigenvalue {
    double square = 0;
    double rest = 0;
  };
  [[nodiscard]] Eigenvalue eigenvalue() const {
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

  /// Frequency in a run of the one-step scheme, by frequency_of().
  /// @param first_amplitude  of the velocity [m/s]
  [[nodiscard]] double measured_frequency(double tau, int steps, double first_amplitude = 1e-6) const {
    Model model(lattice(),
                {.gravity = tank_.gravity, .inertia = tank_.inertia, .gamma = tank_.gamma, .tolerance = 1e-13});
    mechanics::State state = model.state([&](double x, double y) {
      return dispersive_shallow_water_2d::Velocity{0, 0, first_amplitude * at(x, y)};
    });
    mechanics::Start(model).project(state);
    mechanics::OneStep<Model> stepper(model);
    std::vector<double> amplitudes;
    for (int n = 0; n <= steps; ++n) {
      if (n > 0) stepper.step(state, tau);
      amplitudes.push_back(amplitude(model.lattice(), std::span(state.q).subspan(2 * model.nodes(), model.nodes())));
    }
    return frequency_of(amplitudes, tau);
  }

 private:
  using Lattice = dispersive_shallow_water_2d::Lattice;
  using Model = dispersive_shallow_water_2d::Model;

  [[nodiscard]] Lattice lattice() const {
    return dispersive_shallow_water_2d::rectangular_lattice({.end = tank_.length,
                                                             .north = tank_.width,
                                                             .columns = tank_.columns,
                                                             .rows = tank_.rows,
                                                             .depth = tank_.depth});
  }
  /// Amplitude of values on the nodes, nodes on walls with half their weight.
  [[nodiscard]] double amplitude(const Lattice& lattice, std::span<const double> values) const {
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

  PlanTank tank_;
  double kx_, ky_;
};

}  // namespace seiche::validation
