// Over a bottom that is uneven along one axis, too, waves of the plan model along it are those of the one-dimensional
// model.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/polynomial_bottom.hpp"

namespace dispersive_plan_bottom_reduction_test {

using namespace seiche;
using namespace seiche::verification;
using mechanics::Stepping;
namespace plan = dispersive_shallow_water_2d;
namespace line = dispersive_shallow_water_1d;

constexpr std::size_t columns = 60;
constexpr double length = 30;
constexpr double tau = 0.2;
constexpr int steps = 100;

/// b = -1 + tilt x + bend x^2 along one axis. Cells of equal depth at both ends then have their halves alike.
struct Slope {
  double tilt, bend;

  [[nodiscard]] double elevation(double x) const { return -1 + tilt * x + bend * x * x; }
  [[nodiscard]] std::shared_ptr<const BottomProfile> profile() const {
    const Slope s = *this;
    return std::make_shared<SmoothBottom>([s](double x) { return s.elevation(x); },
                                          [s](double x) { return s.tilt + 2 * s.bend * x; }, -1, length + 1);
  }
  [[nodiscard]] std::shared_ptr<const PlanBottom> plan(bool along_y) const {
    using Terms = std::vector<PolynomialBottom::Term>;
    return std::make_shared<PolynomialBottom>(along_y ? Terms{{-1, 0, 0}, {tilt, 0, 1}, {bend, 0, 2}}
                                                      : Terms{{-1, 0, 0}, {tilt, 1, 0}, {bend, 2, 0}});
  }
};

double jet(double x) {
  return 0.2 * std::exp(-0.2 * (x - 12) * (x - 12));
}

line::Flow line_flow(const Slope& slope, Stepping stepping) {
  line::Channel channel{.bottom = slope.profile()};
  line::Markers markers;
  for (std::size_t i = 0; i <= columns; ++i) {
    const double x = length * static_cast<double>(i) / columns;
    markers.x.push_back(x);
    markers.y.push_back(slope.elevation(x) + 1);
    markers.u.push_back(i % columns == 0 ? 0 : jet(x));
    markers.v.push_back(0);
  }
  return line::Flow(channel, markers, {.stepping = stepping});
}

/// @param along_y  the same channel turned by a right angle
plan::Flow plan_flow(const Slope& slope, std::size_t rows, Stepping stepping, bool along_y) {
  const double width = 0.7 * static_cast<double>(rows);
  const plan::Rectangle rectangle{.begin = 0,
                                  .end = along_y ? width : length,
                                  .south = 0,
                                  .north = along_y ? length : width,
                                  .columns = along_y ? rows : columns,
                                  .rows = along_y ? columns : rows,
                                  .elevation = [=](double x, double y) { return slope.elevation(along_y ? y : x) + 1; },
                                  .bottom = slope.plan(along_y)};
  return plan::Flow(
      plan::rectangular_lattice(rectangle),
      [=](double x, double y) {
        return along_y ? plan::Velocity{0, jet(y), 0} : plan::Velocity{jet(x), 0, 0};
      },
      {.stepping = stepping}, {.solver = linear::SolverMethod::banded}, {}, {}, false);
}

/// Largest difference of a coordinate or velocity, and of what is across the channel from nothing.
struct Difference {
  double along = 0;
  double across = 0;
};

Difference difference(const Slope& slope, std::size_t rows, Stepping stepping, bool along_y) {
  line::Flow reference = line_flow(slope, stepping);
  plan::Flow flow = plan_flow(slope, rows, stepping, along_y);
  for (int n = 0; n < steps; ++n) {
    reference.advance(tau);
    flow.advance(tau);
  }
  const auto u = reference.u();
  const auto v = reference.v();
  const plan::Lattice& first = flow.model().lattice();
  Worst along;
  Worst across;
  for (std::size_t j = 0; j <= flow.shape().rows; ++j) {
    for (std::size_t i = 0; i <= flow.shape().columns; ++i) {
      const std::size_t k = flow.shape().node(i, j);
      const std::size_t m = along_y ? j : i;
      along.add((along_y ? flow.y() : flow.x())[k] - reference.x()[m]);
      along.add(flow.z()[k] - reference.y()[m]);
      along.add((along_y ? flow.v() : flow.u())[k] - u[m]);
      along.add(flow.w()[k] - v[m]);
      across.add(along_y ? flow.x()[k] - first.x[k] : flow.y()[k] - first.y[k]);
      across.add((along_y ? flow.u() : flow.v())[k]);
    }
  }
  return {along.value(), across.value()};
}

TEST_CASE("waves of the plan model over a bottom uneven along one axis are those of the one-dimensional model",
          "[conservation]") {
  Check check(
      "dispersive_plan_bottom_reduction", "Two-dimensional horizontal model over slopes: waves along one axis",
      "Water of equal depth 1 over a slope of 1:50, and over one that is bent, runs down with a jet of 0.2 in it, in a "
      "channel of 30 depths with walls all around, 60 columns, 100 steps of 0.2. One and three rows of the plan model, "
      "along x and along y, and the one-dimensional model give the same places, elevations and velocities; nothing "
      "moves across the channel. On the bent slope columns turn with the bottom's normal; there the "
      "conservative steps of the two are not ended alike.");
  struct Bottom {
    std::string id, text;
    Slope slope;
  };
  struct Variant {
    std::size_t rows;
    bool along_y;
  };
  const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 3 and section 4.2";
  for (const Bottom& bottom :
       {Bottom{"plane", "a plane slope", {0.02, 0}}, Bottom{"bent", "a bent slope", {0.03, -0.0008}}}) {
    for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
      for (const Variant& variant : {Variant{1, false}, Variant{3, false}, Variant{2, true}}) {
        const Difference found = difference(bottom.slope, variant.rows, stepping, variant.along_y);
        const std::string id =
            fmt::format("{}-{}-{}{}", bottom.id, stepping == Stepping::one_step ? "one-step" : "conservative",
                        variant.rows, variant.along_y ? "-turned" : "");
        const evidence::Claim same{
            .id = id,
            .text = fmt::format("Over {}, {} rows move as the one-dimensional model.", bottom.text, variant.rows),
            .quantity = "largest difference of a coordinate or velocity",
            .source = source};
        const evidence::Measurement measured{.value = found.along, .resolution = "h = 0.5, tau = 0.2, 100 steps"};
        if (bottom.slope.bend != 0 && stepping == Stepping::conservative) {
          check.that(same, measured,
                     Bound{1e-10,
                           "the one-dimensional model holds its frames from the fourth sweep of a "
                           "step on: sweeps contract by (omega tau)^2/4 = 0.03, so three leave "
                           "3e-5 of the first change of an angle, b'' a tau^2/2 = 1e-6 with "
                           "accelerations a of 0.03; times velocities of 0.3 and the step 2e-12, "
                           "and 100 steps"});
        } else {
          check.that(same, measured,
                     Roundoff{4 * steps, length,
                              "both models round places up to the channel's length once in a step, and the "
                              "integral of the bottom under a cell, as long, likewise; sweeps begin anew"});
        }
        check.holds(id + "-across: Nothing moves across.", {found.across},
                    Roundoff{2 * steps, variant.along_y ? length : 0.7 * static_cast<double>(variant.rows),
                             "places and velocities up to the width are rounded twice in a step; along y the "
                             "bottom's integral is taken between places along it"});
      }
    }
  }
}

}  // namespace dispersive_plan_bottom_reduction_test
