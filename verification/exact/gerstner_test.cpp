#include <array>
#include <cmath>
#include <numbers>

#include "seiche/exact/gerstner.hpp"
#include "seiche/samples.hpp"
#include "verification/difference.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::gerstner_test {

using exact::GerstnerWave;

constexpr double pi = std::numbers::pi;
const std::string source = "Gerstner, Theorie der Wellen (1804); Lamb, Hydrodynamics (1932), section 251";

/// Largest residual of continuity, of Euler's equations and of the vorticity in space-fixed coordinates: velocity and
/// pressure at a place are those of the particle found there.
double euler_residual(const GerstnerWave& wave, double gravity, double x, double y, double t, double span) {
  const auto flow = [&](double dx, double dy, double dt) {
    return wave.velocity(wave.label(x + dx, y + dy, t + dt), t + dt);
  };
  const auto pressure = [&](double dx, double dy) { return wave.pressure(wave.label(x + dx, y + dy, t)); };
  const auto [u, v] = flow(0, 0, 0);
  const double u_x = difference([&](double d) { return flow(d, 0, 0).u; }, span);
  const double u_y = difference([&](double d) { return flow(0, d, 0).u; }, span);
  const double u_t = difference([&](double d) { return flow(0, 0, d).u; }, span / wave.phase_speed());
  const double v_x = difference([&](double d) { return flow(d, 0, 0).v; }, span);
  const double v_y = difference([&](double d) { return flow(0, d, 0).v; }, span);
  const double v_t = difference([&](double d) { return flow(0, 0, d).v; }, span / wave.phase_speed());
  const double p_x = difference([&](double d) { return pressure(d, 0); }, span);
  const double p_y = difference([&](double d) { return pressure(0, d); }, span);
  return worst(std::array{u_x + v_y, v_x - u_y - wave.vorticity(wave.label(x, y, t)), u_t + u * u_x + v * u_y + p_x,
                          v_t + u * v_x + v * v_y + p_y + gravity});
}

void draw(Check& check) {
  auto& figure = check.figure("surface", "Gerstner's wave",
                              "Surface for several labels of the top particles: trochoids up to the cusped cycloid. "
                              "The orbit of a particle is an exact circle.");
  auto& panel = figure.panel({.x = "k x", .y = "k y", .equal_aspect = true});
  for (const double top : {0.0, -0.2, -0.7, -1.5}) {
    const GerstnerWave wave(2 * pi, 1, top);
    std::vector<double> x, y;
    for (int i = -200; i <= 200; ++i) {
      const auto place = wave.position({2 * pi * i / 200, top}, 0);
      x.push_back(place.x);
      y.push_back(place.y);
    }
    panel.line("k b0 = " + std::to_string(top).substr(0, 4), x, y, Role::exact);
  }
  const GerstnerWave wave(2 * pi, 1, -0.7);
  std::vector<double> orbit_x, orbit_y;
  for (int i = 0; i <= 60; ++i) {
    const auto place = wave.position({pi, -0.7}, 2 * pi * i / 60);
    orbit_x.push_back(place.x);
    orbit_y.push_back(place.y);
  }
  panel.line("orbit for k b0 = -0.7", orbit_x, orbit_y, Role::guide);
}

