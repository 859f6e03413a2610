#include "validation/studies/shallow_water/flow_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "seiche/divergence.hpp"

namespace seiche::validation {

using evidence::Role;

ProfileErrors profile_errors(const Profile& profile, const FlowProblem& problem, double t) {
  namespace measures = shallow_water;
  const auto exact = [&](double x) { return problem.exact(x, t); };
  const std::vector<double> breaks = problem.breakpoints(t);
  return {.cell = measures::cell_error(profile, exact, breaks),
          .reconstructed = measures::reconstruction_error(profile, exact, breaks),
          .constant = measures::piecewise_constant_error(profile, exact, breaks)};
}

double excursion(const Profile& profile, double lowest, double highest) {
  double largest = 0;
  for (const State& mean : profile.means) largest = std::max({largest, mean.depth - highest, lowest - mean.depth});
  return largest;
}

long front_width(const Profile& profile, const Front& front) {
  return shallow_water::jump_width(profile, front.behind, front.ahead, front.position - front.reach,
                                   front.position + front.reach);
}

double front_position(const Profile& profile, const Front& front) {
  const double middle = 0.5 * (front.behind + front.ahead);
  double best = std::numeric_limits<double>::quiet_NaN();
  const auto consider = [&](double x) {
    if (std::abs(x - front.position) > front.reach) return;
    if (!(std::abs(x - front.position) >= std::abs(best - front.position))) best = x;
  };
  // A jump inside a cell is where the method says it is.
  for (const double x : profile.breaks) {
    const double hair = 1e-9 * front.reach;
    const double left = profile.reconstruction(x - hair).depth;
    const double right = profile.reconstruction(x + hair).depth;
    const bool inside = std::find(profile.edges.begin(), profile.edges.end(), x) == profile.edges.end();
    if (inside && (left - middle) * (right - middle) < 0) consider(x);
  }
  if (std::isfinite(best)) return best;
  // A captured jump is where the means cross the mid-depth.
  for (std::size_t i = 0; i + 1 < profile.means.size(); ++i) {
    const double a = profile.means[i].depth - middle;
    const double b = profile.means[i + 1].depth - middle;
    if (a * b > 0 || a == b) continue;
    const double left = 0.5 * (profile.edges[i] + profile.edges[i + 1]);
    const double right = 0.5 * (profile.edges[i + 1] + profile.edges[i + 2]);
    consider(left + (right - left) * a / (a - b));
  }
  return best;
}

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
  const auto width = static_cast<double>(front_width(flow.profile(), front));
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
  measure_errors(record, errors);
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

ExactCurve exact_curve(const FlowProblem& problem, double from, double to, double t) {
  constexpr int samples = 400;
  std::vector<double> x;
  for (int k = 0; k <= samples; ++k) x.push_back(from + (to - from) * k / samples);
  for (const double p : problem.breakpoints(t)) {
    if (p <= from || p >= to) continue;
    const double hair = 1e-9 * (to - from);
    x.insert(x.end(), {p - hair, p + hair});
  }
  std::sort(x.begin(), x.end());
  ExactCurve curve{.x = x, .depth = {}, .velocity = {}};
  for (const double at : x) {
    const State s = problem.exact(at, t);
    curve.depth.push_back(s.depth);
    curve.velocity.push_back(s.velocity);
  }
  return curve;
}

ExactCurve computed_curve(const Profile& profile) {
  ExactCurve curve;
  constexpr int samples = 4;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    std::vector<double> places;
    const double a = profile.edges[i];
    const double b = profile.edges[i + 1];
    const double hair = 1e-9 * (b - a);
    for (int k = 0; k <= samples; ++k) places.push_back(a + hair + (b - a - 2 * hair) * k / samples);
    for (const double p : profile.breaks) {
      if (p > a && p < b) places.insert(places.end(), {p - hair, p + hair});
    }
    std::sort(places.begin(), places.end());
    for (const double x : places) {
      const State s = profile.reconstruction(x);
      curve.x.push_back(x);
      curve.depth.push_back(s.depth);
      curve.velocity.push_back(s.velocity);
    }
  }
  return curve;
}

Means means_of(const Profile& profile) {
  Means means;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    means.centre.push_back(0.5 * (profile.edges[i] + profile.edges[i + 1]));
    means.depth.push_back(profile.means[i].depth);
    means.velocity.push_back(profile.means[i].velocity);
  }
  return means;
}

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

void claim_reproduced(evidence::Record& record, const std::string& id, const std::string& quantity,
                      const std::string& text, double measured, double stated, const std::string& unit,
                      const std::string& resolution) {
  record.check(
      {.id = id,
       .text = text,
       .quantity = quantity,
       .unit = unit,
       .source = "independent implementation of the method"},
      {.value = measured, .resolution = resolution},
      evidence::Bound{.limit = 0.1,
                      .reason = "an independent implementation of the same algorithm measured the expected value; "
                                "10 % covers different rounding of limiter decisions",
                      .expected = stated,
                      .relative = true});
}

