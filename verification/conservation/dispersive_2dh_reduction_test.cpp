// Waves of the 2DH model that do not depend on y are those of the one-dimensional model, whatever the number of rows.
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/polynomial_bottom.hpp"

namespace seiche::verification::dispersive_2dh_reduction_test {

using mechanics::Stepping;
namespace plan = dispersive_shallow_water_2d;
namespace line = dispersive_shallow_water_1d;

constexpr std::size_t columns = 60;
constexpr double length = 30, tau = 0.2;
constexpr int steps = 100;

/// A jet in water 1 deep over b = -1 + tilt x + bend x^2 along one axis. Cells of equal depth at both ends have their
/// halves alike.
struct Channel {
  std::string name;
  double tilt = 0, bend = 0;
  double gamma = 0;  ///< of improved dispersion
  double speed = 0.4, middle = 10;

  [[nodiscard]] bool level() const { return tilt == 0; }
  [[nodiscard]] double surface(double x) const { return tilt * x + bend * x * x; }
  [[nodiscard]] double jet(double x) const { return speed * std::exp(-0.2 * (x - middle) * (x - middle)); }

  [[nodiscard]] line::Flow line_flow(Stepping stepping) const {
    line::Channel channel{.bottom = std::make_shared<LevelBottom>(1.0), .alpha = 1.0 / 3 + gamma, .gamma = gamma};
    if (!level()) {
      const auto elevation = [c = *this](double x) { return c.surface(x) - 1; };
      const auto slope = [c = *this](double x) { return c.tilt + 2 * c.bend * x; };
      channel.bottom = std::make_shared<SmoothBottom>(elevation, slope, -1, length + 1);
    }
    line::Markers markers;
    for (std::size_t i = 0; i <= columns; ++i) {
      const double x = length * static_cast<double>(i) / columns;
      markers.x.push_back(x);
      markers.y.push_back(surface(x));
      markers.u.push_back(i % columns == 0 ? 0 : jet(x));
      markers.v.push_back(0);
    }
    return line::Flow(channel, markers, {.stepping = stepping});
  }

  /// @param along_y  the same channel turned by a right angle
  [[nodiscard]] plan::Flow plan_flow(std::size_t rows, Stepping stepping, bool along_y) const {
    const double width = 0.7 * static_cast<double>(rows);
    plan::Rectangle rectangle{.end = along_y ? width : length,
                              .north = along_y ? length : width,
                              .columns = along_y ? rows : columns,
                              .rows = along_y ? columns : rows};
    if (!level()) {
      const int x = along_y ? 0 : 1, y = along_y ? 1 : 0;
      rectangle.elevation = [=, this](double at_x, double at_y) { return surface(along_y ? at_y : at_x); };
      rectangle.bottom = polynomial_bottom({{-1, 0, 0}, {tilt, x, y}, {bend, 2 * x, 2 * y}});
    }
    const auto velocity = [=, this](double x, double y) {
      return along_y ? plan::Velocity{0, jet(y), 0} : plan::Velocity{jet(x), 0, 0};
    };
    return plan::Flow(plan::rectangular_lattice(rectangle), velocity, {.stepping = stepping},
                      {.inertia = 1.0 / 3 + gamma, .gamma = gamma, .solver = linear::SolverMethod::banded}, {}, {},
                      false);
  }
};

TEST_CASE("waves of the 2DH model along one axis agree with the one-dimensional model", "[conservation]") {
  Check check("dispersive_2dh_reduction", "Two-dimensional horizontal model: waves along one axis",
              "A channel 30 h long with walls all around, 60 columns, 100 steps of 0.2: a jet of 0.4 in still water "
              "over a level bottom, without and with improved dispersion, and water of equal depth 1 over a slope of "
              "1:50, and over one that is bent, that runs down with a jet of 0.2 in it. One to four rows of cells of "
              "the 2DH model, along x and along y, and the one-dimensional model give the same positions, elevations "
              "and velocities; transverse displacements are zero. The depth is uniform at the beginning, for the "
              "models share the water of a sloping cell differently: the one-dimensional one splits it at its middle, "
              "the 2DH model gives equal parts to its corners. On the bent slope columns turn with the bottom's "
              "normal; there the conservative steps of the two models end by different criteria.");
  for (const Channel& channel :
       {Channel{"level bottom"}, Channel{.name = "improved dispersion", .gamma = 1.0 / 15},
        Channel{.name = "plane slope", .tilt = 0.02, .speed = 0.2, .middle = 12},
        Channel{.name = "bent slope", .tilt = 0.03, .bend = -0.0008, .speed = 0.2, .middle = 12}}) {
    for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
      line::Flow reference = channel.line_flow(stepping);
      for (int n = 0; n < steps; ++n) reference.advance(tau);
      const auto u = reference.u(), v = reference.v();
      for (const int variant : channel.level() ? std::vector{1, 2, 4, -3} : std::vector{1, 3, -2}) {
        const bool along_y = variant < 0;
        const auto rows = static_cast<std::size_t>(std::abs(variant));
        plan::Flow flow = channel.plan_flow(rows, stepping, along_y);
        for (int n = 0; n < steps; ++n) flow.advance(tau);
        const plan::Lattice& first = flow.model().lattice();
        Worst along, across;
        for (std::size_t k = 0; k < flow.shape().nodes(); ++k) {
          const std::size_t m = along_y ? k / (rows + 1) : k % (columns + 1);
          along.add((along_y ? flow.y() : flow.x())[k] - reference.x()[m]);
          along.add(flow.z()[k] - reference.y()[m]);
          along.add((along_y ? flow.v() : flow.u())[k] - u[m]);
          along.add(flow.w()[k] - v[m]);
          across.add(along_y ? flow.x()[k] - first.x[k] : flow.y()[k] - first.y[k]);
          across.add((along_y ? flow.u() : flow.v())[k]);
        }
        const std::string what =
            fmt::format("{}, {}, {} rows{}", channel.name, stepping == Stepping::one_step ? "one-step" : "conservative",
                        rows, along_y ? ", turned" : "");
        const bool bent = channel.bend != 0 && stepping == Stepping::conservative;
        const evidence::Criterion same =
            Roundoff{(channel.level() ? 2 : 4) * steps, length,
                     "both models round positions up to the channel's length once in a step, and the integral of an "
                     "uneven bottom under a cell, as long, likewise; sweeps begin anew"};
        const evidence::Criterion near =
            Bound{1e-10,
                  "the one-dimensional model holds its frames from the fourth sweep of a step on: sweeps contract by "
                  "(omega tau)^2/4 = 0.03, so three leave 3e-5 of the first change of an angle, b'' a tau^2/2 = 1e-6 "
                  "with accelerations a of 0.03; times velocities of 0.3 and the step 2e-12, and 100 steps"};
        check.holds(what + ": the motion of the rows agrees with the one-dimensional model.", {along.value()},
                    bent ? near : same);
        const evidence::Criterion still =
            channel.level()
                ? evidence::Criterion{Roundoff{2 * steps, 0.7 * static_cast<double>(rows),
                                               "positions and velocities up to the width are rounded twice in a step"}}
                : Bound{0.5 * steps * tau * steps * tau * std::numeric_limits<double>::epsilon() * 2 / 0.7,
                        "the slope across is the difference of two heights up to 1, each known to 2.2e-16, over a "
                        "row's width of 0.7; under gravity 1 it displaces water by T^2/2 times the slope"};
        check.holds(what + ": transverse displacement and velocity are zero to round-off.", {across.value()}, still);
      }
    }
  }
}

}  // namespace seiche::verification::dispersive_2dh_reduction_test
