#include "seiche/free_lagrangian/mesh.hpp"

#include <algorithm>
#include <cmath>
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

/// Rows of nodes, and the nodes at their ends.
struct Rows {
  Mesh mesh;
  std::vector<int> left, right;  // from the bottom up
  std::vector<int> bottom, top;  // without the ends
};

void require_layer(const Layer& layer) {
  require_finite("begin", layer.begin);
  require_positive("end - begin", layer.end - layer.begin);
  require_positive("level - bottom", layer.level - layer.bottom);
  require_at_least("columns", layer.columns, 1);
  require_at_least("rows", layer.rows, 1);
}

Rows rows_of(const Layer& layer) {
  require_layer(layer);
  Rows rows;
  const double width = (layer.end - layer.begin) / layer.columns;
  const auto put = [&](double x, int j) {
    const double top = layer.level + (layer.elevation ? layer.elevation(x) : 0.0);
    require_that(top > layer.bottom, "no water at x = {:g}: its surface at {:g} is not above the bottom at {:g}", x,
                 top, layer.bottom);
    rows.mesh.x.push_back(x);
    rows.mesh.y.push_back(j == layer.rows ? top : layer.bottom + (top - layer.bottom) * j / layer.rows);
    return static_cast<int>(rows.mesh.nodes()) - 1;
  };
  for (int j = 0; j <= layer.rows; ++j) {
    const bool shifted = layer.staggered && j % 2 == 1 && j != layer.rows;
    rows.left.push_back(put(layer.begin, j));
    for (int i = shifted ? 0 : 1; i < layer.columns; ++i) {
      const int node = put(layer.begin + (shifted ? i + 0.5 : i) * width, j);
      if (j == 0) rows.bottom.push_back(node);
      if (j == layer.rows) rows.top.push_back(node);
    }
    rows.right.push_back(put(layer.end, j));
  }
  std::vector<int>& outline = rows.mesh.outline;
  outline.push_back(rows.left.front());
  outline.insert(outline.end(), rows.bottom.begin(), rows.bottom.end());
  outline.insert(outline.end(), rows.right.begin(), rows.right.end());
  outline.insert(outline.end(), rows.top.rbegin(), rows.top.rend());
  outline.insert(outline.end(), rows.left.rbegin(), rows.left.rend() - 1);
  rows.mesh.held.resize(rows.mesh.nodes());
  return rows;
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
      const double off = ((x[k] - wall.through.x) * wall.direction.y - (y[k] - wall.through.y) * wall.direction.x) /
                         std::hypot(wall.direction.x, wall.direction.y);
      require_that(std::abs(off) <= nearest * extent(*this),
                   "node {} at ({:g}, {:g}) is {:g} off its wall {}; allowed: on it", k, x[k], y[k], std::abs(off), w);
    }
  }
}

Mesh layer_mesh(const Layer& layer) {
  Rows rows = rows_of(layer);
  Mesh& mesh = rows.mesh;
  enum { bottom, left, right };
  mesh.walls = {{{layer.begin, layer.bottom}, {1, 0}}, {{layer.begin, layer.bottom}, {0, 1}}};
  if (layer.right_wall) mesh.walls.push_back({{layer.end, layer.bottom}, {0, 1}});
  const auto held = [&](int node) -> Held& { return mesh.held[static_cast<std::size_t>(node)]; };
  for (const int node : rows.bottom) held(node).one = bottom;
  for (const int node : rows.left) held(node).one = left;
  if (layer.right_wall) {
    for (const int node : rows.right) held(node).one = right;
    held(rows.right.front()).other = bottom;
  } else {
    held(rows.right.front()).one = bottom;
  }
  held(rows.left.front()).other = bottom;
  return std::move(rows.mesh);
}

Mesh free_patch(int columns, int rows, Point lower, Point upper, bool staggered) {
  return rows_of({.begin = lower.x,
                  .end = upper.x,
                  .bottom = lower.y,
                  .level = upper.y,
                  .columns = columns,
                  .rows = rows,
                  .staggered = staggered})
      .mesh;
}

