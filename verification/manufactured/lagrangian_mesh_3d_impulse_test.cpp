// Velocities that an impulsive pressure on the surface gives the hexahedral mesh.
#include <cmath>
#include <string>
#include <vector>

#include "seiche/exact/solitary_wave.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/model.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mesh/impulsive_start.hpp"
#include "verification/check.hpp"
#include "verification/manufactured/volume_rates.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::lagrangian_mesh_3d_impulse_test {

using namespace lagrangian_mesh_3d;

/// Relative error of the kinetic energy of a solitary wave in a channel two cells wide.
/// @param rates  takes the largest rate of a cell's volume, over its volume
double kinetic_error(const exact::SolitaryWave& wave, std::size_t layers, Largest& rates) {
  const double h = 1 / static_cast<double>(layers);
  const double width = 2 * h;
  const Mesh mesh = layer_mesh({.begin = -20,
                                .end = 20,
                                .north = width,
                                .columns = 40 * layers,
                                .rows = 2,
                                .layers = layers,
                                .elevation = [&](double x, double) { return wave.elevation(x); }});
  Model model(mesh);
  const mechanics::State state =
      model.state(validation::impulsive_start(mesh, [&](double x, double) { return wave.surface_potential(x); }));
  rates.add(largest_relative_rate(model, state));
  return std::abs(model.kinetic_energy(state.q, state.u) / (width * wave.kinetic_energy()) - 1);
}

TEST_CASE("an impulsive pressure sets hexahedra into the potential flow of its wave", "[manufactured]") {
  Check check(
      "lagrangian_mesh_3d_impulse", "Impulsive start of the hexahedral mesh",
      "On the surface of the exact solitary wave of height 0.3 acts the impulsive pressure $-\\rho\\phi$ of its "
      "potential, on meshes of cubes of 1/4 to 1/16 of the depth: the kinetic energy of the mesh against the wave's.",
      "Lamb, Hydrodynamics (1932), art. 11; Frank (1994), chapter 4.1");
  const exact::SolitaryWave wave(0.3);
  Largest rates;
  refine(check, {"cell/depth", widths(1, {4, 6, 8, 12, 16})},
         {{"kinetic", "The kinetic energy converges to the wave's at second order.",
           Order{2, 0.2, "bilinear patches under a pressure taken at their middles"}}},
         [&](double size) { return kinetic_error(wave, cells_of(1, size), rates); });
  check.that("rates", "Rates of all cell volumes after the impulse are zero.",
             "largest rate of a volume over the volume", {rates.value()},
             Bound{1e-9,
                   "the solver leaves 1e-13 of the norm of the rates before the projection, 256 in each of 1280 cells "
                   "at the surface of the finest mesh"});
}

}  // namespace seiche::verification::lagrangian_mesh_3d_impulse_test
