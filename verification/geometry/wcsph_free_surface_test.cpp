// The free surface as particles show it: elevations of known layers, contours of known shapes.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/particles/sph_free_surface.hpp"
#include "validation/instruments/particles/sph_front.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::wcsph_free_surface_test {

using namespace wcsph;
using std::numbers::pi;

const std::string fractions = "volume fraction 1/2 on the free surface: a property of symmetric kernels";

const Settings water{.sound_speed = 40};

VolumeFraction fraction_of(const Scene& scene, double smoothing = 1.3, KernelName kernel = KernelName::cubic_spline) {
  Box basin = unbounded;
  basin.bottom = scene.extents.bottom > -1 ? 0 : basin.bottom;
  if (std::isinf(scene.period.x) && scene.far_wall > 0) {
    basin.left = scene.rear_wall;
    basin.right = scene.far_wall;
  }
  return {scene.particles, smoothing * scene.spacing, basin, kernel, scene.period};
}

/// Largest error of the elevation of a layer, in dx.
template <class Elevation>
double elevation_error(const Scene& scene, const VolumeFraction& fraction, Elevation expected) {
  Largest error;
  for (int k = 0; k < 200; ++k) {
    const double x = scene.far_wall * (k + 0.37) / 200;
    error.add(std::abs(fraction.elevation(x).value() - expected(x)) / scene.spacing);
  }
  return error.value();
}

/// Errors of the contour of a disc of radius 1 m, over 64 places of the disc on the lattice.
struct DiscErrors {
  Mean area;     ///< relative
  Mean centre;   ///< [m]
  Worst radius;  ///< [m]
};
DiscErrors disc_errors(double spacing) {
  const double reach = spacing * std::ceil(1 / spacing + 3);
  const Box box{-reach, reach, -reach, reach};
  DiscErrors errors;
  for (int place = 0; place < 64; ++place) {
    const double x0 = spacing * (place / 8 + 0.31) / 8, z0 = spacing * (place % 8 + 0.17) / 8;
    const auto from_centre = [=](double x, double z) { return std::hypot(x - x0, z - z0); };
    const auto inside = [=](double x, double z) { return from_centre(x, z) <= 1; };
    const Scene disc = patch({.inside = inside, .box = box, .spacing = spacing}, water);
    const std::vector<Contour> curves = free_surface(fraction_of(disc), box, spacing / 2);
    REQUIRE(curves.size() == 1);
    const Contour& curve = curves[0];
    REQUIRE(curve.closed);
    for (std::size_t k = 0; k < curve.x.size(); ++k) errors.radius.add(from_centre(curve.x[k], curve.z[k]) - 1);
    errors.area.add(-curve.area() / pi - 1);
    errors.centre.add(from_centre(curve.centroid().x, curve.centroid().z));
  }
  return errors;
}

TEST_CASE("the elevation of known layers is found within a fraction of the spacing", "[geometry]") {
  Check check("wcsph_elevation", "Elevation from the volume fraction",
              "A level layer on both lattices with both kernels, also beside walls, and a wave of small steepness on "
              "halving spacings. The contour on which half of the kernel's weight is water is the end of the water, to "
              "the difference between the lattice's sums and the integral; a curved surface is smoothed over h.",
              fractions);
  Largest level;
  for (const Lattice lattice : {Lattice::square, Lattice::body_centred}) {
    for (const auto& [kernel, smoothing] : {std::pair{KernelName::cubic_spline, 1.3}, {KernelName::wendland_c2, 2.0}}) {
      const Scene layer = periodic_layer({.period = 1, .depth = 0.5, .spacing = 0.05, .lattice = lattice}, water);
      level.add(elevation_error(layer, fraction_of(layer, smoothing, kernel), [](double) { return 0.5; }));
    }
  }
  check.that("level", "The elevation of a level layer is found within 0.1 dx.", "largest error over dx",
             {level.value()}, Bound{0.1, "particles stand for cells of height dx: readings resolve a tenth of that"});
  const Scene basin = tank({.width = 1, .depth = 0.5, .spacing = 0.05}, water);
  check.that("walls", "The elevation beside walls is found within 0.1 dx: no weight behind them counts.",
             "largest error over dx", {elevation_error(basin, fraction_of(basin), [](double) { return 0.5; })},
             Bound{0.1, "as in the middle"});

  const auto wave = [](double x) { return 0.02 * std::cos(2 * pi * x); };
  const auto errors =
      refine(check, {"dx", falling(0.05, 4), "wave"},
             {{"wave-order", "The error of a wave falls with the square of the spacing.",
               Order{2, 0.3, "leading term of the smoothing, O(h^2 eta''); the lattice's sums oscillate about it"}}},
             [&](double spacing) {
               // As many particles in every column, whose masses are in proportion to the depth.
               Scene layer = periodic_layer({.period = 1, .depth = 0.5, .spacing = spacing}, water);
               for (std::size_t a = 0; a < layer.particles.size(); ++a) {
                 if (layer.particles.kind[a] != Kind::fluid) continue;
                 const double strip = std::sin(pi * spacing) / (pi * spacing);  // mean of a cosine over it
                 const double stretched = 1 + strip * wave(layer.particles.x[a]) / 0.5;
                 layer.particles.z[a] *= stretched;
                 layer.particles.mass[a] *= stretched;
               }
               return spacing * elevation_error(layer, fraction_of(layer), [&](double x) { return 0.5 + wave(x); });
             });
  check.that("wave", "A wave of amplitude 0.4 dx is resolved to a tenth of the spacing.", "largest error over dx",
             {errors[0][0] / 0.05}, Bound{0.1, "as for the level layer"});

  Scene two = periodic_layer({.period = 1, .depth = 0.5, .spacing = 0.05}, water);
  for (const Place& p : rectangle(Lattice::square, 0.05, 0, 1, 20, 6)) two.particles.add(p.x, p.z, 2.5, 1000);
  const VolumeFraction sheets = fraction_of(two);
  CHECK(std::abs(sheets.elevation(0.33).value() - 1.3) < 0.005);
  CHECK(std::abs(sheets.mean_elevation(0.1, 0.4).value() - 1.3) < 0.005);
}

