#include "seiche/plan_lattice/sides.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::plan_lattice {

namespace {

/// Directions closer than this are one: far above round-off, far below any bend that is meant.
constexpr double parallel = 1e-9;

/// Unit vector.
Point direction(std::size_t from, std::size_t to, std::span<const double> x, std::span<const double> y) {
  const Point way{x[to] - x[from], y[to] - y[from]};
  const double length = std::hypot(way.x, way.y);
  require_that(length > 0, "nodes {} and {} of a side coincide at ({:g}, {:g})", from, to, x[to], y[to]);
  return {way.x / length, way.y / length};
}

std::array<const Side*, 4> in_order(const Sides& sides) {
  return {&sides.south, &sides.east, &sides.north, &sides.west};
}

void bind(BoundNode& bound, Point normal, const DrivenSide* driven, std::array<std::size_t, 2> chord) {
  if (bound.directions == 2) return;
  if (bound.directions == 1 && std::abs(cross(bound.normal[0], normal)) < parallel) return;
  bound.normal[bound.directions] = normal;
  bound.driven[bound.directions] = driven;
  bound.chord[bound.directions] = chord;
  ++bound.directions;
}

void hold(BoundNode& bound) {
  bound.directions = 0;
  bind(bound, {1, 0}, nullptr, {});
  bind(bound, {0, 1}, nullptr, {});
}

}  // namespace

void require_ascending(std::string_view first, double begin, std::string_view last, double end) {
  require_finite(first, begin);
  require_finite(last, end);
  require_that(end > begin, "{} = {:g}; allowed: above {} = {:g}", last, end, first, begin);
}

void require_places(const Shape& shape, long columns, std::size_t levels,
                    std::initializer_list<std::pair<std::string_view, std::span<const double>>> places) {
  require_at_least("columns", static_cast<long>(shape.columns), columns);
  require_at_least("rows", static_cast<long>(shape.rows), 1);
  for (const auto& [name, values] : places) {
    const std::size_t count = levels * shape.nodes();
    require_that(values.size() == count, "{} has {} values; allowed: {}, one per node of {} x {} cells", name,
                 values.size(), count, shape.columns, shape.rows);
    for (std::size_t k = 0; k < count; ++k) {
      require_that(std::isfinite(values[k]), "{}[{}] of node {} is {}; allowed: finite", name, k, k, values[k]);
    }
  }
}

std::array<std::vector<std::size_t>, 4> nodes_around(Shape shape) {
  std::array<std::vector<std::size_t>, 4> walks;
  for (std::size_t i = 0; i <= shape.columns; ++i) {
    walks[0].push_back(shape.node(i, 0));
    walks[2].push_back(shape.node(shape.columns - i, shape.rows));
  }
  for (std::size_t j = 0; j <= shape.rows; ++j) {
    walks[1].push_back(shape.node(shape.columns, j));
    walks[3].push_back(shape.node(0, shape.rows - j));
  }
  return walks;
}

Point chord_normal(const std::array<std::size_t, 2>& chord, std::span<const double> x, std::span<const double> y) {
  const Point way = direction(chord[0], chord[1], x, y);
  return {way.y, -way.x};
}

std::vector<BoundNode> bound_nodes(Shape shape, const Sides& sides, std::span<const double> x,
                                   std::span<const double> y, bool shores) {
  std::vector<BoundNode> all(shape.nodes());
  for (std::size_t k = 0; k < all.size(); ++k) all[k].node = k;
  const auto require_no_outward_bend = [&](std::size_t before, std::size_t node, std::size_t after) {
    require_that(!(cross(direction(before, node, x, y), direction(node, after, x, y)) < -parallel),
                 "the wall bends outwards at ({:g}, {:g}), node {}; allowed: interior "
                 "angles of at most 180 degrees, or a held side",
                 x[node], y[node], node);
  };
  const auto walks = nodes_around(shape);
  for (std::size_t s = 0; s < walks.size(); ++s) {
    const Side& side = *in_order(sides)[s];
    const std::vector<std::size_t>& nodes = walks[s];
    if (std::holds_alternative<FreeSide>(side)) continue;
    if (std::holds_alternative<ShoreSide>(side)) {
      require_that(shores, "a side is a shoreline; allowed in this model: wall, held, driven, free");
      for (const std::size_t k : nodes) all[k].shore = true;
      continue;
    }
    if (std::holds_alternative<HeldSide>(side)) {
      for (const std::size_t k : nodes) hold(all[k]);
      continue;
    }
    const auto* driven = std::get_if<DrivenSide>(&side);
    require_that(driven == nullptr || driven->velocity,
                 "a driven side has no velocity; allowed: a function of place and time");
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const std::size_t before = nodes[k == 0 ? 0 : k - 1];
      const std::size_t after = nodes[std::min(k + 1, nodes.size() - 1)];
      BoundNode& bound = all[nodes[k]];
      if (driven != nullptr) {
        bind(bound, chord_normal({before, after}, x, y), driven, {before, after});
        continue;
      }
      if (k > 0) bind(bound, chord_normal({before, nodes[k]}, x, y), nullptr, {});
      if (k + 1 < nodes.size()) bind(bound, chord_normal({nodes[k], after}, x, y), nullptr, {});
      if (k > 0 && k + 1 < nodes.size()) require_no_outward_bend(before, nodes[k], after);
    }
    const std::size_t next = (s + 1) % walks.size();
    if (driven == nullptr && std::holds_alternative<WallSide>(*in_order(sides)[next])) {
      require_no_outward_bend(nodes[nodes.size() - 2], nodes.back(), walks[next][1]);
    }
  }
  std::erase_if(all, [](const BoundNode& bound) { return bound.directions == 0 && !bound.shore; });
  return all;
}

std::vector<std::array<std::size_t, 2>> shore_edges(Shape shape, const Sides& sides) {
  std::vector<std::array<std::size_t, 2>> edges;
  const auto walks = nodes_around(shape);
  for (std::size_t s = 0; s < walks.size(); ++s) {
    if (!std::holds_alternative<ShoreSide>(*in_order(sides)[s])) continue;
    for (std::size_t k = 0; k + 1 < walks[s].size(); ++k) edges.push_back({walks[s][k], walks[s][k + 1]});
  }
  return edges;
}

}  // namespace seiche::plan_lattice
