#include "seiche/geometry/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/predicates.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche {

namespace {

/// An edge of a triangle by its lower and its upper vertex.
struct Side {
  int lower, upper;
  int triangle;
  int opposite;  // vertex, 0 to 2
  bool ascends;
};

std::vector<Side> sides_of(std::span<const Triangle> triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    const auto& v = triangles[static_cast<std::size_t>(t)].vertex;
    for (int k = 0; k < 3; ++k) {
      const int a = v[next(k)];
      const int b = v[previous(k)];
      sides.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) {
    return p.lower != q.lower ? p.lower < q.lower : p.upper != q.upper ? p.upper < q.upper : p.triangle < q.triangle;
  });
  return sides;
}

void go(std::span<const double> from, std::span<const double> to, double part, std::vector<double>& there) {
  for (std::size_t i = 0; i < from.size(); ++i) there[i] = from[i] + part * (to[i] - from[i]);
}

}  // namespace

Triangulation::Triangulation(std::span<const std::array<int, 3>> triangles) {
  for (const auto& vertices : triangles) triangles_.push_back({vertices, {outside, outside, outside}});
  const std::vector<Side> sides = sides_of(triangles_);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side& one = sides[i];
    const Side& other = sides[i + 1];
    if (one.lower != other.lower || one.upper != other.upper) continue;
    const bool third = i + 2 < sides.size() && sides[i + 2].lower == one.lower && sides[i + 2].upper == one.upper;
    require_that(one.ascends != other.ascends && !third,
                 "edge {}-{} has triangles that overlap; allowed: one on either side", one.lower, one.upper);
    at(one.triangle).across[static_cast<std::size_t>(one.opposite)] = other.triangle;
    at(other.triangle).across[static_cast<std::size_t>(other.opposite)] = one.triangle;
  }
}

int Triangulation::facing(int of, int t) const {
  const auto& across = (*this)[of].across;
  return across[0] == t ? 0 : across[1] == t ? 1 : 2;
}

void Triangulation::relink(int of, int from, int to) {
  if (of != outside) at(of).across[static_cast<std::size_t>(facing(of, from))] = to;
}

void Triangulation::flip(int t, int k) {
  const Triangle one = (*this)[t];
  const auto a = static_cast<std::size_t>(k);
  const std::size_t b = next(k);
  const std::size_t c = previous(k);
  const int o = one.across[a];
  const Triangle other = (*this)[o];
  const int d = facing(o, t);
  const int beyond_b = other.across[next(d)];      // across the edge of b and d
  const int beyond_c = other.across[previous(d)];  // across the edge of d and c
  const int vertex_d = other.vertex[static_cast<std::size_t>(d)];
  at(t) = {{one.vertex[a], one.vertex[b], vertex_d}, {beyond_b, o, one.across[c]}};
  at(o) = {{one.vertex[a], vertex_d, one.vertex[c]}, {beyond_c, one.across[b], t}};
  relink(beyond_b, o, t);
  relink(one.across[b], t, o);
}

bool Triangulation::wants_flip(int t, int k, Places nodes) const {
  const Triangle& one = (*this)[t];
  const int o = one.across[static_cast<std::size_t>(k)];
  if (o == outside) return false;
  const int d = (*this)[o].vertex[static_cast<std::size_t>(facing(o, t))];
  return in_circle(nodes[one.vertex[0]], nodes[one.vertex[1]], nodes[one.vertex[2]], nodes[d]) > 0;
}

long Triangulation::settle(Places nodes) {
  long flips = 0;
  while (!doubtful_.empty()) {
    const auto [t, k] = doubtful_.back();
    doubtful_.pop_back();
    if (!wants_flip(t, k, nodes)) continue;
    const int o = (*this)[t].across[static_cast<std::size_t>(k)];
    flip(t, k);
    ++flips;
    // The four edges around the new pair; a triangle may have turned since an edge was put down: that one is here too.
    doubtful_.insert(doubtful_.end(), {{t, 0}, {t, 2}, {o, 0}, {o, 1}});
  }
  return flips;
}

long Triangulation::make_delaunay(Places nodes) {
  doubtful_.clear();
  for (int t = 0; t < size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if ((*this)[t].across[static_cast<std::size_t>(k)] > t && wants_flip(t, k, nodes)) doubtful_.push_back({t, k});
    }
  }
  return settle(nodes);
}

void Triangulation::insert(int node, int t, Places nodes) {
  const Triangle old = (*this)[t];
  const auto [a, b, c] = old.vertex;
  const int second = size();
  const int third = second + 1;
  at(t) = {{node, b, c}, {old.across[0], second, third}};
  triangles_.push_back({{node, c, a}, {old.across[1], third, t}});
  triangles_.push_back({{node, a, b}, {old.across[2], t, second}});
  relink(old.across[1], t, second);
  relink(old.across[2], t, third);
  doubtful_.clear();
  for (const int part : {t, second, third}) {
    const Triangle& one = (*this)[part];
    // On an edge: a triangle without area, which the other diagonal makes two halves of the neighbour.
    if (orientation(nodes[one.vertex[0]], nodes[one.vertex[1]], nodes[one.vertex[2]]) == 0) {
      const int o = one.across[0];
      flip(part, 0);
      doubtful_.push_back({o, 0});
    }
    doubtful_.push_back({part, 0});
  }
  settle(nodes);
}

