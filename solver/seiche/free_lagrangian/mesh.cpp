#include "seiche/free_lagrangian/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/geometry/triangulation.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::free_lagrangian {

namespace {

constexpr double nearest = 1e-12;  // of a node to its wall, in extents of the mesh

double extent(const Mesh& mesh) {
  return largest(mesh.x) - smallest(mesh.x) + largest(mesh.y) - smallest(mesh.y);
}

/// Rows of nodes from the bottom up, the bottom with a step up to a shelf, or none.
struct Rows {
  int count = 1;  ///< spacings between rows
  int shelf = 0;  ///< row; beyond the last one: no step
  std::function<double(int row, double x)> height;
  std::function<bool(int row)> shifted;  ///< by half a column
  double begin = 0, step = 0, end = 0;
  int deep = 1, shallow = 0;  ///< columns before the step and behind it
};

enum { bottom_wall, left_wall, face, shelf_wall, right_wall };

Mesh mesh_of(const Rows& rows) {
  Mesh mesh;
  std::vector<int> floor, rise, shelf, right, top, left;
  for (int row = 0; row <= rows.count; ++row) {
    const bool shifted = rows.shifted(row);
    const int on_bottom = row == 0 ? bottom_wall : Held::by_none;
    const int on_shelf = row == rows.shelf ? shelf_wall : Held::by_none;
    const auto put = [&](double x, Held held) {
      mesh.x.push_back(x);
      mesh.y.push_back(rows.height(row, x));
      mesh.held.push_back(held);
      return static_cast<int>(mesh.nodes()) - 1;
    };
    const auto put_inside = [&](double begin, double end, int columns, int wall, std::vector<int>& along) {
      for (int i = shifted ? 0 : 1; i < columns; ++i) {
        const int node = put(begin + (shifted ? i + 0.5 : i) * ((end - begin) / columns), {wall});
        if (wall != Held::by_none) along.push_back(node);
        if (row == rows.count) top.push_back(node);
      }
    };
    left.push_back(put(rows.begin, {left_wall, on_bottom}));
    put_inside(rows.begin, rows.step, rows.deep, on_bottom, floor);
    if (row <= rows.shelf) rise.push_back(put(rows.step, {face, row == rows.shelf ? on_shelf : on_bottom}));
    if (row < rows.shelf) continue;
    if (row > rows.shelf && !shifted) {
      const int node = put(rows.step, {});
      if (row == rows.count) top.push_back(node);
    }
    put_inside(rows.step, rows.end, rows.shallow, on_shelf, shelf);
    right.push_back(put(rows.end, {right_wall, on_shelf}));
  }
  mesh.outline.push_back(left.front());
  for (const auto* part : {&floor, &rise, &shelf, &right}) {
    mesh.outline.insert(mesh.outline.end(), part->begin(), part->end());
  }
  mesh.outline.insert(mesh.outline.end(), top.rbegin(), top.rend());
  mesh.outline.insert(mesh.outline.end(), left.rbegin(), left.rend() - 1);
  return mesh;
}

}  // namespace

std::vector<bool> Mesh::on_outline() const {
  std::vector<bool> on(nodes());
  for (const int k : outline) on.at(static_cast<std::size_t>(k)) = true;
  return on;
}

void Mesh::require_valid() const {
  require_that(y.size() == nodes() && held.size() == nodes(),
               "the mesh has {} x, {} y and {} entries of held; allowed: as many", nodes(), y.size(), held.size());
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const Wall& wall = walls[w];
    const double length = std::hypot(wall.direction.x, wall.direction.y);
    require_positive(fmt::format("length of the direction of wall {}", w), length);
    require_finite(fmt::format("place of wall {}", w), wall.through.x + wall.through.y);
  }
  for (const int k : outline) {
    require_that(k >= 0 && static_cast<std::size_t>(k) < nodes(), "the outline names node {}; allowed: 0 to {}", k,
                 nodes() - 1);
  }
  const std::vector<bool> on = on_outline();
  for (std::size_t k = 0; k < nodes(); ++k) {
    for (const int w : {held[k].one, held[k].other}) {
      if (w == Held::by_none) continue;
      require_that(w >= 0 && static_cast<std::size_t>(w) < walls.size(),
                   "node {} is held by wall {}; there are {} walls, from 0", k, w, walls.size());
      require_that(on[k], "node {} is inside; allowed on walls: nodes of the outline", k);
      const Wall& wall = walls[static_cast<std::size_t>(w)];
      const double off =
          cross(Point{x[k], y[k]} - wall.through, wall.direction) / std::hypot(wall.direction.x, wall.direction.y);
      require_that(std::abs(off) <= nearest * extent(*this),
                   "node {} at ({:g}, {:g}) is {:g} off its wall {}; allowed: on it", k, x[k], y[k], std::abs(off), w);
    }
  }
}

