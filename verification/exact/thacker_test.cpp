#include <cmath>

#include "seiche/exact/shallow_water/thacker.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/cell_average.hpp"
#include "validation/instruments/manufactured/lagrangian_manufactured.hpp"
#include "verification/check.hpp"
#include "verification/exact/bed_primitive.hpp"
#include "verification/exact/shallow_water_residual.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::thacker_test {

using exact::Thacker;
using validation::LagrangianManufactured;

constexpr double g = 9.81;

TEST_CASE("water oscillates in a parabolic bowl at any amplitude", "[exact]") {
  const std::string source = "Thacker, J. Fluid Mech. 107 (1981) 499; Delestre et al., SWASHES (2013), section 4.2.1";
  Check check("exact_thacker", "Planar oscillation in a parabolic bowl",
              "Residual of both equations on the sloping bed for "
              "displacements from 0.05 to 1 (the published one is half the radius); constant area; the energy of a "
              "rigid oscillation.",
              source);
  const Thacker published(g, 1, 0.5, 4);
  Worst area;
  const auto largest_residual = [&](double span) {
    Largest residual;
    for (const double displacement : {0.05, 0.3, 0.5, 1.0}) {
      const Thacker bowl(g, 1, 0.5, 4, displacement);
      for (double t = 0.1; t < 2; t += 0.3) {
        for (const double offset : {-0.7, -0.1, 0.5, 0.7}) {
          const double x = 2 + bowl.shift(t) + offset;
          const double slope = 2 * 0.5 * (x - 2);
          residual.add(verification::shallow_water_residual([&](double p, double s) { return bowl.at(p, s); }, g, x, t,
                                                            0.05, span, slope));
        }
        area.add(4 * validation::cell_average(bowl, 0, 4, t).depth - bowl.area());
      }
    }
    return residual.value();
  };
  refine(check, {.axis = "time difference", .sizes = falling(0.08, 4), .title = {}, .floor = 1e-11},
         {{"residual-order",
           "The residual of both equations falls at fourth order in the time difference at every displacement.",
           {4, 0.2, "fourth-order differences; those in x are exact for the solution's polynomials in x"}}},
         largest_residual);
  check.that("area", "The area of the water is constant.", "area change [m^2]", {area.value()},
             Roundoff{60, 1, "sum of 20 weighted points up to 2/3"});
  CHECK(std::abs(published.at(published.left_shoreline(0.3) + 1e-9, 0.3).depth) < 2e-9);
  CHECK(published.at(published.left_shoreline(0.3) - 1e-9, 0.3).depth == 0);
  check.that("path", "A particle moves with the water.",
             "position of a particle less its start and the shift of the water [m]",
             {published.carried(1.2, 0.7) - (1.2 + published.shift(0.7) - published.shift(0))},
             Roundoff{10, 2, "ten roundings of positions up to 2 m"});
  verification::claim_bed_primitive(check, "bed", published.bed(), 0, 4, 1.5);
}

TEST_CASE("the Lagrangian manufactured solution satisfies the forced equations", "[exact]") {
  const std::string source = "Roache, J. Fluids Eng. 124 (2002) 4";
  Check check("exact_lagrangian_manufactured", "Manufactured solution in Lagrangian form",
              "Residual of both equations with the stated force, by differences of halving width: order 4. The label "
              "found from a position leads back to it, walls stay at rest, and the mean velocity of a particle is the "
              "integral of the velocity over its labels.",
              source);
  const LagrangianManufactured flow;
  const auto at = [&](double x, double t) { return flow.at(x, t); };
  refine(check, {.axis = "width of the differences", .sizes = falling(0.04, 4), .title = {}, .floor = 1e-11},
         {{"residual-order",
           "The residual of the equations falls at fourth order in the width of the differences.",
           {4, 0.3, "fourth-order central differences of a smooth solution"}}},
         [&](double span) {
           Largest largest;
           for (double x = 0.05; x < 0.96; x += 0.05) {
             largest.add(verification::shallow_water_residual(at, g, x, 0.4, span, span, 0, flow.source(x, 0.4)));
           }
           return largest.value();
         });
  Worst round_trip, mean;
  for (double s = 0; s <= 1; s += 0.0625) {
    round_trip.add(flow.label(flow.position(s, 0.7), 0.7) - s);
    if (s < 1) {
      const double middle = boost::math::quadrature::gauss<double, 15>::integrate(
          [&](double label) { return flow.state_of(label, 0.7).velocity; }, s, s + 0.0625);
      mean.add(flow.mean_velocity(s, s + 0.0625, 0.7) - middle / 0.0625);
    }
  }
  check.that("label", "Maps from label to position and back are inverse.", "label error [m]", {round_trip.value()},
             Roundoff{10, 1, "10 roundings; J >= 0.69 amplifies by 1.5"});
  check.that("mean-velocity", "Mean velocity is the mean over labels.", "velocity error [m/s]", {mean.value()},
             Roundoff{40, 0.15, "15 points, 40 roundings on velocities up to A w"});
  CHECK(std::abs(flow.at(0, 0.4).velocity) < 1e-16);
  CHECK(std::abs(flow.at(1, 0.4).velocity) < 1e-15);
}

}  // namespace seiche::verification::thacker_test
