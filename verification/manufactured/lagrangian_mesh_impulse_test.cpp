// Velocities that an impulsive pressure on the surface gives the two-dimensional Lagrangian mesh.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mesh/impulsive_start.hpp"
#include "validation/instruments/mesh/mesh_solitary_wave.hpp"
#include "verification/check.hpp"
#include "verification/manufactured/volume_rates.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::lagrangian_mesh_impulse_test {

constexpr double length = 40;

/// Of the velocities of nodes, over the largest speed, in the lower half; of the kinetic energy, relative; and of the
/// velocities at the surface.
/// @param rates  takes the largest rate of a cell's area, over its area
std::array<double, 3> errors_of(const exact::SolitaryWave& wave, long rows, Largest& rates) {
  const validation::PlacedWave placed{wave, length / 2};
  const lagrangian_mesh_2d::Mesh mesh =
      placed.mesh(length, {.column_width = 2 / static_cast<double>(rows), .rows = rows});
  const auto velocity = validation::impulsive_start(mesh, [&](double x) { return placed.surface_potential(x); });
  lagrangian_mesh_2d::Model model(mesh);
  const mechanics::State state = model.state(velocity);
  rates.add(largest_relative_rate(model, state));
  Worst speed, lower_half, surface;
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const Point exact = placed.velocity({mesh.x[k], mesh.y[k]});
    speed.add(std::hypot(exact.x, exact.y));
    const double error = std::hypot(state.u[k] - exact.x, state.u[mesh.nodes() + k] - exact.y);
    const std::size_t row = k / (mesh.columns + 1);
    if (2 * row <= mesh.rows) lower_half.add(error);
    if (row == mesh.rows) surface.add(error);
  }
  return {lower_half.value() / speed.value(),
          std::abs(model.kinetic_energy(state.q, state.u) / wave.kinetic_energy() - 1),
          surface.value() / speed.value()};
}

TEST_CASE("an impulse on the surface starts the potential flow of an exact wave", "[manufactured]") {
  Check check("lagrangian_mesh_impulse", "A mesh set into potential flow by an impulse on its surface",
              "An impulsive pressure, minus the potential of a solitary wave of H/h = 0.3 on its surface, acts on "
              "meshes of 4 to 32 rows at rest. In the lower half velocities and energy converge to the wave's at "
              "second order; at the surface velocities converge at first order only, because the pressure acts on a "
              "surface node half a cell below. This is the potential flow of the mesh; nodes started with the exact "
              "velocities slide over the row beneath indefinitely.",
              "Lamb, Hydrodynamics (1932), art. 11; Frank (1994), chapter 2");
  const exact::SolitaryWave wave(0.3);
  const Order second{2, 0.2, "smooth wave; the coarsest mesh has four rows"};
  Largest rates;
  refine(check, {"h2/depth", widths(1, {4, 8, 16, 32})},
         {{"lower-half", "Velocities in the lower half agree with the wave, to second order.", second},
          {"energy", "The kinetic energy after the impulse converges at second order.", second},
          {"surface", "Velocities at the surface converge at first order.",
           Order{1, 0.2, "a surface node feels the pressure half a cell below"}}},
         [&](double height) { return errors_of(wave, std::lround(1 / height), rates); });
  check.that("areas", "Rates of all cell areas after the impulse are zero to round-off.",
             "largest rate of an area over the area [sqrt(g/depth)]",
             {.value = rates.value(), .resolution = "4 to 32 rows"},
             Roundoff{10, 1300,
                      "ten rounded terms; the impulse alone gives surface nodes speeds 2 phi/h2, up to 40, which the "
                      "cells' reactions take back, and a rate over its area is a difference of speeds over h2 = 1/32"});
}

}  // namespace seiche::verification::lagrangian_mesh_impulse_test
