// What overlapping particles refuse, singular configurations among it, and how they break down.
#include <algorithm>
#include <limits>
#include <vector>

#include "seiche/models/overlapping_particles/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/robustness/breakdown.hpp"
#include "verification/robustness/refusals.hpp"

namespace seiche::verification::overlapping_particles_test {

using namespace overlapping_particles;

/// Rows in a rectangle above y = 0.
Particles block() {
  return staggered({.spacing = 0.1, .lower = {0, 0}, .upper = {0.8, 0.5}, .through = {0, 0.05}});
}

/// A square lattice that fills a box of the side 1: with its mirror images it fills the plane.
Particles full_box() {
  Particles box{.x = {}, .y = {}, .mass = {}, .spacing = 0.1};
  for (int j = 0; j < 10; ++j) {
    for (int i = 0; i < 10; ++i) {
      box.x.push_back((i + 0.5) * 0.1);
      box.y.push_back((j + 0.5) * 0.1);
      box.mass.push_back(0.01);
    }
  }
  return box;
}

const std::vector<Wall> four_walls{{{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}, {{1, 1}, {-1, 0}}, {{1, 1}, {0, -1}}};

TEST_CASE("bad particles, walls and settings are rejected by name", "[robustness]") {
  Check check("overlapping_particles_bad_input", "Bad input of overlapping particles",
              "Missing particles, coincident ones or ones behind walls; walls without images; settings out of range.");
  Refusals refusals(check);
  const auto refused = refusals.of(block(), [](const Particles& p) { Flow flow(p); });
  refused({"x of particle 4", "nan", "finite"}, [](Particles& p) { p.x[4] = not_a_number; });
  refused({"y of particle 2", "inf", "finite"}, [](Particles& p) { p.y[2] = std::numeric_limits<double>::infinity(); });
  refused({"mass of particle 3", "= 0", "positive"}, [](Particles& p) { p.mass[3] = 0; });
  refused({"mass of particle 3", "nan", "positive"}, [](Particles& p) { p.mass[3] = not_a_number; });
  refused({"spacing", "= -0.1", "positive"}, [](Particles& p) { p.spacing = -0.1; });
  refused({"y", "as many of each"}, [](Particles& p) { p.y.pop_back(); });
  refused({"2 particles", "at least 3"}, [](Particles& p) {
    p = {.x = {0, 0.1}, .y = {0, 0}, .mass = {1, 1}, .spacing = 0.1};
  });
  refused({"particles 5 and 9", "one place"}, [](Particles& p) {
    p.x[9] = p.x[5];
    p.y[9] = p.y[5] + 1e-16;
  });
  refused({"singular configuration", "particle 6", "no other control volume", "stabilisation > 0", "support above 2.6"},
          [](Particles& p) { p.x[6] += 10; });
  refused({"singular configuration", "two particles alone", "stabilisation"},
          [](Particles& p) { std::for_each_n(p.x.begin() + 6, 2, [](double& x) { x += 10; }); });
  const auto setting = refusals.with<Settings>([](const Settings& settings) { Flow flow(block(), {}, settings); });
  refusals.outside_ranges(
      "Settings", "support in [1.5, 10]; gravity non-negative and finite; stabilisation non-negative and finite",
      Settings{}, [](const Settings& s) { Flow(block(), {}, s); });
  setting({"particle 0", "from wall 1", "side of the water"}, {.walls = {{{0, 0}, {0, 1}}, {{0.05, 0}, {1, 0}}}});
  setting({"normal of wall 0", "= 0", "positive"}, {.walls = {{{0, 0}, {0, 0}}}});
  setting({"through.x of wall 0", "nan"}, {.walls = {{{not_a_number, 0}, {0, 1}}}});
  setting({"walls 0 and 1", "right angles"}, {.walls = {{{0, 0}, {0, 1}}, {{-1, 0}, {1, 1}}}});
  setting({"walls 0 and 1", "opposite"}, {.walls = {{{0, 0}, {0, 1}}, {{0, -1}, {0, 1}}}});
  setting({"walls 0 and 1", "0.2 apart", "at least the support 0.26"},
          {.walls = {{{-0.1, 0}, {1, 0}}, {{0.1, 0}, {-1, 0}}}});
  refusals.refused({"u[", "nan", "finite"}, [] { Flow flow(block(), [](Point) { return Point{not_a_number, 0}; }); });
  refusals.refused({"shape = \"cube\"", "smoothed, ball"}, [] { shape_named("cube"); });
  refusals.refused({"radius", "= 0", "positive"}, [] { staggered_disc(0, 0.1); });
  refusals.refused({"upper.y - lower.y", "= -1"}, [] { staggered({.lower = {0, 1}, .upper = {1, 0}}); });
  refusals.refused({"spacing", "= 0", "positive"}, [] { staggered({.spacing = 0, .upper = {1, 1}}); });
  refusals.refused({"density", "= 0", "positive"}, [] { staggered({.spacing = 0.1, .upper = {1, 1}, .density = 0}); });
  refusals.refused({"spacing = 1e-06", "at most 1e+07"}, [] { staggered_disc(1, 1e-6); });
}

TEST_CASE("an arrangement that fills a box is singular, and the message names the remedy", "[robustness]") {
  Check check("overlapping_particles_singular", "Singular configurations of overlapping particles",
              "A square arrangement that fills a box with its mirror images: chequered multipliers have no force. Such "
              "an arrangement is rejected; with stabilisation the water rests, bitwise without gravity. Without the "
              "upper half there is a surface, and no singularity.");
  Refusals refusals(check);
  refusals.refused({"singular configuration", "set stabilisation > 0"},
                   [] { Flow flow(full_box(), {}, {.walls = four_walls}); });
  Flow cured(full_box(), {}, {.stabilisation = 0.1, .walls = four_walls});
  cured.advance(0.05);
  check.holds("Velocities in the full box are zero with stabilisation.", {worst(cured.state().u)},
              Bound{0, "every force is exactly zero"});
  Particles half = full_box();
  for (auto* values : {&half.x, &half.y, &half.mass}) values->resize(50);
  const Flow open(half, {}, {.walls = four_walls});
  check.holds("The constraint matrix with a free surface is regular.",
              {open.model().solver().pivot_ratio() > 1e-6 ? 1.0 : 0.0},
              Qualitative{"above 1e-6", "1e4 times the threshold of singularity"});
}

TEST_CASE("overlapping particles beyond a wall stop with time, step and position", "[robustness]") {
  Check check("overlapping_particles_breakdown", "Overlapping particles are thrown at a wall",
              "A block is thrown at a floor so fast that a step takes it through. The run stops and names the "
              "particle, with the state before the step.");
  Flow flow(block(), [](Point) { return Point{0, -1}; }, {.walls = {{{0, -0.5}, {0, 1}}}});
  holds_of_breakdown(check, "floor", run_until_breakdown(flow, 2, 0.4), "goes through wall 0", -0.01, 0.81);
}

}  // namespace seiche::verification::overlapping_particles_test
