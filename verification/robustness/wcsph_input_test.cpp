// What weakly compressible SPH refuses, and how it stops.
#include <omp.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "verification/robustness/refusals.hpp"
#include "verification/wcsph_problems.hpp"

namespace seiche::verification::wcsph_input_test {

using namespace wcsph;

constexpr double spacing = 0.1;
const Settings good{.sound_speed = 20};

void refuse(const Particles& particles, const Settings& settings, const std::string& word) {
  INFO(word);
  CHECK_THROWS_WITH(Flow(particles, spacing, settings), Catch::Contains(word));
  CHECK_THROWS_AS(Flow(particles, spacing, settings), std::invalid_argument);
}

/// Something good, changed.
template <class Good, class Change>
Good with(Good it, const Change& change) {
  change(it);
  return it;
}

TEST_CASE("settings out of range are rejected by name", "[robustness]") {
  const Particles water = lattice(12, 12, spacing, 1000);
  CHECK_NOTHROW(Flow(water, spacing, good));
  CHECK_THROWS_AS(Flow(water, 0, good), std::invalid_argument);
  CHECK_THROWS_AS(Flow(water, -0.1, good), std::invalid_argument);
  Check check("wcsph_bad_settings", "Bad settings of SPH", "Each number outside of its range.");
  Refusals refusals(check);
  const auto viscous = [&](const auto& viscosity) {
    Flow(water, spacing, with(good, [&](Settings& s) { s.viscosity = viscosity; }));
  };
  refusals.outside_ranges(
      "Settings",
      "smoothing in [0.9, 3]; gravity non-negative and finite; density positive and finite; sound_speed positive and "
      "finite; xsph in [0, 1]; density_diffusion non-negative and finite; courant in [1e-06, 1]",
      good, [&](const Settings& s) { Flow(water, spacing, s); });
  refusals.outside_ranges("ArtificialViscosity", "alpha non-negative and finite", ArtificialViscosity{}, viscous);
  refusals.outside_ranges("LaminarSps",
                          "kinematic_viscosity non-negative and finite; smagorinsky non-negative and finite; isotropic "
                          "non-negative and finite",
                          LaminarSps{}, viscous);
  refuse(water, with(good, [](Settings& s) { s.filter_every = -1; }), "filter");
  refuse(water, with(good, [](Settings& s) { s.lanes = 1; }), "lanes = 1");
  // Three supports with their skin: 3 x 2 x 0.13 x 1.15 m.
  refuse(lattice(8, 8, spacing, 1000), with(good, [](Settings& s) { s.period = {0.8, 0.8}; }), "period");
  CHECK_THROWS_WITH(kernel_named("gaussian"), Catch::Contains("cubic_spline") && Catch::Contains("wendland_c2"));
}

TEST_CASE("invalid particles are rejected", "[robustness]") {
  const Particles water = lattice(12, 12, spacing, 1000);
  const auto changed = [&](const auto& change) { return with(water, change); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuse(changed([&](Particles& p) { p.x[17] = nan; }), good, "17");
  refuse(changed([&](Particles& p) { p.w[17] = nan; }), good, "17");
  refuse(changed([&](Particles& p) { p.mass[17] = 0; }), good, "mass");
  refuse(changed([&](Particles& p) { p.density[17] = -1000; }), good, "density");
  refuse(changed([&](Particles& p) {
           p.x[18] = p.x[17];
           p.z[18] = p.z[17] + 1e-8 * spacing;
         }),
         good, "17");
  refuse(changed([&](Particles& p) { p.add(p.x[17] + 0.4 * spacing, p.z[17], 10, 1000, Kind::wall); }), good, "wall");
  refuse(changed([&](Particles& p) { p.add(3, 3, 10, 1000, Kind::paddle, 0, 0, 0); }), good, "paddle");
  CHECK_THROWS_AS(Flow({}, spacing, good), std::invalid_argument);
  Paddle without_rate = piston(0.1, 6);
  without_rate.rate = {};
  CHECK_THROWS_WITH(Flow(water, spacing, good, {piston(0.1, 6), without_rate}),
                    "paddle 1 has no rate: must have pose and rate");
}

TEST_CASE("the motion of a paddle is evaluated by one thread, few times a step, and may throw", "[robustness]") {
  Check check("wcsph_paddle_calls", "Calls of a paddle's functions",
              "A flume with a flap and extrapolated walls, 100 steps with two threads. The paddle's functions are the "
              "user's: they are called outside of parallel loops, at times from 0 on, a few times a step for any "
              "number of particles, and their exceptions reach the caller, with the particles as before the step.");
  const Settings settings{.sound_speed = 10, .walls = WallPressure::extrapolated};
  // Enough particles for two threads.
  Scene scene = flume({.length = 1, .depth = 0.25, .stroke = 0.05, .frequency = 12, .spacing = 0.005}, settings);
  const int usual = omp_get_max_threads();
  omp_set_num_threads(2);
  std::atomic<long> calls = 0, in_parallel = 0, before_zero = 0;
  double last = std::numeric_limits<double>::infinity();
  const auto watched = [&](const std::function<Pose(double)>& motion) {
    return [&, motion](double time) {
      ++calls;
      in_parallel += omp_in_parallel() != 0 ? 1 : 0;
      before_zero += time < 0 ? 1 : 0;
      if (omp_in_parallel() == 0 && time > last) throw std::runtime_error("the paddle's record ends");
      return motion(time);
    };
  };
  for (Paddle& paddle : scene.paddles) {
    paddle.pose = watched(paddle.pose);
    paddle.rate = watched(paddle.rate);
  }
  Flow flow(scene.particles, scene.spacing, settings, scene.paddles);
  long most = 0;
  for (int n = 0; n < 100; ++n) {
    const long before = calls;
    flow.advance(flow.stable_step());
    if (calls - before > most) most = calls - before;
  }
  last = flow.time();
  const std::vector<double> x = flow.particles().x;
  const double time = flow.time();
  CHECK_THROWS_WITH(flow.advance(flow.stable_step()), "the paddle's record ends");
  omp_set_num_threads(usual);
  CHECK(flow.particles().x == x);
  CHECK(flow.time() == time);
  check.holds("The paddle's functions are called outside of parallel loops.", {static_cast<double>(in_parallel)},
              Bound{0, "they are the user's, and may throw or share data"});
  check.holds("The paddle's functions are called at times from 0 on.", {static_cast<double>(before_zero)},
              Bound{0, "a measured motion begins at 0"});
  check.holds("The paddle's functions are called a few times a step.", {static_cast<double>(most)},
              Bound{20,
                    "pose and rate at two instants for each of at most three evaluations, and at one for each of at "
                    "most four positions: 20"});
}

TEST_CASE("a computation that breaks down reports time and position, and retains the last valid state",
          "[robustness]") {
  Particles water = lattice(12, 12, spacing, 1000);
  // Two halves meet at the speed of sound: the density leaves [0.5, 1.5] rho_0.
  for (std::size_t a = 0; a < water.size(); ++a) water.u[a] = water.x[a] < 0.6 ? 40 : -40;
  Flow flow(water, spacing, good);
  std::string message;
  double time = -1;
  try {
    for (int step = 0; step < 1000; ++step) flow.advance(0.004);
  } catch (const Divergence& divergence) {
    message = divergence.what();
    time = divergence.time();
  }
  INFO(message);
  CHECK_THAT(message, Catch::Contains("density") || Catch::Contains("finite"));
  CHECK(time == flow.time());
  const Particles& p = flow.particles();
  for (std::size_t a = 0; a < p.size(); ++a) {
    CHECK(std::isfinite(p.x[a]));
    CHECK(p.density[a] >= 500);
    CHECK(p.density[a] <= 1500);
  }
  CHECK_THROWS_AS(Flow(water, spacing, good).advance(std::numeric_limits<double>::quiet_NaN()), std::exception);
}

}  // namespace seiche::verification::wcsph_input_test
