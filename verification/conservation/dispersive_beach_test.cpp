// Run-up and run-down on plane slopes: what each scheme of the dispersive shallow-water model conserves there.
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "verification/check.hpp"
#include "verification/conservation/dispersive_defects.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::dispersive_beach_test {

using namespace dispersive_shallow_water_1d;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapter 3";

struct Beach {
  double cotangent, amplitude, spacing, end;
};

/// A solitary wave on its way to a plane slope; the crest starts where the wave's front reaches the toe (Synolakis, J.
/// Fluid Mech. 185 (1987) 523), between a wall and the shore at x = 0.
Flow beach_flow(const Beach& beach, const Scheme& scheme) {
  const double front = std::acosh(std::sqrt(20.0)) / std::sqrt(0.75 * beach.amplitude);
  const double crest = -beach.cotangent - front;
  const double wall = crest - front - 5;
  const Channel channel{
      .bottom = std::make_shared<PiecewiseLinearBottom>(std::vector{wall - 10, -beach.cotangent, 10 * beach.cotangent},
                                                        std::vector{-1.0, -1.0, 10.0}),
      .left = End::wall,
      .right = End::tip};
  return Flow(channel,
              solitary_markers(channel, wall, 0, beach.spacing, {.amplitude = beach.amplitude, .crest = crest}),
              scheme);
}

constexpr Beach synolakis{.cotangent = 19.85, .amplitude = 0.0185, .spacing = 0.25, .end = 75};

/// `refine` divides the longest step and the Courant number.
Defects synolakis_defects(const Scheme& scheme, double refine = 1) {
  Flow flow = beach_flow(synolakis, scheme);
  return defects_until(flow, synolakis.end, synolakis.spacing / 4 / refine, 0.3 / refine);
}

void check_round_off(Check& check, const std::string& id, const std::string& text, const Defects& defects,
                     double length) {
  const auto steps = static_cast<double>(defects.steps);
  check.holds(id + "-energy: " + text + ": energy to round-off.", {defects.energy},
              Roundoff{steps, 1, "one rounded energy per step"});
  check.holds(id + "-volume: " + text + ": the volume of every cell to round-off.", {defects.volume},
              Roundoff{steps, length, "one place, up to the channel's length, rounded per step, times the depth"});
}

TEST_CASE("run-up and full run-down on a mild slope: what each scheme conserves", "[conservation]") {
  Check check("dispersive_beach_conservation", "Dispersive shallow water: conservation on a beach",
              "Solitary wave of 0.0185 depths on a slope 1:19.85, run-up and run-down until $t = 75$; cells of 0.25, "
              "steps of at most 1/16 and 0.3 of the longest stable one. The one-step scheme's errors are made at the "
              "largest draw-down, $67 < t < 70$, where a thin layer runs back under a steep front; until then its "
              "energy errs by $1.4\\times10^{-6}$.",
              source);
  const auto order = [](double theory) { return Order{theory, 0.1, "four halvings of all steps"}; };
  refine(check, {"longest step", widths(synolakis.spacing / 4, {1, 2, 4, 8})},
         {{"one-step-energy-order", "The energy error on the beach is second-order in the step (one-step scheme).",
           order(2)},
          {"one-step-volume-order", "The volume error on the beach is second-order in the step (one-step scheme).",
           order(2)},
          {"feedback-energy-order", "With feedback: the energy defect is of second order.", order(2)},
          {"feedback-volume-order", "With feedback: the volume defect is of third order.", order(3)}},
         [&](double step) {
           const double fineness = synolakis.spacing / 4 / step;
           const Defects a = synolakis_defects({}, fineness);
           const Defects b = synolakis_defects({.stepping = Stepping::one_step_feedback}, fineness);
           return std::array{a.energy, a.volume, b.energy, b.volume};
         });
  check_round_off(check, "conservative", "Fully conservative", synolakis_defects({.stepping = Stepping::conservative}),
                  82);
}

TEST_CASE("markers that cross the toe of a slope do not spoil conservation", "[conservation]") {
  Check check("dispersive_corner_conservation", "Dispersive shallow water: markers that cross a corner of the bottom",
              "Steep slopes: markers near the toe go back and forth over it, and the frame of a marker in the middle "
              "of its step may flip from one sweep of the implicit step to the next. The frames are held from the "
              "fourth sweep on. Energy and volumes do not depend on them, and stay exact.");
  for (const Beach& beach :
       {Beach{1, 0.5, 0.25, 40}, Beach{1, 0.5, 0.125, 40}, Beach{3.732, 0.1, 0.25, 40}, Beach{3.732, 0.1, 0.125, 40}}) {
    Flow flow = beach_flow(beach, {.stepping = Stepping::conservative});
    const double length = flow.x().back() - flow.x().front();
    const Defects defects = defects_until(flow, beach.end, beach.spacing / 4);
    const std::string id = fmt::format("cot-{:.0f}-cells-{:.0f}", beach.cotangent, 1 / beach.spacing);
    const std::string text =
        fmt::format("cot {:g}, amplitude {:g}, cells of {:g}", beach.cotangent, beach.amplitude, beach.spacing);
    check_round_off(check, id, text, defects, length);
  }
}

}  // namespace seiche::verification::dispersive_beach_test
