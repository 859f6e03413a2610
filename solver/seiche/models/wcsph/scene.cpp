#include "seiche/models/wcsph/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "seiche/models/wcsph/scene_builder.hpp"
#include "seiche/require.hpp"

namespace seiche::wcsph {
namespace {

constexpr double dry = -std::numeric_limits<double>::infinity();

/// Corners of an open basin from the top of the rear wall to that of the far one; places of the front rows.
std::array<Place, 4> basin(double left, double right, double bottom, double top) {
  return {{{left, top}, {left, bottom}, {right, bottom}, {right, top}}};
}

}  // namespace

Scene dam_break(const DamBreak& dam, const Settings& settings) {
  SceneBuilder builder(dam.spacing, dam.lattice, settings);
  const double half = dam.spacing / 2;
  const long columns = builder.whole("width", dam.width);
  const long rows = builder.whole("height", dam.height);
  const long tank = builder.whole("tank_length", dam.tank_length, 2);
  const long wall_height = builder.whole("wall_height", dam.wall_height);
  require_within("width", builder.length(columns), dam.spacing, builder.length(tank - 1));
  require_within("height", builder.length(rows), dam.spacing, builder.length(wall_height));
  require_within("wall_rows", dam.wall_rows, 1, 3);
  require_within("water_ahead", dam.water_ahead, 0, dam.height);
  const long rows_ahead = dam.water_ahead > 0 ? builder.whole("water_ahead", dam.water_ahead) : 0;

  builder.still_water(dam.lattice, columns, rows, dam.hydrostatic);
  if (rows_ahead > 0) builder.water_at_rest(dam.lattice, columns, tank - 1 - columns, rows_ahead, dam.hydrostatic);
  Scene& scene = builder.scene;
  scene.far_wall = builder.length(tank - 1);
  const std::array<Place, 4> corners = basin(-half, scene.far_wall + half, -half, builder.length(wall_height) - half);
  const double column_end = builder.length(columns);
  const double level_ahead = rows_ahead > 0 ? builder.length(rows_ahead) : dry;
  const auto surface = [&](double x) {
    if (!dam.hydrostatic) return dry;
    return x <= column_end ? scene.still_water : level_ahead;
  };
  const double back = builder.basin_walls(corners, tank - 1, wall_height, {dam.wall_rows, dam.corners_twice}, surface);
  scene.extents = {-back, scene.far_wall + back, -back, corners[0].z};
  return std::move(builder.scene);
}

Scene tank(const Tank& parameters, const Settings& settings) {
  SceneBuilder builder(parameters.spacing, parameters.lattice, settings);
  const double half = parameters.spacing / 2;
  const long columns = builder.whole("width", parameters.width);
  const long rows = builder.whole("depth", parameters.depth);
  require_not_negative("wall_height", parameters.wall_height);
  const long wall_height =
      parameters.wall_height > 0 ? builder.whole("wall_height", parameters.wall_height, rows) : rows + 4;
  require_within("wall_rows", parameters.wall_rows, 1, 3);

  builder.still_water(parameters.lattice, columns, rows, parameters.hydrostatic);
  Scene& scene = builder.scene;
  scene.far_wall = builder.length(columns);
  const std::array<Place, 4> corners = basin(-half, scene.far_wall + half, -half, builder.length(wall_height) + half);
  const double back = builder.basin_walls(corners, columns, wall_height, {parameters.wall_rows},
                                          [&](double) { return parameters.hydrostatic ? scene.still_water : dry; });
  scene.extents = {-back, scene.far_wall + back, -back, corners[0].z};
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

}  // namespace seiche::wcsph
