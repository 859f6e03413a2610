// Free particles at rest: over a flat bottom for ever, over an uneven one to the order of the sums over particles.
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/cosine_bottom.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::gauss_particles_rest_test {

using namespace gauss_particles;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 6";

constexpr double length = 2 * std::numbers::pi;

/// Still water of depth 1, over a flat bottom or over one of amplitude 0.3 and the channel's length.
Flow still(bool uneven, int cells, int per_side, double penalty, bool shift) {
  const double h = length / cells;
  const auto profile = std::make_shared<CosineBottom>(1, 0.3, 1);
  Ground ground{.level = -1};
  if (uneven) ground.profile = profile;
  return Flow(layer({.end = length,
                     .columns = static_cast<std::size_t>(cells * per_side),
                     .rows = static_cast<std::size_t>(std::lround(per_side / h)),
                     .surface = [](double) { return 0.0; },
                     .bottom = [=](double x) { return uneven ? profile->elevation(x) : -1; },
                     .markers = 64}),
              std::make_unique<SplineSpace>(LatticePlan{
                  .cell_x = h, .left_wall = 0.0, .period = length, .bottom = true, .ground = ground, .shift = shift}),
              {}, {.penalty = penalty});
}

double highest_marker(const Flow& flow) {
  Largest highest;
  for (const Point& marker : flow.markers()) highest.add(std::abs(marker.y));
  return highest.value();
}

TEST_CASE("Gauss-principle particles at rest over a flat bottom stay at rest", "[rest]") {
  Check check("gauss_particles_rest", "Gauss-principle particles at rest",
              "Still water of depth 1 in a periodic channel, rows of particles parallel to the surface. Over a flat "
              "bottom gravity's component in the space is zero to round-off, on a fixed grid and on one shifted at "
              "random. Over an uneven bottom the sums over particles are no exact integrals: the water is accelerated "
              "by O(n^-4) with n particles to a cell's side, and the penalty limits the resulting motion.",
              source);
  for (const bool shift : {false, true}) {
    Flow flow = still(false, 20, 6, 0.01, shift);
    march(flow, 10, 0.03, [&] { flow.observe(); });
    check.holds(std::string("Over a flat bottom the surface stays, to round-off, on a grid that ") +
                    (shift ? "is shifted at random." : "stays."),
                {highest_marker(flow)},
                Roundoff{333 * 333, 1,
                         "positions of order 1; a velocity that is rounded in each of 333 steps moves the surface in "
                         "all later ones"});
  }
  refine(check, {"spacing in cells", widths(1, {8, 12, 16, 24, 32})},
         {{"uneven-order",
           "The initial acceleration over an uneven bed falls at fourth order in the particle spacing.",
           {4, 0.5,
            "end-corrected masses are fourth-order accurate for smooth fields; where rows cross a line of the grid, at "
            "which second derivatives of the velocities jump, a sum errs by s^3 with a sign that changes along the "
            "row: s^3.5 in a mean, not less"}}},
         [](double spacing) {
           Flow flow = still(true, 20, static_cast<int>(cells_of(1, spacing)), 0, false);
           constexpr double tau = 0.03;
           flow.advance(tau);
           return worst(flow.model().projected()) * 2 / tau;
         });
  Flow flow = still(true, 20, 12, 0.01, false);
  flow.advance(0.03);
  const double first = worst(flow.model().projected()) * 2 / 0.03;
  march(flow, 10, 0.03, [&] { flow.observe(); });
  check.at("20 cells, 12 particles to a side");
  check.that("uneven-bounded",
             "The surface over an uneven bottom with the penalty rises by at most 2 a/omega^2, a the first "
             "acceleration, omega of the longest wave.",
             "highest elevation up to t = 10 [depth]", {highest_marker(flow)},
             Bound{2 * first / std::tanh(1.0),
                   "an oscillator that is pushed with a steady acceleration a from rest swings to 2 a/omega^2; the "
                   "longest wave, omega^2 = tanh 1, swings farthest"});
  check.that("uneven-energy", "The change of energy equals the energy removed by the penalty, to round-off.",
             "largest error of the energy after booking", {flow.ledger().largest_defect("energy")},
             Roundoff{333, 1e-2,
                      "one rounding per step of potential energies m g (y - y0), which are sums of terms below 1e-2"});
}

}  // namespace seiche::verification::gauss_particles_rest_test
