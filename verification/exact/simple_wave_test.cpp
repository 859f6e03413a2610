#include <cmath>

#include "seiche/exact/shallow_water/simple_wave.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/cell_average.hpp"
#include "verification/check.hpp"
#include "verification/exact/shallow_water_residual.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::simple_wave_test {

TEST_CASE("the simple wave satisfies the equations until it breaks", "[exact]") {
  const std::string source = "Stoker, Water Waves (1957), section 10.3";
  Check check("exact_simple_wave", "Simple wave",
              "Residual of both equations by fourth-order differences with halving steps: it must fall with order 4, "
              "which no wrong solution does. Mass and momentum of the wave are constant, and the breaking time follows "
              "from the steepest fall of the celerity.",
              source);
  constexpr double g = 9.81;
  const auto wave = exact::SimpleWave::hump(g, 1, 0.2, 6, 6);
  const auto at = [&](double x, double t) { return wave.at(x, t); };
  refine(check, {.axis = "width of the differences", .sizes = falling(0.08, 4), .title = {}, .floor = 1e-12},
         {{"residual-order",
           "The residual of the equations falls at fourth order in the width of the differences.",
           {4, 0.3, "fourth-order central differences of a smooth solution"}}},
         [&](double span) {
           Largest largest;
           for (double x = 6; x < 11; x += 0.1) {
             largest.add(verification::shallow_water_residual(at, g, x, 0.6, span, span / 4));
           }
           return largest.value();
         });
  Worst mass, momentum;
  const auto integrals = [&](double t) {
    double m = 0, q = 0;
    for (int k = 0; k < 200; ++k) {
      const auto mean = validation::cell_average(wave, 0.1 * k, 0.1 * (k + 1), t);
      m += 0.1 * mean.depth;
      q += 0.1 * mean.discharge;
    }
    return std::pair(m, q);
  };
  const auto [mass0, momentum0] = integrals(0);
  for (const double t : {0.3, 0.6, 0.9}) {
    const auto [m, q] = integrals(t);
    mass.add(m - mass0);
    momentum.add(q - momentum0);
  }
  const Roundoff limit{.operations = 4000,
                       .scale = 1,
                       .reason = "200 cells of 20 points of size 0.1, partial sums up to 20 over 200 additions"};
  check.that("mass", "Mass of the exact simple wave is constant.", "mass change [m^2]", {mass.value()}, limit);
  check.that("momentum", "Momentum of the exact simple wave is constant.", "momentum change [m^3/s]",
             {momentum.value()}, limit);

  // Direct search for the first crossing of characteristics on a fine grid.
  Smallest steepest;
  const auto celerity = [&](double x) { return std::sqrt(g * wave.at(x, 0).depth); };
  constexpr double d = 1e-4;
  for (double x = 3; x < 9; x += 0.001) steepest.add((celerity(x + d) - celerity(x - d)) / (2 * d));
  check.that("breaking", "The breaking time is the theoretical one of the steepest fall of the celerity.",
             "breaking time [s]", {wave.breaking_time()},
             Bound{1e-6, "grid of 1e-3 misses the extremum by (1e-3)^2/8 of its curvature", -1 / (3 * steepest.value()),
                   true});
  CHECK_NOTHROW(wave.at(6, 0.999 * wave.breaking_time()));
}

}  // namespace seiche::verification::simple_wave_test