int Triangulation::first_inverted(Places nodes) const {
  for (int t = 0; t < size(); ++t) {
    const auto [a, b, c] = (*this)[t].vertex;
    if (!(orientation(nodes[a], nodes[b], nodes[c]) > 0)) return t;
  }
  return outside;
}

namespace {

constexpr double closest = 1e-12;  // of the extent

std::string at(Places nodes, int k) {
  return fmt::format("node {} at ({:g}, {:g})", k, nodes[k].x, nodes[k].y);
}

void require_nodes(Places nodes, std::span<const int> outline) {
  require_that(nodes.x.size() == nodes.y.size(), "{} x and {} y of nodes; allowed: as many", nodes.x.size(),
               nodes.y.size());
  require_that(outline.size() >= 3, "the outline has {} nodes; allowed: at least 3", outline.size());
  for (int k = 0; k < nodes.size(); ++k) {
    if (!std::isfinite(nodes[k].x) || !std::isfinite(nodes[k].y)) {
      throw std::invalid_argument(at(nodes, k) + "; allowed: finite coordinates");
    }
  }
  std::vector<bool> named(nodes.x.size());
  for (const int k : outline) {
    require_that(k >= 0 && k < nodes.size(), "the outline names node {}; allowed: 0 to {}", k, nodes.size() - 1);
    require_that(!named[static_cast<std::size_t>(k)], "the outline names {} twice; allowed: once", at(nodes, k));
    named[static_cast<std::size_t>(k)] = true;
  }
}

double extent_of(Places nodes) {
  const auto range = [](std::span<const double> values) { return largest(values) - smallest(values); };
  return range(nodes.x) + range(nodes.y);
}

/// Whether the closed segments have a point in common.
bool meet(Point a, Point b, Point c, Point d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x)) return false;
  if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) return false;
  const auto side = [](Point p, Point q, Point r) {
    const double turn = orientation(p, q, r);
    return turn > 0 ? 1 : turn < 0 ? -1 : 0;
  };
  return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

void require_simple(Places nodes, std::span<const int> outline) {
  const std::size_t n = outline.size();
  const auto refuse = [&](std::size_t i, std::size_t j) {
    throw std::invalid_argument(fmt::format(
        "the outline meets itself: its edges {}-{} and {}-{}, near ({:g}, {:g}); allowed: a simple polygon", outline[i],
        outline[(i + 1) % n], outline[j], outline[(j + 1) % n], nodes[outline[i]].x, nodes[outline[i]].y));
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = nodes[outline[i]];
    const Point b = nodes[outline[(i + 1) % n]];
    // The edge after it shares b: it must not turn back.
    const Point after = nodes[outline[(i + 2) % n]];
    if (orientation(a, b, after) == 0 && dot(b - a, after - b) <= 0) {
      refuse(i, (i + 1) % n);
    }
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (meet(a, b, nodes[outline[j]], nodes[outline[(j + 1) % n]])) refuse(i, j);
    }
  }
}

/// Whether p is in the closed triangle.
bool covers(Point a, Point b, Point c, Point p) {
  return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
}

std::vector<std::array<int, 3>> cut_ears(Places nodes, std::span<const int> outline) {
  std::vector<int> ring(outline.begin(), outline.end());
  std::vector<std::array<int, 3>> triangles;
  std::size_t i = 0;
  std::size_t tried = 0;
  while (ring.size() > 3) {
    const std::size_t n = ring.size();
    // A simple polygon has two ears, one of which has an area.
    if (tried++ > n) throw std::logic_error("polygon without ears");
    const int before = ring[(i + n - 1) % n];
    const int tip = ring[i % n];
    const int after = ring[(i + 1) % n];
    const Point a = nodes[before];
    const Point b = nodes[tip];
    const Point c = nodes[after];
    const bool ear = orientation(a, b, c) > 0 && std::none_of(ring.begin(), ring.end(), [&](int k) {
                       return k != before && k != tip && k != after && covers(a, b, c, nodes[k]);
                     });
    if (!ear) {
      i = (i + 1) % n;
      continue;
    }
    triangles.push_back({before, tip, after});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i % n));
    i %= ring.size();
    tried = 0;
  }
  triangles.push_back({ring[0], ring[1], ring[2]});
  return triangles;
}

/// The triangle that covers a point, by a walk from another one; where the outline is in the way, by looking at all.
std::optional<int> triangle_at(const Triangulation& mesh, Places nodes, Point p, int from) {
  const auto first_beyond = [&](int t) {
    for (int k = 0; k < 3; ++k) {
      const auto& v = mesh[t].vertex;
      if (orientation(nodes[v[next(k)]], nodes[v[previous(k)]], p) < 0) return k;
    }
    return 3;
  };
  int t = from;
  for (int steps = 0; steps < mesh.size(); ++steps) {
    const int k = first_beyond(t);
    if (k == 3) return t;
    t = mesh[t].across[static_cast<std::size_t>(k)];
    if (t == Triangulation::outside) break;
  }
  for (t = 0; t < mesh.size(); ++t) {
    if (first_beyond(t) == 3) return t;
  }
  return {};
}

