// Overlapping particles: free fall, and what walls do.
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/overlapping_particles/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/differences.hpp"
#include "verification/noise.hpp"

namespace seiche::verification::overlapping_particles_test {

using namespace overlapping_particles;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 5.1";
constexpr double spacing = 0.125;

void claim_kept(Check& check, const std::string& what, const Flow& flow,
                const std::vector<std::pair<std::string, std::string>>& invariants) {
  for (const auto& [entry, name] : invariants) {
    check.holds(fmt::format("{} is conserved to round-off ({}).", what, name), {flow.ledger().largest_defect(entry)},
                Roundoff{static_cast<double>(flow.steps()), 1,
                         "one rounding per step of a sum of order 1; sums are compensated"});
  }
}

TEST_CASE("a blob of overlapping particles falls freely", "[conservation]") {
  Check check("overlapping_particles_fall", "Free fall of overlapping particles",
              "A jittered disc is thrown upwards under gravity 9.81, for 100 steps of 0.02: a potential that is "
              "linear, so that the parabola of the scheme is the exact one. Particles stay where they are to each "
              "other, and no multiplier acts.",
              source);
  const Particles first = shaken(staggered_disc(1, spacing), 0.1 * spacing, 2);
  Flow flow(first, [](Point) { return Point{1.5, 4}; }, {.gravity = 9.81});
  CHECK((flow.u().size() == first.size() && flow.v().size() == first.size()));
  CHECK((std::abs(flow.u().front() - 1.5) < 1e-12 && std::abs(flow.u().back() - 1.5) < 1e-12));
  CHECK((std::abs(flow.v().front() - 4) < 1e-12 && std::abs(flow.v().back() - 4) < 1e-12));
  Worst multiplier;
  march(flow, 2, 0.02, [&] {
    flow.observe();
    for (const double lambda : flow.state().multipliers) multiplier.add(lambda, flow.time());
  });
  Worst apart;
  for (std::size_t k = 0; k < first.size(); ++k) {
    apart.add(flow.x()[k] - first.x[k] - 1.5 * 2);
    apart.add(flow.y()[k] - first.y[k] - (4 * 2 - 9.81 * 2));
  }
  check.that("places", "All particles are on their parabolas.", "largest distance", {apart.value()},
             Roundoff{100 * 10, 20, "100 steps to positions up to 12 away, at speeds up to 16"});
  check.that("multipliers", "All multipliers of the falling drop are zero to round-off.", "largest",
             {multiplier.value()},
             Roundoff{20, 2e4,
                      "a speed of 16, rounded, taken out within half a step of 1/100, over gradients m/h^3 = 7 and "
                      "pivots of 1/100"});
  check.that("energy", "Energy of the falling drop is conserved to round-off.", "largest defect",
             {flow.ledger().largest_defect("energy")}, Roundoff{2000, 400, "kinetic energy at the end: pi 16^2/2"});
}

TEST_CASE("water beside walls moves as part of the symmetric flow", "[conservation]") {
  Check check(
      "overlapping_particles_mirror", "Walls of overlapping particles as planes of symmetry",
      "A quarter of a jittered disc, mirrored into a whole one that is stretched along x; half of it above a wall, and "
      "the quarter in the corner of two. After ten steps of 0.02 the positions agree with the whole disc's.");
  const Particles quarter = shaken(staggered({.spacing = spacing,
                                              .lower = {0.3 * spacing, 0.3 * spacing},
                                              .upper = {1, 1},
                                              .through = {0.5 * spacing, 0.5 * spacing},
                                              .inside = [](Point r) { return std::hypot(r.x, r.y) < 1; }}),
                                   0.1 * spacing, 4);
  const std::size_t n = quarter.size();
  const auto with_mirrored = [](Particles part, double across_x, double across_y) {
    for (std::size_t k = 0, count = part.size(); k < count; ++k) {
      part.x.push_back(across_x * part.x[k]);
      part.y.push_back(across_y * part.y[k]);
      part.mass.push_back(part.mass[k]);
    }
    return part;
  };
  const Particles half = with_mirrored(quarter, -1, 1);
  const VelocityAt stretched = [](Point r) { return Point{r.x, -r.y}; };
  const Wall floor{{-3, 0}, {0, 2}}, side{{0, 5}, {1, 0}};
  Flow whole(with_mirrored(half, 1, -1), stretched);
  Flow above(half, stretched, {.walls = {floor}});
  Flow corner(quarter, stretched, {.walls = {floor, side}});
  for (Flow* flow : {&whole, &above, &corner}) march(*flow, 0.2, 0.02, [&] { flow->observe(); });
  const auto same = [&](const std::string& text, const Flow& flow) {
    const double x = largest_difference(flow.x().first(n), whole.x()),
                 y = largest_difference(flow.y().first(n), whole.y());
    check.holds(text, {worst(std::array{x, y})},
                Roundoff{10 * 20, 1, "ten steps of positions of size 1, by sums of some twenty multipliers"});
  };
  same("Half of the disc above a wall.", above);
  same("A quarter of the disc in a corner moves as the whole disc.", corner);
  claim_kept(check, "Above the wall", above, {{"energy", "Energy"}, {"momentum_x", "Momentum along it"}});
  claim_kept(check, "In the corner", corner, {{"energy", "Energy"}});
}

TEST_CASE("water on a floor conserves energy and the momentum along it", "[conservation]") {
  Check check("overlapping_particles_floor", "Overlapping particles on a floor, under gravity",
              "A drop that slides along a floor under gravity 1 for 40 steps of 0.01: the energy and the momentum "
              "along the floor, also of an oblique one without gravity. A stack of particles above each other has one "
              "multiplier for each equation of balance, and rests.",
              source);
  const Particles rows =
      shaken(staggered({.spacing = spacing, .lower = {0, 0}, .upper = {1.5, 0.6}, .through = {0, 0.5 * spacing}}),
             0.1 * spacing, 5);
  Flow drop(rows, [](Point r) { return Point{0.5 + 0.2 * r.y, 0}; }, {.gravity = 1, .walls = {{{0, 0}, {0, 1}}}});
  march(drop, 0.4, 0.01, [&] { drop.observe(); });
  claim_kept(check, "Drop on a floor", drop, {{"energy", "Energy"}, {"momentum_x", "Momentum along it"}});
  check.that(
      "pushes", "The floor carries some of the weight.", "momentum across the floor beyond free fall",
      {drop.ledger().entry("momentum_y").defect + 0.4 * drop.model().mass() > 0.1 * drop.model().mass() * 0.4 ? 1.0
                                                                                                              : 0.0},
      Qualitative{"more than a tenth of the weight's impulse", "otherwise there would be no floor"});

  Particles stack{.x = {}, .y = {}, .mass = {}, .spacing = spacing};
  for (int j = 0; j < 8; ++j) {
    stack.x.push_back(0.3);
    stack.y.push_back((0.5 + j) * spacing);
    stack.mass.push_back(1);
  }
  Flow still(stack, {}, {.gravity = 1, .walls = {{{0, 0}, {0, 1}}}});
  Worst moved;
  march(still, 1, 0.01, [&] { moved.add(worst(still.state().u)); });
  check.that("stack", "A stack on the floor rests.", "largest velocity", {moved.value()},
             Roundoff{100 * 20, 0.1,
                      "100 kicks g tau = 1/100 and reactions that balance it, sums of some twenty terms that are up to "
                      "ten times as large"});
}

}  // namespace seiche::verification::overlapping_particles_test
