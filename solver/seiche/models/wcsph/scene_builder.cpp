#include "seiche/models/wcsph/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"

namespace seiche::wcsph {
namespace {

/// Lengths are whole numbers of dx to this part of themselves.
constexpr double whole_number_tolerance = 1e-9;

/// A number of cells that fits no memory is a mistake in a length.
constexpr double most_cells = 1e9;

}  // namespace

SceneBuilder::SceneBuilder(double spacing, Lattice lattice, const Settings& settings)
    : fluid_(settings.density, settings.sound_speed, settings.exponent),
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

long SceneBuilder::whole(std::string_view name, double length, long least) {
  require_positive(name, length);
  const double steps = length / scene.spacing;
  const double rounded = std::round(steps);
  if (!(rounded >= static_cast<double>(least) && rounded <= most_cells)) {
    throw std::invalid_argument(fmt::format("{} = {:g} is {:g} spacings of {:g}: must be at least {} and at most {:g}",
                                            name, length, steps, scene.spacing, least, most_cells));
  }
  if (std::abs(steps - rounded) > whole_number_tolerance * rounded) {
    scene.warnings.push_back(fmt::format("{} = {:.12g} is {:.12g} spacings: rounded to {:.12g}", name, length, steps,
                                         rounded * scene.spacing));
  }
  return static_cast<long>(rounded);
}

double SceneBuilder::hydrostatic(double depth) const {
  return depth > 0 ? fluid_.hydrostatic_density(gravity_, depth) : fluid_.reference_density();
}

void SceneBuilder::fluid(const Place& place, double area, double density, const Velocity& velocity) {
  scene.particles.add(place.x, place.z, area * cell_mass_, density, Kind::fluid, velocity.u, velocity.w);
}

void SceneBuilder::still_water(Lattice lattice, long columns, long rows, bool hydrostatic_start) {
  scene.still_water = length(rows);
  water_at_rest(lattice, 0, columns, rows, hydrostatic_start);
}

void SceneBuilder::water_at_rest(Lattice lattice, long first, long columns, long rows, bool hydrostatic_start) {
  const double cells = static_cast<double>(columns) * static_cast<double>(rows);
  if (cells > most_cells) {
    throw std::invalid_argument(fmt::format("{} x {} cells of water at spacing = {:g}: must be at most {:g}", columns,
                                            rows, scene.spacing, most_cells));
  }
  const double level = length(rows);
  for (const Place& place : rectangle(lattice, scene.spacing, length(first), 0, columns, rows)) {
    fluid(place, particle_area_, hydrostatic(hydrostatic_start ? level - place.z : 0));
  }
}

std::vector<Place> SceneBuilder::lattice_frame(long columns, long wall_rows) const {
  const double far = length(columns);
  std::vector<Place> places = rectangle(lattice_, scene.spacing, -length(frame_cells_), -length(frame_cells_),
                                        columns + 2 * frame_cells_, wall_rows + frame_cells_);
  std::erase_if(places, [far](const Place& p) { return p.x > 0 && p.x < far && p.z > 0; });
  return places;
}

void SceneBuilder::solid(const Place& place, double density, Kind kind) {
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

}  // namespace seiche::wcsph
