// Layers with an uneven surface and round patches: masses, moments and fields of their particles.
#include <cmath>
#include <numbers>
#include <string>

#include "seiche/compensated_sum.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::wcsph_layer_test {

using namespace wcsph;

constexpr double depth = 0.1;
const Settings water{.sound_speed = 14};

double elevation(double x) {
  return 0.5 * depth * std::cos(2 * std::numbers::pi * x);
}

TEST_CASE("layers follow their surface and patches their circle", "[geometry]") {
  Check check("wcsph_layers_patches", "Layers with an uneven surface and round patches",
              "A cosine of half the depth on columns of constant spacing: the mass is exact. A disc of 1 "
              "m: the count, the second moment that the lattice gives it, velocities and pressures at the particles.",
              "Dalrymple and Rogers, Coastal Eng. 53 (2006) 141, section 2");
  const Particles wavy =
      periodic_layer({.period = 1, .depth = depth, .elevation = elevation, .spacing = depth / 10}, water).particles;
  CompensatedSum mass;
  Smallest lightest;
  Largest heaviest;
  for (std::size_t i = 0; i < wavy.size(); ++i) {
    if (wavy.kind[i] != Kind::fluid) continue;
    mass.add(wavy.mass[i]);
    lightest.add(wavy.mass[i] / 0.1);
    heaviest.add(wavy.mass[i] / 0.1);
  }
  check.that("columns", "The area below the surface is represented by columns of equal spacing.",
             "relative error of the mass", {mass.value() / (1000 * depth) - 1},
             Roundoff{20, 1,
                      "the mean of three depths; the sum is compensated, and the elevation's means over all strips "
                      "cancel by symmetry"});
  check.from("interface of the scene")
      .that("masses", "The particle masses of columns of equal spacing are nearly equal.", "heaviest over lightest",
            {heaviest.value() / lightest.value()},
            Bound{0.2, "in the lowest column of 5.0 dx half a spacing is a tenth up or down", 1});

  const auto stretching = [](double x, double z) { return Velocity{-x, z}; };
  const auto pressure = [](double x, double z) { return 500 * (1 - x * x - z * z); };
  const Scene disc = patch({.radius = 1, .velocity = stretching, .pressure = pressure, .spacing = 0.02}, water);
  Largest wrong;
  const TaitFluid fluid(1000, 14);
  const Particles& p = disc.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    wrong.add(std::abs(p.u[i] + p.x[i]));
    wrong.add(std::abs(p.w[i] - p.z[i]));
    wrong.add(std::abs(fluid.pressure(p.density[i]) - pressure(p.x[i], p.z[i])) / 500);
  }
  check.from("lattice points of half-integers in a circle of radius 50")
      .that("disc", "A disc of 1 m at dx = 0.02 m has 7860 particles.", "particles", {static_cast<double>(p.size())},
            Bound{0, "a count", 7860});
  check.from("interface of the scene")
      .that("fields", "Velocity and pressure at the particles are the given ones.",
            "largest error, over 1 m/s and 500 Pa", {wrong.value()},
            Roundoff{10, 28000 / 500.0, "B = 28000 Pa times the rounding of a power"});
}

}  // namespace seiche::verification::wcsph_layer_test
