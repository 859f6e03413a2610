#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/models/wcsph/scene_builder.hpp"
#include "seiche/require.hpp"

namespace seiche::wcsph {
namespace {

/// Depth of the water below its surface.
class Depth {
 public:
  explicit Depth(const PeriodicLayer& layer) : layer_(layer) {}

  [[nodiscard]] double at(double x) const {
    const double elevation = layer_.elevation ? layer_.elevation(x) : 0;
    if (!(std::isfinite(elevation) && elevation > -layer_.depth)) {
      throw std::invalid_argument(
          fmt::format("elevation = {:g} at x = {:g} is out of range: must be finite and above {:g}, the bottom",
                      elevation, x, -layer_.depth));
    }
    return layer_.depth + elevation;
  }
  /// Mean over the strip of a line, by Gauss's rule of three points.
  [[nodiscard]] double mean(const LatticeLine& line) const {
    const double offset = std::sqrt(0.6) * line.width / 2;
    return (5 * at(line.x - offset) + 8 * at(line.x) + 5 * at(line.x + offset)) / 18;
  }

 private:
  const PeriodicLayer& layer_;
};

/// How many particles stand on a line in water that is so many dx deep.
long particles_on(const LatticeLine& line, double depth, Fitting fitting, long undisturbed) {
  if (fitting == Fitting::stretched) return undisturbed;
  if (fitting == Fitting::columns) return std::max(1L, std::lround(depth));
  return static_cast<long>(std::ceil(depth - line.offset));
}

/// The rows of a level bottom that repeats itself; the first row has its particles below those of the square lattice.
std::vector<Place> periodic_bottom(double spacing, long columns, int rows) {
  std::vector<Place> places;
  for (int row = 0; row < rows; ++row) {
    for (long i = 0; i < columns; ++i) {
      places.push_back({(static_cast<double>(i) + (row % 2 == 0 ? 0.5 : 0)) * spacing, -(row + 1) * spacing / 2});
    }
  }
  return places;
}

}  // namespace

Scene periodic_layer(const PeriodicLayer& layer, const Settings& settings) {
  SceneBuilder builder(layer.spacing, layer.lattice, settings);
  const long columns = builder.whole("period", layer.period, 3);
  require_positive("depth", layer.depth);
  const long rows = layer.fitting == Fitting::stretched ? builder.whole("depth", layer.depth)
                                                        : std::lround(layer.depth / layer.spacing);
  require_at_least("particles in the depth", rows, 1);
  require_within("wall_rows", layer.wall_rows, 1, 3);
  const double spacing = layer.spacing;
  const Depth depth(layer);

  for (const LatticeLine& line : lattice_lines(layer.lattice, spacing, 0, columns)) {
    const double water = depth.mean(line);
    const long count = particles_on(line, water / spacing, layer.fitting, rows);
    const double step = layer.fitting == Fitting::cut ? spacing : water / static_cast<double>(count);
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
  builder.bottom(periodic_bottom(spacing, columns, layer.wall_rows), columns, [&](double x) { return depth.at(x); });
  scene.extents.bottom = -spacing / 2 * layer.wall_rows;
  return std::move(builder.scene);
}

}  // namespace seiche::wcsph