void insert_inside(Triangulation& mesh, Places nodes, int node, int& last) {
  const Point p = nodes[node];
  const auto found = triangle_at(mesh, nodes, p, last);
  if (!found) throw std::invalid_argument(at(nodes, node) + " is outside the outline; allowed: inside");
  const Triangle& around = mesh[*found];
  for (int k = 0; k < 3; ++k) {
    const int v = around.vertex[static_cast<std::size_t>(k)];
    if (nodes[v].x == p.x && nodes[v].y == p.y) {
      throw std::invalid_argument(at(nodes, node) + fmt::format(" coincides with node {}; allowed: nodes apart", v));
    }
    if (around.across[static_cast<std::size_t>(k)] == Triangulation::outside &&
        orientation(nodes[around.vertex[next(k)]], nodes[around.vertex[previous(k)]], p) == 0) {
      throw std::invalid_argument(at(nodes, node) + fmt::format(" is on the outline's edge {}-{}; allowed: inside",
                                                                around.vertex[next(k)], around.vertex[previous(k)]));
    }
  }
  mesh.insert(node, *found, nodes);
  last = *found;
}

/// Nodes next to each other are joined by an edge.
void require_apart(const Triangulation& mesh, Places nodes) {
  const double least = closest * extent_of(nodes);
  for (const Triangle& one : mesh.triangles()) {
    for (int k = 0; k < 3; ++k) {
      const int a = one.vertex[next(k)];
      const int b = one.vertex[previous(k)];
      const double apart = distance(nodes[a], nodes[b]);
      if (!(apart >= least)) {
        throw std::invalid_argument(
            at(nodes, a) +
            fmt::format(" coincides with node {}: they are {:g} apart; allowed: at least {:g}", b, apart, least));
      }
    }
  }
}

}  // namespace

double enclosed_area(Places nodes, std::span<const int> outline) {
  const Point origin = nodes[outline[0]];
  CompensatedSum twice;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    twice.add(cross(nodes[outline[i]] - origin, nodes[outline[i + 1]] - origin));
  }
  return twice.value() / 2;
}

Triangulation triangulate_polygon(Places nodes, std::span<const int> outline) {
  require_nodes(nodes, outline);
  const double area = enclosed_area(nodes, outline);
  require_simple(nodes, outline);
  require_that(area > 0, "the outline encloses an area of {:g}; allowed: positive, that is counter-clockwise", area);
  Triangulation mesh(cut_ears(nodes, outline));
  mesh.make_delaunay(nodes);
  std::vector<bool> placed(nodes.x.size());
  for (const int k : outline) placed[static_cast<std::size_t>(k)] = true;
  int last = 0;
  for (int k = 0; k < nodes.size(); ++k) {
    if (!placed[static_cast<std::size_t>(k)]) insert_inside(mesh, nodes, k, last);
  }
  require_apart(mesh, nodes);
  return mesh;
}

MovingTriangulation::MovingTriangulation(Triangulation mesh, Places nodes)
    : mesh_(std::move(mesh)),
      x_(nodes.x.begin(), nodes.x.end()),
      y_(nodes.y.begin(), nodes.y.end()),
      next_x_(x_.size()),
      next_y_(y_.size()) {}

void MovingTriangulation::move_to(Places nodes) {
  require_that(nodes.x.size() == x_.size() && nodes.y.size() == x_.size(),
               "{} and {} coordinates; the mesh has {} nodes", nodes.x.size(), nodes.y.size(), x_.size());
  if (std::equal(x_.begin(), x_.end(), nodes.x.begin()) && std::equal(y_.begin(), y_.end(), nodes.y.begin())) return;
  double left = 1;  // of the way, from where the nodes are
  while (left > 0) {
    double part = left;
    for (;;) {
      // The end itself is hit to the last bit.
      if (part == left) {
        std::ranges::copy(nodes.x, next_x_.begin());
        std::ranges::copy(nodes.y, next_y_.begin());
      } else {
        go(x_, nodes.x, part / left, next_x_);
        go(y_, nodes.y, part / left, next_y_);
      }
      const int inverted = mesh_.first_inverted({next_x_, next_y_});
      if (inverted == Triangulation::outside) break;
      part /= 2;
      if (part >= shortest_part) continue;
      const auto [a, b, c] = mesh_[inverted].vertex;
      throw Infeasible(
          next_x_[static_cast<std::size_t>(a)],
          "triangle {} of nodes {}, {}, {} is inverted: a node reaches the outline, or two of the outline meet",
          inverted, a, b, c);
    }
    x_.swap(next_x_);
    y_.swap(next_y_);
    flips_ += mesh_.make_delaunay({x_, y_});
    left -= part;
  }
}

}  // namespace seiche
