// Gravity on the surface's markers: a wave of free particles runs five periods without a penalty.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "seiche/exact/stokes_wave.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::gauss_particles_surface_gravity_test {

using namespace gauss_particles;
using exact::StokesWave;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 6";

constexpr double turn = 2 * std::numbers::pi, length = turn, depth = std::numbers::pi, height = 0.4;
constexpr int cells = 20, per_side = 6;

/// A Stokes wave of free particles without a penalty, gravity on the line of its markers.
class Wave {
 public:
  Wave(bool exact_energy, double inner_fraction)
      : flow_(layer({.end = length,
                     .columns = std::size_t{cells} * per_side,
                     .rows = std::size_t{cells} / 2 * per_side,
                     .surface = [this](double x) { return surface(x); },
                     .bottom = [](double) { return -depth; },
                     .markers = 400}),
              std::make_unique<SplineSpace>(LatticePlan{.cell_x = length / cells,
                                                        .left_wall = 0.0,
                                                        .period = length,
                                                        .bottom = true,
                                                        .ground = {.level = -depth}},
                                            SplineSpace::Settings{.inner_fraction = inner_fraction}),
              [this](Point r) {
                const auto v = wave_.velocity(r.x - length / 2, std::min(r.y, surface(r.x) - 1e-13));
                return Point{v.u, v.v};
              },
              {.gravity = 1, .penalty = 0, .surface = SurfaceLine{.period = length, .exact_energy = exact_energy}}) {}

  void run(int steps_per_period, int periods) {
    const double tau = length / wave_.phase_speed() / steps_per_period;
    for (int n = 0; n < steps_per_period * periods; ++n) {
      flow_.advance(tau);
      flow_.observe();
    }
  }
  /// Rms difference of the markers' elevations from the exact wave.
  [[nodiscard]] double difference() const {
    Mean squares;
    for (const Point& marker : flow_.markers()) {
      squares.add(marker.y - surface(marker.x - wave_.phase_speed() * flow_.time()));
    }
    return squares.rms();
  }
  [[nodiscard]] double defect(const std::string& of) const {
    const auto& entry = flow_.ledger().entry(of);
    return entry.largest_defect / entry.initial;
  }

 private:
  [[nodiscard]] double surface(double x) const { return wave_.elevation(x - length / 2); }

  StokesWave wave_{height / 2, length, depth, 1};
  Flow flow_;
};

/// Rms of a wave whose phase is by the square of omega tau over 12 per period beside the exact one.
double of_phase(int steps_per_period, int periods) {
  const double lead = turn / steps_per_period * turn / steps_per_period / 12;
  return height / 2 / std::sqrt(2.0) * turn * periods * lead;
}

constexpr int steps = 100, periods = 5;

void check_surface_and_momentum(Check& check, const Wave& wave) {
  check.at("20 cells, 6 particles to a side, 100 steps per period");
  check.that("surface",
             "The surface after five periods agrees with the wave within 1.5 times the phase error (omega tau)^2/12.",
             "rms difference of the markers' elevations [1/k]", {wave.difference()},
             Bound{1.5 * of_phase(steps, periods),
                   "the phase errs by (omega tau)^2/12, so much of an amplitude of 0.2 over five periods; the grid may "
                   "add half as much, or it and not the steps would be the larger error"});
  check.that(
      "momentum",
      "The momentum is conserved to round-off: the potential energy does not depend on the position of the water.",
      "largest error over the momentum", {wave.defect("momentum_x")},
      Roundoff{steps * periods, 5,
               "one rounding per step of the sum of the velocities' magnitudes, 5 times the momentum"});
}

TEST_CASE("with gravity on its surface a wave needs no penalty", "[dispersion]") {
  Check check("gauss_particles_surface_gravity", "Gauss-principle particles: gravity on the surface",
              "A Stokes wave of height 0.4 (wavelength 2 pi, depth pi) runs for five periods without the penalty. With "
              "gravity on every particle the wave is lost by then: sums over particles do work on small eddies. With "
              "the potential energy of the line of markers this work is zero. With the force at the middle of a step "
              "the energy is not exact.",
              source);
  Wave wave(false, 0.6);
  wave.run(steps, periods);
  check_surface_and_momentum(check, wave);
  check.that("energy", "The energy error is below (omega tau)^2/12, by which the energy of the steps differs.",
             "largest error over the kinetic energy", {wave.defect("energy")},
             Bound{turn / steps * turn / steps / 12,
                   "(omega tau)^2/12, the difference between the energy that the steps conserve and the exact one; a "
                   "force that lags by a part of the step removes ten times as much in each period"});
}

TEST_CASE("the discrete gradient of the surface's energy conserves the energy of a wave", "[dispersion]") {
  Check check("gauss_particles_surface_energy", "Gauss-principle particles: exact energy with gravity on the surface",
              "The same wave with the discrete gradient of the potential energy over the markers' displacement, and "
              "inner cells 0.9 full: after five periods without the penalty the surface, the momentum and the energy "
              "have their initial values. The phase lags by (omega tau)^2/12.",
              source);
  Wave wave(true, 0.9);
  wave.run(steps, periods);
  check_surface_and_momentum(check, wave);
  check.that("energy", "The energy is conserved to round-off.", "largest error over the kinetic energy",
             {wave.defect("energy")},
             Roundoff{steps * periods, 2, "one rounding per step of the kinetic and the potential energy"});
  refine(check, {"omega tau", widths(turn, {28, 40, 56, 80})},
         {{"order",
           "The surface converges with the second order of the step.",
           {2, 0.2,
            "the next term of the phase is (omega tau)^2/5 of the first: 1 % over this range, and the grid adds 1e-4 "
            "to differences from 5e-4"}}},
         [](double step) {
           Wave one_period(true, 0.9);
           one_period.run(static_cast<int>(cells_of(turn, step)), 1);
           return one_period.difference();
         });
}

}  // namespace seiche::verification::gauss_particles_surface_gravity_test