TEST_CASE("contours of discs and rings have their exact positions", "[geometry]") {
  Check check("wcsph_contours", "Free-surface contours",
              "Level curves of given fields, with linear interpolation along the edges of the grid; the contour of a "
              "disc of particles against its radius, area and centre, on 64 positions of the disc on the lattice; "
              "directions of curves around water and around air.",
              "Lorensen and Cline, Computer Graphics 21 (1987) 163, in the plane");
  refine(check, {"step of the grid", widths(3, {20, 40, 80, 160}), "ellipse"},
         {{"ellipse", "The area inside the level curve of a smooth field has second order.",
           Order{2, 0.2, "linear interpolation, chords of arcs"}}},
         [](double step) {
           const auto n = static_cast<long>(cells_of(3, step));
           Raster raster{.left = -1.5, .bottom = -1.5, .step = step, .columns = n + 1, .rows = n + 1, .values = {}};
           for (long j = 0; j <= n; ++j) {
             for (long i = 0; i <= n; ++i) {
               const double x = raster.left + static_cast<double>(i) * raster.step;
               const double z = raster.bottom + static_cast<double>(j) * raster.step;
               raster.values.push_back(1.5 - (x - 0.1) * (x - 0.1) - 2 * z * z);
             }
           }
           const std::vector<Contour> curves = level_curves(raster, 0.5);
           REQUIRE(curves.size() == 1);
           return std::abs(curves[0].area() + pi / std::numbers::sqrt2);
         });

  Largest farthest;
  refine(
      check,
      {"dx/R", std::vector{0.14, 0.1, 0.07, 0.05, 0.035, 0.025}, "disc",
       "A disc's contour: errors over 64 positions on the lattice"},
      {{"disc-area", "The area of a disc, averaged over its positions on the grid, converges at second order.",
        Order{2, 0.3,
              "leading term, curvature moves the level 1/2 by a part of h^2/R; a mean of 64 positions leaves a part of "
              "the scatter"}},
       {"disc-centre",
        "The centre of the disc converges with order 1.5.",
        {1.5, 0.5,
         "the first moment of the remainder of the number of lattice points in a disc, rms R^(1/2): Kendall, Q. J. "
         "Math. 19 (1948) 1"}}},
      [&](double spacing) {
        const DiscErrors errors = disc_errors(spacing);
        farthest.add(errors.radius.value() / spacing);
        return std::array{std::abs(errors.area.value()), errors.centre.rms()};
      });
  check.from(fractions).that("disc-radius", "The contour error of a disc is at most half a cell diagonal.",
                             "largest distance over dx", {farthest.value()},
                             Bound{0.75, "whether a cell belongs to the disc is decided by its middle: 0.71 dx"});

  const auto inside = [](double x, double z) { return std::hypot(x, z) <= 1 && std::hypot(x, z) > 0.4; };
  const Box box{-1.2, 1.2, -1.2, 1.2};
  const Scene ring = patch({.inside = inside, .box = box, .spacing = 0.04}, water);
  const std::vector<Contour> curves = free_surface(fraction_of(ring), box, 0.02);
  REQUIRE(curves.size() == 2);
  check.that("ring-outside",
             "The area of a curve around water, which runs clockwise, is negative and correct within half a spacing "
             "all around.",
             "area [m^2]", {curves[0].area()}, Bound{2 * pi * 0.02, "half a spacing all around", -pi});
  check.that(
      "ring-inside",
      "The area of a curve around air, which runs counter-clockwise, is counted within half a spacing all around.",
      "area [m^2]", {curves[1].air}, Bound{2 * pi * 0.4 * 0.02, "half a spacing all around", 0.16 * pi});
  CHECK(curves[0].air == 0);
  CHECK(std::abs(curves[0].distance(0, 0) - 1) < 0.04);
}

TEST_CASE("front and height of a column follow its particles, not spray", "[geometry]") {
  const Scene dam =
      dam_break({.width = 0.5, .height = 1, .tank_length = 2, .wall_height = 1.5, .spacing = 0.05}, water);
  Particles particles = dam.particles;
  const double h = 1.3 * dam.spacing;
  for (const bool spray : {false, true}) {
    if (spray) {
      for (int k = 0; k < 4; ++k) particles.add(1.2 + 0.01 * k, 1.1, 2.5, 1000);  // too few to be water
      particles.add(0.2, 1.3, 2.5, 1000);
    }
    CHECK(front_position(particles, h) == Approx(0.475).epsilon(1e-12));
    CHECK(column_height(particles, h, 0.15, 0.3) == Approx(0.975).epsilon(1e-12));
  }
  particles.add(1.24, 1.1, 2.5, 1000);
  CHECK(front_position(particles, h) == Approx(1.24).epsilon(1e-12));
  CHECK(std::isnan(front_position(Particles{}, h)));
}

}  // namespace seiche::verification::wcsph_free_surface_test
