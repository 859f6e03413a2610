#include "seiche/geometry/moving_triangulation.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "seiche/require_that.hpp"

namespace seiche {

namespace {

void copy(std::span<const double> from, std::vector<double>& to) {
  std::copy(from.begin(), from.end(), to.begin());
}

void go(std::span<const double> from, std::span<const double> to, double part, std::vector<double>& there) {
  for (std::size_t i = 0; i < from.size(); ++i) there[i] = from[i] + part * (to[i] - from[i]);
}

}  // namespace

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
        copy(nodes.x, next_x_);
        copy(nodes.y, next_y_);
      } else {
        go(x_, nodes.x, part / left, next_x_);
        go(y_, nodes.y, part / left, next_y_);
      }
      const int inverted = mesh_.first_inverted({next_x_, next_y_});
      if (inverted == Triangulation::outside) break;
      part /= 2;
      ++bisections_;
      if (part < shortest_part) throw_tangled(inverted, {next_x_, next_y_});
    }
    x_.swap(next_x_);
    y_.swap(next_y_);
    flips_ += mesh_.make_delaunay({x_, y_});
    left -= part;
  }
}

void MovingTriangulation::throw_tangled(int triangle, Places there) const {
  const auto [a, b, c] = mesh_[triangle].vertex;
  throw MeshTangled(fmt::format("triangle {} of nodes {}, {}, {} turns over: a node reaches the outline, or two of the "
                                "outline meet",
                                triangle, a, b, c),
                    there[a].x);
}

}  // namespace seiche
