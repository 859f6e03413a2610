// Rates and runs of weakly compressible SPH against plain sums over all pairs, for every model, kernel and boundary;
// and a carriage under the tank, which must change nothing.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/differences.hpp"
#include "verification/conservation/wcsph_direct_sums.hpp"
#include "verification/wcsph_problems.hpp"

namespace seiche::verification::wcsph_rates_test {

using namespace wcsph;

constexpr double spacing = 0.1;

/// A jittered layer over a floor, repeated in x.
Particles layer(std::size_t columns, std::size_t rows) {
  const Particles water = noisy_square(columns, spacing);
  Particles wall, all;
  for (std::size_t a = 0; a < columns * rows; ++a) {
    all.add(water.x[a], water.z[a] + 0.5 * spacing, water.mass[a], water.density[a], Kind::fluid, water.u[a],
            water.w[a]);
  }
  const double length = static_cast<double>(columns) * spacing;
  add_floor(wall, 0, length, spacing, 1000);
  Noise noise(11);
  for (std::size_t a = 0; a < wall.size(); ++a) {
    const double density = 1000 * (1 + 0.02 * noise());
    // The last one is the image of the first.
    if (wall.x[a] < length - 0.25 * spacing) all.add(wall.x[a], wall.z[a], wall.mass[a], density, Kind::wall);
  }
  return all;
}

struct Setup {
  std::string id, name;
  Particles particles;
  Period period;
  double deviation;  ///< of densities from rho_0, relative
};

constexpr double side = 16 * spacing;
const std::vector<Setup> periodic_setups{{"box", "periodic box", noisy_square(16, spacing), {side, side}, 0.02},
                                         {"floor", "layer over a floor", layer(16, 10), {.x = side}, 0.02}};

/// Particles side by side: the loops exist for every width of registers.
constexpr std::array widths{2, 4, 8};

TEST_CASE("rates equal the sums over all pairs for every viscosity, kernel and boundary", "[conservation]") {
  Check check("wcsph_rates", "Rates against sums over all pairs",
              "The right-hand sides of (2)-(6) on disordered particles with random velocities, densities and masses: "
              "the tiled, clustered evaluation against sums over all N^2 pairs written straight from the formulas. A "
              "free blob, a box that repeats itself in both directions and a layer over a floor of dynamic particles; "
              "both kernels; inviscid, artificial viscosity, laminar viscosity with and without sub-particle-scale "
              "stress; two, four and eight particles side by side where the machine has them. Largest difference over "
              "the largest rate.");
  const std::vector<std::pair<std::string, Viscosity>> models{
      {"no viscosity", Inviscid{}},
      {"artificial viscosity", ArtificialViscosity{0.3}},
      {"laminar viscosity", LaminarSps{0.01, 0, 0}},
      {"laminar and sub-particle-scale stress", LaminarSps{0.01, 0.12, 0.0066}}};
  std::vector<Setup> setups{{"blob", "free blob", random_blob(spacing, 1000, 1), {}, 0.01}};
  setups.insert(setups.end(), periodic_setups.begin(), periodic_setups.end());
  for (const Setup& setup : setups) {
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
      for (const auto& [name, viscosity] : models) {
        Largest difference;
        for (const int lanes : widths) {
          const Settings settings{.kernel = kernel,
                                  .smoothing = kernel == KernelName::cubic_spline ? 1.3 : 1.6,
                                  .sound_speed = 20,
                                  .viscosity = viscosity,
                                  .period = setup.period,
                                  .lanes = lanes};
          Flow flow(setup.particles, spacing, settings);
          difference.add(compare(flow, spacing));
          CHECK(flow.extremes().interactions == DirectSums(flow.particles(), spacing, settings).pairs());
        }
        check.holds(
            fmt::format("{}, {} kernel, {}: all rates agree with the sums over all pairs.", setup.name, name_of(kernel),
                        name),
            {difference.value()},
            Roundoff{4, 1 / setup.deviation,
                     "pressures are differences (rho/rho_0)^7 - 1 of densities within 1 % (blob) or 2 %: the rounding "
                     "of rho/rho_0, of both particles and in both ways of summing, counts 100 or 50 times; of the 40 "
                     "others of a pair each counts once, all together less than one of these"});
      }
    }
  }
}

