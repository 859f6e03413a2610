#include "validation/studies/shallow_water/flow_evidence.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace seiche::validation {

using evidence::Role;

namespace {

void draw_profile(evidence::Figure& figure, const FlowProblem& problem, const Flow& flow, const std::string& title) {
  const Profile profile = flow.profile();
  const double from = std::min(problem.start, profile.edges.front());
  const double to = std::max(problem.end, profile.edges.back());
  const ExactCurve exact = exact_curve(problem, from, to, flow.time());
  const Means means = means_of(profile);
  auto& depth = figure.panel({.x = "x [m]", .y = "depth h [m]", .title = title});
  depth.line("exact", exact.x, exact.depth, Role::exact);
  depth.steps(fmt::format("{}, {} particles", flow.discretisation().scheme, means.depth.size()), profile.edges,
              means.depth, Role::computed);
  auto& velocity = figure.panel({.x = "x [m]", .y = "velocity u [m/s]", .title = title});
  velocity.line("exact", exact.x, exact.velocity, Role::exact);
  velocity.points(flow.discretisation().scheme, means.centre, means.velocity, Role::computed);
}

void add_snapshot(evidence::Record& record, const Flow& flow) {
  const ExactCurve curve = computed_curve(flow.profile());
  record.snapshot({.time = flow.time(),
                   .x = curve.x,
                   .z = curve.depth,
                   .fields = {{"depth", "m", curve.depth}, {"velocity", "m/s", curve.velocity}}});
}

}  // namespace

void claim_conservation(evidence::Record& record, const Flow& flow, const std::string& suffix) {
  const auto steps = static_cast<double>(std::max(1L, flow.steps()));
  const double scale = flow.momentum_scale();
  const Profile profile = flow.profile();
  double mass = 0;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    mass += profile.means[i].depth * (profile.edges[i + 1] - profile.edges[i]);
  }
  record.measure("mass_defect" + suffix, flow.mass_defect());
  record.measure("momentum_defect" + suffix, flow.momentum_defect());
  record.measure("max_courant" + suffix, flow.max_courant());
  record.check({.id = "mass" + suffix,
                .text = "Mass changes only by what passes the ends.",
                .quantity = "mass less the mass booked at the ends",
                .unit = "m^2",
                .source = "conservation law of mass"},
               {.value = flow.mass_defect(), .resolution = flow.discretisation().text()},
               evidence::Roundoff{.operations = steps,
                                  .scale = mass,
                                  .reason = "one rounded update per cell and step, of the size of all the water"});
  record.check({.id = "momentum" + suffix,
                .text = "Momentum changes only by the impulses at the ends.",
                .quantity = "momentum less the impulses booked at the ends",
                .unit = "m^3/s",
                .source = "conservation law of momentum"},
               {.value = flow.momentum_defect(), .resolution = flow.discretisation().text()},
               evidence::Roundoff{.operations = steps,
                                  .scale = scale,
                                  .reason = "one rounded update per cell and step; scale is the sum of m (|u| + c)"});
}

void claim_single_particle(evidence::Record& record, const Flow& flow, const Front& front) {
  const auto width = front_width(flow.profile(), front);
  record.measure("front_width", width);
  record.check({.id = "width",
                .text = "The jump lies inside a single particle.",
                .quantity = "particles between 5 % and 95 % of the jump",
                .source = "the hand-over of section 3 of the paper"},
               {.value = width, .resolution = flow.discretisation().text()},
               evidence::Bound{.limit = 1, .reason = "one particle holds the jump; none at the instant of hand-over"});
}

void claim_exact_profile(evidence::Record& record, const Flow& flow, const FlowProblem& problem, double deepest) {
  const ProfileErrors errors = profile_errors(flow.profile(), problem, flow.time());
  show_errors(errors, record);
  record.check(
      {.id = "reconstructed_l1_h",
       .text = "The method's profile is the exact one.",
       .quantity = "reconstructed L1(h)",
       .unit = "m",
       .source = "jump conditions (11) of the paper"},
      {.value = errors.reconstructed.depth.l1, .resolution = flow.discretisation().text()},
      evidence::Roundoff{.operations = 8.0 * static_cast<double>(flow.steps()),
                         .scale = deepest,
                         .reason = "about eight rounded operations per edge and step, on depths of this size"});
}

std::unique_ptr<Flow> run_and_draw(evidence::Record& record, const FlowProblem& problem,
                                   const Discretisation& discretisation, const std::vector<double>& times,
                                   const std::string& title, const std::vector<std::string>& atlas,
                                   const std::function<void(double)>& progress) {
  std::unique_ptr<Flow> flow = make_flow(problem, discretisation);
  auto& figure =
      record.figure("profiles", title,
                    "The exact solution, the particles as rectangles of their mean depth, and as dots at their "
                    "velocity.",
                    atlas);
  for (const double time : times) {
    flow->advance_to(time, [&](double t) { progress(t / times.back()); });
    draw_profile(figure, problem, *flow, fmt::format("t = {:g} s, step {}", time, flow->steps()));
    add_snapshot(record, *flow);
  }
  return flow;
}

}  // namespace seiche::validation
