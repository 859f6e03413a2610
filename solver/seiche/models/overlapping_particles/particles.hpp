/// Sets of particles with fixed masses, in staggered rows.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "seiche/geometry/curve.hpp"

namespace seiche::overlapping_particles {

// How much of a particle's mass lies in a control volume, by the distance of their centres.
//
//     smoothed   Wendland's C2 function, which is of class C2 where it vanishes, q = d/S:
//
//                    Phi = 7/(pi S^2) (1 - q)^4 (1 + 4 q)                      [1/m^2]
//
//     ball       a disc of radius R = S/2 in a disc of the same radius, in the words of the source: the lens of the
//                two over the area of one,
//
//                    Phi = (2 R^2 acos(d/2R) - (d/2) sqrt(4 R^2 - d^2))/(pi R^2)    [1]
//
// When not to use the ball: for numbers. Its derivative is largest between particles that nearly meet and ends like a
// square root; the ellipse of section 5.1 comes out right in kind only.
//
// References: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), section 5.1; Wendland,
// Adv. Comput. Math. 4 (1995) 389.

enum class Shape { smoothed, ball };
/// Throws std::invalid_argument listing the names there are.
Shape shape_named(std::string_view name);

class Kernel {
 public:
  /// @param support  S [m], beyond which there is no overlap. Throws std::invalid_argument
  Kernel(Shape shape, double support);

  [[nodiscard]] double support() const { return support_; }
  /// Phi(d) for d >= 0.
  [[nodiscard]] double value(double distance) const;
  /// Phi'(d)/d for 0 < d < S; times the vector between the centres, the gradient. Not positive.
  [[nodiscard]] double slope_over_distance(double distance) const;

 private:
  Shape shape_;
  double support_;
  double value_scale_;
  double slope_scale_;
};

struct Particles {
  std::vector<double> x;     ///< [m]
  std::vector<double> y;     ///< [m]
  std::vector<double> mass;  ///< [kg/m]
  double spacing = 1;        ///< h, of neighbours [m]

  [[nodiscard]] std::size_t size() const { return x.size(); }
  /// Throws std::invalid_argument naming the particle: arrays of different lengths, fewer than three particles, places
  /// not finite, masses or spacing not positive.
  void require_valid() const;
};

/// Rows of height h sqrt(3)/2, every other one shifted by h/2.
struct Rows {
  double spacing = 0.1;                    ///< h [m]
  Point lower, upper;                      ///< corners of the rectangle that is filled
  Point through;                           ///< a particle of an unshifted row
  double density = 1;                      ///< [kg/m^3]; a particle has that of h^2 sqrt(3)/2
  std::function<bool(Point)> inside = {};  ///< which places are taken; empty: all
};
/// Row by row from below. Throws std::invalid_argument, also where more than 1e7 places would be tried.
Particles staggered(const Rows& rows);

/// Disc about the origin, with a particle in its middle; on its rim too, but for the ends of the middle row. Together
/// they have the mass of the disc.
Particles staggered_disc(double radius, double spacing, double density = 1);

// Plane walls, behind which every particle has its mirror image.
//
// A particle's image takes part in all control volumes, its own among them:
//
// @f[ \mathbf{r}^* = \mathbf{r} - 2 \mathbf{n} \, \mathbf{n} \cdot (\mathbf{r} - \mathbf{p}), \qquad
//     f_s = \dots + \sum_k m_k \Phi(|\mathbf{r}_k^* - \mathbf{r}_s|) @f]
//
// so that water beside a wall moves as half of the flow that is symmetric about it, to round-off. Where two walls meet
// at a right angle there is the image of the images too, and the water is a quarter of a symmetric flow.

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
