/// Plane walls, behind which every particle has its mirror image.
///
/// A particle's image takes part in all control volumes, its own among them:
///
/// @f[ \mathbf{r}^* = \mathbf{r} - 2 \mathbf{n} \, \mathbf{n} \cdot (\mathbf{r} - \mathbf{p}), \qquad
///     f_s = \dots + \sum_k m_k \Phi(|\mathbf{r}_k^* - \mathbf{r}_s|) @f]
///
/// so that water beside a wall moves as half of the flow that is symmetric about it, to round-off. Where two walls meet
/// at a right angle there is the image of the images too, and the water is a quarter of a symmetric flow.
#pragma once

#include <span>
#include <vector>

#include "seiche/geometry/curve.hpp"

namespace seiche::overlapping_particles {

/// A straight line without ends, with the water on one side.
struct Wall {
  Point through;
  Point normal;  ///< towards the water, of any length but zero
};

/// A map r -> Q r + o of the plane, Q = Q^T = Q^-1, about one wall or two.
struct Image {
  double xx, xy, yy;
  Point offset;
  int one;
  int other;  ///< the same wall where there is only one

  [[nodiscard]] Point turned(Point v) const { return {xx * v.x + xy * v.y, xy * v.x + yy * v.y}; }
  [[nodiscard]] Point of(Point r) const {
    const Point q = turned(r);
    return {q.x + offset.x, q.y + offset.y};
  }
};

class Walls {
 public:
  /// @param reach  S: walls that face each other are at least so far apart, for only next images are taken
  /// Throws std::invalid_argument naming the wall: not finite, no direction, neither parallel nor at right angles.
  Walls(std::vector<Wall> walls, double reach);

  [[nodiscard]] bool empty() const { return walls_.empty(); }
  [[nodiscard]] std::span<const Image> images() const { return images_; }
  /// Distance from a wall, negative behind it.
  [[nodiscard]] double distance(int wall, Point r) const;
  /// Whether the image of a place may be within `reach` of the water.
  [[nodiscard]] bool sees(const Image& image, Point r, double reach) const {
    return distance(image.one, r) < reach && distance(image.other, r) < reach;
  }
  /// The wall that a place is on or behind, or -1.
  [[nodiscard]] int behind(Point r) const;

 private:
  void require_apart(int one, int other, double reach) const;

  std::vector<Wall> walls_;  // with unit normals
  std::vector<Image> images_;
};

/// Calls visit(R r) for the place r itself and for those of its images that may be within `reach` of the water.
template <class Visit>
void each_image(Point r, const Walls& walls, double reach, Visit&& visit) {
  visit(r);
  for (const Image& image : walls.images()) {
    if (walls.sees(image, r, reach)) visit(image.of(r));
  }
}

}  // namespace seiche::overlapping_particles