Contestant contest(const FlowProblem& problem, const Discretisation& discretisation, double time, const Front* front) {
  Contestant c;
  c.scheme = discretisation.scheme;
  c.front_error = std::numeric_limits<double>::quiet_NaN();
  try {
    const std::unique_ptr<Flow> flow = make_flow(problem, discretisation);
    flow->advance_to(time);
    c.profile = flow->profile();
    c.seconds = flow->seconds();
  } catch (const Divergence& breakdown) {
    c.failure = breakdown.what();
    return c;
  }
  c.errors = profile_errors(c.profile, problem, time);
  if (front != nullptr) {
    c.front_error = front_position(c.profile, *front) - front->position;
    c.width = front_width(c.profile, *front);
  }
  return c;
}

std::vector<Contestant> contest_all(const FlowProblem& problem, const Discretisation& discretisation,
                                    const std::vector<std::string>& schemes, double time, const Front* front,
                                    const std::function<void(double)>& progress) {
  std::vector<Contestant> contestants;
  for (const std::string& scheme : schemes) {
    Discretisation d = discretisation;
    d.scheme = scheme;
    contestants.push_back(contest(problem, d, time, front));
    if (progress) progress(static_cast<double>(contestants.size()) / static_cast<double>(schemes.size()));
  }
  return contestants;
}

void report_contest(evidence::Exhibit& record, const FlowProblem& problem, double time,
                    const std::vector<Contestant>& contestants, const std::vector<std::string>& atlas) {
  evidence::Table table{
      .id = "schemes",
      .title = "The schemes side by side",
      .caption = fmt::format("Errors at t = {:g} s, means over the water: of cell means, of the method's own "
                             "reconstruction, of the piecewise constant picture. The width of the jump "
                             "counts cells between 5 % and 95 % of it.",
                             time),
      .columns = {{"scheme", ""},
                  {"cell L1(h)", "m"},
                  {"reconstructed L1(h)", "m"},
                  {"constant L1(h)", "m"},
                  {"constant L2(h)", "m"},
                  {"constant max(h)", "m"},
                  {"cell L1(u)", "m/s"},
                  {"width", "cells"},
                  {"front error", "m"}},
      .rows = {},
      .atlas = {}};
  auto& figure = record.figure("schemes", "The schemes side by side",
                               fmt::format("Depth at t = {:g} s by each scheme at the same resolution.", time), atlas);
  for (const Contestant& c : contestants) {
    if (!c.failure.empty()) {
      table.rows.push_back({c.scheme, c.failure, "", "", "", "", "", "", ""});
      continue;
    }
    table.rows.push_back({c.scheme, c.errors.cell.depth.l1, c.errors.reconstructed.depth.l1, c.errors.constant.depth.l1,
                          c.errors.constant.depth.l2, c.errors.constant.depth.linf, c.errors.cell.velocity.l1,
                          static_cast<double>(c.width), c.front_error});
    measure_errors(record, c.errors, "_" + c.scheme);
    record.measure("front_error_" + c.scheme, c.front_error);
    record.measure("width_" + c.scheme, static_cast<double>(c.width));
    const double from = std::min(problem.start, c.profile.edges.front());
    const double to = std::max(problem.end, c.profile.edges.back());
    const ExactCurve exact = exact_curve(problem, from, to, time);
    auto& panel = figure.panel({.x = "x [m]", .y = "depth h [m]", .title = c.scheme});
    panel.line("exact", exact.x, exact.depth, Role::exact);
    const bool particles =
        std::find(particle_schemes.begin(), particle_schemes.end(), c.scheme) != particle_schemes.end();
    panel.steps(particles ? "particles" : "cells", c.profile.edges, means_of(c.profile).depth,
                particles ? Role::computed : Role::peer);
  }
  record.table(std::move(table));
}

void measure_errors(evidence::Exhibit& record, const ProfileErrors& e, const std::string& suffix) {
  record.measure("cell_l1_h" + suffix, e.cell.depth.l1);
  record.measure("cell_l1_u" + suffix, e.cell.velocity.l1);
  record.measure("reconstructed_l1_h" + suffix, e.reconstructed.depth.l1);
  record.measure("reconstructed_l1_u" + suffix, e.reconstructed.velocity.l1);
  record.measure("constant_l1_h" + suffix, e.constant.depth.l1);
  record.measure("constant_l1_u" + suffix, e.constant.velocity.l1);
  record.measure("constant_l2_h" + suffix, e.constant.depth.l2);
  record.measure("constant_max_h" + suffix, e.constant.depth.linf);
}

void add_snapshot(evidence::Record& record, const Flow& flow) {
  const ExactCurve curve = computed_curve(flow.profile());
  record.snapshot({.time = flow.time(),
                   .x = curve.x,
                   .z = curve.depth,
                   .fields = {{"depth", "m", curve.depth}, {"velocity", "m/s", curve.velocity}}});
}

}  // namespace seiche::validation
