#include "validation/studies/shallow_water/judged_states.hpp"

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {
namespace {

evidence::Claim claim_of(const RiemannRequirement& one) {
  return {one.id, one.text, one.quantity, one.unit, "exact solution of the Riemann problem"};
}

std::string command_of(const JudgedStates& states) {
  const exact::Riemann& solution = states.solution;
  const double half = states.length() / (2 * static_cast<double>(states.cells));
  return fmt::format(
      "seiche exact riemann --set "
      "left_depth={},left_velocity={},right_depth={},right_velocity={},gravity={},jump={}"
      " --grid x={}:{}:{},t={}",
      solution.left().depth, solution.left().velocity, solution.right().depth, solution.right().velocity,
      solution.gravity(), solution.jump(), states.start + half, states.end - half, states.cells, states.since);
}

void judge(const JudgedStates& states, const Submitted& submitted, const SolverFacts& facts, evidence::Record& record) {
  const auto& [solution, since, start, end, cells] = states;
  const double cell = judged_cell(submitted, states.length(), cells, facts);
  const ProfilePoints points = submitted_points(submitted, start, end, cell);
  const RiemannErrors errors = riemann_errors(solution, since, points);
  const bool depth = submitted.at("profile").front().values.contains("h");
  const bool both = depth && submitted.at("profile").front().values.contains("u");
  record.measure("l1_h", errors.depth);
  record.measure("l1_u", errors.velocity);
  record.measure("points", static_cast<double>(points.x.size()));
  const JudgedFront judged = judged_front(solution, since);
  record.measure("front_position", judged_position(solution, judged, points.cells(), false));
  record.measure("front_position_exact", judged.front.position);
  if (judged.is_jump) record.measure("front_width", front_width(points.cells(), judged.front));

  const std::vector<double> exact_depth = each(points.x, [&](double x) { return solution.at(x, since).depth; });
  const std::string resolution = resolution_of(points, cell, facts);
  for (const RiemannRequirement& one : riemann_requirements(solution, since, start, end, cell, points.apart())) {
    const bool of_flow = one.error == &RiemannErrors::discharge || one.error == &RiemannErrors::momentum;
    if (!(of_flow ? both : depth)) {
      record.leave_out({claim_of(one), of_flow ? "needs depth and velocity" : "needs the depth"});
      continue;
    }
    if (one.id == "front" && !points.cover(judged.front.position)) {
      record.leave_out({claim_of(one), "the submitted points do not reach the front"});
      continue;
    }
    if (one.id == "celerity" && largest(exact_depth) - smallest(exact_depth) <= 1e-9 * largest(exact_depth)) {
      record.leave_out({claim_of(one), "the points do not reach a wave"});
      continue;
    }
    record.check(claim_of(one), {.value = errors.*one.error, .resolution = resolution}, one.bound);
  }
}

}  // namespace

std::vector<WantedTable> wanted_states(const JudgedStates& states) {
  const auto exact = [solution = states.solution, since = states.since](double x) { return solution.at(x, since); };
  return {wanted_profile(states.start, states.end, states.cells, exact, command_of(states))};
}

Submission submission_of(const std::function<JudgedStates(const Values&)>& states_of) {
  return {.tables = [states_of](const Values& values) { return wanted_states(states_of(values)); },
          .judge = [states_of](const Values& values, const Submitted& submitted, const SolverFacts& facts,
                               evidence::Record& record) { judge(states_of(values), submitted, facts, record); }};
}

void claim_states(const Claims<FlowRun>& claims, const JudgedStates& states, double cell, double viscosity) {
  for (const RiemannRequirement& one :
       riemann_requirements(states.solution, states.since, states.start, states.end, cell, 0, viscosity)) {
    const Amount& limit = one.bound.limit;
    claims
        .only_if(!(limit.value() > limit.cap()), fmt::format("on cells of {:.3g} m the error of a first-order scheme "
                                                             "exceeds half of the error of water at rest: inconclusive",
                                                             cell))
        .check(
            claim_of(one),
            [states, error = one.error](const FlowRun& run) {
              return riemann_errors(states.solution, states.since, points_of(run.profile())).*error;
            },
            one.bound);
  }
}

}  // namespace seiche::validation
