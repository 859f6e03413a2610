// Paddles: velocities are the derivatives of places, and nothing is stretched.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "seiche/models/wcsph/particles.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::wcsph_paddle_test {

using namespace wcsph;

constexpr double period = 0.308;
constexpr double depth = 0.013;
constexpr double stroke = 0.0305;

PointMotion at(const Paddle& paddle, double t, double x, double z) {
  return carried(paddle.pose(t), paddle.rate(t), paddle.hinge_x, paddle.hinge_z, x, z);
}

TEST_CASE("paddles move rigidly with the velocity that they state", "[geometry]") {
  Check check("wcsph_paddles", "Piston and flap",
              "A flap in 1.3 cm of water whose stroke is 2.3 h, so that it tilts by 49.6 degrees, and a piston: "
              "velocities against central differences of the positions, distances between particles of the paddle, and "
              "the place of the face at the still-water level.",
              "kinematics of a rigid body; Dean and Dalrymple (1991), ch. 6, for the motion X_w");
  const double frequency = 2 * std::numbers::pi / period;
  const std::vector<std::pair<std::string, Paddle>> paddles{{"piston", piston(stroke, frequency)},
                                                            {"flap", flap(0.001, -0.002, depth, stroke, frequency)}};
  const std::vector<Place> places{{-0.0005, 0.0005}, {-0.001, 0.012}, {0.001, 0.03}};
  for (const auto& [name, paddle] : paddles) {
    const Order order = name == "piston"
                            ? Order{2, 0.003,
                                    "central differences of a sine: next term (omega dt)^2/20 relative, 0.0012 at the "
                                    "longest step, 1/40 of a period, 0.002 per halving"}
                            : Order{2, 0.1, "central second-order differences; steps from 1/40 of a period"};
    refine(
        check, {.axis = "step", .sizes = falling(period / 40, 5), .title = {}},
        {{name + "-velocity",
          "The velocity equals the rate of change of position: central differences converge at their order.", order}},
        [&](double step) {
          Worst error;
          for (double t = 0.013; t < period; t += 0.029) {
            for (const auto& [x, z] : places) {
              const PointMotion now = at(paddle, t, x, z);
              const PointMotion before = at(paddle, t - step, x, z);
              const PointMotion after = at(paddle, t + step, x, z);
              error.add((after.x - before.x) / (2 * step) - now.u);
              error.add((after.z - before.z) / (2 * step) - now.w);
            }
          }
          return error.value();
        });
  }

  const Paddle& leaning = paddles[1].second;
  Worst stretch;
  Largest off;
  for (double t = 0; t < period; t += period / 97) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto& [ax, az] = places[i];
      const auto& [bx, bz] = places[(i + 1) % places.size()];
      const PointMotion a = at(leaning, t, ax, az);
      const PointMotion b = at(leaning, t, bx, bz);
      stretch.add(std::hypot(a.x - b.x, a.z - b.z) / std::hypot(ax - bx, az - bz) - 1);
    }
    const double angle = leaning.pose(t).angle;
    const double wanted = stroke / 2 * std::sin(frequency * t);
    // Of the face through the hinge, the point that is at the still-water level at this moment.
    const PointMotion face = at(leaning, t, 0.001, -0.002 + depth / std::cos(angle));
    off.add(std::abs(face.x - 0.001 - wanted) / depth);
    off.add(std::abs(face.z + 0.002 - depth) / depth);
  }
  check.that("rigid", "The flap turns without stretching its rows.", "relative change of distances", {stretch.value()},
             Roundoff{60, 1, "differences of positions up to 0.03 m over 0.012 m"});
  check.that("still-water-level", "The paddle position at the still-water level is X_w = (S/2) sin(omega t).",
             "distance over the depth", {off.value()},
             Roundoff{30, 1.6, "atan, sin, cos and a product; up to 1.54 h from the hinge"});
  const PointMotion start = at(leaning, 0, -0.0005, 0.0005);
  CHECK(start.x == -0.0005);
  CHECK(start.z == 0.0005);
}

}  // namespace seiche::verification::wcsph_paddle_test