TEST_CASE("rates equal the sums over all pairs with clamped walls and density diffusion", "[conservation]") {
  Check check("wcsph_rates_options", "Rates of the options against sums over all pairs",
              "The same for options: no smoothed motion, walls that do not suck or whose pressure is extrapolated from "
              "the fluid, and density diffusion with corrected gradients, whose correction here is the inverse of the "
              "matrix of first moments of the fluid.");
  const std::vector<std::pair<std::string, Settings>> options{
      {"no smoothed motion", {.xsph = 0}},
      {"clamped walls", {.walls = WallPressure::clamped}},
      {"density diffusion", {.density_diffusion = 0.1}},
      {"extrapolated walls", {.walls = WallPressure::extrapolated}}};
  for (const Setup& setup : periodic_setups) {
    for (auto [name, settings] : options) {
      settings.sound_speed = 20;
      settings.viscosity = ArtificialViscosity{0.1};
      settings.period = setup.period;
      Largest difference;
      for (const int lanes : widths) {
        settings.lanes = lanes;
        Flow flow(setup.particles, spacing, settings);
        // Walls are clamped by steps.
        flow.advance(1e-4);
        difference.add(compare(flow, spacing));
        const Rates once = flow.rates();
        const bool same = once.ddensity == flow.rates().ddensity && once.dw == flow.rates().dw;
        CHECK(same);
      }
      std::string id = setup.id + "-" + name;
      std::replace(id.begin(), id.end(), ' ', '-');
      check.holds(id + ": " + fmt::format("{}, {}: all rates agree with the sums over all pairs.", setup.name, name),
                  {difference.value()},
                  Roundoff{6, 1 / setup.deviation,
                           "as for the plain rates, and two roundings of rho/rho_0 more where the pressure of a wall "
                           "becomes a density and a pressure again"});
    }
  }
}

TEST_CASE("particle shifting agrees with sums over all pairs", "[conservation]") {
  Check check("wcsph_shifting", "Particle shifting against sums over all pairs",
              "A jittered square of 21 by 21 particles with random velocities and densities, after a step in which the "
              "longest shift is cut off: positions, velocities and densities against sums over all pairs. Particles at "
              "its edge and their neighbours stay.");
  constexpr double tau = 0.015;
  for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
    Largest difference;
    for (const int lanes : widths) {
      Settings settings{.kernel = kernel, .gravity = 0, .sound_speed = 2, .lanes = lanes};
      Flow plain(noisy_square(21, spacing), spacing, settings);
      settings.particle_shifting = true;
      Flow shifting(noisy_square(21, spacing), spacing, settings);
      plain.advance(tau);
      shifting.advance(tau);
      const Particles& before = plain.particles();
      const Particles& found = shifting.particles();
      const Particles direct = DirectSums(before, spacing, settings).shifted(tau);
      const auto compared = [&](std::vector<double> Particles::*member, double scale) {
        difference.add(largest_difference(sorted_back(found, found.*member), sorted_back(before, direct.*member)) /
                       scale);
      };
      compared(&Particles::x, spacing);
      compared(&Particles::z, spacing);
      compared(&Particles::u, 1);
      compared(&Particles::w, 1);
      compared(&Particles::density, 1000);
      long shifted = 0;
      Largest shift;
      for (std::size_t a = 0; a < before.size(); ++a) {
        shifted += direct.x[a] != before.x[a] ? 1 : 0;
        shift.add(std::hypot(direct.x[a] - before.x[a], direct.z[a] - before.z[a]));
      }
      CHECK(shifted > 100);
      CHECK(shifted < 400);
      CHECK(shift.value() > 0.0999 * spacing);
    }
    check.holds(fmt::format("Particles are shifted as by sums over all pairs ({}).", name_of(kernel)),
                {difference.value()},
                Roundoff{2, 21,
                         "the two positions are rounded as numbers of up to 21 dx; the shift, 0.1 dx or less, and "
                         "velocities and densities have errors below that"});
  }
}

TEST_CASE("the time step agrees with sums over all pairs", "[conservation]") {
  Check check("wcsph_step_rule", "Length of the step",
              "$\\Delta t = 0.3\\min_a h_a/(c_a + \\sigma_a)$ with $\\sigma_a$ the largest $|h_{ab}\\,u_{ab}\\cdot "
              "r_{ab}|/(r_{ab}^2 + 0.01 h_{ab}^2)$ over neighbours inside the support.",
              "Monaghan, J. Comput. Phys. 110 (1994) 399");
  Flow flow(noisy_square(16, spacing), spacing,
            {.sound_speed = 20, .viscosity = ArtificialViscosity{0.1}, .period = {side, side}});
  const double expected = DirectSums(noisy_square(16, spacing), spacing, flow.settings()).largest_step();
  check.that("step", "The first step has the length of the rule.", "dt [s]", {flow.stable_step()},
             Roundoff{40, expected,
                      "two evaluations of some 10 roundings of h, of the sound speed and of their quotient, and one of "
                      "rho/rho_0, which the cube of the sound speed counts three times (as 9)",
                      expected});
}

constexpr std::size_t across = 12;
constexpr double length = across * spacing;
/// Of velocities over the sound speed and of densities over rho_0, after 50 steps.
const Roundoff steps_of_two_runs{
    100, 1,
    "each of 50 steps rounds a density of about rho_0, in both runs; its pressure, rho_0 c_0^2 eps, changes a velocity "
    "by c_0 dt/dx = 0.26 of c_0 eps per step, the velocity's own rounding is less"};
const Settings periodic{
    .gravity = 0, .sound_speed = 20, .viscosity = ArtificialViscosity{0.3}, .period = {length, length}};

