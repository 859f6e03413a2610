// What overlapping particles refuse, singular configurations among it, and how they break down.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "seiche/models/overlapping_particles/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/robustness/breakdown.hpp"
#include "verification/robustness/refusals.hpp"

namespace overlapping_particles_test {

using namespace seiche;
using namespace seiche::overlapping_particles;
using namespace seiche::verification;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Rows in a rectangle above y = 0.
Particles block() {
  return staggered({.spacing = 0.1, .lower = {0, 0}, .upper = {0.8, 0.5}, .through = {0, 0.05}});
}

template <class Change>
void build(const Change& change, Settings settings = {}) {
  Particles particles = block();
  change(particles);
  Flow flow(particles, {}, std::move(settings));
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

TEST_CASE("bad particles, walls and settings are refused by name", "[robustness]") {
  Check check(
      "overlapping_particles_bad_input", "Bad input of overlapping particles",
      "Particles that are none, at one place or behind walls; walls that images cannot do; settings out of range.");
  Refusals refusals(check);
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words, auto change) {
    refusals.refused(text, words, [&] { build(change); });
  };
  refused("A place that is not a number.", {"x of particle 4", "nan", "finite"},
          [](Particles& p) { p.x[4] = not_a_number; });
  refused("A place at infinity.", {"y of particle 2", "inf", "finite"},
          [](Particles& p) { p.y[2] = std::numeric_limits<double>::infinity(); });
  refused("A particle without mass.", {"mass of particle 3", "= 0", "positive"}, [](Particles& p) { p.mass[3] = 0; });
  refused("A mass that is not a number.", {"mass of particle 3", "nan", "positive"},
          [](Particles& p) { p.mass[3] = not_a_number; });
  refused("A spacing that is none.", {"spacing", "= -0.1", "positive"}, [](Particles& p) { p.spacing = -0.1; });
  refused("Arrays of other lengths.", {"y", "as many of each"}, [](Particles& p) { p.y.pop_back(); });
  refused("Two particles.", {"2 particles", "at least 3"}, [](Particles& p) {
    p = {.x = {0, 0.1}, .y = {0, 0}, .mass = {1, 1}, .spacing = 0.1};
  });
  const auto twice = [](Particles& p) {
    p.x[9] = p.x[5];
    p.y[9] = p.y[5] + 1e-16;
  };
  refused("Two particles at one place.", {"particles 5 and 9", "one place"}, twice);
  refused("A particle that is alone.",
          {"singular configuration", "particle 6", "no other control volume", "stabilisation > 0", "support above 2.6"},
          [](Particles& p) { p.x[6] += 10; });
  refused("Two that are alone with each other.", {"singular configuration", "two particles alone", "stabilisation"},
          [](Particles& p) {
            p.x[6] += 10;
            p.x[7] += 10;
          });
  const auto setting = [&](const std::string& text, const std::vector<std::string>& words, const Settings& settings) {
    refusals.refused(text, words, [&] { build([](Particles&) {}, settings); });
  };
  setting("Volumes that do not reach the next particles.", {"support", "= 1.25", "[1.5, 10]"}, {.support = 1.25});
  setting("A support that is not a number.", {"support", "nan"}, {.support = not_a_number});
  setting("Gravity upwards.", {"gravity", "= -1", "non-negative"}, {.gravity = -1});
  setting("A stabilisation that destabilises.", {"stabilisation", "= -0.1"}, {.stabilisation = -0.1});
  setting("Particles behind a wall.", {"particle 0", "from wall 1", "side of the water"},
          {.walls = {{{0, 0}, {0, 1}}, {{0.05, 0}, {1, 0}}}});
  setting("A wall without direction.", {"normal of wall 0", "= 0", "positive"}, {.walls = {{{0, 0}, {0, 0}}}});
  setting("A wall that is nowhere.", {"through.x of wall 0", "nan"}, {.walls = {{{not_a_number, 0}, {0, 1}}}});
  setting("Walls at an angle of 45 degrees.", {"walls 0 and 1", "right angles"},
          {.walls = {{{0, 0}, {0, 1}}, {{-1, 0}, {1, 1}}}});
  setting("A wall behind another.", {"walls 0 and 1", "opposite"}, {.walls = {{{0, 0}, {0, 1}}, {{0, -1}, {0, 1}}}});
  setting("Walls nearer than the support.", {"walls 0 and 1", "0.2 apart", "at least the support 0.26"},
          {.walls = {{{-0.1, 0}, {1, 0}}, {{0.1, 0}, {-1, 0}}}});
  refusals.refused("A velocity that is not a number.", {"u[", "nan", "finite"}, [] {
    Flow flow(block(), [](Point) { return Point{not_a_number, 0}; });
  });
  refusals.refused("A shape that there is not.", {"shape = \"cube\"", "smoothed, ball"}, [] { shape_named("cube"); });
  refusals.refused("A disc without radius.", {"radius", "= 0", "positive"}, [] { staggered_disc(0, 0.1); });
  refusals.refused("Rows from above.", {"upper.y - lower.y", "= -1"}, [] {
    staggered({.lower = {0, 1}, .upper = {1, 0}});
  });
  refusals.refused("A spacing that would fill the memory.", {"spacing = 1e-06", "at most 1e+07"},
                   [] { staggered_disc(1, 1e-6); });
}

TEST_CASE("a lattice that fills a box is singular, and says what to do", "[robustness]") {
  Check check(
      "overlapping_particles_singular", "Singular configurations of overlapping particles",
      "A square lattice in a box that it fills with its mirror images: chequered multipliers are without forces. "
      "It is refused; with stabilisation the water rests, without gravity bit by bit. With the lattice's upper "
      "half alone there is a surface, and nothing is singular.");
  Refusals refusals(check);
  refusals.refused("The full box without stabilisation.", {"singular configuration", "set stabilisation > 0"},
                   [] { Flow flow(full_box(), {}, {.walls = four_walls}); });
  Flow cured(full_box(), {}, {.stabilisation = 0.1, .walls = four_walls});
  cured.advance(0.05);
  check.holds("The full box stays at rest with stabilisation.", {worst(cured.state().u)},
              Bound{0, "every force is exactly zero"});
  Particles half = full_box();
  half.x.resize(50);
  half.y.resize(50);
  half.mass.resize(50);
  Flow open(half, {}, {.walls = four_walls});
  check.holds("With a free surface it is regular.", {open.model().solver().pivot_ratio() > 1e-6 ? 1.0 : 0.0},
              Qualitative{"above 1e-6", "ten thousand times what counts as singular"});
}

TEST_CASE("overlapping particles that go through a wall stop with time, step and place", "[robustness]") {
  Check check(
      "overlapping_particles_breakdown", "Overlapping particles are thrown at a wall",
      "A block is thrown at a floor so fast that a step takes it through. The run stops and names the particle, "
      "with the state of before.");
  Flow flow(block(), [](Point) { return Point{0, -1}; }, {.walls = {{{0, -0.5}, {0, 1}}}});
  holds_of_breakdown(check, "floor", run_until_breakdown(flow, 2, [](Flow& f) { f.advance(0.4); }),
                     "goes through wall 0", -0.01, 0.81);
}

}  // namespace overlapping_particles_test
