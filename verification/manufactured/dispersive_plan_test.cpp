// The plan model against a manufactured motion of a basin: orders in space and time together, and in time alone.
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "reports/evidence/slope_guide.hpp"
#include "validation/instruments/plan/plan_manufactured_flow.hpp"
#include "verification/check.hpp"

namespace dispersive_plan_test {

using namespace seiche::verification;
using seiche::mechanics::Stepping;
using seiche::validation::plan_manufactured_errors;
using seiche::validation::plan_manufactured_flow;
using seiche::validation::PlanManufacturedErrors;

const std::string source = "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4";

struct Quantity {
  std::string id, text;
  double PlanManufacturedErrors::*error;
};
const std::vector<Quantity> quantities = {{"position", "places", &PlanManufacturedErrors::position},
                                          {"elevation", "elevations", &PlanManufacturedErrors::elevation},
                                          {"velocity", "horizontal velocities", &PlanManufacturedErrors::velocity}};

std::string scheme_id(Stepping stepping) {
  return stepping == Stepping::one_step ? "one-step" : "conservative";
}

TEST_CASE("the plan model is of second order against a manufactured motion", "[manufactured]") {
  Check check("manufactured_dispersive_plan", "Manufactured motion of a basin: orders in space and time",
              "A basin of sides $\\pi$ whose columns of water follow a prescribed motion under the body force that "
              "sustains it. $n \\times n$ cells with equally spaced labels, steps of a quarter of a cell, $t = 0$ to "
              "$2$: errors in the $L_2$ norm over the labels.");
  auto& figure = check.figure("convergence", "Errors under refinement", "The grey line has slope 2.");
  auto& panel = figure.panel({.x = "width of a cell", .y = "error", .log_x = true, .log_y = true});
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    std::vector<double> sizes;
    std::vector<std::vector<double>> errors(quantities.size());
    for (const std::size_t n : {12, 16, 24, 32, 48}) {
      const PlanManufacturedErrors found = plan_manufactured_errors({.n = n, .scheme = {.stepping = stepping}});
      sizes.push_back(std::numbers::pi / static_cast<double>(n));
      for (std::size_t i = 0; i < quantities.size(); ++i) errors[i].push_back(found.*quantities[i].error);
    }
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      const std::string id = scheme_id(stepping) + "-" + quantities[i].id;
      panel.line(id, sizes, errors[i], stepping == Stepping::one_step ? Role::computed : Role::peer);
      check.that({.id = id,
                  .text = scheme_id(stepping) + ": " + quantities[i].text + " are of second order.",
                  .quantity = "observed order",
                  .source = source},
                 observed_order(sizes, errors[i]), Order{2, 0.05, "second order of smooth solutions"});
    }
    if (stepping == Stepping::one_step) seiche::validation::slope_guide(panel, 2, sizes, errors[1].back() * 1.5);
  }
}

TEST_CASE("the plan model is of second order in time alone", "[manufactured]") {
  Check check("manufactured_dispersive_plan_time", "Manufactured motion of a basin: order in time",
              "The same motion on 16 x 16 cells with 16 to 128 steps, against 2048 steps on the same cells: errors of "
              "time alone. The one-step scheme's volumes err by $O(\\tau^2)$ too.");
  for (const Stepping stepping : {Stepping::one_step, Stepping::conservative}) {
    const auto flow_of = [&](long steps) {
      auto flow = plan_manufactured_flow({.scheme = {.stepping = stepping}});
      for (long n = 0; n < steps; ++n) flow.advance(2.0 / static_cast<double>(steps));
      return flow;
    };
    const auto finest = flow_of(2048);
    std::vector<double> taus;
    std::vector<std::vector<double>> errors(quantities.size());
    for (const long steps : {16, 32, 64, 128}) {
      const PlanManufacturedErrors found = seiche::validation::differences(flow_of(steps), finest);
      taus.push_back(2.0 / static_cast<double>(steps));
      for (std::size_t i = 0; i < quantities.size(); ++i) errors[i].push_back(found.*quantities[i].error);
    }
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      check.that({.id = scheme_id(stepping) + "-" + quantities[i].id,
                  .text = scheme_id(stepping) + ": " + quantities[i].text + " are second-order in time.",
                  .quantity = "observed order",
                  .source = source},
                 observed_order(taus, errors[i]), Order{2, 0.05, "a symmetric scheme; 2048 steps err by 1/256"});
    }
  }
}

}  // namespace dispersive_plan_test
