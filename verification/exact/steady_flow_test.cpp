#include <cmath>

#include "seiche/exact/shallow_water/steady_flow.hpp"
#include "seiche/samples.hpp"
#include "verification/exact/bed_primitive.hpp"
#include "verification/reference_digits.hpp"

namespace steady_flow_test {

using namespace seiche;
using exact::MacDonald;
using exact::SteadyBump;
using namespace seiche::verification;

constexpr double g = 9.81;
const std::string source = "Delestre et al., SWASHES, Int. J. Numer. Meth. Fluids 72 (2013) 269; 30-digit arithmetic";

TEST_CASE("steady flow over a bump has every digit in its three regimes", "[exact]") {
  Check check("exact_steady_bump", "Steady flow over a bump",
              "Depths in the three regimes and the place of the hydraulic jump, the constancy of Bernoulli's "
              "head on either side of the jump, and momentum through the jump.");
  const SteadyBump subcritical(g, 4.42, 2);
  check_digits(check, "sub-10", "subcritical depth at x = 10", subcritical.at(10).depth, 1.707347467915034, 15);
  check_digits(check, "sub-9", "subcritical depth at x = 9", subcritical.at(9).depth, 1.787184574689539, 15);
  const auto transcritical = SteadyBump::transcritical(g, 1.53);
  check_digits(check, "trans-crest", "critical depth on the crest", transcritical.at(10).depth, 0.6202564436995096, 16);
  check_digits(check, "trans-up", "transcritical depth upstream", transcritical.at(0).depth, 1.014446798301019, 15);
  check_digits(check, "trans-9", "transcritical depth at x = 9", transcritical.at(9).depth, 0.7884653952712161, 16);
  check_digits(check, "trans-11", "transcritical depth at x = 11", transcritical.at(11).depth, 0.4966215311011425, 16);
  check_digits(check, "trans-down", "transcritical depth downstream", transcritical.at(20).depth, 0.4057809453450359,
               16);
  const SteadyBump jump(g, 0.18, 0.33);
  check_digits(check, "jump-place", "place of the jump", jump.jump(), 11.66561838431536, 14);
  check_digits(check, "jump-before", "depth before the jump", jump.depth_before_jump(), 0.07597027371341473, 17);
  check_digits(check, "jump-after", "depth after the jump", jump.depth_after_jump(), 0.2593217976608193, 16);
  check_digits(check, "jump-up", "depth upstream", jump.at(0).depth, 0.4137357305845031, 16);

  Worst head;
  for (const SteadyBump* flow : {&subcritical, &transcritical, &jump}) {
    const double q = flow->discharge();
    const auto bernoulli = [&](double x) {
      const double h = flow->at(x).depth;
      return h + flow->elevation(x) + q * q / (2 * g * h * h);
    };
    const double upstream = bernoulli(0);
    const double downstream = bernoulli(25);
    for (double x = 0; x <= 25; x += 0.05) {
      const double expected =
          flow->regime() == SteadyBump::Regime::with_jump && x > flow->jump() ? downstream : upstream;
      head.add(bernoulli(x) - expected);
    }
  }
  check.that({.id = "head",
              .text = "Bernoulli's head is constant away from the jump.",
              .quantity = "change of head",
              .unit = "m",
              .source = source},
             {.value = head.value()},
             Roundoff{30, 4,
                      "30 roundings on heads up to 2.3; the velocity head of "
                      "the shallow branch doubles an error of the depth"});
  const auto momentum = [&](double h) { return 0.18 * 0.18 / h + 0.5 * g * h * h; };
  check.that({.id = "jump-momentum",
              .text = "Momentum flux is continuous through the jump.",
              .quantity = "momentum flux difference",
              .unit = "m^3/s^2",
              .source = source},
             {.value = momentum(jump.depth_after_jump()) - momentum(jump.depth_before_jump())},
             Roundoff{10, 1,
                      "the jump is placed to one unit in the last place of x = 11.7 (1.8e-15 m); the "
                      "imbalance changes by 0.5 per metre there"});
  check_digits(check, "sub-down", "subcritical depth at the outflow", subcritical.at(25).depth, 2, 14);
  check_digits(check, "jump-down", "depth at the outflow behind the jump", jump.at(25).depth, 0.33, 15);
  verification::claim_bed_primitive(check, "bed", jump.bed(), 0, 25, 0.2);
}

TEST_CASE("the MacDonald channel carries its depth", "[exact]") {
  Check check("exact_macdonald", "MacDonald channel with friction",
              "Depths and falls of the bed against 30-digit arithmetic, and the steady momentum equation, by "
              "fourth-order differences of the bed that the quadrature made.");
  const auto channel = MacDonald::smooth_rise(g);
  check_digits(check, "depth-0", "depth at the inflow", channel.at(0).depth, 0.7483235583183894, 16);
  check_digits(check, "depth-500", "depth in the middle", channel.at(500).depth, 1.112299103123052, 15);
  check_digits(check, "fall", "fall of the bed over the channel", channel.elevation(0) - channel.elevation(1000),
               6.9522453493352, 13);
  check_digits(check, "half-fall", "fall of the bed over the lower half",
               channel.elevation(500) - channel.elevation(1000), 3.3114297799115, 13);
  Worst residual;
  const double d = 1;
  for (double x = 20; x <= 980; x += 7.3) {
    const auto difference = [&](auto f) {
      return (8 * (f(x + d) - f(x - d)) - (f(x + 2 * d) - f(x - 2 * d))) / (12 * d);
    };
    const double h = channel.at(x).depth;
    const double thrust = difference([&](double s) {
      const auto state = channel.at(s);
      return state.depth * state.velocity * state.velocity + shallow_water::thrust(g, state.depth);
    });
    const double slope = difference([&](double s) { return channel.elevation(s); });
    const double u = channel.at(x).velocity;
    residual.add(thrust + g * h * slope + g * 0.033 * 0.033 * u * u / std::cbrt(h));
  }
  check.that({.id = "residual",
              .text = "Thrust, bed slope and friction are in balance along the channel.",
              .quantity = "momentum residual",
              .unit = "m^2/s^2",
              .source = source},
             {.value = residual.value()},
             Bound{1e-10,
                   "truncation d^4/30 times fifth derivatives of order g h (4/L)^5 16 ~ "
                   "2e-10/30; round-off 10 eps g 7 < 2e-13"});
  verification::claim_bed_primitive(check, "bed", channel.bed(), 0, 1000, 7);
}

}  // namespace steady_flow_test
