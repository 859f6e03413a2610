// A step of the shallow-water particles goes through a long row stretch by stretch, on threads: neither leaves a trace.
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "seiche/models/shallow_water_particles/initial.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace particles_threads_test {

using namespace seiche;
using namespace seiche::shallow_water_particles;

constexpr long steps = 6;
const std::string source = "what a step makes of a particle depends on its neighbours alone";

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

/// A dam that breaks beside a piston, with a front on dry ground.
ParticleFlow dam(Level level, std::size_t count) {
  Scheme scheme;
  scheme.level = level;
  const Ends ends{.left = Piston{[](double time) { return 0.2 * time; }}, .right = Vacuum{}};
  return ParticleFlow(dam_break(0, 0.4, 1, {1, 0}, {0.5, 0}, count), ends, {}, scheme);
}

std::vector<double> after(ParticleFlow flow) {
  const double tau = 0.2 * flow.largest_step().tau;
  for (long k = 0; k < steps; ++k) flow.advance(tau);
  const StepLimit limit = flow.largest_step();
  std::vector<double> all = {limit.tau,
                             static_cast<double>(limit.particle),
                             flow.largest_courant(),
                             flow.ledger().left_impulse.value(),
                             flow.ledger().right_impulse.value(),
                             static_cast<double>(flow.structures().size())};
  for (const Array* values : {&flow.particles().edge, &flow.particles().velocity}) {
    all.insert(all.end(), values->begin(), values->end());
  }
  return all;
}

bool same_for_any_threads(const auto& made) {
  const int usual = omp_get_max_threads();
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    results.push_back(after(made()));
  }
  omp_set_num_threads(usual);
  return results[0] == results[1] && results[0] == results[2];
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

TEST_CASE("stretches and threads of a row of shallow-water particles leave no trace", "[conservation]") {
  verification::Check check(
      "particles_threads", "Shallow-water particles: stretch by stretch",
      "A row of 5000 particles, which a step goes through in three stretches, and a piece of it across a seam: where "
      "the ends of the piece have not been felt, edges and velocities are equal but for the round-off of edges whose "
      "waves are solved for to the end in one row and to 1e-13 in the other. A row that is worth threads gives the "
      "same "
      "bits with one, two and three of them, of ripples and of a dam that breaks between a piston and dry ground. "
      "Every "
      "particle has a part in the limit of the next step.");
  for (const auto& [level, name] :
       {std::pair{Level::godunov, "G1"}, std::pair{Level::muscl, "M2"}, std::pair{Level::hand_over, "H2"}}) {
    const std::string id = name;
    check.that({.id = id + "-seams",
                .text = "A piece of the row moves like the whole.",
                .quantity = "difference of edges and velocities",
                .source = source},
               {.value = differing(level), .resolution = "5000 and 1500 particles, 6 steps"},
               evidence::Bound{.limit = 1e-11, .reason = "waves to 1e-13, places up to 3000 m to 5e-13, six steps"});
    const auto same = [&](const std::string& what, const auto& made) {
      check.that({.id = id + "-" + what,
                  .text = "Results of one, two and three threads are bitwise identical.",
                  .quantity = "same bits",
                  .source = source},
                 {.value = same_for_any_threads(made) ? 1.0 : 0.0, .resolution = "140 000 particles, 6 steps"},
                 evidence::Qualitative{"equal places, velocities, limits and booked impulses",
                                       "results must not depend on the machine's load"});
    };
    constexpr std::size_t many = 140000;
    same("threads", [level = level] { return water(level, 0, many); });
    same("dam", [level = level] { return dam(level, many); });
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
  check.that({.id = "limit",
              .text = "The last particle of a stretch limits the step when it is the narrowest.",
              .quantity = "particle that limits the step",
              .source = "tau c/w <= Courant number for all particles"},
             {.value = static_cast<double>(still.largest_step().particle), .resolution = "5000 particles"},
             evidence::Bound{.limit = 0, .reason = "a number of a particle", .expected = narrowest});
}

}  // namespace particles_threads_test
