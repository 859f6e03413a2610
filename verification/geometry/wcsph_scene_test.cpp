// The particles of the beginning: counts, places, masses and densities of every scene.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/models/wcsph/kernel.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "seiche/samples.hpp"
#include "verification/all_hold.hpp"
#include "verification/check.hpp"

namespace seiche::verification::wcsph_scene_test {

using namespace wcsph;

Settings water(double height, double coefficient = 10 * std::numbers::sqrt2) {
  return {.sound_speed = sound_speed_for(9.81, height, coefficient)};
}

/// Column of 5.7 cm x 11.4 cm in 50 x 100 cells, and of 30 cm x 30 cm in 60 x 60 cells.
constexpr double a = 0.057, b = 0.3;
constexpr DamBreak tall_column{
    .width = a, .height = 2 * a, .tank_length = 4 * a, .wall_height = 3.5 * a, .spacing = a / 50};
constexpr DamBreak square_column{
    .width = b, .height = b, .tank_length = 3 * b, .wall_height = 1.75 * b, .spacing = b / 60};

Scene scene_of(DamBreak dam, Lattice lattice, bool corners_twice) {
  dam.lattice = lattice;
  dam.corners_twice = corners_twice;
  return dam_break(dam, water(dam.height));
}

Flume flap_flume() {
  return {.length = 0.06,
          .depth = 0.013,
          .wall_height = 0.03,
          .wavemaking = Wavemaking::flap,
          .stroke = 0.0305,
          .frequency = 2 * std::numbers::pi / 0.308,
          .spacing = 0.001};
}

/// Smallest distance of fluid to fluid and of fluid to walls, in dx.
struct Distances {
  Smallest fluid, wall;

  void add(const Scene& scene) {
    const Particles& p = scene.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.kind[i] != Kind::fluid) continue;
      for (std::size_t k = 0; k < p.size(); ++k) {
        if (k == i) continue;
        const double apart = std::abs(p.x[i] - p.x[k]);
        const double dx = std::isfinite(scene.period.x) ? std::min(apart, scene.period.x - apart) : apart;
        (p.kind[k] == Kind::fluid ? fluid : wall).add(std::hypot(dx, p.z[i] - p.z[k]) / scene.spacing);
      }
    }
  }
};

TEST_CASE("dam breaks have the published numbers of particles", "[geometry]") {
  Check check("wcsph_particle_counts", "Particle counts of the dam breaks",
              "A column of 50 x 100 cells and one of 60 x 60, body-centred, in open tanks whose walls are two "
              "staggered rows: 201 + 200 particles per 200 spacings. The published counts come out with a particle for "
              "each of both walls at their common corners; the square lattice has one particle per cell.");
  using enum Lattice;
  const auto count = [](const DamBreak& dam, Lattice lattice, bool corners_twice) {
    return static_cast<double>(scene_of(dam, lattice, corners_twice).particles.size());
  };
  all_hold(
      check, Bound{0, "a count"},
      {{"Case of the tall column, corners twice: 10000 + 1103.", count(tall_column, body_centred, true), 11103},
       {"The same without duplicates: 10000 + 1101.", count(tall_column, body_centred, false), 11101},
       {"The same on the square lattice: 5000 + 1101.", count(tall_column, square, false), 6101},
       {"Case of the square column, corners twice: 7200 + 783.", count(square_column, body_centred, true), 7983},
       {"The same on the square lattice, without duplicates: 3600 + 781.", count(square_column, square, false), 4381}});

  const Scene scene = scene_of(tall_column, square, false);
  evidence::Figure& figure =
      check.figure("particles", "Dam break, particles of the beginning",
                   "Square lattice of water and staggered rows of walls; right, the lower rear corner.");
  for (const bool corner : {false, true}) {
    auto& panel = figure.panel({.x = "x [m]", .y = "z [m]", .equal_aspect = true});
    for (const bool fluid : {true, false}) {
      std::vector<double> x, z;
      for (std::size_t i = 0; i < scene.particles.size(); ++i) {
        const Place at{scene.particles.x[i], scene.particles.z[i]};
        if ((scene.particles.kind[i] == Kind::fluid) != fluid) continue;
        if (corner && std::max(at.x, at.z) > 10 * scene.spacing) continue;
        x.push_back(at.x);
        z.push_back(at.z);
      }
      panel.points(fluid ? "water" : "walls", x, z, fluid ? Role::computed : Role::bed);
    }
  }
}

