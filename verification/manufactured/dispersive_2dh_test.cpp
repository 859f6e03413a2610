// The 2DH model against a manufactured motion of a basin: orders in space and time together, and in time alone.
#include <array>
#include <functional>
#include <numbers>
#include <string>

#include "validation/instruments/plan/plan_manufactured_flow.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::dispersive_2dh_test {

using mechanics::Stepping;

const std::string source = "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4";

/// Orders of places, elevations and horizontal velocities.
void check_orders(Check& check, Stepping stepping, Refinement refinement, const Order& order,
                  const std::function<validation::PlanManufacturedErrors(double)>& errors_at) {
  const std::string scheme = stepping == Stepping::one_step ? "one-step" : "conservative";
  refinement.id = scheme;
  refine(check, refinement,
         {{scheme + "-position", scheme + ": node positions converge at second order.", order},
          {scheme + "-elevation", scheme + ": elevations converge at second order.", order},
          {scheme + "-velocity", scheme + ": horizontal velocities converge at second order.", order}},
         [&](double size) {
           const auto found = errors_at(size);
           return std::array{found.position, found.elevation, found.velocity};
         });
}

TEST_CASE("the 2DH model is second-order accurate against a manufactured motion", "[manufactured]") {
  Check check("manufactured_dispersive_2dh", "Manufactured motion of a basin: orders in space and time",
              "A basin of sides $\\pi$ whose columns of water follow a prescribed motion under the body force that "
              "sustains it. $n \\times n$ cells with equally spaced labels, steps of a quarter of a cell, $t = 0$ to "
              "$2$: errors in the $L_2$ norm over the labels.",
              source);
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    check_orders(check, stepping, {"width of a cell", widths(std::numbers::pi, {12, 16, 24, 32, 48})},
                 {2, 0.05, "second order of smooth solutions"}, [&](double width) {
                   return validation::plan_manufactured_errors(
                       {.n = cells_of(std::numbers::pi, width), .scheme = {.stepping = stepping}});
                 });
  }
}

TEST_CASE("the 2DH model is second-order accurate in time alone", "[manufactured]") {
  Check check("manufactured_dispersive_2dh_time", "Manufactured motion of a basin: order in time",
              "The same motion on 16 x 16 cells with 16 to 128 steps, against 2048 steps on the same cells: errors of "
              "time alone. The one-step scheme's volumes err by $O(\\tau^2)$ too.",
              source);
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    const auto flow_of = [&](long steps) {
      auto flow = validation::plan_manufactured_flow({.scheme = {.stepping = stepping}});
      for (long n = 0; n < steps; ++n) flow.advance(2.0 / static_cast<double>(steps));
      return flow;
    };
    const auto finest = flow_of(2048);
    check_orders(check, stepping, {"step", widths(2, {16, 32, 64, 128})},
                 {2, 0.05, "a symmetric scheme; 2048 steps err by 1/256"},
                 [&](double tau) { return validation::differences(flow_of(std::lround(2 / tau)), finest); });
  }
}

}  // namespace seiche::verification::dispersive_2dh_test
