// What the free-particle model refuses, and how it says so.
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/models/gauss_particles/field_space.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "verification/message_of.hpp"
#include "verification/robustness/refusals.hpp"

namespace seiche::verification::gauss_particles_input_test {

using namespace gauss_particles;

LatticePlan tank() {
  return {.cell_x = 0.25, .left_wall = 0.0, .right_wall = 2.0, .bottom = true};
}

Layer water() {
  return {
      .end = 2, .columns = 48, .rows = 24, .surface = [](double) { return 1.0; }, .bottom = [](double) { return 0.0; }};
}

std::unique_ptr<FieldSpace> splines(const LatticePlan& plan = tank(), SplineSpace::Settings settings = {}) {
  return std::make_unique<SplineSpace>(plan, settings);
}

TEST_CASE("bad particles, grids and settings of Gauss-principle particles are rejected", "[robustness]") {
  Check check("gauss_particles_bad_input", "Bad input of the free-particle model",
              "Water in a tank with one error at a time.");
  Refusals refusals(check);
  const auto with_particles =
      refusals.of(layer(water()), [&](Particles particles) { Flow flow(std::move(particles), splines()); });
  with_particles({"mass of particle 3", "-1", "non-negative"}, [](Particles& p) { p.mass[3] = -1; });
  with_particles({"mass of particle 0", "nan"}, [](Particles& p) { p.mass[0] = not_a_number; });
  with_particles({"particle 7", "nan", "finite"}, [](Particles& p) { p.y[7] = not_a_number; });
  with_particles({"1152 x", "1151 y"}, [](Particles& p) { p.y.pop_back(); });
  with_particles({"none of them with a mass"}, [](Particles& p) { p.mass.assign(p.size(), 0); });
  with_particles({"0 particles"}, [](Particles& p) { p = {}; });
  with_particles({"particles", "at least 8"}, [](Particles& p) {
    Layer coarse = water();
    coarse.columns = 16;
    coarse.rows = 8;
    p = layer(coarse);
  });
  with_particles({"no cell", "full enough"}, [](Particles& p) {
    for (double& m : p.mass) m *= 1e-3;
  });

  refusals.refused({"surface", "dissipative", "conservative stepping"}, [] {
    Layer with_markers = water();
    with_markers.markers = 20;
    Flow flow(layer(with_markers), splines(), {}, {.penalty = 0, .surface = SurfaceLine{}}, {}, Stepping::dissipative);
  });

  refusals.refused({"penalty", "0.01", "dissipative", "allowed: 0"},
                   [] { Flow flow(layer(water()), splines(), {}, {}, {}, Stepping::dissipative); });

  const auto with_plan = refusals.of(tank(), [&](LatticePlan plan) { Flow flow(layer(water()), splines(plan)); });
  with_plan({"degree", "= 1", "[2, 4]"}, [](LatticePlan& p) { p.degree = 1; });
  with_plan({"degree", "= 5", "[2, 4]"}, [](LatticePlan& p) { p.degree = 5; });
  with_plan({"cell_x", "= 0", "positive"}, [](LatticePlan& p) { p.cell_x = 0; });
  with_plan({"right_wall - left_wall", "multiple", "0.25"}, [](LatticePlan& p) { p.right_wall = 2.1; });
  with_plan({"period", "multiple"}, [](LatticePlan& p) {
    p.right_wall.reset();
    p.period = 2.1;
  });
  with_plan({"cells of a periodic lattice", "7"}, [](LatticePlan& p) {
    p.right_wall.reset();
    p.cell_x = 0.5;
    p.period = 2;
  });
  with_plan({"right_wall", "periodic"}, [](LatticePlan& p) { p.period = 2; });
  with_plan({"two walls that do not meet"}, [](LatticePlan& p) { p.bottom = false; });
  with_plan({"slope jumps", "x = 1"}, [](LatticePlan& p) {
    p.ground.profile =
        std::make_shared<PiecewiseLinearBottom>(std::vector<double>{-1, 1, 4}, std::vector<double>{0, 0, 0.3});
  });

  refusals.outside_ranges(
      "Settings", "gravity non-negative and finite; density positive and finite; penalty non-negative and finite",
      Settings{}, [](const Settings& s) { Flow(layer(water()), splines(), {}, s); });
  refusals.outside_ranges("SplineSpace::Settings", "density positive and finite; inner_fraction in [0.05, 1]",
                          SplineSpace::Settings{}, [](const SplineSpace::Settings& s) { splines(tank(), s); });
  refusals.refused({"no space"}, [] { Flow flow(layer(water()), nullptr); });
  refusals.refused({"no stream function"}, [] { PolynomialSpace space(std::vector<StreamFunction>{}); });
  const auto with_water = refusals.of(water(), [](const Layer& l) { layer(l); });
  with_water({"depth", "positive"}, [](Layer& l) { l.surface = [](double) { return -1.0; }; });
  with_water({"rows", "at least 6"}, [](Layer& l) { l.rows = 5; });
  refusals.refused({"nan"}, [] { Flow flow(layer(water()), splines(), [](Point) { return Point{not_a_number, 0}; }); });
  refusals.refused({"tau", "= 0.6", "2/sqrt(pi g/h)"}, [] { Flow(layer(water()), splines()).advance(0.6); });
}

TEST_CASE("Gauss-principle particles that leave their grid cause a Divergence with time and position", "[robustness]") {
  Check check("gauss_particles_breakdown", "Gauss-principle particles that leave their grid",
              "A drop flies through a fixed grid: the run stops before the step in which a particle comes within two "
              "cells of its end, and the state is the one before the step.");
  const LatticeAt fixed = [](mechanics::Interval, const Bounds&) {
    return Lattice{SplineAxis(3, -2, 0.25, 16, Ends::free), SplineAxis(3, -2, 0.25, 16, Ends::free)};
  };
  const auto along = [](Point) { return Point{1, 0}; };
  Flow flow(disc(1, 12), std::make_unique<SplineSpace>(Ground{}, fixed, SplineSpace::Settings{}), along,
            {.gravity = 0, .penalty = 0});
  const std::string message = message_of<Divergence>([&] { march(flow, 5, 0.05); });
  INFO(message);
  const bool named = message.find("lattice with its margin is [-1.5, 1.5]") != std::string::npos;
  check.holds("The message gives the position of departure and the range of the grid.", {named ? 1.0 : 0.0},
              Qualitative{"Divergence that names the grid's ends", "a run that breaks down must say where"});
  // The disc's outermost ring has radius 0.96; its rightmost particle passes 1.5 at t = 0.54 and more.
  check.holds("The run stops at the time when the drop arrives, not later.", {flow.time()},
              Bound{0.05, "one step; the outermost ring's radius is sqrt((11^2 + 12^2)/2)/12",
                    1.5 - std::sqrt((121.0 + 144.0) / 2) / 12});
}

}  // namespace seiche::verification::gauss_particles_input_test
