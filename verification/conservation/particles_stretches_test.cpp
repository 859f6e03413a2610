// A step of the shallow-water particles goes through a long row stretch by stretch, on threads: neither leaves a trace.
#include <cmath>
#include <cstddef>
#include <string>

#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::particles_stretches_test {

using namespace shallow_water_particles;

constexpr long steps = 6;

/// Ripples as long as a few particles, over the particles [begin, end) of a longer row one metre apart.
Particles ripples(std::size_t begin, std::size_t end) {
  Particles row;
  for (std::size_t k = begin; k <= end; ++k) row.edge.push_back(static_cast<double>(k));
  for (std::size_t i = begin; i < end; ++i) {
    const auto x = static_cast<double>(i);
    row.mass.push_back(1.5 + 0.01 * std::sin(x / 7));
    row.velocity.push_back(0.02 * std::cos(x / 5));
  }
  return row;
}

ParticleFlow water(Level level, std::size_t begin, std::size_t end) {
  Scheme scheme;
  scheme.level = level;
  return ParticleFlow(ripples(begin, end), {}, {}, scheme);
}

/// Of the particles that no end of the piece has reached, and of the limits of their steps.
double differing(Level level) {
  constexpr std::size_t begin = 1500;
  constexpr std::size_t count = 1500;
  constexpr std::size_t out_of_reach = 3 * steps;
  ParticleFlow longer = water(level, 0, 5000);
  ParticleFlow piece = water(level, begin, begin + count);
  const double tau = 0.5 * longer.largest_step().tau;
  for (long k = 0; k < steps; ++k) {
    longer.advance(tau);
    piece.advance(tau);
  }
  Worst differing;
  for (std::size_t i = out_of_reach; i < count - out_of_reach; ++i) {
    differing.add(longer.particles().edge[begin + i] - piece.particles().edge[i]);
    differing.add(longer.particles().velocity[begin + i] - piece.particles().velocity[i]);
  }
  return differing.value();
}

TEST_CASE("stretches of a row of shallow-water particles leave no trace", "[conservation]") {
  Check check("particles_stretches", "Shallow-water particles: stretch by stretch",
              "A row of 5000 particles, which a step goes through in three stretches, and a piece of it across a seam: "
              "where the ends of the piece have not been felt, edges and velocities are equal but for the round-off of "
              "edges whose waves are solved for to the end in one row and to 1e-13 in the other. Every particle has a "
              "part in the limit of the next step.");
  for (const auto& [level, name] :
       {std::pair{Level::godunov, "G1"}, std::pair{Level::muscl, "M2"}, std::pair{Level::hand_over, "H2"}}) {
    check.holds(std::string(name) + ": A piece of the row moves like the whole.", {differing(level)},
                Bound{1e-11, "waves to 1e-13, places up to 3000 m to 5e-13, six steps"});
  }
  // The narrowest particle is the last of a stretch.
  Particles row = ripples(0, 5000);
  constexpr std::size_t narrowest = 2047;
  constexpr double width = 0.25;
  row.edge[narrowest] = row.edge[narrowest + 1] - width;
  row.mass[narrowest] = 1.5 * width;
  row.mass[narrowest - 1] = 1.5 * (2 - width);
  row.velocity.assign(row.size(), 0.0);
  ParticleFlow still(row);
  still.advance(0.1 * still.largest_step().tau);
  check.holds("The last particle of a stretch limits the step when it is the narrowest.",
              {static_cast<double>(still.largest_step().particle)}, Bound{0, "a number of a particle", narrowest});
}

}  // namespace seiche::verification::particles_stretches_test
