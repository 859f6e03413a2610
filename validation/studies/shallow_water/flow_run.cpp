#include "validation/studies/shallow_water/flow_run.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace seiche::validation {
namespace {

using evidence::Amount;
using evidence::Role;
using evidence::Roundoff;

/// More steps than any case takes: 1e9 of them leave half of the digits.
constexpr double most_steps = 1e9;

/// Mass and momentum m (|u| + c) of a channel filled to the largest depth of the start, moving at the largest velocity.
/// What a run tells of its own may be twice as much: bores pile water up.
struct Fullest {
  double mass = 0;
  double momentum = 0;
};
Fullest fullest(const FlowProblem& problem) {
  constexpr int samples = 1000;
  Largest depth;
  Largest speed;
  for (int k = 0; k <= samples; ++k) {
    const State s = problem.exact(problem.start + problem.length() * k / samples, 0);
    depth.add(s.depth);
    speed.add(std::abs(s.velocity) + std::sqrt(problem.gravity * s.depth));
  }
  const double mass = problem.length() * depth.value();
  return {2 * mass, 2 * mass * speed.value()};
}

void draw_frame(evidence::Figure& figure, const FlowRun& flow, const FlowRun::Frame& frame) {
  const Profile& profile = frame.profile;
  const double from = std::min(flow.problem.start, profile.edges.front());
  const double to = std::max(flow.problem.end, profile.edges.back());
  const ExactCurve exact = exact_curve(flow.problem, from, to, frame.time);
  const Means means = means_of(profile);
  const std::string title = fmt::format("t = {:g} s, step {}", frame.time, frame.steps);
  auto& depth = figure.panel({.x = "x [m]", .y = "depth h [m]", .title = title});
  depth.line("exact", exact.x, exact.depth, Role::exact);
  depth.steps(fmt::format("{}, {} particles", flow.discretisation.scheme, means.depth.size()), profile.edges,
              means.depth, Role::computed);
  auto& velocity = figure.panel({.x = "x [m]", .y = "velocity u [m/s]", .title = title});
  velocity.line("exact", exact.x, exact.velocity, Role::exact);
  velocity.points(flow.discretisation.scheme, means.centre, means.velocity, Role::computed);
}

}  // namespace

FlowRun compute_flow(const FlowProblem& problem, const Discretisation& discretisation, const std::vector<double>& times,
                     const std::function<void(double)>& progress) {
  const std::unique_ptr<Flow> flow = make_flow(problem, discretisation);
  FlowRun run{.problem = problem, .discretisation = discretisation};
  for (const double time : times) {
    flow->advance_to(time, [&](double t) { progress(t / times.back()); });
    run.frames.push_back({time, flow->steps(), flow->profile()});
  }
  const Profile& profile = run.profile();
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    run.mass += profile.means[i].depth * (profile.edges[i + 1] - profile.edges[i]);
  }
  run.errors = profile_errors(profile, problem, flow->time());
  run.mass_defect = flow->mass_defect();
  run.momentum_defect = flow->momentum_defect();
  run.momentum_scale = flow->momentum_scale();
  run.max_courant = flow->max_courant();
  return run;
}

void claim_conservation(Claims<FlowRun> claims, const FlowProblem& problem, const std::string& suffix) {
  const Fullest most = fullest(problem);
  const auto told = [](const FlowRun& flow, double value, double scale) -> Measurement {
    const auto steps = static_cast<double>(std::max(1L, flow.steps()));
    return {.value = value, .resolution = flow.discretisation.text(), .told = {.operations = steps, .scale = scale}};
  };
  claims.check(
      {.id = "mass" + suffix,
       .text = "Mass changes only by what passes the ends.",
       .quantity = "mass less the mass booked at the ends",
       .unit = "m^2",
       .source = "conservation law of mass"},
      [told](const FlowRun& flow) { return told(flow, flow.mass_defect, flow.mass); },
      Roundoff{.operations = Amount::told_by_run(most_steps),
               .scale = Amount::told_by_run(most.mass),
               .reason = "one rounded update per cell and step, of the size of all the water"});
  claims.check(
      {.id = "momentum" + suffix,
       .text = "Momentum changes only by the impulses at the ends.",
       .quantity = "momentum less the impulses booked at the ends",
       .unit = "m^3/s",
       .source = "conservation law of momentum"},
      [told](const FlowRun& flow) { return told(flow, flow.momentum_defect, flow.momentum_scale); },
      Roundoff{.operations = Amount::told_by_run(most_steps),
               .scale = Amount::told_by_run(most.momentum),
               .reason = "one rounded update per cell and step; scale is the sum of m (|u| + c)"});
}

