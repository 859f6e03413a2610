#include <algorithm>
#include <array>
#include <cmath>

#include "seiche/models/wcsph/scene_builder.hpp"
#include "seiche/require.hpp"

namespace seiche::wcsph {
namespace {

/// How far behind its place at rest the paddle comes, its rows of particles included.
double reach_behind(const Flume& flume, double paddle_top) {
  const double amplitude = flume.stroke / 2;
  const double rows = flume.spacing * flume.paddle_rows;
  if (flume.wavemaking == Wavemaking::piston) return amplitude + rows;
  const double depth = flume.depth - flume.hinge;
  return (paddle_top - flume.hinge) * amplitude / std::hypot(amplitude, depth) + rows;
}

}  // namespace

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
  require_within("hinge", parameters.hinge, -10 * parameters.depth, 0);
  const double paddle_top = builder.length(paddle_height) + half;
  const double sweep = parameters.sweep.value_or(reach_behind(parameters, paddle_top));
  require_not_negative("sweep", sweep);
  require_within("stroke", parameters.stroke, 0, 2 * sweep);

  builder.still_water(parameters.lattice, columns, rows);
  Scene& scene = builder.scene;
  scene.far_wall = builder.length(columns);
  scene.paddles.push_back(
      parameters.wavemaking == Wavemaking::piston
          ? piston(parameters.stroke, parameters.frequency)
          : flap(0, parameters.hinge, scene.still_water - parameters.hinge, parameters.stroke, parameters.frequency));
  const auto surface = [&](double) { return scene.still_water; };
  const double behind = builder.length(static_cast<long>(std::ceil(sweep / spacing))) + half;
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

}  // namespace seiche::wcsph