TEST_CASE("scenes have the water's mass, regular distances and a hydrostatic start", "[geometry]") {
  Check check("wcsph_scenes", "Particles of the beginning",
              "Every scene on both lattices: the mass agrees with the water's area, no two particles are nearer than "
              "on the lattice, walls of the square lattice stand a spacing from the water's first particles and half a "
              "spacing from its effective end, and the pressure from the density is hydrostatic.",
              "Dalrymple and Rogers, Coastal Eng. 53 (2006) 141, section 2");
  Worst mass_defect;
  Distances square, centred;
  Largest pressure_error;
  for (const Lattice lattice : {Lattice::square, Lattice::body_centred}) {
    Distances& least = lattice == Lattice::square ? square : centred;
    DamBreak dam = square_column;
    dam.spacing = 0.3 / 12;
    dam.wall_height = 21 * dam.spacing;
    Flume with_flap = flap_flume();
    with_flap.lattice = lattice;
    Flume with_piston = with_flap;
    with_piston.wavemaking = Wavemaking::piston;
    const std::vector<std::pair<Scene, double>> scenes{
        {scene_of(dam, lattice, false), 0.09},
        {tank({.width = 0.4, .depth = 0.2, .spacing = 0.02, .lattice = lattice}, water(0.2)), 0.08},
        {flume(with_flap, water(0.013)), 0.06 * 0.013},
        {flume(with_piston, water(0.013)), 0.06 * 0.013},
        {periodic_layer({.period = 0.5, .depth = 0.2, .spacing = 0.02, .lattice = lattice}, water(0.2)), 0.1}};
    for (const auto& [scene, area] : scenes) {
      least.add(scene);
      const Settings settings = water(scene.still_water);
      const TaitFluid tait(settings.density, settings.sound_speed);
      CompensatedSum mass;
      for (std::size_t i = 0; i < scene.particles.size(); ++i) {
        const bool fluid = scene.particles.kind[i] == Kind::fluid;
        if (fluid) mass.add(scene.particles.mass[i]);
        if (!fluid && &scene != &scenes[1].first) continue;  // of walls those of the tank
        const double expected = 1000 * 9.81 * std::max(scene.still_water - scene.particles.z[i], 0.0);
        pressure_error.add(std::abs(tait.pressure(scene.particles.density[i]) - expected) /
                           (1000 * 9.81 * scene.still_water));
      }
      mass_defect.add(mass.value() / (1000 * area) - 1);
    }
  }
  check.that("mass", "The fluid's mass is rho_0 times the area of the water.", "relative defect", {mass_defect.value()},
             Roundoff{10, 1, "dx^2 of rounded lengths; the sum is compensated"});
  const auto in_water = [](double expected) {
    return Roundoff{
        4, 60,
        "two coordinates of up to 60 dx, each a rounded product; the image in the periodic layer, and its period",
        expected};
  };
  const auto at_walls = [](double expected) {
    return Roundoff{6, 100,
                    "a position on a wall is a product with a quotient, added to the start of the wall: numbers of up "
                    "to 100 dx along the bottom of the flume; otherwise as in the water",
                    expected};
  };
  check.that("fluid-square", "Square lattice: neighbours are dx apart.", "distance/dx", {square.fluid.value()},
             in_water(1));
  check.that("fluid-centred", "Body-centred lattice: neighbours are dx/sqrt 2 apart.", "distance/dx",
             {centred.fluid.value()}, in_water(1 / std::numbers::sqrt2));
  check.that("wall-square", "Square lattice: the first row of water is dx from the row of the wall.", "distance/dx",
             {square.wall.value()}, at_walls(1));
  check.that("wall-centred",
             "Body-centred lattice: its first particles are a quarter of a cell inside the water's end, half a spacing "
             "in front of the wall, and a quarter beside its particles.",
             "distance/dx", {centred.wall.value()}, at_walls(std::hypot(0.75, 0.25)));
  check.from("Monaghan, J. Comput. Phys. 110 (1994) 399")
      .that("hydrostatic", "The pressure is rho_0 g (z_s - z), in the water and in the walls of the tank.",
            "largest error over rho_0 g H", {pressure_error.value()},
            Roundoff{10, 200 / 7.0,
                     "B [(rho/rho_0)^7 - 1]: B/(rho_0 g H) = 200/7 multiplies the rounding of the power, about 10 "
                     "operations"});

  const Scene with_flap = flume(flap_flume(), water(0.013));
  Smallest rearmost;
  const Paddle& paddle = with_flap.paddles.at(0);
  for (double phase = 0; phase < 1; phase += 0.01) {
    const double t = 0.308 * phase;
    for (std::size_t i = 0; i < with_flap.particles.size(); ++i) {
      if (with_flap.particles.kind[i] != Kind::paddle) continue;
      rearmost.add(carried(paddle.pose(t), paddle.rate(t), paddle.hinge_x, paddle.hinge_z, with_flap.particles.x[i],
                           with_flap.particles.z[i])
                       .x);
    }
  }
  check.from("interface of the scene")
      .that("sweep", "The length by which the paddle reaches behind the end of the bottom is zero.",
            "rearmost position of the paddle behind the end of the bottom [m]",
            {std::max(with_flap.extents.left - rearmost.value(), 0.0)}, Bound{0, "no particle lies outside"});

  Settings extrapolating = water(0.2);
  extrapolating.walls = WallPressure::extrapolated;
  const Scene thick = tank({.width = 0.4, .depth = 0.2, .spacing = 0.02, .lattice = Lattice::square}, extrapolating);
  check.that(
      "thickness", "Walls that continue the lattice are as thick as the support.", "lowest row of the wall/dx",
      {smallest(thick.particles.z) / thick.spacing},
      Roundoff{6, 10, "a sum of rounded lengths, up to 10 dx", 0.5 - std::ceil(support * extrapolating.smoothing)});

  DamBreak odd = tall_column;
  CHECK(scene_of(odd, Lattice::square, false).warnings.empty());
  odd.width = 0.0575;
  const Scene rounded = scene_of(odd, Lattice::square, false);
  REQUIRE(rounded.warnings.size() == 1);
  CHECK(rounded.warnings[0].find("width") != std::string::npos);
  CHECK(rounded.warnings[0].find("0.05700") == std::string::npos);
  CHECK(rounded.particles.count(Kind::fluid) == 5000);
}

}  // namespace seiche::verification::wcsph_scene_test
