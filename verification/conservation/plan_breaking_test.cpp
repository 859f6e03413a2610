// Bores of the plan model with breaking: the depth behind them, their speed and what they lose.
#include <cmath>
#include <vector>

#include "seiche/exact/bore.hpp"
#include "seiche/exact/dam_break.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace {

using namespace seiche::dispersive_shallow_water_2d;
using namespace seiche::verification;
using seiche::evidence::Bound;

constexpr double spacing = 0.25;
const std::string source = "jump conditions: Stoker, Water Waves (1957), 10.6";

/// A channel of two rows between walls, 1 deep, with a step up to `high` at x = 0, at rest.
Flow dam_break(double high, double reach) {
  const auto step = [high](double x, double) { return 0.5 * (high - 1) * (1 - std::tanh(2 * x)); };
  return Flow(rectangular_lattice({.begin = -reach,
                                   .end = reach,
                                   .south = 0,
                                   .north = 2 * spacing,
                                   .columns = static_cast<std::size_t>(std::lround(2 * reach / spacing)),
                                   .rows = 2,
                                   .elevation = step}),
              {}, {.stepping = Stepping::conservative}, {.tolerance = 1e-13, .drag = {.breaking_slope = 0.364}});
}

/// Where the surface along the south wall falls through a level, from the east.
double front_of(const Flow& flow, double level) {
  for (std::size_t i = flow.shape().columns; i-- > 0;) {
    const double above = flow.z()[i] - level;
    const double below = flow.z()[i + 1] - level;
    if (above >= 0 && below < 0) return flow.x()[i] + (flow.x()[i + 1] - flow.x()[i]) * above / (above - below);
  }
  return std::nan("");
}

}  // namespace

TEST_CASE("behind a breaking bore in plan stands the conjugate depth", "[conservation]") {
  Check check("plan_breaking_bore", "A bore that breaks, in plan",
              "A dam 2.5 times as high as the water before it breaks in a channel of two rows, cells of 0.25, "
              "conservative steps of a third of it, t = 60. The shallow-water equations' exact solution has a bore of "
              "Froude number 1.48; long behind its front the breaking model must have its depth and its speed. The "
              "scheme keeps energy, so that all that goes is what the bore loses.");
  constexpr double high = 2.5;
  constexpr double end = 60;
  const double conjugate = seiche::exact::Stoker(1, high, 1).plateau().depth;
  const seiche::exact::Bore bore(1, 1, conjugate);
  Flow flow = dam_break(high, 1.6 * end + 20);
  const double tau = spacing / 3;
  flow.advance_to(0.5 * end, tau);
  const double level = 0.5 * (conjugate - 1);
  const double first = front_of(flow, level);
  flow.advance_to(0.9 * end, tau);
  const double before = flow.energy();
  flow.advance_to(end, tau);
  const double last = front_of(flow, level);
  const double rate = (before - flow.energy()) / (0.1 * end) / (2 * spacing);
  seiche::Largest behind;  // of the water behind the front
  for (std::size_t k = 0; k < flow.x().size(); ++k) {
    if (flow.x()[k] > last - 10) behind.add(flow.z()[k] + 1);
  }
  const std::string spread =
      "what the start sheds leaves the front slowly: a tenth of a per cent of the rise is left after 60 depths of way, "
      "and the loss goes with the cube of the rise; 1 % covers both and the O(tau^2) of the step";
  check.that({.id = "depth",
              .text = "The surface rises to the conjugate depth and not above: there are no waves behind the front.",
              .quantity = "highest surface within ten depths of the front over the conjugate depth",
              .source = source},
             {.value = behind.value()},
             Bound{.limit = 0.005,
                   .reason = "1 % of the rise, 0.66: half of the viscosity would overshoot by 2.6 % of it",
                   .expected = conjugate});
  check.that({.id = "speed",
              .text = "The front runs with the speed of the bore.",
              .quantity = "speed between t = 30 and 60",
              .source = source},
             {.value = (last - first) / (0.5 * end)},
             Bound{.limit = 0.01, .reason = spread, .expected = bore.speed(), .relative = true});
  check.that({.id = "loss",
              .text = "The energy that goes is what the bore loses.",
              .quantity = "energy lost per unit of time and width, t = 54 to 60",
              .source = source},
             {.value = rate},
             Bound{.limit = 0.01, .reason = spread, .expected = bore.energy_loss_rate(), .relative = true});
}
