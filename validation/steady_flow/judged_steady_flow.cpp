#include "validation/steady_flow/judged_steady_flow.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

#include <cmath>

#include <fmt/format.h>

namespace seiche::validation {
namespace {

constexpr long cells = 200;  ///< over the channel, of a solver that does not say how many it has

/// Mean distance of the level water's depth from the exact one.
double untouched(const JudgedSteadyFlow& flow, const ProfilePoints& points) {
  ProfilePoints level;
  level.x = evenly(points.x.front(), points.x.back(), 2001);
  level.depth = each(level.x, [&](double x) { return flow.level_water(x); });
  level.velocity.resize(level.x.size());
  return mean_errors(level, flow.exact).depth;
}

struct Required {
  evidence::Claim claim;
  std::function<double(const ProfilePoints&)> measured;
  Bound bound;
};

std::vector<Required> requirements(const JudgedSteadyFlow& flow, double cell) {
  std::vector<Required> all{
      {{"depth", "The mean depth error is below the tolerance, by default 5 % of the error of a level surface.",
        "mean |h - exact| over the error of a level surface", "1", flow.source},
       [flow](const ProfilePoints& points) { return mean_errors(points, flow.exact).depth / untouched(flow, points); },
       {.limit = flow.tolerance,
        .reason = "the case's parameter `tolerance`, relative to the effect of bed and friction on a level surface; by "
                  "default 5 %"}},
      {{"discharge", "The unit discharge q = hu agrees with the inflow along the channel within 1 %.",
        "mean |h u - q| over q", "1", flow.source},
       [flow](const ProfilePoints& points) { return mean_errors(points, flow.exact).discharge / flow.discharge; },
       {.limit = 0.01, .reason = "1 %, the uncertainty of a measuring weir"}}};
  if (flow.jump) {
    all.push_back(
        {{"jump", "The position of the hydraulic jump is exact within one cell plus its shift by 1 % of discharge.",
          "position minus the exact position", "m", flow.source},
         [front = flow.jump->front](const ProfilePoints& points) {
           return front_position(points.cells(), front) - front.position;
         },
         {.limit = Amount::at_most(cell + flow.jump->sway, flow.jump->front.reach),
          .reason = "the middle of a jump smeared over eight cells is known to one cell; and a discharge error of 1 %, "
                    "which passes, displaces it"}});
  }
  return all;
}

/// What may be missing of all the water in the end. The books are compensated sums; what rounds is the mass of the two
/// particles that fill and empty at the ends, at every step, and the sums once at last.
evidence::Roundoff open_ends_roundoff(const JudgedSteadyFlow& flow, const SettlingRun& run) {
  const double water = flow.length * run.depth;
  const auto particles = static_cast<double>(run.particles);
  const double particle = 2 * water / particles;
  const double fastest = run.celerity + flow.discharge / run.depth;
  // At a tenth of the Courant number 0.4: steps shorten while a narrow particle leaves.
  const double steps = run.time * fastest * particles / (0.04 * flow.length);
  const double passed = flow.discharge * run.time;
  return {.operations = 1,
          .scale = std::hypot(std::sqrt(2 * steps) * particle, std::sqrt(4.0) * (water + passed)),
          .reason =
              "the particles at the two ends, up to twice as large as the others, are rounded at every step; the sums "
              "of present and passed mass once each"};
}

void judge(const JudgedSteadyFlow& flow, const Submitted& submitted, const SolverFacts& facts,
           evidence::Record& record) {
  const double cell = judged_cell(submitted, flow.length, cells, facts);
  const ProfilePoints points = submitted_points(submitted, 0, flow.length, cell);
  const std::string resolution = resolution_of(points, cell, facts);
  const bool whole = submitted.at("profile").front().values.size() == 2;
  for (const Required& one : requirements(flow, cell)) {
    const double value = one.measured(points);
    if (!whole && std::isnan(value)) {
      record.leave_out({one.claim, "needs a quantity that was not submitted"});
    } else {
      record.check(one.claim, {.value = value, .resolution = resolution}, one.bound);
    }
  }
}

}  // namespace

Parameter level_tolerance_parameter() {
  return real("tolerance", 0.05, "1", {1e-12, 1},
              "largest passing mean error of a submitted depth, over the error of a level surface");
}

Submission submission_of(const std::function<JudgedSteadyFlow(const Values&)>& flow_of) {
  return {.tables = [flow_of](const Values& values) -> std::vector<WantedTable> {
            const JudgedSteadyFlow flow = flow_of(values);
            const double half = flow.length / (2 * cells);
            return {wanted_profile(0, flow.length, cells, flow.exact,
                                   fmt::format("{} --grid x={}:{}:{}", flow.command, half, flow.length - half, cells))};
          },
          .judge = [flow_of](const Values& values, const Submitted& submitted, const SolverFacts& facts,
                             evidence::Record& record) { judge(flow_of(values), submitted, facts, record); }};
}

void claim_steady_flow(const Claims<Settled>& claims, const JudgedSteadyFlow& flow, const SettlingRun& run) {
  const std::string prefix = run.regime.empty() ? "" : run.regime + "-";
  for (const Required& one : requirements(flow, flow.length / static_cast<double>(run.particles))) {
    evidence::Claim claim = one.claim;
    claim.id = prefix + "judged-" + claim.id;
    if (!run.regime.empty()) claim.text = fmt::format("{}: {}", run.regime, claim.text);
    claims.check(
        claim, [measured = one.measured](const Settled& own) { return measured(points_of(own.profile)); }, one.bound);
  }
  claims.from("conservation law of mass")
      .check(prefix + "mass",
             fmt::format("The mass change equals inflow minus outflow to round-off{}.",
                         run.regime.empty() ? "" : " (" + run.regime + ")"),
             "mass minus the recorded mass [m^2]", &Settled::mass_defect, open_ends_roundoff(flow, run));
}

}  // namespace seiche::validation
