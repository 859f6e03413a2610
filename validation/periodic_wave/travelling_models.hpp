/// One period of a periodic wave that travels without a change of shape, by four models: what the surface is
/// afterwards, and what it took.
///
/// The crest is at x = 0 at the beginning; gravity, density and the mean depth are 1.
#pragma once

#include <vector>

#include "seiche/exact/serre_cnoidal.hpp"
#include "seiche/exact/stokes_wave.hpp"
#include "seiche/geometry/curve.hpp"

namespace seiche::validation {

/// What one computation left after one period of the wave: of `wave`, the exact crest is then at the wavelength.
struct Travelled {
  double size = 0;             ///< of a cell, or spacing of markers or particles
  double seconds = 0;          ///< of the processor
  std::vector<Point> surface;  ///< one wavelength about the crest
  double energy_change = 0;    ///< over the kinetic energy of the exact wave
};

/// Way of the wave in a step of the particles, in cells.
constexpr double particles_courant = 0.15;

/// Free particles under Gauss's principle in a periodic channel, gravity as the potential energy under the line of
/// markers: six particles to a cell's side.
Travelled travel_particles(const exact::StokesWave& wave, long cells);

/// Lagrangian mesh of cells twice as wide as high, steps of 0.4 rows. Meshes have no period: of three wavelengths the
/// nodes of both ends and of nothing else are led on exact paths, and the wave in the middle counts, with a third of
/// the seconds. What the ends know travels with the group, which is slower than the wave, and does not reach it.
Travelled travel_mesh(const exact::StokesWave& wave, long rows);

/// Discrete dispersive shallow water in a periodic channel, from the wave of its own equations; steps of a quarter of a
/// cell.
/// @param time  of the run
Travelled travel_dispersive(const exact::SerreCnoidal& wave, double time, long cells);

/// Weakly compressible SPH in a periodic box, from the exact pressures: kernel of Wendland, h = 2 dx, sound speed
/// 10 sqrt(g d), artificial viscosity 0.01. The surface is where the share of water is one half.
Travelled travel_sph(const exact::StokesWave& wave, long rows);

}  // namespace seiche::validation
