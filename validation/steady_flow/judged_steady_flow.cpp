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
      {{.id = "discharge",
        .text = "The unit discharge q = hu agrees with the inflow along the channel within 1 %.",
        .quantity = "mean |h u - q| over q",
        .source = flow.source},
       [flow](const ProfilePoints& points) { return mean_errors(points, flow.exact).discharge / flow.discharge; },
       {.limit = 0.01, .reason = "1 %, the uncertainty of a measuring weir"}}};
  if (flow.jump) {
    all.push_back(
        {{.id = "jump",
          .text = "The position of the hydraulic jump is exact within one cell plus its shift by 1 % of discharge.",
          .quantity = "position minus the exact position",
          .unit = "m",
          .source = flow.source},
         [front = flow.jump->front](const ProfilePoints& points) {
           return front_position(points.cells(), front) - front.position;
         },
         {.limit = Amount::at_most(cell + flow.jump->sway, flow.jump->front.reach),
          .reason = "the middle of a jump smeared over eight cells is known to one cell; and a discharge error of 1 %, "
                    "which passes, displaces it"}});
  }
  return all;
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

void claim_steady_flow(const Claims<Profile>& claims, const JudgedSteadyFlow& flow, double cell,
                       const std::string& prefix) {
  for (const Required& one : requirements(flow, cell)) {
    evidence::Claim claim = one.claim;
    claim.id = prefix + claim.id;
    const std::size_t regime = prefix.find("-judged");
    if (regime != std::string::npos) claim.text = fmt::format("{}: {}", prefix.substr(0, regime), claim.text);
    claims.check(
        claim, [measured = one.measured](const Profile& own) { return measured(points_of(own)); }, one.bound);
  }
}

}  // namespace seiche::validation
