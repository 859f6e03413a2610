/// What all scenes have in common: lengths in whole spacings, densities, masses, walls.
#pragma once

#include <span>
#include <string_view>

#include "seiche/models/wcsph/equation_of_state.hpp"
#include "seiche/models/wcsph/scene.hpp"

namespace seiche::wcsph {

/// Of staggered particles.
struct WallRows {
  int count = 2;
  bool corners_twice = false;
};

class SceneBuilder {
 public:
  /// Throws std::invalid_argument.
  SceneBuilder(double spacing, Lattice lattice, const Settings& settings);

  /// Length in dx, rounded with a warning where it is no whole number.
  long whole(std::string_view name, double length, long least = 1);
  [[nodiscard]] double length(long steps) const { return static_cast<double>(steps) * scene.spacing; }

  /// rho in still water, rho_0 above its surface.
  [[nodiscard]] double hydrostatic(double depth) const;
  [[nodiscard]] double density_at(double pressure) const { return fluid_.density_at(pressure); }

  /// A particle that stands for an area of dx^2 times `area`.
  void fluid(const Place& place, double area, double density, const Velocity& velocity = {0, 0});
  /// Walls beside water that reaches up to `surface`; paddle particles with the velocity of scene.paddles.back().
  template <class Surface>
  void walls(std::span<const Place> places, Surface surface, Kind kind = Kind::wall) {
    for (const Place& place : places) solid(place, hydrostatic(surface(place.x) - place.z), kind);
  }
  /// Walls of an open basin, columns x wall_rows cells from the origin: staggered rows along `corners`; or, for
  /// pressures that are extrapolated and have to fill the whole support, the lattice of the water continued behind the
  /// walls. Returns how far behind the effective walls they reach [m].
  template <class Surface>
  double basin_walls(std::span<const Place> corners, long columns, long wall_rows, const WallRows& rows,
                     Surface surface) {
    if (!walls_continue_lattice_) {
      walls(wall(corners, scene.spacing, rows.count, rows.corners_twice), surface);
      return scene.spacing / 2 * rows.count;
    }
    walls(lattice_frame(columns, wall_rows), surface);
    return length(frame_cells_);
  }
  /// The same of a level bottom alone, `columns` cells long; `places` are its staggered rows.
  template <class Surface>
  void bottom(std::span<const Place> places, long columns, Surface surface) {
    if (walls_continue_lattice_) {
      const double thickness = length(frame_cells_);
      walls(rectangle(lattice_, scene.spacing, 0, -thickness, columns, frame_cells_), surface);
    } else {
      walls(places, surface);
    }
  }
  /// Lattice points in whole cells from the origin, at rest below a level surface.
  void still_water(Lattice lattice, long columns, long rows, bool hydrostatic_start = true);
  /// The same in columns from number `first` on, with a surface of its own.
  void water_at_rest(Lattice lattice, long first, long columns, long rows, bool hydrostatic_start = true);

  Scene scene;

 private:
  [[nodiscard]] std::vector<Place> lattice_frame(long columns, long wall_rows) const;
  void solid(const Place& place, double density, Kind kind);

  TaitFluid fluid_;
  double gravity_;
  double cell_mass_;      ///< rho_0 dx^2
  double particle_area_;  ///< of the lattice, in dx^2: of wall particles too
  Lattice lattice_;
  bool walls_continue_lattice_;
  long frame_cells_;  ///< thickness of walls that continue the lattice, in dx: the support
};

}  // namespace seiche::wcsph
