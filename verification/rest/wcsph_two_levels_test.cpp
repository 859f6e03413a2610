// Water of two levels beside each other: what a dam break over water begins with.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::wcsph_two_levels_test {

using namespace wcsph;

constexpr double gravity = 9.81, column = 0.4, basin = 1, high = 0.3, dx = 0.02;
const std::string source = "Monaghan, J. Comput. Phys. 110 (1994) 399";

Settings still(WallPressure walls) {
  return {.gravity = gravity, .sound_speed = sound_speed_for(gravity, high), .walls = walls};
}

Scene levels(double low, Lattice lattice, const Settings& settings) {
  return dam_break({.width = column,
                    .height = high,
                    .water_ahead = low,
                    .tank_length = basin + dx,
                    .wall_height = 2 * high,
                    .spacing = dx,
                    .lattice = lattice},
                   settings);
}

/// In a lattice's order: from left to right, and upwards on a line.
std::vector<std::size_t> fluid_in_order(const Particles& p) {
  std::vector<std::size_t> fluid;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.kind[i] == Kind::fluid) fluid.push_back(i);
  }
  std::sort(fluid.begin(), fluid.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(p.x[a] - p.x[b]) > 0.1 * dx ? p.x[a] < p.x[b] : p.z[a] < p.z[b];
  });
  return fluid;
}

TEST_CASE("water of two levels is in balance on both sides", "[rest]") {
  Check check(
      "wcsph_two_levels", "Two levels of water in SPH",
      "A column 0.3 m high beside water of 0.1 m, and beside water of equal height: then the gate has no effect.",
      source);
  constexpr double low = 0.1;
  const Settings plain = still(WallPressure::dynamic);
  const TaitFluid fluid(plain.density, plain.sound_speed);
  Worst pressure_error, area_error;
  for (const Lattice lattice : {Lattice::square, Lattice::body_centred}) {
    const Scene scene = levels(low, lattice, plain);
    const Particles& p = scene.particles;
    double behind = 0, ahead = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const bool in_column = p.x[i] <= column;
      const double expected = std::max((in_column ? high : low) - p.z[i], 0.0);
      pressure_error.add(fluid.pressure(p.density[i]) / (plain.density * gravity * high) - expected / high);
      if (p.kind[i] == Kind::fluid) (in_column ? behind : ahead) += p.mass[i] / plain.density;
    }
    area_error.add(behind / (column * high) - 1);
    area_error.add(ahead / ((basin - column) * low) - 1);
  }
  check.that(
      "hydrostatic", "The pressure agrees with the depth below the level of its side, in water and walls.",
      "largest error over rho_0 g H", {pressure_error.value()},
      Roundoff{10, 100 / 7.0, "B [(rho/rho_0)^7 - 1]: B/(rho_0 g H) = 100/7 multiplies the rounding of the power"});
  check.that("area", "Column and water ahead have the area of their rectangles.", "largest relative error",
             {area_error.value()}, Roundoff{900, 1, "a rounding per particle of up to 900 on a side"});

  Worst place_error, density_error;
  for (const Lattice lattice : {Lattice::square, Lattice::body_centred}) {
    const Particles level = levels(high, lattice, plain).particles;
    const Particles whole = tank({.width = basin, .depth = high, .spacing = dx, .lattice = lattice}, plain).particles;
    const std::vector<std::size_t> one = fluid_in_order(level), other = fluid_in_order(whole);
    place_error.add(static_cast<double>(one.size()) - static_cast<double>(other.size()));
    for (std::size_t k = 0; k < std::min(one.size(), other.size()); ++k) {
      const std::size_t a = one[k], b = other[k];
      place_error.add((level.x[a] - whole.x[b]) / dx);
      place_error.add((level.z[a] - whole.z[b]) / dx);
      density_error.add(level.density[a] / whole.density[b] - 1);
    }
  }
  check.that("place", "Equal levels: the water is a tank's.", "largest distance over dx, or particles too many",
             {place_error.value()}, Roundoff{4, 50, "coordinates of up to 50 dx, counted from the gate"});
  check.that("density", "Equal levels: its density equals the reference.", "largest relative difference",
             {density_error.value()}, Roundoff{4, 1, "of the same depth, to its rounding"});

  // Pairs of water cancel: what is left of the momentum's rate is the push of the two end walls.
  // Staggered rows, twice as dense as the water, push too hard before the water has made room: not these.
  const Settings followed = still(WallPressure::extrapolated);
  Flow parted(levels(low, Lattice::square, followed).particles, dx, followed);
  const Rates rates = parted.rates();
  double push = 0;
  for (std::size_t i = 0; i < rates.du.size(); ++i) {
    if (parted.particles().kind[i] == Kind::fluid) push += parted.particles().mass[i] * rates.du[i];
  }
  check.that("push",
             "The rate of the momentum agrees with the pressures on the end walls within one spacing over the depth.",
             "rate of the momentum over rho g (H^2 - h^2)/2",
             {push / (0.5 * plain.density * gravity * (high * high - low * low))},
             Bound{dx / high,
                   "where the surface meets the wall half of a spacing of water is not known better: the pressure at "
                   "the floor over that height",
                   1});

  Flow rest(levels(high, Lattice::square, followed).particles, dx, followed);
  march(rest, 0.5);
  Mean square;  // of the water's velocities
  for (const std::size_t i : fluid_in_order(rest.particles())) {
    square.add(std::pow(rest.particles().u[i], 2) + std::pow(rest.particles().w[i], 2));
  }
  check.that(
      "rest",
      "The rms velocity of equal levels without a gate is below a sound wave with the pressure of one spacing of "
      "water.",
      "rms velocity over sqrt(g H) after 0.5 s", {std::sqrt(square.value() / (gravity * high))},
      Bound{dx / high * 0.1, "sound whose pressure rho c u equals one spacing of water: dx/H sqrt(g H)/c"});
}

}  // namespace seiche::verification::wcsph_two_levels_test
