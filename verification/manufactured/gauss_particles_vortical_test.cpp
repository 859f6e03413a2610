// An unsteady vortical flow with a free surface, driven by a body force, against its exact velocities and paths.
#include <cmath>
#include <memory>
#include <string>

#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::gauss_particles_vortical_test {

using namespace gauss_particles;

/// Disc r < 1 with the stream function (1 - r^2)(a + b sin 2x), a = 0.5 + 0.3 sin t, b = 0.4 cos t, and the pressure
/// (1/2)(1 - r^2)^2 (1 + x/2): its surface is the circle.
struct Motion {
  explicit Motion(double t)
      : a(0.5 + 0.3 * std::sin(t)), da(0.3 * std::cos(t)), b(0.4 * std::cos(t)), db(-0.4 * std::sin(t)) {}

  [[nodiscard]] Point velocity(Point r) const {
    const double below = 1 - r.x * r.x - r.y * r.y;
    const double strength = a + b * std::sin(2 * r.x);
    return {-2 * r.y * strength, 2 * r.x * strength - 2 * b * below * std::cos(2 * r.x)};
  }

  /// du/dt along the motion plus the pressure's gradient.
  [[nodiscard]] Point force(Point r) const {
    const auto [x, y] = r;
    const double below = 1 - x * x - y * y;
    const double s = std::sin(2 * x), c = std::cos(2 * x);
    const auto [u, v] = velocity(r);
    const double rate = da + db * s;
    const double u_x = -4 * y * b * c;
    const double u_y = -2 * (a + b * s);
    const double v_x = 2 * (a + b * s) + 8 * x * b * c + 4 * b * below * s;
    const double v_y = 4 * y * b * c;
    const double p_x = -2 * x * below * (1 + x / 2) + 0.25 * below * below;
    const double p_y = -2 * y * below * (1 + x / 2);
    return {-2 * y * rate + u * u_x + v * u_y + p_x, 2 * x * rate - 2 * db * below * c + u * v_x + v * v_y + p_y};
  }

  double a, da, b, db;
};

/// Error of the mean velocity of the last step, root mean square.
/// @param work_defect  gets the largest defect of the energy after the force's work
double error(double h, double& work_defect) {
  const double tau = h / 4;
  Flow flow(disc(1, static_cast<std::size_t>(std::lround(6 / h))),
            std::make_unique<SplineSpace>(LatticePlan{.degree = 3, .cell_x = h}),
            [](Point r) { return Motion(0).velocity(r); }, {.gravity = 0, .penalty = 0},
            {.body_force = [](Point r, double t) { return Motion(t).force(r); }});
  march(flow, 1, tau, [&] { flow.observe(); });
  // The projection of the last step belongs to its middle.
  const double length = 1 / static_cast<double>(flow.steps());
  const Motion middle(1 - length / 2);
  const Model& model = flow.model();
  const std::size_t n = model.size();
  Mean off;
  for (std::size_t k = 0; k < n; ++k) {
    const Point v = middle.velocity({model.places()[k], model.places()[n + k]});
    off.add(std::hypot(model.projected()[k] - v.x, model.projected()[n + k] - v.y), model.particles().mass[k]);
  }
  if (h == 0.2) work_defect = flow.ledger().largest_defect("energy");
  return off.rms();
}

TEST_CASE("an unsteady vortical flow with a free surface is computed at second order", "[manufactured]") {
  Check check(
      "gauss_particles_vortical", "Gauss-principle particles: a manufactured vortical flow",
      "Water in a circle turns with a strength and a shape that change in time, driven by the body force that makes it "
      "a solution with zero pressure on the circle. Cubic splines, steps in proportion to the cells: the error of the "
      "velocity falls with the square of both. The force's work is the change of energy, to round-off.",
      "Frank, Discrete models of incompressible fluid (1994), chapter 6, formula (20)");
  double defect = 0;
  refine(
      check, {"h", {0.3, 0.2, 0.15, 0.1, 0.075}},
      {{"order", "The velocity errs by O(h^2) with tau = h/4.",
        Order{2, 0.25,
              "second order in time; the splines add a third-order term, up to h of the first with fields of order 1: "
              "0.3 on the coarsest grid, 0.075 on the finest"}}},
      [&](double h) { return error(h, defect); });
  check.that("work", "The energy changes by the force's work.", "largest error of the energy",
             {.value = defect, .resolution = "h = 0.2, tau = 0.05, 20 steps"},
             Roundoff{20, 3, "one rounding per step of the kinetic energy, at most 3"});
}

}  // namespace seiche::verification::gauss_particles_vortical_test