namespace {

enum { bottom_wall, left_wall, face, shelf_wall, right_wall };

void require_channel(const SteppedChannel& channel) {
  require_finite("begin", channel.begin);
  require_positive("step - begin", channel.step - channel.begin);
  require_positive("end - step", channel.end - channel.step);
  require_finite("bottom", channel.bottom);
  require_positive("shelf - bottom", channel.shelf - channel.bottom);
  require_positive("level - shelf", channel.level - channel.shelf);
  require_at_least("rows", channel.rows, 2);
}

int rounded(double count) {
  return static_cast<int>(std::lround(std::max(count, 1.0)));
}

}  // namespace

Mesh stepped_channel_mesh(const SteppedChannel& channel) {
  require_channel(channel);
  const double spacing = (channel.level - channel.bottom) / channel.rows;
  const int below = rounded((channel.shelf - channel.bottom) / spacing);
  const int above = rounded((channel.level - channel.shelf) / spacing);
  const int deep = rounded((channel.step - channel.begin) / spacing);
  const int shallow = rounded((channel.end - channel.step) / spacing);
  const double deep_width = (channel.step - channel.begin) / deep;
  const double shallow_width = (channel.end - channel.step) / shallow;

  Mesh mesh;
  std::vector<int> floor, rise, shelf, right, top, left;
  const auto put = [&](double x, double y, Held held) {
    mesh.x.push_back(x);
    mesh.y.push_back(y);
    mesh.held.push_back(held);
    return static_cast<int>(mesh.nodes()) - 1;
  };
  for (int row = 0; row <= below + above; ++row) {
    const bool is_floor = row == 0;
    const bool is_shelf = row == below;
    const bool is_top = row == below + above;
    const bool shifted = (below + above - row) % 2 != 0;
    const double y = is_top        ? channel.level
                     : row < below ? channel.bottom + (channel.shelf - channel.bottom) * row / below
                                   : channel.shelf + (channel.level - channel.shelf) * (row - below) / above;
    left.push_back(put(channel.begin, y, {left_wall, is_floor ? bottom_wall : Held::by_none}));
    for (int i = shifted ? 0 : 1; i < deep; ++i) {
      const int node =
          put(channel.begin + (shifted ? i + 0.5 : i) * deep_width, y, {is_floor ? bottom_wall : Held::by_none});
      if (is_floor) floor.push_back(node);
      if (is_top) top.push_back(node);
    }
    if (row < below) {
      rise.push_back(put(channel.step, y, {face, is_floor ? bottom_wall : Held::by_none}));
      continue;
    }
    if (is_shelf) {
      rise.push_back(put(channel.step, y, {face, shelf_wall}));
    } else if (!shifted) {
      const int node = put(channel.step, y, {});
      if (is_top) top.push_back(node);
    }
    for (int i = shifted ? 0 : 1; i < shallow; ++i) {
      const int node =
          put(channel.step + (shifted ? i + 0.5 : i) * shallow_width, y, {is_shelf ? shelf_wall : Held::by_none});
      if (is_shelf) shelf.push_back(node);
      if (is_top) top.push_back(node);
    }
    right.push_back(put(channel.end, y, {right_wall, is_shelf ? shelf_wall : Held::by_none}));
  }
  mesh.walls = {{{channel.begin, channel.bottom}, {1, 0}},
                {{channel.begin, channel.bottom}, {0, 1}},
                {{channel.step, channel.bottom}, {0, 1}},
                {{channel.step, channel.shelf}, {1, 0}},
                {{channel.end, channel.shelf}, {0, 1}}};
  mesh.outline.push_back(left.front());
  for (const auto* part : {&floor, &rise, &shelf, &right}) {
    mesh.outline.insert(mesh.outline.end(), part->begin(), part->end());
  }
  mesh.outline.insert(mesh.outline.end(), top.rbegin(), top.rend());
  mesh.outline.insert(mesh.outline.end(), left.rbegin(), left.rend() - 1);
  return mesh;
}

}  // namespace seiche::free_lagrangian
