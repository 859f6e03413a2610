#include "seiche/geometry/dirichlet_cells.hpp"

#include <algorithm>
#include <cmath>

namespace seiche {

namespace {

/// A triangle by the sides that face its vertices, counter-clockwise, and the cotangents of its angles.
struct Shape {
  std::array<Point, 3> side;
  std::array<double, 3> cotangent{};
  double twice_area;

  Shape(Point a, Point b, Point c) : side{c - b, a - c, b - a}, twice_area(cross(side[2], -1.0 * side[1])) {
    for (int k = 0; k < 3; ++k) {
      cotangent[static_cast<std::size_t>(k)] = -dot(side[next(k)], side[previous(k)]) / twice_area;
    }
  }
  /// Of the cell of vertex k.
  [[nodiscard]] double share(int k) const {
    const std::size_t j = next(k);
    const std::size_t l = previous(k);
    return (dot(side[l], side[l]) * cotangent[l] + dot(side[j], side[j]) * cotangent[j]) / 8;
  }
  /// Circumcentre as seen from the first vertex.
  [[nodiscard]] Point circumcentre() const {
    const Point b = side[2];
    const Point c = -1.0 * side[1];
    const double b2 = dot(b, b) / (2 * twice_area);
    const double c2 = dot(c, c) / (2 * twice_area);
    return {c.y * b2 - b.y * c2, b.x * c2 - c.x * b2};
  }
};

Shape shape(const Triangle& one, Places nodes) {
  return {nodes[one.vertex[0]], nodes[one.vertex[1]], nodes[one.vertex[2]]};
}

std::size_t index(int k) {
  return static_cast<std::size_t>(k);
}

}  // namespace

void DirichletCells::connect(const Triangulation& mesh, int nodes) {
  begin_.assign(index(nodes) + 1, 0);
  for (const Triangle& one : mesh.triangles()) {
    for (int k = 0; k < 3; ++k) {
      ++begin_[index(one.vertex[index(k)]) + 1];
      if (one.across[index(k)] == Triangulation::outside) ++begin_[index(one.vertex[previous(k)]) + 1];
    }
  }
  for (std::size_t k = 0; k < index(nodes); ++k) begin_[k + 1] += begin_[k] + 1;
  member_.resize(index(begin_.back()));
  std::vector<int> filled(begin_.begin(), begin_.end() - 1);
  const auto enter = [&](int member, int node) {
    const int entry = filled[index(node)]++;
    member_[index(entry)] = member;
    return entry;
  };
  for (int k = 0; k < nodes; ++k) enter(k, k);
  entry_.resize(mesh.triangles().size());
  // An edge a -> b is of one triangle, b -> a of its neighbour: each enters one end in the ring of the other.
  for (int t = 0; t < mesh.size(); ++t) {
    const auto& v = mesh[t].vertex;
    for (int k = 0; k < 3; ++k) {
      const std::size_t a = next(k);
      const std::size_t b = previous(k);
      entry_[index(t)][3 * index(k) + index(k)] = begin_[index(v[index(k)])];
      entry_[index(t)][3 * b + a] = enter(v[b], v[a]);
      if (mesh[t].across[index(k)] == Triangulation::outside) entry_[index(t)][3 * a + b] = enter(v[a], v[b]);
    }
  }
  for (int t = 0; t < mesh.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int o = mesh[t].across[index(k)];
      if (o == Triangulation::outside) continue;
      const std::size_t a = next(k);
      const std::size_t b = previous(k);
      // There the edge runs from b to a, and a is entered in the ring of b.
      const auto& there = mesh[o].vertex;
      const int from = there[0] == mesh[t].vertex[b] ? 0 : there[1] == mesh[t].vertex[b] ? 1 : 2;
      entry_[index(t)][3 * a + b] = entry_[index(o)][3 * next(from) + index(from)];
    }
  }
}

void DirichletCells::measure(const Triangulation& mesh, Places nodes) {
  area_.assign(nodes.x.size(), 0.0);
  gradient_.assign(member_.size(), Point{});
  const auto add = [&](int entry, Point part) { gradient_[index(entry)] += part; };
  for (int t = 0; t < mesh.size(); ++t) {
    const Triangle& one = mesh[t];
    const auto& entry = entry_[index(t)];
    const Shape s = shape(one, nodes);
    for (int k = 0; k < 3; ++k) area_[index(one.vertex[index(k)])] += s.share(k);
    // Seen from the first vertex, so that nothing cancels far from the origin.
    const std::array<Point, 3> r{Point{0, 0}, s.side[2], -1.0 * s.side[1]};
    const Point centre = s.circumcentre();
    for (int k = 0; k < 3; ++k) {
      const std::size_t i = next(k);
      const std::size_t j = previous(k);
      // The edge between the cells i and j goes from the middle of the nodes to the centre, w = its length over the
      // nodes' distance, and its own middle is m: dA_i/dr_j = w (r_j - m).
      const double w = s.cotangent[index(k)] / 2;
      const Point middle = 0.25 * (r[i] + r[j]) + 0.5 * centre;
      const Point by_j = w * (r[j] - middle);
      const Point by_i = w * (r[i] - middle);
      add(entry[3 * i + j], by_j);
      add(entry[4 * j], -1.0 * by_j);
      add(entry[3 * j + i], by_i);
      add(entry[4 * i], -1.0 * by_i);
      if (one.across[index(k)] == Triangulation::outside) {
        const Point normal{s.side[index(k)].y / 8, -s.side[index(k)].x / 8};
        add(entry[4 * i], 3.0 * normal);
        add(entry[3 * i + j], normal);
        add(entry[3 * j + i], normal);
        add(entry[4 * j], 3.0 * normal);
      }
    }
  }
}

void dirichlet_areas(const Triangulation& mesh, Places nodes, std::span<double> areas) {
  std::fill(areas.begin(), areas.end(), 0.0);
  for (const Triangle& one : mesh.triangles()) {
    const Shape s = shape(one, nodes);
    for (int k = 0; k < 3; ++k) areas[index(one.vertex[index(k)])] += s.share(k);
  }
}

std::vector<Point> dirichlet_centroids(const Triangulation& mesh, Places nodes) {
  std::vector<Point> moment(nodes.x.size());
  std::vector<double> area(nodes.x.size(), 0.0);
  for (const Triangle& one : mesh.triangles()) {
    const Shape s = shape(one, nodes);
    const Point first = nodes[one.vertex[0]];
    const Point centre = s.circumcentre();
    for (int k = 0; k < 3; ++k) {
      // Two right triangles on the edge ij, of one size: of the node, the middle of the edge and the centre.
      const int i = one.vertex[next(k)];
      const int j = one.vertex[previous(k)];
      const double piece = dot(s.side[index(k)], s.side[index(k)]) * s.cotangent[index(k)] / 8;
      const Point middle = 0.5 * (nodes[i] + nodes[j]);
      for (const int node : {i, j}) {
        area[index(node)] += piece;
        const Point corners = nodes[node] + middle + first + centre;
        moment[index(node)] += Point{piece * corners.x / 3, piece * corners.y / 3};
      }
    }
  }
  for (std::size_t k = 0; k < area.size(); ++k) moment[k] = {moment[k].x / area[k], moment[k].y / area[k]};
  return moment;
}

}  // namespace seiche
