#include "seiche/models/wcsph/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "seiche/models/wcsph/settings.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::wcsph {
namespace {

/// Lengths are whole numbers of dx to this part of themselves.
constexpr double whole_number_tolerance = 1e-9;

/// A number of cells that fits no memory is a mistake in a length.
constexpr double most_cells = 1e9;

/// What all scenes have in common: lengths in whole spacings, densities, masses, walls.
class SceneBuilder {
 public:
  SceneBuilder(double spacing, Lattice lattice, const Settings& settings)
      : fluid_(settings.density, settings.sound_speed),
        gravity_(settings.gravity),
        cell_mass_(settings.density * spacing * spacing),
        particle_area_(area_per_particle(lattice)),
        lattice_(lattice),
        walls_continue_lattice_(settings.walls == WallPressure::extrapolated),
        frame_cells_(static_cast<long>(std::ceil(support * settings.smoothing))) {
    require_positive("spacing", spacing);
    require_not_negative("gravity", gravity_);
    scene.spacing = spacing;
  }

  /// Length in dx, rounded with a warning where it is no whole number.
  long whole(std::string_view name, double length, long least = 1) {
    require_positive(name, length);
    const double steps = length / scene.spacing;
    const double rounded = std::round(steps);
    require_that(rounded >= static_cast<double>(least) && rounded <= most_cells,
                 "{} = {:g} is {:g} spacings of {:g}: must be at least {} and at most {:g}", name, length, steps,
                 scene.spacing, least, most_cells);
    if (std::abs(steps - rounded) > whole_number_tolerance * rounded) {
      scene.warnings.push_back(fmt::format("{} = {:.12g} is {:.12g} spacings: rounded to {:.12g}", name, length, steps,
                                           rounded * scene.spacing));
    }
    return static_cast<long>(rounded);
  }
  [[nodiscard]] double length(long steps) const { return static_cast<double>(steps) * scene.spacing; }

  /// rho in still water, rho_0 above its surface.
  [[nodiscard]] double hydrostatic(double depth) const {
    return depth > 0 ? fluid_.hydrostatic_density(gravity_, depth) : fluid_.reference_density();
  }
  [[nodiscard]] double density_at(double pressure) const { return fluid_.density_at(pressure); }

  /// A particle that stands for an area of dx^2 times `area`.
  void fluid(const Place& place, double area, double density, const Velocity& velocity = {0, 0}) {
    scene.particles.add(place.x, place.z, area * cell_mass_, density, Kind::fluid, velocity.u, velocity.w);
  }
  /// Walls beside water that reaches up to `surface`; paddle particles with the velocity of scene.paddles.back().
  template <class Surface>
  void walls(std::span<const Place> places, Surface surface, Kind kind = Kind::wall) {
    for (const Place& place : places) solid(place, hydrostatic(surface(place.x) - place.z), kind);
  }
  /// Walls of an open basin, columns x wall_height cells from the origin, up to `top`: staggered rows; or, for
  /// pressures that are extrapolated and have to fill the whole support, the lattice of the water continued behind the
  /// walls.
  template <class Surface>
  void enclose(long columns, long wall_height, double top, int rows, bool corners_twice, Surface surface) {
    const double half = scene.spacing / 2;
    const double far = scene.far_wall = length(columns);
    const std::array<Place, 4> corners{{{-half, top}, {-half, -half}, {far + half, -half}, {far + half, top}}};
    walls(walls_continue_lattice_ ? lattice_frame(columns, wall_height)
                                  : wall(corners, scene.spacing, rows, corners_twice),
          surface);
    const double back = walls_continue_lattice_ ? length(frame_cells_) : half * rows;
    scene.extents = {-back, far + back, -back, top};
  }
  /// The same of a level bottom alone that repeats itself, `columns` cells long; the first row has its particles below
  /// those of the square lattice.
  template <class Surface>
  void bottom(long columns, int rows, Surface surface) {
    if (walls_continue_lattice_) {
      walls(rectangle(lattice_, scene.spacing, 0, -length(frame_cells_), columns, frame_cells_), surface);
      return;
    }
    std::vector<Place> places;
    for (int row = 0; row < rows; ++row) {
      for (long i = 0; i < columns; ++i) {
        const double x = (static_cast<double>(i) + (row % 2 == 0 ? 0.5 : 0)) * scene.spacing;
        places.push_back({x, -(row + 1) * scene.spacing / 2});
      }
    }
    walls(places, surface);
  }
  /// Lattice points in whole cells from the origin, at rest below a level surface.
  void still_water(long columns, long rows) {
    scene.still_water = length(rows);
    water_at_rest(0, columns, rows);
  }
  /// The same in columns from number `first` on, with a surface of its own.
  void water_at_rest(long first, long columns, long rows) {
    const double cells = static_cast<double>(columns) * static_cast<double>(rows);
    require_that(cells <= most_cells, "{} x {} cells of water at spacing = {:g}: must be at most {:g}", columns, rows,
                 scene.spacing, most_cells);
    const double level = length(rows);
    for (const Place& place : rectangle(lattice_, scene.spacing, length(first), 0, columns, rows)) {
      fluid(place, particle_area_, hydrostatic(level - place.z));
    }
  }

