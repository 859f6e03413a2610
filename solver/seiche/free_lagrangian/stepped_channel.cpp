#include "seiche/free_lagrangian/stepped_channel.hpp"

#include <algorithm>
#include <cmath>

#include "seiche/require.hpp"

namespace seiche::free_lagrangian {

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
