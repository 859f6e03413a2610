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

namespace {

using namespace seiche::gauss_particles;
using namespace seiche::verification;
using seiche::Mean;
using seiche::Point;
using seiche::evidence::Bound;
using seiche::evidence::Roundoff;
using seiche::exact::StokesWave;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 6";

constexpr double length = 2 * std::numbers::pi;
constexpr double depth = std::numbers::pi;
constexpr int cells = 20;
constexpr int per_side = 6;
constexpr int steps = 100;
constexpr int periods = 5;
constexpr double height = 0.4;

}  // namespace

TEST_CASE("with gravity on its surface a wave needs no penalty", "[dispersion]") {
  Check check(
      "gauss_particles_surface_gravity", "Free particles: gravity on the surface",
      "A Stokes wave of height 0.4 (wavelength 2 pi, depth pi) runs for five periods without the penalty. With "
      "gravity on every particle it is lost by then: sums over particles do work on small eddies. With the "
      "potential energy of the line of markers there is nothing that they could take. The energy is no longer exact.");
  const StokesWave wave(height / 2, length, depth, 1);
  const auto surface = [&](double x) { return wave.elevation(x - length / 2); };
  Flow flow(layer({.begin = 0,
                   .end = length,
                   .columns = cells * per_side,
                   .rows = cells / 2 * per_side,
                   .surface = surface,
                   .bottom = [](double) { return -depth; },
                   .markers = 400}),
            std::make_unique<SplineSpace>(LatticePlan{.cell_x = length / cells,
                                                      .left_wall = 0.0,
                                                      .period = length,
                                                      .bottom = true,
                                                      .ground = {.level = -depth}},
                                          SplineSpace::Settings{.inner_fraction = 0.6}),
            [&](Point r) {
              const auto v = wave.velocity(r.x - length / 2, std::min(r.y, surface(r.x) - 1e-13));
              return Point{v.u, v.v};
            },
            {.gravity = 1, .penalty = 0, .surface = SurfaceLine{.period = length}});
  const double kinetic = flow.model().kinetic_energy(flow.state().q, flow.state().u);
  const double momentum = flow.ledger().entry("momentum_x").initial;
  const double tau = length / wave.phase_speed() / steps;
  for (int n = 0; n < steps * periods; ++n) {
    flow.advance(tau);
    flow.observe();
  }
  Mean squares;
  for (const Point& marker : flow.markers()) {
    squares.add(marker.y - surface(marker.x - wave.phase_speed() * flow.time()));
  }
  const double turn = 2 * std::numbers::pi;
  const double lead = turn / steps * turn / steps / 12;
  const std::string resolution = "20 cells, 6 particles to a side, 100 steps per period";
  check.that(
      {.id = "surface",
       .text = "After five periods the surface is that of the wave.",
       .quantity = "rms difference of the markers' elevations",
       .unit = "1/k",
       .source = source},
      {.value = squares.rms(), .resolution = resolution},
      Bound{1.5 * height / 2 / std::sqrt(2.0) * turn * periods * lead,
            "the linear law of markers that lead by a third of their last change has the phase lead by "
            "(omega tau)^2/12: so much of an amplitude of 0.2 over five periods; the lattice may add half as much, or "
            "it and not the steps would be the larger error"});
  check.that({.id = "energy",
              .text = "The energy errs by less than the square of the step.",
              .quantity = "largest defect over the kinetic energy",
              .source = source},
             {.value = flow.ledger().largest_defect("energy") / kinetic, .resolution = resolution},
             Bound{lead,
                   "(omega tau)^2/12, by which the energy that the steps keep differs from the exact one; a force that "
                   "lags by a part of the step takes ten times as much in each period"});
  check.that(
      {.id = "momentum",
       .text = "The momentum is kept to round-off: the potential energy does not depend on where the water is.",
       .quantity = "largest defect over the momentum",
       .source = source},
      {.value = flow.ledger().entry("momentum_x").largest_defect / momentum, .resolution = resolution},
      Roundoff{.operations = steps * periods,
               .scale = 5,
               .reason = "one rounding per step of the sum of the velocities' magnitudes, 5 times the momentum"});
}
