// The outline of free particles for plots: areas of a ring of water.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "seiche/models/gauss_particles/particles.hpp"
#include "validation/instruments/particles/gauss_outline.hpp"
#include "verification/all_hold.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::gauss_particles_contour_test {

using namespace gauss_particles;

double area(const std::vector<Point>& line) {
  double sum = 0;
  for (std::size_t k = 0; k < line.size(); ++k) sum += 0.5 * cross(line[k], line[(k + 1) % line.size()]);
  return sum;
}

TEST_CASE("the outline of particles encloses their water", "[geometry]") {
  Check check("gauss_particles_contour", "Gauss-principle particles: their outline",
              "A disc of radius 1 with a hole of radius 0.4: two lines, the outer one against the clock and the inner "
              "one with it, whose areas tend to the exact ones with the square of the spacing, for a kernel that is "
              "symmetrical about a curved edge.",
              "Wendland, Adv. Comput. Math. 4 (1995) 389; geometry");
  bool two = true;
  bool marked = true;
  refine(
      check, {"spacing", widths(1, {10, 20, 40, 80})},
      {{"order", "The outer area errs by the square of the spacing.",
        Order{2, 0.4,
              "the kernel moves the line by its second moment times the curvature; the grid of half a spacing adds as "
              "much at most, which changes with where it lies: a factor of 2 over three octaves is 0.33 of an order"}}},
      [&](double width) {
        Particles particles = disc(1, cells_of(1, width));
        for (std::size_t k = 0; k < particles.size(); ++k) {
          if (std::hypot(particles.x[k], particles.y[k]) < 0.4) particles.mass[k] = 0;
        }
        const auto lines = surface_contours(particles.x, particles.y, particles.mass, 1, width);
        particles.add(-3e5, 5e5, 0);
        const auto again = surface_contours(particles.x, particles.y, particles.mass, 1, width);
        marked = marked && again.size() == lines.size() && area(again[0]) == area(lines[0]);
        two = two && lines.size() == 2 && area(lines[0]) > 0 && area(lines[1]) < 0;
        return std::abs(area(lines[0]) - std::numbers::pi);
      });
  check.that("lines", "The contour consists of two lines, each correctly oriented.", "so at all spacings",
             {.value = two ? 1.0 : 0.0, .resolution = "10 to 80 rings"},
             Qualitative{"two lines, areas of opposite sign", "a ring has an outer and an inner edge"});
  check.holds("The contour is unchanged by a marker far from the water.", {marked ? 1.0 : 0.0},
              Qualitative{"equal bits at all spacings", "markers have no mass"});
}

TEST_CASE("a disc of particles has the mass and the moments of inertia of a disc", "[geometry]") {
  Check check("gauss_particles_disc", "Gauss-principle particles: a disc",
              "Rings of particles on a disc of radius 2 and density 3: mass and second moments equal the disc's.");
  const Particles particles = disc(2, 20, 16, 3);
  double mass = 0, along = 0, up = 0, mixed = 0;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const double m = particles.mass[k];
    mass += m;
    along += m * particles.x[k] * particles.x[k];
    up += m * particles.y[k] * particles.y[k];
    mixed += m * particles.x[k] * particles.y[k];
  }
  const double expected = 3 * std::numbers::pi * 4;
  all_hold(check, Roundoff{1200, expected, "a sum over 1200 particles, of the size of the mass"},
           {{"mass: The mass of the particles equals the disc's.", mass, expected},
            {"moment-x: The second moment along x of the particles equals the disc's.", along, expected},
            {"moment-y: The second moment along y of the particles equals the disc's.", up, expected},
            {"moment-xy: The mixed second moment of the particles equals the disc's.", mixed}});
}

}  // namespace seiche::verification::gauss_particles_contour_test
