/// Sets of particles: layers of water and discs.
///
/// Particles without mass are markers: they ride on the field and trace the surface.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace seiche::gauss_particles {

struct Particles {
  std::vector<double> x;     ///< [m]
  std::vector<double> y;     ///< [m]
  std::vector<double> mass;  ///< [kg/m]; 0: marker

  [[nodiscard]] std::size_t size() const { return x.size(); }
  void add(double at_x, double at_y, double of_mass);
};

/// Throws std::invalid_argument: arrays of different lengths, no mass at all, masses negative, places not finite.
void require_particles(const Particles& particles);

/// Water over a bottom, in columns of equal width and rows that follow the surface.
struct Layer {
  double begin = 0;  ///< [m]
  double end = 1;    ///< [m]
  std::size_t columns = 1;
  std::size_t rows = 1;
  double density = 1;                            ///< [kg/m^3]
  std::function<double(double x)> surface = {};  ///< elevation of the surface [m]
  std::function<double(double x)> bottom = {};   ///< [m]
  /// Masses of the three rows at the surface and at the bottom times 13/12, 7/8, 25/24: the midpoint rule to fourth
  /// order. At least six rows.
  bool end_corrected = true;
  std::size_t markers = 0;  ///< equidistant in x, on the surface; the first at `begin`, none at `end` in a channel
  bool marker_at_end = false;
};
/// The massive particles first, column by column from the bottom up; then the markers. Throws std::invalid_argument.
Particles layer(const Layer& layer);

/// Disc of the radius about the origin: ring i of so many holds 3 (2 i - 1) particles, whose masses are the ring's area
/// over their number; second moments are isotropic, to round-off. Markers on the rim. Throws std::invalid_argument.
Particles disc(double radius, std::size_t rings, std::size_t markers = 0, double density = 1);

}  // namespace seiche::gauss_particles
