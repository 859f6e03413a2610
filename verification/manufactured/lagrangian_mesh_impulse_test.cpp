// Velocities that an impulsive pressure on the surface gives the two-dimensional Lagrangian mesh.
#include <cmath>
#include <string>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mesh/impulsive_start.hpp"
#include "validation/instruments/mesh/mesh_solitary_wave.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::lagrangian_mesh_impulse_test {

const std::string source = "Lamb, Hydrodynamics (1932), art. 11; Frank (1994), chapter 2";
constexpr double length = 40;

struct Errors {
  double lower_half = 0;  ///< of the velocities of nodes, over the largest speed
  double surface = 0;
  double kinetic = 0;  ///< relative
  double rates = 0;    ///< largest rate of a cell's area, over its area
};

Errors errors_of(const exact::SolitaryWave& wave, long rows) {
  const validation::PlacedWave placed{wave, length / 2};
  const lagrangian_mesh_2d::Mesh mesh =
      placed.mesh(length, {.column_width = 2 / static_cast<double>(rows), .rows = rows});
  const auto velocity = validation::impulsive_start(mesh, [&](double x) { return placed.surface_potential(x); });
  lagrangian_mesh_2d::Model model(mesh);
  const mechanics::State state = model.state(velocity);
  Errors errors;
  errors.kinetic = std::abs(model.kinetic_energy(state.q, state.u) / wave.kinetic_energy() - 1);
  model.linearise({}, state.q);
  std::vector<double> rates(mesh.cells());
  model.constraint_rates(state.u, rates);
  Worst fastest;
  for (std::size_t s = 0; s < rates.size(); ++s) fastest.add(rates[s] / model.first_volumes()[s]);
  errors.rates = fastest.value();
  Worst speed, lower_half, surface;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const Point exact = placed.velocity({mesh.x[k], mesh.y[k]});
    speed.add(std::hypot(exact.x, exact.y));
    const double error = std::hypot(state.u[k] - exact.x, state.u[mesh.nodes() + k] - exact.y);
    const std::size_t row = k / (mesh.columns + 1);
    if (2 * row <= mesh.rows) lower_half.add(error);
    if (row == mesh.rows) surface.add(error);
  }
  errors.lower_half = lower_half.value() / speed.value();
  errors.surface = surface.value() / speed.value();
  return errors;
}

TEST_CASE("an impulse on the surface starts the potential flow of an exact wave", "[manufactured]") {
  Check check("lagrangian_mesh_impulse", "A mesh set into potential flow by an impulse on its surface",
              "An impulsive pressure, minus the potential of a solitary wave of H/h = 0.3 on its surface, acts on "
              "meshes of 4 to 32 rows at rest. In the lower half velocities and energy converge to the wave's at "
              "second order; at the surface velocities converge at first order only, because the pressure acts on a "
              "surface node half a cell below. This is the potential flow of the mesh; nodes started with the exact "
              "velocities slide over the row beneath indefinitely.",
              source);
  const exact::SolitaryWave wave(0.3);
  const Order second{2, 0.2, "smooth wave; the coarsest mesh has four rows"};
  Largest rates;
  refine(check, {"h2/depth", widths(1, {4, 8, 16, 32})},
         {{"lower-half", "Velocities in the lower half agree with the wave, to second order.", second},
          {"energy", "The kinetic energy after the impulse converges at second order.", second},
          {"surface",
           "Velocities at the surface converge at first order.",
           {1, 0.2, "a surface node feels the pressure half a cell below"}}},
         [&](double height) {
           const Errors errors = errors_of(wave, std::lround(1 / height));
           rates.add(errors.rates);
           return std::array{errors.lower_half, errors.kinetic, errors.surface};
         });
  check.that("areas", "Rates of all cell areas after the impulse are zero to round-off.",
             "largest rate of an area over the area [sqrt(g/depth)]",
             {.value = rates.value(), .resolution = "4 to 32 rows"},
             Roundoff{10, 1300,
                      "ten rounded terms; the impulse alone gives surface nodes speeds 2 phi/h2, up to 40, which the "
                      "cells' reactions take back, and a rate over its area is a difference of speeds over h2 = 1/32"});
}

}  // namespace seiche::verification::lagrangian_mesh_impulse_test
