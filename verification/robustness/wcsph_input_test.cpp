// What weakly compressible SPH refuses, and how it stops.
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "verification/check.hpp"
#include "verification/wcsph_problems.hpp"

namespace wcsph_input_test {

using namespace seiche::wcsph;
using namespace seiche::verification;

constexpr double spacing = 0.1;
const Settings good{.sound_speed = 20};

void refuse(const Particles& particles, const Settings& settings, const std::string& word) {
  INFO(word);
  CHECK_THROWS_WITH(Flow(particles, spacing, settings), Catch::Contains(word));
  CHECK_THROWS_AS(Flow(particles, spacing, settings), std::invalid_argument);
}

Settings with(const std::function<void(Settings&)>& change) {
  Settings settings = good;
  change(settings);
  return settings;
}

TEST_CASE("settings out of range are refused by name", "[robustness]") {
  const Particles water = lattice(12, 12, spacing, 1000);
  CHECK_NOTHROW(Flow(water, spacing, good));
  CHECK_THROWS_AS(Flow(water, 0, good), std::invalid_argument);
  CHECK_THROWS_AS(Flow(water, -0.1, good), std::invalid_argument);
  refuse(water, with([](Settings& s) { s.smoothing = 0.89; }), "smoothing");
  refuse(water, with([](Settings& s) { s.smoothing = 3.01; }), "smoothing");
  refuse(water, with([](Settings& s) { s.exponent = 0.9; }), "exponent");
  refuse(water, with([](Settings& s) { s.sound_speed = 0; }), "sound_speed");
  refuse(water, with([](Settings& s) { s.density = -1; }), "density");
  refuse(water, with([](Settings& s) { s.xsph = 1.1; }), "xsph");
  refuse(water, with([](Settings& s) { s.xsph = -0.1; }), "xsph");
  refuse(water, with([](Settings& s) { s.viscosity = ArtificialViscosity{-0.1}; }), "alpha");
  refuse(water, with([](Settings& s) { s.viscosity = LaminarSps{-1e-6}; }), "viscosity");
  refuse(water, with([](Settings& s) { s.filter_every = -1; }), "filter");
  refuse(water, with([](Settings& s) { s.courant = 0; }), "courant");
  refuse(water, with([](Settings& s) { s.gravity = std::numeric_limits<double>::quiet_NaN(); }), "gravity");
  // Three supports with their skin: 3 x 2 x 0.13 x 1.15 m.
  refuse(lattice(8, 8, spacing, 1000), with([](Settings& s) { s.period = {0.8, 0.8}; }), "period");
  const auto mixed = [](const auto& change) {
    return with([&change](Settings& s) {
      s.storage = Storage::mixed;
      change(s);
    });
  };
  refuse(water, mixed([](Settings& s) { s.density_diffusion = 0.1; }), "density_diffusion");
  refuse(water, mixed([](Settings& s) { s.filter_every = 20; }), "filter_every");
  refuse(water, mixed([](Settings& s) { s.particle_shifting = true; }), "particle_shifting");
  refuse(water, mixed([](Settings& s) { s.walls = WallPressure::extrapolated; }), "walls");
  Particles far = water;
  far.add(5000, 0, 1, 1000);
  refuse(far, mixed([](Settings& /*s*/) {}), "storage");
  CHECK_THROWS_WITH(kernel_named("gaussian"), Catch::Contains("cubic_spline") && Catch::Contains("wendland_c2"));
}

TEST_CASE("particles that cannot be are refused", "[robustness]") {
  const Particles water = lattice(12, 12, spacing, 1000);
  const auto changed = [&](const std::function<void(Particles&)>& change) {
    Particles particles = water;
    change(particles);
    return particles;
  };
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
}

TEST_CASE("a computation that breaks down says when and where, and keeps the last good state", "[robustness]") {
  Particles water = lattice(12, 12, spacing, 1000);
  // Two halves meet at the speed of sound: the density leaves [0.5, 1.5] rho_0.
  for (std::size_t a = 0; a < water.size(); ++a) water.u[a] = water.x[a] < 0.6 ? 40 : -40;
  Flow flow(water, spacing, good);
  std::string message;
  double time = -1;
  try {
    for (int step = 0; step < 1000; ++step) flow.advance(0.004);
  } catch (const seiche::Divergence& divergence) {
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

TEST_CASE("a particle that flies farther than mixed storage tells places is reported", "[robustness]") {
  Particles water = lattice(12, 12, spacing, 1000);
  water.add(4259, 0, 10, 1000, Kind::fluid, 10);
  Settings settings = good;
  settings.storage = Storage::mixed;
  Flow flow(water, spacing, settings);
  const auto fly = [&flow] {
    for (int step = 0; step < 100; ++step) flow.advance(0.004);
  };
  CHECK_THROWS_WITH(fly(), Catch::Contains("storage = mixed") && Catch::Contains("after"));
  CHECK(flow.time() > 0);
}

}  // namespace wcsph_input_test