  Scene scene;

 private:
  [[nodiscard]] std::vector<Place> lattice_frame(long columns, long wall_rows) const {
    const double far = length(columns);
    std::vector<Place> places = rectangle(lattice_, scene.spacing, -length(frame_cells_), -length(frame_cells_),
                                          columns + 2 * frame_cells_, wall_rows + frame_cells_);
    std::erase_if(places, [far](const Place& p) { return p.x > 0 && p.x < far && p.z > 0; });
    return places;
  }
  void solid(const Place& place, double density, Kind kind) {
    Velocity velocity{0, 0};
    if (kind == Kind::paddle) {
      const Paddle& paddle = scene.paddles.back();
      const PointMotion motion =
          carried(paddle.pose(0), paddle.rate(0), paddle.hinge_x, paddle.hinge_z, place.x, place.z);
      velocity = {motion.u, motion.w};
    }
    const auto body = static_cast<std::int32_t>(kind == Kind::paddle ? scene.paddles.size() - 1 : 0);
    scene.particles.add(place.x, place.z, particle_area_ * cell_mass_, density, kind, velocity.u, velocity.w,
                        kind == Kind::paddle ? body : -1);
  }

  TaitFluid fluid_;
  double gravity_;
  double cell_mass_;      ///< rho_0 dx^2
  double particle_area_;  ///< of the lattice, in dx^2: of wall particles too
  Lattice lattice_;
  bool walls_continue_lattice_;
  long frame_cells_;  ///< thickness of walls that continue the lattice, in dx: the support
};

constexpr double dry = -std::numeric_limits<double>::infinity();

}  // namespace

Scene dam_break(const DamBreak& dam, const Settings& settings) {
  SceneBuilder builder(dam.spacing, dam.lattice, settings);
  const long columns = builder.whole("width", dam.width);
  const long rows = builder.whole("height", dam.height);
  const long tank = builder.whole("tank_length", dam.tank_length, 2);
  const long wall_height = builder.whole("wall_height", dam.wall_height);
  require_within("width", builder.length(columns), dam.spacing, builder.length(tank - 1));
  require_within("height", builder.length(rows), dam.spacing, builder.length(wall_height));
  require_within("wall_rows", dam.wall_rows, 1, 3);
  require_within("water_ahead", dam.water_ahead, 0, dam.height);
  const long rows_ahead = dam.water_ahead > 0 ? builder.whole("water_ahead", dam.water_ahead) : 0;

  builder.still_water(columns, rows);
  if (rows_ahead > 0) builder.water_at_rest(columns, tank - 1 - columns, rows_ahead);
  const double column_end = builder.length(columns);
  const double level_ahead = rows_ahead > 0 ? builder.length(rows_ahead) : dry;
  const auto surface = [&](double x) { return x <= column_end ? builder.scene.still_water : level_ahead; };
  builder.enclose(tank - 1, wall_height, builder.length(wall_height) - dam.spacing / 2, dam.wall_rows,
                  dam.corners_twice, surface);
  return std::move(builder.scene);
}

Scene tank(const Tank& parameters, const Settings& settings) {
  SceneBuilder builder(parameters.spacing, parameters.lattice, settings);
  const long columns = builder.whole("width", parameters.width);
  const long rows = builder.whole("depth", parameters.depth);
  require_not_negative("wall_height", parameters.wall_height);
  const long wall_height =
      parameters.wall_height > 0 ? builder.whole("wall_height", parameters.wall_height, rows) : rows + 4;
  require_within("wall_rows", parameters.wall_rows, 1, 3);

  builder.still_water(columns, rows);
  builder.enclose(columns, wall_height, builder.length(wall_height) + parameters.spacing / 2, parameters.wall_rows,
                  false, [&](double) { return builder.scene.still_water; });
  return std::move(builder.scene);
}

Scene patch(const Patch& parameters, const Settings& settings) {
  SceneBuilder builder(parameters.spacing, parameters.lattice, settings);
  Box box = parameters.box;
  std::function<bool(double, double)> inside = parameters.inside;
  if (!inside) {
    const double radius = parameters.radius;
    require_positive("radius", radius);
    const double reach = std::ceil(radius / parameters.spacing) * parameters.spacing;
    box = {-reach, reach, -reach, reach};
    inside = [radius](double x, double z) { return x * x + z * z <= radius * radius; };
  }
  const std::vector<Place> places = shape(parameters.lattice, parameters.spacing, box, inside);
  require_at_least("particles in the patch", static_cast<long>(places.size()), 1);
  for (const Place& place : places) {
    const double pressure = parameters.pressure ? parameters.pressure(place.x, place.z) : 0;
    builder.fluid(place, area_per_particle(parameters.lattice), builder.density_at(pressure),
                  parameters.velocity ? parameters.velocity(place.x, place.z) : Velocity{0, 0});
  }
  return std::move(builder.scene);
}