/// A disordered box with smooth velocities of order 1.
Particles box() {
  Particles particles = lattice(across, across, spacing, 1000);
  jitter(particles, 0.2 * spacing);
  const double k = 2 * std::numbers::pi / length;
  for (std::size_t a = 0; a < particles.size(); ++a) {
    particles.u[a] = std::sin(k * particles.x[a]) * std::cos(k * particles.z[a]);
    particles.w[a] = -std::cos(k * particles.x[a]) * std::sin(k * particles.z[a]);
  }
  return particles;
}

/// Velocities less (u, 0) and densities, in the order of identities.
std::array<std::vector<double>, 3> after_50_steps(Flow flow, double step, double u = 0) {
  for (int n = 0; n < 50; ++n) flow.advance(step);
  const Particles& p = flow.particles();
  std::array result{sorted_back(p, p.u), sorted_back(p, p.w), sorted_back(p, p.density)};
  for (double& value : result[0]) value -= u;
  return result;
}

/// The midpoint rule with sums over all pairs, no walls.
Particles midpoint(const Particles& start, const Settings& settings, double step) {
  const auto moved = [&](const Particles& at, double interval) {
    const Rates rates = DirectSums(at, spacing, settings).rates();
    Particles result = start;
    for (std::size_t a = 0; a < start.size(); ++a) {
      result.x[a] += interval * rates.dx[a];
      result.z[a] += interval * rates.dz[a];
      result.u[a] += interval * rates.du[a];
      result.w[a] += interval * rates.dw[a];
      result.density[a] += interval * rates.ddensity[a];
    }
    return result;
  };
  return moved(moved(start, 0.5 * step), step);
}

double kinetic_energy(const Particles& p) {
  double sum = 0;
  for (std::size_t a = 0; a < p.size(); ++a) sum += 0.5 * p.mass[a] * (p.u[a] * p.u[a] + p.w[a] * p.w[a]);
  return sum;
}

TEST_CASE("a tank carried at a uniform velocity is unaffected by it", "[conservation]") {
  Check check("wcsph_carried_tank", "Tank carried at a uniform velocity",
              "Water settling in a tank, 50 steps: with all walls carried by a paddle at 2 m/s and the water at the "
              "same velocity, against walls that stand. Wall particles must be where their motion has them at every "
              "stage of a step.",
              "Galilean invariance");
  const Settings settings{.sound_speed = 20, .viscosity = ArtificialViscosity{0.1}};
  Scene still = tank({.width = 12 * spacing, .depth = 6 * spacing, .spacing = spacing}, settings);
  std::ranges::fill(still.particles.density, settings.density);
  constexpr double velocity = 2;
  Particles carried = still.particles;
  for (std::size_t a = 0; a < carried.size(); ++a) {
    carried.u[a] = velocity;
    if (carried.kind[a] != Kind::wall) continue;
    carried.kind[a] = Kind::paddle;
    carried.body[a] = 0;
  }
  const auto pose = [](double t) { return Pose{velocity * t, 0}; };
  const auto rate = [](double) { return Pose{velocity, 0}; };
  const Paddle cart{.pose = pose, .rate = rate};
  const double step = 0.2 * 1.3 * spacing / settings.sound_speed;
  const auto [u, w, density] = after_50_steps(Flow(still.particles, spacing, settings), step);
  const auto [moving_u, moving_w, moving_density] =
      after_50_steps(Flow(carried, spacing, settings, {cart}), step, velocity);
  CHECK(largest(w) > 0.01);
  check.that(
      "velocity", "Velocities relative to the tank agree with a standing tank.",
      "largest difference over the sound speed",
      {worst(std::array{largest_difference(u, moving_u), largest_difference(w, moving_w)}) / settings.sound_speed},
      steps_of_two_runs);
  check.that("density", "Densities, of walls too, agree with a standing tank.", "largest difference over rho_0",
             {largest_difference(density, moving_density) / 1000}, steps_of_two_runs);
}

TEST_CASE("runs agree with sums over all pairs step by step", "[conservation]") {
  Check check("wcsph_run_of_direct_sums", "A run against sums over all pairs",
              "600 steps of a disordered box, by Flow with its candidate lists and rebuilds, and by the midpoint rule "
              "on sums over all pairs: no list may miss a neighbour at any stage of any step.",
              "formulas (2)-(8)");
  const double step = 0.25 * 1.3 * spacing / periodic.sound_speed;
  Flow flow(box(), spacing, periodic);
  Particles direct = box();
  for (int n = 0; n < 600; ++n) {
    flow.advance(step);
    direct = midpoint(direct, periodic, step);
  }
  check.that("energy", "The kinetic energies after 600 steps agree to ten digits.", "kinetic energy [J/m]",
             {.value = flow.totals().kinetic, .resolution = "N = 144, 600 steps"},
             Bound{1e-10, "ten digits: 600 steps of 100 roundings, with room for their growth in a disordered flow",
                   kinetic_energy(direct), true});
  CHECK(flow.extremes().rebuilds > 3);
}

}  // namespace seiche::verification::wcsph_rates_test
