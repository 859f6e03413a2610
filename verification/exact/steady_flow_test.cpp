#include <cmath>

#include "seiche/exact/shallow_water/steady_flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/difference.hpp"
#include "verification/exact/bed_primitive.hpp"

namespace seiche::verification::steady_flow_test {

using namespace exact;

constexpr double g = 9.81;
const std::string source = "Delestre et al., SWASHES, Int. J. Numer. Meth. Fluids 72 (2013) 269; 30-digit arithmetic";

TEST_CASE("steady flow over a bump conserves its head and satisfies the momentum balance", "[exact]") {
  Check check("exact_steady_bump", "Steady flow over a bump",
              "The constancy of Bernoulli's head on "
              "either side of the jump, and momentum through the jump.",
              source);
  const SteadyBump subcritical(g, 4.42, 2);
  const auto transcritical = SteadyBump::transcritical(g, 1.53);
  const SteadyBump jump(g, 0.18, 0.33);

  Worst head;
  for (const SteadyBump* flow : {&subcritical, &transcritical, &jump}) {
    const double q = flow->discharge();
    const auto bernoulli = [&](double x) {
      const double h = flow->at(x).depth;
      return h + flow->elevation(x) + q * q / (2 * g * h * h);
    };
    const double upstream = bernoulli(0), downstream = bernoulli(25);
    for (double x = 0; x <= 25; x += 0.05) {
      const double expected =
          flow->regime() == SteadyBump::Regime::with_jump && x > flow->jump() ? downstream : upstream;
      head.add(bernoulli(x) - expected);
    }
  }
  check.that(
      "head", "Bernoulli's head is constant away from the jump.", "change of head [m]", {head.value()},
      Roundoff{
          30, 4,
          "30 roundings on heads up to 2.3; the velocity head of the shallow branch doubles an error of the depth"});
  const auto momentum = [&](double h) { return 0.18 * 0.18 / h + 0.5 * g * h * h; };
  check.that("jump-momentum", "Momentum flux is continuous through the jump.", "momentum flux difference [m^3/s^2]",
             {momentum(jump.depth_after_jump()) - momentum(jump.depth_before_jump())},
             Roundoff{10, 1,
                      "the jump is placed to one unit in the last place of x = 11.7 (1.8e-15 m); the imbalance changes "
                      "by 0.5 per metre there"});
  verification::claim_bed_primitive(check, "bed", jump.bed(), 0, 25, 0.2);
}

TEST_CASE("the MacDonald channel has its prescribed depth", "[exact]") {
  Check check(
      "exact_macdonald", "MacDonald channel with friction",
      "Residual of the steady momentum equation, from fourth-order differences of the bed computed by quadrature.",
      source);
  const auto channel = MacDonald::smooth_rise(g);
  Worst residual;
  for (double x = 20; x <= 980; x += 7.3) {
    const double h = channel.at(x).depth;
    const auto thrust_at = [&](double d) {
      const auto state = channel.at(x + d);
      return state.depth * state.velocity * state.velocity + shallow_water::thrust(g, state.depth);
    };
    const double thrust = difference(thrust_at, 2);
    const double slope = difference([&](double d) { return channel.elevation(x + d); }, 2);
    const double u = channel.at(x).velocity;
    residual.add(thrust + g * h * slope + g * 0.033 * 0.033 * u * u / std::cbrt(h));
  }
  check.that("residual", "Thrust, bed slope and friction are in balance along the channel within 2e-11.",
             "momentum residual [m^2/s^2]", {residual.value()},
             Bound{2e-11,
                   "truncation d^4/30 times fifth derivatives of order g h (4/L)^5 16 ~ 2e-10/30 = 7e-12, which each "
                   "of three terms may have; round-off 10 eps g 7 "
                   "< 2e-13"});
  verification::claim_bed_primitive(check, "bed", channel.bed(), 0, 1000, 7);
}

}  // namespace seiche::verification::steady_flow_test