Scene flume(const Flume& parameters, const Settings& settings) {
  SceneBuilder builder(parameters.spacing, parameters.lattice, settings);
  const double spacing = parameters.spacing;
  const double half = spacing / 2;
  const long columns = builder.whole("length", parameters.length);
  const long rows = builder.whole("depth", parameters.depth);
  require_not_negative("wall_height", parameters.wall_height);
  require_not_negative("paddle_height", parameters.paddle_height);
  const long wall_height =
      parameters.wall_height > 0 ? builder.whole("wall_height", parameters.wall_height, rows) : 2 * rows;
  const long paddle_height =
      parameters.paddle_height > 0 ? builder.whole("paddle_height", parameters.paddle_height, rows) : wall_height;
  require_within("wall_rows", parameters.wall_rows, 1, 3);
  require_within("paddle_rows", parameters.paddle_rows, 1, 3);
  require_within("stroke", parameters.stroke, 0, parameters.length);
  const double paddle_top = builder.length(paddle_height) + half;
  const bool piston_moves = parameters.wavemaking == Wavemaking::piston;

  builder.still_water(columns, rows);
  Scene& scene = builder.scene;
  scene.far_wall = builder.length(columns);
  scene.paddles.push_back(piston_moves ? piston(parameters.stroke, parameters.frequency)
                                       : flap(0, 0, scene.still_water, parameters.stroke, parameters.frequency));
  const auto surface = [&](double) { return scene.still_water; };
  // How far behind its place at rest the paddle comes, its rows of particles included.
  const double amplitude = parameters.stroke / 2;
  const double turned = paddle_top * amplitude / std::hypot(amplitude, parameters.depth);
  const double reach = (piston_moves ? amplitude : turned) + spacing * parameters.paddle_rows;
  const double behind = builder.length(static_cast<long>(std::ceil(reach / spacing))) + half;
  const double top = builder.length(wall_height) + half;
  const std::array<Place, 3> standing{{{-behind, -half}, {scene.far_wall + half, -half}, {scene.far_wall + half, top}}};
  builder.walls(wall(standing, spacing, parameters.wall_rows), surface);
  // The paddle begins where the water does: its lowest particle is one spacing above the row of the bottom.
  const std::array<Place, 2> moving{{{-half, paddle_top}, {-half, half}}};
  builder.walls(wall(moving, spacing, parameters.paddle_rows), surface, Kind::paddle);
  const double back = half * parameters.wall_rows;
  scene.extents = {-behind, scene.far_wall + back, -back, std::max(top, paddle_top)};
  return std::move(builder.scene);
}

Scene periodic_layer(const PeriodicLayer& layer, const Settings& settings) {
  SceneBuilder builder(layer.spacing, layer.lattice, settings);
  const long columns = builder.whole("period", layer.period, 3);
  require_positive("depth", layer.depth);
  require_at_least("particles in the depth", std::lround(layer.depth / layer.spacing), 1);
  require_within("wall_rows", layer.wall_rows, 1, 3);
  const double spacing = layer.spacing;
  const auto depth = [&](double x) {
    const double elevation = layer.elevation ? layer.elevation(x) : 0;
    require_that(std::isfinite(elevation) && elevation > -layer.depth,
                 "elevation = {:g} at x = {:g} is out of range: must be finite and above {:g}, the bottom", elevation,
                 x, -layer.depth);
    return layer.depth + elevation;
  };

  for (const LatticeLine& line : lattice_lines(layer.lattice, spacing, 0, columns)) {
    // Mean over the strip of the line, by Gauss's rule of three points.
    const double offset = std::sqrt(0.6) * line.width / 2;
    const double water = (5 * depth(line.x - offset) + 8 * depth(line.x) + 5 * depth(line.x + offset)) / 18;
    const long count = std::max(1L, std::lround(water / spacing));
    const double step = water / static_cast<double>(count);
    for (long k = 0; k < count; ++k) {
      const Place place{line.x, (static_cast<double>(k) + line.offset) * step};
      const double density =
          layer.pressure ? builder.density_at(layer.pressure(place.x, place.z)) : builder.hydrostatic(water - place.z);
      builder.fluid(place, line.width * step / (spacing * spacing), density,
                    layer.velocity ? layer.velocity(place.x, place.z) : Velocity{0, 0});
    }
  }
  Scene& scene = builder.scene;
  scene.period.x = builder.length(columns);
  scene.far_wall = scene.period.x;
  scene.still_water = layer.depth;
  builder.bottom(columns, layer.wall_rows, depth);
  scene.extents.bottom = -spacing / 2 * layer.wall_rows;
  return std::move(builder.scene);
}

}  // namespace seiche::wcsph
