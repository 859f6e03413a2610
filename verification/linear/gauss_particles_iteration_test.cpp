// The two solvers of the normal equations of free particles give one projection.
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/gauss_particles/particles.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace gauss_particles_iteration_test {

using namespace seiche::gauss_particles;
using namespace seiche::verification;
using seiche::Worst;
using seiche::evidence::Bound;
using seiche::evidence::Roundoff;

const std::string source = "Hestenes & Stiefel, J. Res. NBS 49 (1952) 409";

constexpr double length = 2 * std::numbers::pi;
constexpr double depth = std::numbers::pi;

struct Projection {
  std::vector<double> velocities;
  double residual;
  std::size_t unknowns;
  long iterations;
};

/// Of a field that is not solenoidal, on water under a wave, in a channel or between walls.
Projection projection(int cells, bool walls, std::size_t iterate_above) {
  const Particles water = layer({.begin = 0,
                                 .end = length,
                                 .columns = static_cast<std::size_t>(4 * cells),
                                 .rows = static_cast<std::size_t>(2 * cells),
                                 .surface = [](double x) { return 0.3 * std::cos(x); },
                                 .bottom = [](double) { return -depth; }});
  LatticePlan plan{.cell_x = length / cells, .left_wall = 0.0, .bottom = true, .ground = {.level = -depth}};
  if (walls) {
    plan.right_wall = length;
  } else {
    plan.period = length;
  }
  SplineSpace space(plan, {.iterate_above = iterate_above});
  std::vector<double> u(water.size());
  std::vector<double> v(water.size());
  for (std::size_t k = 0; k < water.size(); ++k) {
    u[k] = std::sin(water.x[k] + 2 * water.y[k]) + 0.3;
    v[k] = std::cos(3 * water.x[k]) * std::exp(water.y[k]) - water.y[k];
  }
  space.place({0, 0}, water.x, water.y, water.mass, 0);
  space.project(u, v);
  u.insert(u.end(), v.begin(), v.end());
  return {u, space.facts().residual, space.facts().unknowns, space.iterations()};
}

TEST_CASE("conjugate gradients and factors give one projection", "[linear]") {
  Check check("gauss_particles_iteration", "Free particles: conjugate gradients against factors",
              "The projection by conjugate gradients, which take the place of factors in large systems, is that by "
              "factors, to round-off, and its normal equations are solved as well. The preconditioner, the exact "
              "inverse for a rectangle and for the strip along the surface, makes the number of iterations independent "
              "of the cells.");
  for (const bool walls : {false, true}) {
    const std::string where = walls ? "tank" : "channel";
    long few = 0;
    for (const int cells : {16, 32, 64}) {
      const Projection factors = projection(cells, walls, 1000000);
      const Projection iterated = projection(cells, walls, 0);
      const std::string id = fmt::format("{}-{}", where, cells);
      const std::string resolution = fmt::format("{} unknowns", factors.unknowns);
      Worst difference;
      for (std::size_t k = 0; k < factors.velocities.size(); ++k) {
        difference.add(factors.velocities[k] - iterated.velocities[k]);
      }
      check.measure(id + "-iterations", static_cast<double>(iterated.iterations));
      check.that({.id = id + "-velocities",
                  .text = "The velocities are the same.",
                  .quantity = "largest difference",
                  .source = source},
                 {.value = difference.value(), .resolution = resolution},
                 Roundoff{.operations = static_cast<double>(factors.unknowns),
                          .scale = 100,
                          .reason = "residuals of one rounding per unknown, of velocities up to 3, through a matrix "
                                    "whose cut functions have a condition of some 30"});
      check.that({.id = id + "-residual",
                  .text = "The normal equations are solved to round-off.",
                  .quantity = "largest defect, fields of norm 1, over the norm of the velocities",
                  .source = source},
                 {.value = iterated.residual, .resolution = resolution},
                 Roundoff{.operations = 1, .scale = 1, .reason = "the refinement goes on until one rounding is left"});
      if (cells == 16) few = iterated.iterations;
      if (cells == 64) {
        check.that(
            {.id = where + "-growth",
             .text = "Cells of a quarter of the size need hardly more iterations.",
             .quantity = "iterations over those with 16 cells",
             .source = "Nepomnyaschikh, Sov. J. Numer. Anal. Math. Modelling 6 (1991) 151"},
            {.value = static_cast<double>(iterated.iterations) / static_cast<double>(few), .resolution = resolution},
            Bound{1.5,
                  "the condition does not depend on the cells; without the lattice's part the iterations grow "
                  "like their number to a wavelength, by 4"});
      }
    }
  }
}

}  // namespace gauss_particles_iteration_test
