#include "seiche/geometry/triangulation.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/geometry/predicates.hpp"

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

}  // namespace

Triangulation::Triangulation(std::span<const std::array<int, 3>> triangles) {
  for (const auto& vertices : triangles) triangles_.push_back({vertices, {outside, outside, outside}});
  const std::vector<Side> sides = sides_of(triangles_);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side& one = sides[i];
    const Side& other = sides[i + 1];
    if (one.lower != other.lower || one.upper != other.upper) continue;
    const bool third = i + 2 < sides.size() && sides[i + 2].lower == one.lower && sides[i + 2].upper == one.upper;
    if (one.ascends == other.ascends || third) {
      throw std::invalid_argument(
          fmt::format("edge {}-{} has triangles that overlap; allowed: one on either side", one.lower, one.upper));
    }
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

long Triangulation::edges_not_delaunay(Places nodes) const {
  long found = 0;
  for (int t = 0; t < size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if ((*this)[t].across[static_cast<std::size_t>(k)] > t && wants_flip(t, k, nodes)) ++found;
    }
  }
  return found;
}

}  // namespace seiche
