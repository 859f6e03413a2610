/// A periodic wave that travels without a change of shape, by four models: what the surface is at some instants, and
/// what it took.
///
/// The crest is at x = 0 at the beginning; gravity, density and the mean depth are 1.
#pragma once

#include <vector>

#include "seiche/exact/model_waves.hpp"
#include "seiche/exact/stokes_wave.hpp"
#include "seiche/geometry/curve.hpp"

namespace seiche::validation {

/// What there is at an instant.
struct Station {
  double time = 0;
  std::vector<Point> surface;  ///< one wavelength about the crest, ascending; of a periodic model wherever it drifted
  double energy_change = 0;    ///< over the kinetic energy at the beginning; NaN where the model does not count it
};

/// When a wave is looked at, in periods, ascending: after one.
inline const std::vector<double> after_a_period{1.0};

struct Followed {
  double size = 0;     ///< of a cell, or spacing of markers or particles
  double seconds = 0;  ///< of the processor, for one wavelength of water
  std::vector<Station> stations;

  [[nodiscard]] const Station& last() const { return stations.back(); }
};

/// What its height adds to a wave's speed, over the speed of low waves.
double excess_speed(const exact::StokesWave& wave);

/// Way of the wave in a step of the particles, in cells.
constexpr double particles_courant = 0.15;

/// Free particles under Gauss's principle in a periodic channel, gravity as the potential energy under the line of
/// markers: six particles to a cell's side.
Followed follow_particles(const exact::StokesWave& wave, long cells,
                          const std::vector<double>& instants = after_a_period);

/// Lagrangian mesh of cells twice as wide as high, steps of 0.4 rows. Meshes have no period: of a chain of waves the
/// nodes of both ends and of nothing else are led on exact paths, and the wave that begins a wavelength from the left
/// one counts. What the left end knows travels with the group, which is slower than the wave, and does not reach it; of
/// the right one it is a wavelength away at the end, and half as far again as the wave went where it goes on for more
/// than a period.
Followed follow_mesh(const exact::StokesWave& wave, long rows, const std::vector<double>& instants = after_a_period);

/// Discrete dispersive shallow water in a periodic channel, from the wave of its own equations; steps of a quarter of a
/// cell.
/// @param period  in which instants are told
Followed follow_dispersive(const exact::SerreCnoidal& wave, double period, long cells,
                           const std::vector<double>& instants = after_a_period);

/// Artificial viscosity of the SPH particles, and their smoothing length in spacings and sound speed in sqrt(g d).
constexpr double sph_viscosity = 0.01;
constexpr double sph_smoothing = 2;
constexpr double sph_sound = 10;

/// Weakly compressible SPH in a periodic box, from the exact pressures, with the kernel of Wendland. The surface is
/// where the share of water is one half.
Followed follow_sph(const exact::StokesWave& wave, long rows, const std::vector<double>& instants = after_a_period);

}  // namespace seiche::validation
