// Waves of the plan model that do not depend on y are those of the one-dimensional model, whatever the number of rows.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::dispersive_plan_reduction_test {

using mechanics::Stepping;
namespace plan = dispersive_shallow_water_2d;
namespace line = dispersive_shallow_water_1d;

constexpr std::size_t columns = 60;
constexpr double length = 30;
constexpr double tau = 0.2;
constexpr int steps = 100;

double velocity(double x) {
  return 0.4 * std::exp(-0.2 * (x - 10) * (x - 10));
}

/// @param gamma  of improved dispersion
line::Flow line_flow(Stepping stepping, double gamma) {
  line::Channel channel{.bottom = std::make_shared<LevelBottom>(1.0)};
  channel.alpha = 1.0 / 3 + gamma;
  channel.gamma = gamma;
  line::Markers markers;
  for (std::size_t i = 0; i <= columns; ++i) {
    const double x = length * static_cast<double>(i) / columns;
    markers.x.push_back(x);
    markers.y.push_back(0);
    markers.u.push_back(i % columns == 0 ? 0 : velocity(x));
    markers.v.push_back(0);
  }
  return line::Flow(channel, markers, {.stepping = stepping});
}

/// @param along_y  the same channel turned by a right angle
plan::Flow plan_flow(std::size_t rows, Stepping stepping, bool along_y, double gamma) {
  const double width = 0.7 * static_cast<double>(rows);
  const plan::Rectangle rectangle{.begin = 0,
                                  .end = along_y ? width : length,
                                  .south = 0,
                                  .north = along_y ? length : width,
                                  .columns = along_y ? rows : columns,
                                  .rows = along_y ? columns : rows};
  return plan::Flow(
      plan::rectangular_lattice(rectangle),
      [=](double x, double y) {
        return along_y ? plan::Velocity{0, velocity(y), 0} : plan::Velocity{velocity(x), 0, 0};
      },
      {.stepping = stepping}, {.inertia = 1.0 / 3 + gamma, .gamma = gamma, .solver = linear::SolverMethod::banded}, {},
      {}, false);
}

TEST_CASE("waves of the plan model along one axis are those of the one-dimensional model", "[conservation]") {
  Check check(
      "dispersive_plan_reduction", "Two-dimensional horizontal model: waves along one axis",
      "A jet of 0.4 in still water of a channel of 30 depths, 60 columns, 100 steps of 0.2, with walls all around. "
      "One, two and four rows of the plan model, along x and along y, and the one-dimensional model give the same "
      "places, elevations and velocities to round-off; nothing moves across the channel. The surface is level at the "
      "beginning, for the models share the water of a sloping cell differently: the one-dimensional one splits it at "
      "its middle, the plan model gives equal parts to its corners. Without and with improved dispersion.");
  struct Kind {
    Stepping stepping;
    double gamma;
  };
  for (const auto& [stepping, gamma] : {Kind{Stepping::one_step, 0}, Kind{Stepping::conservative, 0},
                                        Kind{Stepping::one_step, 1.0 / 15}, Kind{Stepping::conservative, 1.0 / 15}}) {
    line::Flow reference = line_flow(stepping, gamma);
    for (int n = 0; n < steps; ++n) reference.advance(tau);
    const auto u = reference.u();
    const auto v = reference.v();
    struct Variant {
      std::size_t rows;
      bool along_y;
    };
    for (const Variant& variant : {Variant{1, false}, Variant{2, false}, Variant{4, false}, Variant{3, true}}) {
      plan::Flow flow = plan_flow(variant.rows, stepping, variant.along_y, gamma);
      for (int n = 0; n < steps; ++n) flow.advance(tau);
      Worst worst;
      Largest across;
      const plan::Lattice& first = flow.model().lattice();
      for (std::size_t j = 0; j <= flow.shape().rows; ++j) {
        for (std::size_t i = 0; i <= flow.shape().columns; ++i) {
          const std::size_t k = flow.shape().node(i, j);
          const std::size_t m = variant.along_y ? j : i;
          const auto [place, speed] =
              variant.along_y ? std::pair{flow.y()[k], flow.v()[k]} : std::pair{flow.x()[k], flow.u()[k]};
          worst.add(place - reference.x()[m]);
          worst.add(flow.z()[k] - reference.y()[m]);
          worst.add(speed - u[m]);
          worst.add(flow.w()[k] - v[m]);
          across.add(variant.along_y ? std::abs(flow.x()[k] - first.x[k]) + std::abs(flow.u()[k])
                                     : std::abs(flow.y()[k] - first.y[k]) + std::abs(flow.v()[k]));
        }
      }
      const std::string id = fmt::format("{}{}{}{}", stepping == Stepping::one_step ? "one-step-" : "conservative-",
                                         variant.rows, variant.along_y ? "-turned" : "", gamma > 0 ? "-improved" : "");
      check.holds(id + ": " + fmt::format("{} rows move as the one-dimensional model.", variant.rows), {worst.value()},
                  Roundoff{2 * steps, length,
                           "both models round places up to the channel's length once in a step; what is added to them "
                           "is small, and sweeps begin anew"});
      check.holds(id + "-across: Nothing moves across.", {across.value()},
                  Roundoff{2 * steps, 0.7 * static_cast<double>(variant.rows),
                           "places and velocities up to the width are rounded twice in a step"});
    }
  }
}

}  // namespace seiche::verification::dispersive_plan_reduction_test
