// The particle count published with the plunging wave, 35232, and what it says of its flume.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "seiche/models/wcsph/particles.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::wcsph_flume_count_test {

using namespace wcsph;

constexpr long published = 35232;
constexpr long layers = 26;       // of 0.05 cm in 1.3 cm of water
constexpr long highest_wall = 8;  // in depths

/// How the walls of a flume are made.
struct Walls {
  int paddle_rows = 2;
  bool corner_twice = true;  // of bottom and far wall
};

/// Particles of a straight wall of so many steps, two staggered rows deep or three.
long straight(long steps, int rows) {
  return rows == 2 ? 2 * steps + 1 : 3 * steps + 2;
}

/// @param columns  of water, in dx; bottom, far wall and paddle are so many dx long
long flume_count(Lattice lattice, long columns, long bottom, long far_wall, long paddle, const Walls& walls) {
  const long per_cell = lattice == Lattice::square ? 1 : 2;
  return per_cell * layers * columns + straight(bottom, 2) + straight(far_wall, 2) - (walls.corner_twice ? 0 : 1) +
         straight(paddle, walls.paddle_rows);
}

/// Flumes with the published count: water of any length, a bottom that reaches up to 1.5 depths behind the paddle,
/// walls of one to eight depths.
long solutions(Lattice lattice, const Walls& walls) {
  long found = 0;
  for (long columns = layers; flume_count(lattice, columns, columns, layers, layers, walls) <= published; ++columns) {
    for (long behind = 0; behind <= 3 * layers / 2; ++behind) {
      for (long far_wall = layers; far_wall <= highest_wall * layers; ++far_wall) {
        const long rest = published - flume_count(lattice, columns, columns + behind, far_wall, layers, walls);
        const long steps = rest / walls.paddle_rows;
        if (rest >= 0 && steps * walls.paddle_rows == rest && steps <= (highest_wall - 1) * layers) ++found;
      }
    }
  }
  return found;
}

TEST_CASE("the number of particles does not determine the published flume", "[geometry]") {
  Check check(
      "wcsph_flume_count", "Particle count of the plunging wave",
      "The counts of both dam breaks follow from their geometry, with walls of two staggered rows and a particle for "
      "each of both walls at a common corner. A flume has a bottom, a far wall and a paddle. By the same rules each of "
      "the three has an odd number of particles, $2n + 1$, and 26 layers of water an even one: the sum is odd, 35232 "
      "is even. By other rules, a corner counted once or a paddle of three rows, tens of thousands of flumes have that "
      "number. The length of the published flume therefore does not follow from its count.",
      "particle counts published with two dam breaks and a plunging wave");
  Worst formula;
  for (const Lattice lattice : {Lattice::square, Lattice::body_centred}) {
    for (const int paddle_rows : {2, 3}) {
      constexpr double dx = 0.0005;
      constexpr long columns = 60;
      const long behind = 19 + paddle_rows;  // a flap 50.5 dx high that turns by atan(10/26): 18.1 dx, and its rows
      const Scene scene = flume({.length = columns * dx,
                                 .depth = layers * dx,
                                 .wall_height = 40 * dx,
                                 .paddle_height = 50 * dx,
                                 .stroke = 0.01,
                                 .frequency = 20,
                                 .spacing = dx,
                                 .lattice = lattice,
                                 .paddle_rows = paddle_rows},
                                {.sound_speed = 4});
      // Behind the paddle and beyond the far wall the bottom goes on for half a spacing, the far wall below and above.
      formula.add(static_cast<double>(scene.particles.size()) -
                  static_cast<double>(flume_count(lattice, columns, columns + behind + 1, 41, 50,
                                                  {.paddle_rows = paddle_rows, .corner_twice = false})));
    }
  }
  check.that("formula",
             "The particle number of flumes of both arrangements, with paddles of two and three rows, agrees with the "
             "formula.",
             "largest difference", {formula.value()}, Bound{0, "a count"});
  Count even;
  for (long steps = 1; steps <= highest_wall * layers; ++steps) {
    const std::array<Place, 2> ends{{{0, 0}, {static_cast<double>(steps), 0}}};
    even.add(static_cast<double>(wall(ends, 1).size()), [](double count) { return std::fmod(count, 2) == 0; });
  }
  check.that("odd", "A straight wall of two rows has an odd number of particles.", "walls with an even one",
             {even.value()}, Bound{0, "n + 1 and n"});
  check.that("impossible",
             "The number of flumes with the published particle number by the rules of the dam breaks is zero.",
             "flumes with it, of both lattices",
             {static_cast<double>(solutions(Lattice::square, {}) + solutions(Lattice::body_centred, {}))},
             Bound{0, "three odd numbers and an even one make an odd one"});
  const bool ambiguous = solutions(Lattice::body_centred, {.paddle_rows = 3}) > 1 &&
                         solutions(Lattice::body_centred, {.corner_twice = false}) > 1;
  check.that("ambiguous", "The published particle number by other rules does not determine the flume.",
             "more than one flume has the number", {ambiguous ? 1.0 : 0.0},
             Qualitative{"body-centred flumes with 35232 particles, with a paddle of three rows, and with the corner "
                         "counted once: more than one of each",
                         "three lengths and one number"});
}

}  // namespace seiche::verification::wcsph_flume_count_test