TEST_CASE("Gerstner's wave satisfies the Euler equations", "[exact]") {
  Check check("exact_gerstner", "Gerstner's wave",
              "Residual of continuity, momentum and vorticity in space-fixed coordinates, through the inversion from "
              "position to particle; area of patches of particles; zero pressure at the surface; inversion.",
              source);
  constexpr double gravity = 9.81;
  const GerstnerWave wave(3, gravity, -0.1);
  const Order fourth{4, 0.2, "fourth-order differences of an analytic function"};
  refine(
      check, {.axis = "width of the differences", .sizes = falling(0.04, 5), .title = {}, .floor = 1e-11},
      {{"euler",
        "The residuals of continuity, Euler's equations and vorticity at fixed positions converge at fourth order.",
        {4, 0.3, "fourth-order differences of a smooth solution"}},
       {"jacobian", "The area ratio from labels to positions is J = 1 - e^{2kb} at any time.", fourth},
       {"acceleration",
        "The acceleration of a particle is the rate of its velocity: the difference falls at fourth order.", fourth}},
      [&](double span) {
        Worst euler, jacobian, acceleration;
        for (double x = 0; x < 3; x += 0.37) {
          for (const double depth : {0.12, 0.4, 1.0}) {
            const double t = 0.43;
            euler.add(euler_residual(wave, gravity, x, wave.elevation(x, t) - depth, t, span));
          }
        }
        for (const double b : {-0.2, -0.6}) {
          // J is the determinant of the derivatives of the place by the label.
          for (double a = 0; a < 3; a += 0.41) {
            const auto place = [&](double da, double db) { return wave.position({a + da, b + db}, 0.7); };
            const double x_a = difference([&](double d) { return place(d, 0).x; }, span);
            const double x_b = difference([&](double d) { return place(0, d).x; }, span);
            const double y_a = difference([&](double d) { return place(d, 0).y; }, span);
            const double y_b = difference([&](double d) { return place(0, d).y; }, span);
            jacobian.add(x_a * y_b - x_b * y_a - wave.area_factor({a, b}));
          }
          const GerstnerWave::Label particle{1.1, b};
          const auto rate = [&](double exact::Velocity::*component) {
            return difference([&](double d) { return wave.velocity(particle, 0.7 + d).*component; }, span);
          };
          const auto stated = wave.acceleration(particle, 0.7);
          acceleration.add(std::hypot(rate(&exact::Velocity::u) - stated.x, rate(&exact::Velocity::v) - stated.y));
        }
        return std::array{euler.value(), jacobian.value(), acceleration.value()};
      });
  Worst inversion, surface;
  for (const double top : {-0.02, -0.1, -1.0}) {
    const GerstnerWave one(3, gravity, top);
    const double conditioning = -std::expm1(one.wavenumber() * top);
    for (double a = -4; a < 5; a += 0.23) {
      for (const double below : {0.0, 0.01, 0.3, 2.0}) {
        const GerstnerWave::Label particle{a, top - below};
        const auto place = one.position(particle, 1.9);
        const auto found = one.label(place.x, place.y, 1.9);
        inversion.add(std::hypot(found.a - a, found.b - particle.b) * conditioning);
        if (below == 0) surface.add(one.elevation(place.x, 1.9) - place.y);
      }
    }
    CHECK(one.pressure({0.3, top}) == 0);
  }
  check.that("inversion", "The inversion from position to particle is exact to round-off.",
             "error of the label times its conditioning 1 - e^{k b0} [m]", {inversion.value()},
             Roundoff{30, 5, "30 roundings of labels and positions up to 5 m"});
  check.that("elevation", "The elevation passes through the particles of the surface.", "error of the elevation [m]",
             {surface.value()},
             Roundoff{30, 5 * 3.4, "30 roundings of x up to 5 m, times the steepest slope, 3.4 for b0 = -0.02 m"});
  // The particle that starts at the crest.
  const auto crest = wave.position({0, -0.1}, 0);
  CHECK(std::abs(crest.y - wave.elevation(0, 0)) < 1e-15);
  CHECK(std::abs(wave.height() - 2 * std::exp(-0.1 * wave.wavenumber()) / wave.wavenumber()) < 1e-15);
  CHECK_THROWS_AS(wave.position({0, -0.09}, 0), exact::OutsideFluid);
  CHECK_THROWS_AS(wave.label(0, wave.elevation(0, 0) + 1e-9, 0), exact::OutsideFluid);
  draw(check);
}

}  // namespace seiche::verification::gerstner_test
