// Bores of the dispersive shallow-water models with breaking: what they keep, what they lose, and the depth behind
// them.
#include <cmath>
#include <functional>
#include <memory>
#include <span>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/exact/dam_break.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::dispersive_breaking_test {

using namespace dispersive_shallow_water_1d;

const std::string source = "jump conditions: Stoker, Water Waves (1957), 10.6";

constexpr double end = 60;  // of a bore's way

/// Elevation over water 1 deep of a step up to `high` at x = 0.
double dam(double high, double x) {
  return 0.5 * (high - 1) * (1 - std::tanh(2 * x));
}

/// Water with such a step, at rest.
Flow dam_break(double high, double reach, double spacing) {
  const Channel channel{.bottom = std::make_shared<LevelBottom>(1.0), .breaking = Breaking{}};
  Markers markers = still_markers(channel, equal_labels(channel, -reach, reach, cells_of(2 * reach, spacing)));
  for (std::size_t i = 0; i < markers.size(); ++i) markers.y[i] = dam(high, markers.x[i]);
  return {channel, markers};
}

namespace plan = dispersive_shallow_water_2d;

/// The same in 2DH, a channel of two rows between walls.
plan::Flow dam_break_in_plan(double high, double reach, double spacing) {
  plan::Rectangle channel{.begin = -reach, .end = reach, .north = 2 * spacing, .rows = 2};
  channel.columns = cells_of(2 * reach, spacing);
  channel.elevation = [high](double x, double) { return dam(high, x); };
  return plan::Flow(plan::rectangular_lattice(channel), {}, {.stepping = Stepping::conservative},
                    {.tolerance = 1e-13, .drag = {.breaking_slope = Breaking{}.onset_slope}});
}

/// A surface along x, above the level of the water before the bore.
struct Profile {
  std::span<const double> x, elevation;

  /// Where it falls through half of a rise, from the right.
  [[nodiscard]] double front(double rise) const {
    for (std::size_t i = x.size() - 1; i-- > 0;) {
      const double above = elevation[i] - 0.5 * rise;
      const double below = elevation[i + 1] - 0.5 * rise;
      if (above >= 0 && below < 0) return x[i] + (x[i + 1] - x[i]) * above / (above - below);
    }
    return std::nan("");
  }
};

/// A flow that comes from a dam 2.5 times as high as the water before it, until t = 60.
/// @param profile  of the flow
/// @param taken    energy that breaking took of a unit of width so far
template <class Flow, class Steps>
void claim_bore(Check& check, Flow& flow, const Steps& steps, const std::function<Profile()>& profile,
                const std::function<double()>& taken) {
  const double conjugate = exact::Stoker(1, 2.5, 1).plateau().depth;
  const exact::Bore bore(1, 1, conjugate);
  march(flow, 0.5 * end, steps);
  const double first = profile().front(conjugate - 1);
  march(flow, 0.9 * end, steps);
  const double before = taken();
  march(flow, end, steps);
  check.source(source);
  const Profile now = profile();
  const double last = now.front(conjugate - 1);
  Largest behind;  // of the water behind the front
  for (std::size_t i = 0; i < now.x.size(); ++i) {
    if (now.x[i] > last - 10) behind.add(now.elevation[i] + 1);
  }
  const std::string spread =
      "waves shed at the start leave the front slowly: 0.1 % of the rise is left after a distance of 60 h, and the "
      "loss goes with the cube of the rise; 1 % covers both and the O(tau^2) of the step";
  check.that("depth", "The maximum depth within 10 h of the front is the conjugate depth: no waves follow the front.",
             "highest surface within ten depths of the front over the conjugate depth", {behind.value()},
             Bound{0.005, "0.8 % of the rise, 0.66: half of the viscosity would overshoot by 2.6 % of it", conjugate});
  check.that("speed", "The speed of the front agrees with the bore within 1 %.", "speed between t = 30 and 60",
             {(last - first) / (0.5 * end)}, Bound{0.01, spread, bore.speed(), true});
  check.that("loss", "The energy dissipated by breaking agrees with the loss in the bore within 1 %.",
             "energy taken per unit of time, t = 54 to 60", {(taken() - before) / (0.1 * end)},
             Bound{0.01, spread, bore.energy_loss_rate(), true});
}

TEST_CASE("breaking conserves mass and momentum and dissipates energy", "[conservation]") {
  Check check("dispersive_breaking_ledger", "Conservation and dissipation by breaking",
              "A block of water 1.5 above depth 1, 20 long, falls apart into two bores in a periodic channel of length "
              "80 that streams with 0.3, conservative scheme, t = 20, cells of 0.25.");
  const Channel channel{.bottom = std::make_shared<LevelBottom>(1.0), .period = 80, .breaking = Breaking{}};
  Markers markers = still_markers(channel, equal_labels(channel, -40, 40, 320));
  for (std::size_t i = 0; i < markers.size(); ++i) {
    markers.y[i] = 0.75 * (std::tanh(2 * (markers.x[i] + 10)) - std::tanh(2 * (markers.x[i] - 10)));
  }
  markers.u.assign(markers.size(), 0.3);
  Flow flow(channel, markers, {.stepping = Stepping::conservative});
  const double energy = flow.energy(), momentum = flow.ledger().entry("momentum_x").initial;
  constexpr int steps = 200;
  double taken = 0;
  Largest gain;
  for (int n = 0; n < steps; ++n) {
    flow.advance(0.1);
    flow.observe();
    gain.add(taken - flow.lost().breaking);
    taken = flow.lost().breaking;
  }
  const double operations = steps * 320;
  check.from(source).that("momentum", "Momentum of the breaking wave is conserved to round-off.",
                          "largest error over the momentum", {flow.ledger().largest_defect("momentum") / momentum},
                          Roundoff{operations, 4, "a rounded force per node and step"});
  check.from("formula 10")
      .that("volumes", "The volume of every cell is conserved to round-off.", "largest defect",
            {flow.ledger().largest_defect("volume_worst")},
            Roundoff{steps, 40, "a rounded position, up to 40, per step"});
  check.from("energy balance")
      .that("energy", "The sum of energy and dissipation by breaking is conserved to round-off.",
            "largest error over the energy", {flow.ledger().largest_defect("energy") / energy},
            Roundoff{operations, 4, "a rounded term per node and step"});
  check.from("an implicit exchange between pairs")
      .that("takes", "The breaking term adds no energy in any step.", "largest gain over the energy",
            {std::max(0.0, gain.value()) / energy}, Roundoff{320, 1, "a rounded term per node"});
  CHECK(taken > 0.005 * energy);
}

