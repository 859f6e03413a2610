// The pressure that a gauge in a wall reads: hydrostatic water, and linear pressures.
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "seiche/models/wcsph/scene.hpp"
#include "validation/instruments/particles/sph_wall_gauge.hpp"
#include "verification/check.hpp"

namespace seiche::verification::wcsph_wall_gauge_test {

using namespace wcsph;

constexpr double gravity = 9.81;
constexpr double depth = 0.5;
constexpr double wall_x = 1;

Settings water(double felt) {
  return {.kernel = KernelName::wendland_c2,
          .smoothing = 2,
          .gravity = felt,
          .sound_speed = 40,
          .walls = WallPressure::extrapolated};
}

/// A tank whose water has the pressure p_0 + along (z - depth/2) + normal (x - wall_x).
Flow with_pressure(double spacing, const Settings& settings, double along, double normal) {
  Scene scene = tank({.width = wall_x, .depth = depth, .spacing = spacing}, settings);
  const TaitFluid fluid(settings.density, settings.sound_speed);
  Particles& p = scene.particles;
  for (std::size_t a = 0; a < p.size(); ++a) {
    if (p.kind[a] != Kind::fluid) continue;
    p.density[a] = fluid.density_at(5000 + along * (p.z[a] - depth / 2) + normal * (p.x[a] - wall_x));
  }
  return {p, spacing, settings};
}

TEST_CASE("a gauge in a wall reads hydrostatic pressure, and the pressure of the water beside it", "[manufactured]") {
  Check check("wcsph_wall_gauge", "Pressure on a gauge in a wall",
              "A tank of water 1 m x 0.5 m with given pressures and a round gauge in its wall. Hydrostatic: the gauge "
              "reads $\\rho_0 g$ times the depth of its middle. A pressure linear along the wall: about a height of "
              "symmetry of the lattice its mean equals the value at the middle, to round-off. A pressure linear "
              "towards the wall: the reading belongs to the centroid of the weights; halving the spacing halves the "
              "error. Without water the pressure is zero.",
              "Shepard, Proc. 23rd ACM National Conference (1968) 517");
  const double spacing = 0.025;
  const double diameter = 0.02;
  const auto pressure = [](const Flow& flow, double z, double across) {
    return pressure_on({.x = wall_x, .z = z, .diameter = across}, flow);
  };
  const Settings still = water(gravity);
  const Flow flow(tank({.width = wall_x, .depth = depth, .spacing = spacing}, still).particles, spacing, still);
  for (const double z : {0.01, 0.1, 0.25}) {
    check.holds(fmt::format("hydrostatic-{:.0f}: The gauge reads the pressure of its depth.", 100 * z),
                {pressure(flow, z, diameter)},
                Bound{1000 * gravity * 2 * flow.smoothing_length() * gravity * depth / (40 * 40.0),
                      "densities are up to rho_0 (1 + g H/c_0^2): so much more weight over the support",
                      1000 * gravity * (depth - z)});
  }
  CHECK(pressure(flow, 0.9, diameter) == 0);
  CHECK_THROWS_AS(pressure(flow, 0.1, -1), std::invalid_argument);
  const Flow along = with_pressure(spacing, water(0), 2000, 0);
  check.that("along",
             "A pressure that is linear along the wall is read in the middle of the face within P/(rho c^2) over the "
             "support, 2 h.",
             "pressure [Pa]", {pressure(along, depth / 2, diameter)},
             Bound{2000 * 2 * 2 * spacing * 5000 / (1000 * 1600.0),
                   "volumes m/rho differ by P/(rho_0 c_0^2), 5000 of 1.6e6, over the support", 5000});
  const auto error = [&](int parts) {
    return pressure(with_pressure(spacing / parts, water(0), 0, 4000), depth / 2, diameter / parts) - 5000;
  };
  check.that(
      "normal",
      "A pressure that rises towards the wall is read at the centre of the weights, -0.424, within 0.02 of its "
      "gradient.",
      "error over its gradient times h", {error(1) / (4000 * 2 * spacing)},
      Bound{0.02,
            "-0.424: the centre of half of the kernel, 2/pi int w q^2 dq/int w q dq; rows of the lattice at h/4, 3h/4, "
            "... add (1/24)(dx/h)^2 W_1(0)/(1/2) = 0.016 to its distance, W_1 the kernel's integral along the wall",
            -0.424});
  check.that("order", "The error of the reading halves with the spacing.", "error over that with twice the spacing",
             {error(2) / error(1)}, Bound{0.01, "volumes m/rho differ by up to 5000 Pa over 1.6e6 Pa", 0.5});
}

}  // namespace seiche::verification::wcsph_wall_gauge_test
