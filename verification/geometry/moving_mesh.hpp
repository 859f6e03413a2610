/// Meshes of nodes that move at random, and triangle sets to compare them by.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <boost/polygon/voronoi.hpp>

#include "seiche/free_lagrangian/mesh.hpp"
#include "seiche/geometry/predicates.hpp"
#include "seiche/geometry/triangulation.hpp"
#include "verification/jittered_mesh.hpp"
#include "verification/noise.hpp"

namespace seiche::verification {

using TriangleSet = std::vector<std::array<int, 3>>;

/// Each triangle from its lowest node on, in ascending order.
inline TriangleSet sorted(TriangleSet triangles) {
  for (auto& t : triangles) std::ranges::rotate(t, std::ranges::min_element(t));
  std::ranges::sort(triangles);
  return triangles;
}

inline TriangleSet triangles_of(const Triangulation& mesh) {
  TriangleSet triangles;
  for (const Triangle& one : mesh.triangles()) triangles.push_back(one.vertex);
  return sorted(std::move(triangles));
}

/// Coordinates that are whole multiples of this are what Boost.Polygon computes with.
constexpr double grain = 0x1p-28;

inline double snapped(double value) {
  return grain * std::round(value / grain);
}

/// The Delaunay triangles of all nodes from Boost.Polygon's Voronoi diagram of integer points: an independent method,
/// a sweep, and its own exact arithmetic. For convex outlines whose coordinates are snapped.
inline TriangleSet triangles_of_sweep(Places nodes) {
  using boost::polygon::point_data;
  std::vector<point_data<std::int32_t>> points;
  for (int k = 0; k < nodes.size(); ++k) {
    points.emplace_back(static_cast<std::int32_t>(nodes[k].x / grain), static_cast<std::int32_t>(nodes[k].y / grain));
  }
  boost::polygon::voronoi_diagram<double> diagram;
  boost::polygon::construct_voronoi(points.begin(), points.end(), &diagram);
  TriangleSet triangles;
  for (const auto& vertex : diagram.vertices()) {
    // Its cells in turn, counter-clockwise. More than three where nodes are on one circle: a fan of triangles.
    std::vector<int> corners;
    const auto* edge = vertex.incident_edge();
    do {
      corners.push_back(static_cast<int>(edge->cell()->source_index()));
      edge = edge->rot_next();
    } while (edge != vertex.incident_edge());
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) triangles.push_back({corners[0], corners[i], corners[i + 1]});
  }
  for (auto& [a, b, c] : triangles) {
    if (orientation(nodes[a], nodes[b], nodes[c]) < 0) std::swap(b, c);
  }
  return sorted(std::move(triangles));
}

/// How many triangles are in one set alone.
inline double difference(const TriangleSet& one, const TriangleSet& other) {
  TriangleSet alone;
  std::ranges::set_symmetric_difference(one, other, std::back_inserter(alone));
  return static_cast<double>(alone.size());
}

/// Nodes of a box that wander: those inside anywhere within it, those of its sides along them, its corners not at all.
class WanderingBox {
 public:
  WanderingBox(int columns, int rows, std::uint64_t seed)
      : noise_(seed),
        mesh_(free_lagrangian::jittered(
            free_lagrangian::free_patch(columns, rows, {0, 0}, {snapped(1.0), snapped(1.0)}), 0.3, seed)),
        on_outline_(mesh_.on_outline()),
        spacing_(1.0 / columns) {
    for (double& x : mesh_.x) x = snapped(x);
    for (double& y : mesh_.y) y = snapped(y);
  }

  [[nodiscard]] const free_lagrangian::Mesh& mesh() const { return mesh_; }
  [[nodiscard]] Places nodes() const { return mesh_.places(); }

  /// Moves every node by up to `part` of the spacing along both axes.
  void move(double part) {
    for (std::size_t k = 0; k < mesh_.nodes(); ++k) {
      if (on_outline_[k]) continue;
      wander(mesh_.x[k], part);
      wander(mesh_.y[k], part);
    }
    // A node of a side keeps a tenth of the spacing from its neighbours.
    const std::size_t n = mesh_.outline.size();
    for (std::size_t i = 0; i < n; ++i) {
      const int before = mesh_.outline[(i + n - 1) % n];
      const int node = mesh_.outline[i];
      const int after = mesh_.outline[(i + 1) % n];
      for (auto* along : {&mesh_.x, &mesh_.y}) {
        auto& across = along == &mesh_.x ? mesh_.y : mesh_.x;
        const auto at = [](const std::vector<double>& values, int k) { return values[static_cast<std::size_t>(k)]; };
        if (at(across, before) != at(across, node) || at(across, node) != at(across, after)) continue;
        double& here = (*along)[static_cast<std::size_t>(node)];
        const double old = here;
        wander(here, part);
        const double low = std::min(at(*along, before), at(*along, after)) + 0.1 * spacing_;
        const double high = std::max(at(*along, before), at(*along, after)) - 0.1 * spacing_;
        if (!(here > low && here < high)) here = old;
      }
    }
  }

 private:
  void wander(double& value, double part) {
    const double next = snapped(value + part * spacing_ * noise_());
    if (next > 0.01 * spacing_ && next < 1 - 0.01 * spacing_) value = next;
  }

  Noise noise_;
  free_lagrangian::Mesh mesh_;
  std::vector<bool> on_outline_;
  double spacing_;
};

}  // namespace seiche::verification