TEST_CASE("the depth behind a breaking bore is the conjugate depth", "[conservation]") {
  Check check("dispersive_breaking_bore", "A bore that breaks",
              "A dam 2.5 times as high as the water before it breaks, cells of 0.25, steps of a third of it, t = 60. "
              "The shallow-water equations' exact solution has a bore of Froude number 1.48; long behind its front the "
              "breaking model must have the depth, speed and energy loss of that bore, without waves.");
  Flow flow = dam_break(2.5, 1.6 * end + 20, 0.25);
  const auto profile = [&] { return Profile{flow.x(), flow.y()}; };
  claim_bore(check, flow, stable_steps(flow, 0.25 / 3), profile, [&] { return flow.lost().breaking; });
}

TEST_CASE("the depth behind a breaking bore in 2DH is the conjugate depth", "[conservation]") {
  Check check("breaking_bore_2dh", "A bore that breaks, in 2DH",
              "The same bore in a channel of two rows; fronts steeper than 30 degrees begin to break. The conservative "
              "scheme conserves energy, so that breaking causes all of the energy loss.");
  constexpr double spacing = 0.25;
  plan::Flow flow = dam_break_in_plan(2.5, 1.6 * end + 20, spacing);
  const std::size_t count = flow.shape().columns + 1;
  const double energy = flow.energy();
  const auto profile = [&] { return Profile{flow.x().first(count), flow.z().first(count)}; };
  claim_bore(check, flow, spacing / 3, profile, [&] { return (energy - flow.energy()) / (2 * spacing); });
}

TEST_CASE("a weak bore remains undular", "[conservation]") {
  Check check("dispersive_breaking_undular", "A bore that does not break",
              "A dam 1.6 times as high as the water ahead: the Froude number of the bore is 1.2.");
  Flow flow = dam_break(1.6, 60, 0.25);
  march(flow, 20, stable_steps(flow, 0.08));
  check.from("Favre (1935): bores below 1.3 are undular")
      .that("nothing", "The breaking term dissipates no energy of an undular bore.", "energy taken",
            {flow.lost().breaking}, Bound{0, "no front breaks"});
}

TEST_CASE("a node-to-node oscillation over shallow water is damped", "[conservation]") {
  Check check("dispersive_breaking_zigzag", "Nodes that the water does not resolve",
              "Nodes 0.2 apart are displaced alternately up and down by 1e-5. Volumes do not depend on it, the "
              "potential energy does, with $\\omega^2 = g/(3 \\alpha H)$. In water 0.1 deep this is no wave of the "
              "model, and the exchange of vertical momentum damps it with the damping ratio $\\zeta = 0.2/0.1 = 2$. In "
              "water 0.3 deep it is not damped.");
  const auto zigzag = [](double depth) {
    const Channel channel{.bottom = std::make_shared<LevelBottom>(depth), .period = 3.2, .breaking = Breaking{}};
    Markers markers = still_markers(channel, equal_labels(channel, 0, 3.2, 16));
    for (std::size_t i = 0; i < markers.size(); ++i) markers.y[i] = i % 2 == 0 ? 1e-5 : -1e-5;
    return Flow(channel, markers);
  };
  const double omega = std::sqrt(1 / 0.1);                            // 3 alpha = 1
  const double slow = 2 - std::sqrt(3.0), fast = 2 + std::sqrt(3.0);  // rates over omega
  const double exact = (fast * std::exp(-2 * slow) - slow * std::exp(-2 * fast)) / (fast - slow);
  refine(check, {"tau", widths(0.05 / omega, {1, 2, 4, 8})},
         {{"dies-out",
           "The amplitude of the zigzag at t = 2/omega converges at first order to the exact damped oscillation.",
           {1, 0.1, "the exchange is Euler's implicit rule"}}},
         [&](double tau) {
           Flow flow = zigzag(0.1);
           for (long n = 0; n < std::lround(2 / (omega * tau)); ++n) flow.advance(tau);
           return std::abs(flow.y()[0] / 1e-5 - exact);
         });
  Flow deep = zigzag(0.3);
  for (int n = 0; n < 50; ++n) deep.advance(0.05);
  check.from("breaking.hpp")
      .that("left-alone", "The energy dissipated by breaking in water deeper than the node spacing is zero.",
            "energy taken", {deep.lost().breaking}, Bound{0, "no exchange"});
}

}  // namespace seiche::verification::dispersive_breaking_test