void claim_single_particle(Claims<FlowRun> claims, const Front& front) {
  claims.check(
      {.id = "width",
       .text = "The jump lies inside a single particle.",
       .quantity = "particles between 5 % and 95 % of the jump",
       .source = "the hand-over of section 3 of the paper"},
      [front](const FlowRun& flow) -> Measurement {
        return {.value = static_cast<double>(front_width(flow.profile(), front)),
                .resolution = flow.discretisation.text()};
      },
      evidence::Bound{.limit = 1, .reason = "one particle holds the jump; none at the instant of hand-over"});
}

void claim_exact_profile(Claims<FlowRun> claims, double deepest, long steps) {
  claims.check(
      {.id = "reconstructed_l1_h",
       .text = "The method's profile is the exact one.",
       .quantity = "reconstructed L1(h)",
       .unit = "m",
       .source = "jump conditions (11) of the paper"},
      [](const FlowRun& flow) -> Measurement {
        return {.value = flow.errors.reconstructed.depth.l1, .resolution = flow.discretisation.text()};
      },
      Roundoff{.operations = 8.0 * static_cast<double>(steps),
               .scale = deepest,
               .reason = "about eight rounded operations per edge and step, on depths of this size"});
}

void show_conservation(const FlowRun& flow, evidence::Exhibit& exhibit, const std::string& suffix) {
  exhibit.measure("mass_defect" + suffix, flow.mass_defect);
  exhibit.measure("momentum_defect" + suffix, flow.momentum_defect);
  exhibit.measure("max_courant" + suffix, flow.max_courant);
}

void show_errors(const ProfileErrors& e, evidence::Exhibit& exhibit, const std::string& suffix) {
  exhibit.measure("cell_l1_h" + suffix, e.cell.depth.l1);
  exhibit.measure("cell_l1_u" + suffix, e.cell.velocity.l1);
  exhibit.measure("reconstructed_l1_h" + suffix, e.reconstructed.depth.l1);
  exhibit.measure("reconstructed_l1_u" + suffix, e.reconstructed.velocity.l1);
  exhibit.measure("constant_l1_h" + suffix, e.constant.depth.l1);
  exhibit.measure("constant_l1_u" + suffix, e.constant.velocity.l1);
  exhibit.measure("constant_l2_h" + suffix, e.constant.depth.l2);
  exhibit.measure("constant_max_h" + suffix, e.constant.depth.linf);
}

void draw_flow(const FlowRun& flow, evidence::Exhibit& exhibit, const std::string& title,
               const std::vector<std::string>& atlas) {
  auto& figure = exhibit.figure(
      "profiles", title,
      "The exact solution, the particles as rectangles of their mean depth, and as dots at their velocity.", atlas);
  for (const FlowRun::Frame& frame : flow.frames) {
    draw_frame(figure, flow, frame);
    const ExactCurve curve = computed_curve(frame.profile);
    exhibit.snapshot({.time = frame.time,
                      .x = curve.x,
                      .z = curve.depth,
                      .fields = {{"depth", "m", curve.depth}, {"velocity", "m/s", curve.velocity}}});
  }
}

}  // namespace seiche::validation
