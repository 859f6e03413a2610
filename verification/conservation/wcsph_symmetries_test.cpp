// What must not change a computation by weakly compressible SPH: a carriage under the tank, and the way the sums are
// made.
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/wcsph_direct_sums.hpp"
#include "verification/wcsph_problems.hpp"

namespace seiche::verification::wcsph_symmetries_test {

using namespace wcsph;

constexpr double spacing = 0.1;
constexpr std::size_t side = 12;
constexpr double length = side * spacing;
/// Of velocities over the sound speed and of densities over rho_0, after 50 steps.
const Roundoff steps_of_two_runs{
    .operations = 100,
    .scale = 1,
    .reason =
        "each of 50 steps rounds a density of about rho_0, in both runs; its pressure, rho_0 c_0^2 eps, changes a "
        "velocity by c_0 dt/dx = 0.26 of c_0 eps per step, the velocity's own rounding is less"};
const Settings periodic{
    .gravity = 0, .sound_speed = 20, .viscosity = ArtificialViscosity{0.3}, .period = {length, length}};

/// A disordered box with smooth velocities of order 1.
Particles box() {
  Particles particles = lattice(side, side, spacing, 1000);
  jitter(particles, 0.2 * spacing);
  const double k = 2 * std::numbers::pi / length;
  for (std::size_t a = 0; a < particles.size(); ++a) {
    particles.u[a] = std::sin(k * particles.x[a]) * std::cos(k * particles.z[a]);
    particles.w[a] = -std::cos(k * particles.x[a]) * std::sin(k * particles.z[a]);
  }
  return particles;
}

/// Velocities less (u, 0) and densities, in the order of identities.
struct Result {
  std::vector<double> u, w, density;
};

Result after_50_steps(Flow flow, double step, double u = 0) {
  for (int n = 0; n < 50; ++n) flow.advance(step);
  const Particles& p = flow.particles();
  Result result{sorted_back(p, p.u), sorted_back(p, p.w), sorted_back(p, p.density)};
  for (double& value : result.u) value -= u;
  return result;
}

double largest_difference(const std::vector<double>& one, const std::vector<double>& other) {
  Worst difference;
  for (std::size_t a = 0; a < one.size(); ++a) difference.add(one[a] - other[a]);
  return difference.value();
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

TEST_CASE("a tank that is carried at a uniform velocity sees nothing of it", "[conservation]") {
  Check check("wcsph_carried_tank", "Tank carried at a uniform velocity",
              "Water settling in a tank, 50 steps: with all walls carried by a paddle at 2 m/s and the water at the "
              "same velocity, against walls that stand. Wall particles must be where their motion has them at every "
              "stage of a step.",
              "Galilean invariance");
  const Settings settings{.sound_speed = 20, .viscosity = ArtificialViscosity{0.1}};
  const Scene still =
      tank({.width = 12 * spacing, .depth = 6 * spacing, .spacing = spacing, .hydrostatic = false}, settings);
  constexpr double velocity = 2;
  Particles carried = still.particles;
  for (std::size_t a = 0; a < carried.size(); ++a) {
    carried.u[a] = velocity;
    if (carried.kind[a] != Kind::wall) continue;
    carried.kind[a] = Kind::paddle;
    carried.body[a] = 0;
  }
  const Paddle cart{.pose =
                        [](double t) {
                          return Pose{velocity * t, 0};
                        },
                    .rate =
                        [](double) {
                          return Pose{velocity, 0};
                        }};
  const double step = 0.2 * 1.3 * spacing / settings.sound_speed;
  const Result standing = after_50_steps(Flow(still.particles, spacing, settings), step);
  const Result moving = after_50_steps(Flow(carried, spacing, settings, {cart}), step, velocity);
  const double fastest = largest(standing.w);
  CHECK(fastest > 0.01);
  check.that("velocity", "Velocities relative to the tank agree with a standing tank.",
             "largest difference over the sound speed",
             {worst(std::array{largest_difference(standing.u, moving.u), largest_difference(standing.w, moving.w)}) /
              settings.sound_speed},
             steps_of_two_runs);
  check.that("density", "Densities, of walls too, agree with a standing tank.", "largest difference over rho_0",
             {largest_difference(standing.density, moving.density) / 1000}, steps_of_two_runs);
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
  check.that("energy", "After 600 steps the kinetic energies have the same digits.", "kinetic energy [J/m]",
             {.value = flow.totals().kinetic, .resolution = "N = 144, 600 steps"},
             Bound{1e-10, "ten digits: 600 steps of 100 roundings, with room for their growth in a disordered flow",
                   kinetic_energy(direct), true});
  CHECK(flow.extremes().rebuilds > 3);
}

}  // namespace seiche::verification::wcsph_symmetries_test
