// The measures of the particle cases on curves for which they are known, and the start of the steep wave against the
// boundary-integral solution that it is compared with.
#include <cmath>
#include <numbers>
#include <vector>

#include "seiche/exact/overturning/overturning_wave.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/particles/sph_steep_wave.hpp"
#include "validation/instruments/polyline_distance.hpp"
#include "validation/instruments/shifted_front.hpp"
#include "verification/check.hpp"
#include "verification/evidence/known_curve.hpp"

namespace seiche::verification::particle_measures_test {

using namespace validation;
using exact::OverturningWave;

constexpr double pi = std::numbers::pi;

Polyline circle(double radius, int points) {
  Polyline curve;
  for (int k = 0; k <= points; ++k) {
    curve.x.push_back(radius * std::cos(2 * pi * k / points));
    curve.y.push_back(radius * std::sin(2 * pi * k / points));
  }
  return curve;
}

TEST_CASE("the lag of a front is found", "[evidence]") {
  Check check("shifted_front", "The shift of a front",
              "A front $X = 1 + T^2/4$ and points of it that lag by 0.17, one of them beyond the tank.");
  const auto front = [](double T) { return 1 + 0.25 * T * T; };
  const auto [T, X] = sampled(0, 3, 3000, front);
  const std::vector<double> late{0.6, 1.1, 1.7, 2.3, 2.9};
  std::vector<double> measured;
  for (const double t : late) measured.push_back(front(t - 0.17));
  const ShiftedFront fit = shifted_front({T, X}, {late, measured}, 2.5);
  // Straight lines between points 1e-3 apart leave 0.5/8 1e-6 of the parabola, which least squares weigh by the slopes
  // T/2; the shift itself is searched with steps halved from 0.0035 to 2^-19 of it.
  constexpr double of_lines = 0.5 / 8 * 1e-6;
  const double of_halving = std::ldexp(0.0035, -19);
  double slopes = 0, squares = 0;
  for (int k = 0; k < 4; ++k) {
    const double steepness = 0.5 * (late[k] - 0.17);
    slopes += steepness;
    squares += steepness * steepness;
  }
  check.holds("The fitted shift equals the shift of the points.", {fit.shift},
              Bound{of_lines * slopes / squares + of_halving,
                    "lines between points 1e-3 apart leave 6e-8, which least squares weigh by the slopes; the last of "
                    "20 halved steps is 2^-19 of 0.0035",
                    0.17});
  check.holds("The rms distance after the shift is zero.", {fit.rms},
              Bound{of_lines + of_halving * std::sqrt(squares / 4),
                    "the residual of least squares is at most the residual of the true shift, whose lines leave 6e-8, "
                    "and the remainder of halving times the slopes"});
  check.holds("Points beyond the tank are excluded.", {static_cast<double>(fit.points)}, Bound{0, "by hand", 4});
  double sum = 0;
  for (int k = 0; k < 4; ++k) sum += std::pow(front(late[k]) - measured[k], 2);
  check.holds("The difference before the shift agrees with the formulas.", {fit.raw_rms},
              Bound{1e-6, "lines between the points", std::sqrt(sum / 4)});
  check.holds("The fitted slope of a straight part is exact.", {slope_between({T, T}, 1, 2)},
              Roundoff{4000, 1, "sums over 1000 points", 1});
  CHECK_THROWS_AS(shifted_front({T, X}, {late, measured}, 1.0), std::invalid_argument);
}

TEST_CASE("distances of curves agree with lines and circles", "[evidence]") {
  Check check("polyline_distance", "Distance of curves",
              "Parallel lines, concentric circles, and a line that lies a period away.");
  const Polyline low{{0, 1}, {0, 0}};
  const Polyline high{{0, 0.3, 1}, {0.25, 0.25, 0.25}};
  const PolylineDistance lines = polyline_distance({low}, {high});
  check.holds("The rms distance of parallel lines equals their distance.", {lines.rms},
              Roundoff{20, 1, "three segments", 0.25});
  const PolylineDistance circles = polyline_distance({circle(1, 1000)}, {circle(1.5, 1000)});
  check.holds("The rms distance of concentric circles is the difference of their radii.", {circles.rms},
              Bound{1.5 * pi * pi / 2 / 1e6, "the height of a chord of the larger one", 0.5});
  check.holds("The largest distance of concentric circles is the difference of their radii.", {circles.largest},
              Bound{1.5 * pi * pi / 2 / 1e6, "the height of a chord of the larger one", 0.5});
  const PolylineDistance images = polyline_distance({low}, {Polyline{{2, 3}, {0, 0}}}, 2);
  check.holds("The distance of a curve from its copy one period away is zero.", {images.rms},
              Roundoff{20, 1, "one segment"});
  // From the part nothing is missing; from the whole, its two further pieces are half and one and a half away.
  const PolylineDistance part = polyline_distance({low}, {Polyline{{0, 1, 2, 3}, {0, 0, 0, 0}}});
  check.holds("The distance of a curve from a part of itself is zero.", {part.rms},
              Roundoff{20, 2, "four segments", std::sqrt(0.5 * (0.25 + 2.25) / 3)});
  CHECK_THROWS_AS(polyline_distance({}, {low}), std::invalid_argument);
}

TEST_CASE("the steep wave starts with the velocities and accelerations of potential flow", "[evidence]") {
  Check check("steep_wave_start", "Velocity and pressure of the steep wave",
              "The surface of `overturning_wave` moves with the velocity inside, and its particles are accelerated by "
              "the gradient of the pressure.");
  constexpr double amplitude = 0.065, depth = 0.13, gravity = 9.81;
  const SteepWaveStart start(amplitude, 1, depth, gravity);
  const OverturningWave wave(
      {.amplitude = amplitude, .wavelength = 1, .depth = depth, .gravity = gravity, .markers = 128, .last_time = 0.01});
  const auto at_rest = wave.profile(0);
  constexpr double tau = 1e-4;
  const auto soon = wave.profile(tau);
  const auto later = wave.profile(2 * tau);
  Worst velocity, acceleration, fastest;
  constexpr double step = 1e-5;
  for (std::size_t i = 0; i < at_rest.x.size(); ++i) {
    const double x = at_rest.x[i], y = at_rest.y[i];
    const auto [u, v] = start.velocity(x, y);
    velocity.add(std::hypot(u - at_rest.u[i], v - at_rest.v[i]));
    fastest.add(std::hypot(u, v));
    const double p_x =
        (start.pressure_over_density(x + step, y) - start.pressure_over_density(x - step, y)) / (2 * step);
    const double p_y =
        (start.pressure_over_density(x, y + step) - start.pressure_over_density(x, y - step)) / (2 * step);
    const double a_x = (-3 * at_rest.u[i] + 4 * soon.u[i] - later.u[i]) / (2 * tau);
    const double a_y = (-3 * at_rest.v[i] + 4 * soon.v[i] - later.v[i]) / (2 * tau);
    acceleration.add(std::hypot(a_x + p_x, a_y + p_y + gravity));
  }
  check.holds("Velocities at the surface agree with the boundary integral.", {velocity.value() / fastest.value()},
              Bound{1e-10, "128 markers resolve the first surface to round-off of the kernels"});
  check.holds("Accelerations at the surface agree with the boundary integral.", {acceleration.value() / gravity},
              Bound{1e-5, "a second-order difference over 1e-4 s of velocities that change within 0.05 s leaves 4e-6"});
  check.holds("The pressure at the surface is zero between the points.", {start.surface_defect()},
              Bound{1e-9, "24 terms of a series whose terms fall by a factor of 2.2"});
  check.holds("The velocity through the bottom is zero to round-off.", {std::abs(start.velocity(0.3, -depth)[1])},
              Roundoff{4, fastest.value(), "sinh of zero"});
  CHECK_THROWS_AS(SteepWaveStart(0.08, 1, 0.13, gravity), std::invalid_argument);
  CHECK_THROWS_AS(SteepWaveStart(0.05, 1, 0.04, gravity), std::invalid_argument);
}

}  // namespace seiche::verification::particle_measures_test