Mesh layer_mesh(const Layer& layer) {
  require_finite("begin", layer.begin);
  require_positive("end - begin", layer.end - layer.begin);
  require_positive("level - bottom", layer.level - layer.bottom);
  require_at_least("columns", layer.columns, 1);
  require_at_least("rows", layer.rows, 1);
  Mesh mesh = mesh_of({.count = layer.rows,
                       .shelf = layer.rows + 1,
                       .height =
                           [&](int row, double x) {
                             const double top = layer.level + (layer.elevation ? layer.elevation(x) : 0.0);
                             require_that(top > layer.bottom,
                                          "no water at x = {:g}: its surface at {:g} is not above the bottom at {:g}",
                                          x, top, layer.bottom);
                             return row == layer.rows ? top : layer.bottom + (top - layer.bottom) * row / layer.rows;
                           },
                       .shifted = [&](int row) { return layer.staggered && row % 2 == 1 && row != layer.rows; },
                       .begin = layer.begin,
                       .step = layer.end,
                       .deep = layer.columns});
  mesh.walls = {{{layer.begin, layer.bottom}, {1, 0}}, {{layer.begin, layer.bottom}, {0, 1}}};
  if (layer.right_wall) {
    mesh.walls.push_back({{layer.end, layer.bottom}, {0, 1}});
  } else {
    for (Held& held : mesh.held) held = held.one == face ? Held{held.other} : held;
  }
  return mesh;
}

Mesh free_patch(int columns, int rows, Point lower, Point upper, bool staggered) {
  Mesh mesh = layer_mesh({.begin = lower.x,
                          .end = upper.x,
                          .bottom = lower.y,
                          .level = upper.y,
                          .columns = columns,
                          .rows = rows,
                          .staggered = staggered});
  mesh.walls.clear();
  mesh.held.assign(mesh.nodes(), {});
  return mesh;
}

Mesh stepped_channel_mesh(const SteppedChannel& channel) {
  require_finite("begin", channel.begin);
  require_positive("step - begin", channel.step - channel.begin);
  require_positive("end - step", channel.end - channel.step);
  require_finite("bottom", channel.bottom);
  require_positive("shelf - bottom", channel.shelf - channel.bottom);
  require_positive("level - shelf", channel.level - channel.shelf);
  require_at_least("rows", channel.rows, 2);
  const double spacing = (channel.level - channel.bottom) / channel.rows;
  const auto spacings = [&](double length) { return static_cast<int>(std::lround(std::max(length / spacing, 1.0))); };
  const int below = spacings(channel.shelf - channel.bottom);
  const int above = spacings(channel.level - channel.shelf);
  Mesh mesh = mesh_of({.count = below + above,
                       .shelf = below,
                       .height =
                           [&](int row, double) {
                             if (row == below + above) return channel.level;
                             if (row < below) return channel.bottom + (channel.shelf - channel.bottom) * row / below;
                             return channel.shelf + (channel.level - channel.shelf) * (row - below) / above;
                           },
                       .shifted = [&](int row) { return (below + above - row) % 2 != 0; },
                       .begin = channel.begin,
                       .step = channel.step,
                       .end = channel.end,
                       .deep = spacings(channel.step - channel.begin),
                       .shallow = spacings(channel.end - channel.step)});
  mesh.walls = {{{channel.begin, channel.bottom}, {1, 0}},
                {{channel.begin, channel.bottom}, {0, 1}},
                {{channel.step, channel.bottom}, {0, 1}},
                {{channel.step, channel.shelf}, {1, 0}},
                {{channel.end, channel.shelf}, {0, 1}}};
  return mesh;
}

}  // namespace seiche::free_lagrangian
