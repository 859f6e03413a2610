#include "validation/studies/shallow_water/flow_run.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace seiche::validation {
namespace {

/// What an exact solution reaches from its start to `time`.
struct Extent {
  Largest depth;
  Smallest shallowest;  ///< at the start, where there is water
  Largest speed;        ///< |u| + c
};

Extent extent_of(const FlowProblem& problem, double time) {
  constexpr int samples = 1000;
  Extent extent;
  for (const double t : {0.0, 0.5 * time, time}) {
    for (int k = 0; k <= samples; ++k) {
      const State s = problem.exact(problem.start + problem.length() * k / samples, t);
      extent.depth.add(s.depth);
      if (s.depth == 0) continue;
      if (t == 0) extent.shallowest.add(s.depth);
      extent.speed.add(std::abs(s.velocity) + shallow_water::celerity(problem.gravity, s.depth));
    }
  }
  return extent;
}

std::string resolution_of(const FlowRun& flow) {
  return flow.discretisation.text();
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

Parameter rearrangement() {
  return choice("rearrangement", {as_written, "hand_over", "hand_over"}, {as_written, "hand_over"},
                "of particles: as written by the authors beside the hand-over, or the hand-over alone");
}

FlowRun compute_as_written(const Values& values, const FlowProblem& problem, const Discretisation& discretisation,
                           const std::vector<double>& times) {
  if (values.text("rearrangement") != as_written) return {};
  Discretisation d = discretisation;
  d.scheme = as_written;
  return compute_flow(problem, d, times, [](double) {});
}

double most_steps(const FlowProblem& problem, const Discretisation& d, double time) {
  constexpr double times_shown = 10;  // each cuts a step short
  if (d.time_step > 0) return time / d.time_step + times_shown;
  // By the Courant number, with particles squeezed from the shallowest to the largest depth from the start, and four
  // times as many for jumps that need shorter steps.
  const Extent extent = extent_of(problem, time);
  const double squeezed = extent.depth.value() / extent.shallowest.value();
  const double width = problem.length() / static_cast<double>(d.particles);
  return 4 * squeezed * extent.speed.value() * time / (d.courant * width) + times_shown;
}

void claim_conservation(const Claims<FlowRun>& claims, const FlowProblem& problem, const Discretisation& discretisation,
                        double time, const std::string& suffix) {
  // A scheme may overshoot the exact depths and velocities, not twice them.
  const Extent extent = extent_of(problem, time);
  const auto count = static_cast<double>(discretisation.particles);
  const double mass = 2 * extent.depth.value() * problem.length() / count;
  const double momentum = mass * 2 * extent.speed.value();
  const auto operations = [](double particles, double steps) { return particles * (steps + 2 * particles); };
  const auto told = [operations](const FlowRun& flow, double value, double total) -> Measurement {
    const auto particles = static_cast<double>(flow.profile().means.size());
    return {
        .value = value,
        .resolution = flow.discretisation.text(),
        .told = {.operations = operations(particles, static_cast<double>(flow.steps())), .scale = total / particles}};
  };
  const std::string by = suffix.empty() ? "" : " by the rearrangement as written";
  const Amount most_operations = Amount::told_by_run(operations(count, most_steps(problem, discretisation, time)));
  claims.from("conservation law of mass")
      .check(
          "mass" + suffix, fmt::format("The mass change equals the recorded inflow minus outflow to round-off{}.", by),
          "mass minus the recorded mass through the ends [m^2]",
          [told](const FlowRun& flow) { return told(flow, flow.mass_defect, flow.mass); },
          Roundoff{.operations = most_operations,
                   .scale = Amount::told_by_run(mass),
                   .reason = "one rounded update per particle and step, of the size of one particle's mass m; two sums "
                             "over N particles, of the size N m, count as N^2 such operations each"});
  claims.from("conservation law of momentum")
      .check(
          "momentum" + suffix,
          fmt::format("The momentum change equals the recorded impulses at the ends to round-off{}.", by),
          "momentum minus the recorded impulses at the ends [m^3/s]",
          [told](const FlowRun& flow) { return told(flow, flow.momentum_defect, flow.momentum_scale); },
          Roundoff{.operations = most_operations,
                   .scale = Amount::told_by_run(momentum),
                   .reason = "one rounded update per particle and step, of the size of m (|u| + c) of one particle; "
                             "two sums over N particles, N times that size, count as N^2 such operations each"});
}

void claim_as_written(const Claims<FlowRun>& all, const Values& values, const std::string& tile,
                      const FlowProblem& problem, const Discretisation& discretisation, double time, double range,
                      const Front* front, const std::map<std::string, double>& misses) {
  Discretisation d = discretisation;
  d.scheme = as_written;
  const auto claims = all.only_if(values.text("rearrangement") == as_written, "of the rearrangement as written")
                          .from("section 3 of the paper")
                          .at(d.text());
  claim_conservation(claims, problem, d, time, "_as_written");
  const auto check = [&](const std::string& id, const std::string& text, const std::string& quantity, auto measure,
                         const Bound& bound) {
    const auto published = claims.only_if(values.as_published(tile), "of the particles and steps of the figure");
    const bool known = misses.contains(id);
    const double missed = known ? misses.at(id) : 0;
    published
        .fails(
            {.value = missed,
             .width = 0.01 * std::abs(missed),
             .reason =
                 "the text leaves the pressure at a shared side and equal densities open; in this interpretation the "
                 "states beside a discontinuity deviate from the jump conditions by up to 5 %, and so does its speed"},
            known)
        .check(id + "_as_written", text, quantity, measure, bound);
  };
  check(
      "cell_l1_h",
      "The mean error of depths by the rearrangement as written is below the error of the exact profile moved by one "
      "particle width.",
      "cell L1(h) [m]", [](const FlowRun& flow) { return flow.errors.cell.depth.l1; },
      Bound{.limit = range / static_cast<double>(d.particles),
            .reason = "a profile moved by the width of one of N particles differs by the range of depths over N in the "
                      "mean"});
  if (front == nullptr) return;
  check(
      "front", "The position of the discontinuity by the rearrangement as written is exact within one particle width.",
      "position of the discontinuity minus the exact position [m]",
      [front = *front](const FlowRun& flow) { return front_position(flow.profile(), front) - front.position; },
      Bound{.limit = problem.length() / static_cast<double>(d.particles),
            .reason = "the initial particle width: one particle contains the discontinuity"});
  check(
      "width", "The width of the discontinuity by the rearrangement as written is one particle.",
      "particles between 5 % and 95 % of the depth difference",
      [front = *front](const FlowRun& flow) { return front_width(flow.profile(), front); },
      Bound{.limit = 1, .reason = "the paper hands the jump from one particle to the next"});
}

void claim_single_particle(const Claims<FlowRun>& claims, const Front& front) {
  const auto about = claims.at(resolution_of).from("the hand-over of section 3 of the paper");
  about.check(
      "width", "The width of the bore is a single particle.", "particles between 5 % and 95 % of the depth difference",
      [front](const FlowRun& flow) { return front_width(flow.profile(), front); },
      Bound{.limit = 1, .reason = "one particle holds the bore; none at the instant of hand-over"});
}

void claim_exact_profile(const Claims<FlowRun>& claims, double deepest, const Discretisation& discretisation,
                         double time) {
  const auto about = claims.at(resolution_of).from("jump conditions (11) of the paper");
  about.check(
      "reconstructed_l1_h", "The reconstructed profile equals the exact solution to round-off.",
      "reconstructed L1(h) [m]", [](const FlowRun& flow) { return flow.errors.reconstructed.depth.l1; },
      Roundoff{
          .operations = 8 * std::round(time / discretisation.time_step) * static_cast<double>(discretisation.particles),
          .scale = deepest,
          .reason = "eight rounded operations per step, and per particle that the jump has passed"});
}

void claim_range(const Claims<FlowRun>& claims, double lowest, double highest, const Discretisation& discretisation,
                 double time, const std::string& source) {
  const auto about = claims.at(resolution_of).from(source);
  about.check(
      "range", "Depths stay within the range of the exact solution to round-off.",
      "largest depth outside the range [m]",
      [lowest, highest](const FlowRun& flow) { return excursion(flow.profile(), lowest, highest); },
      // Depth is mass over width: the rounding of two edges of the size of the channel counts N times.
      Roundoff{.operations = std::round(time / discretisation.time_step),
               .scale = highest * static_cast<double>(discretisation.particles),
               .reason = "edges as large as the channel are rounded once per step, and a width is their difference, N "
                         "times smaller"});
}

void draw_exact(evidence::Figure& figure, const FlowProblem& problem, double time, const std::string& title) {
  const ProfileCurve curve = exact_curve(problem, problem.start, problem.end, time);
  figure.panel({.x = "x [m]", .y = "depth h [m]", .title = title}).line("exact", curve.x, curve.depth, Role::exact);
  figure.panel({.x = "x [m]", .y = "velocity u [m/s]", .title = title})
      .line("exact", curve.x, curve.velocity, Role::exact);
}

void draw_frame(evidence::Figure& figure, evidence::Exhibit& exhibit, const FlowRun& flow, const FlowRun::Frame& frame,
                const std::string& title, const FlowRun::Frame* beside) {
  const ProfileCurve exact = exact_curve(flow.problem, frame.profile, frame.time);
  const ProfileCurve means = means_of(frame.profile);
  const ProfileCurve others = beside != nullptr ? means_of(beside->profile) : ProfileCurve{};
  auto& depth = figure.panel({.x = "x [m]", .y = "depth h [m]", .title = title});
  depth.line("exact", exact.x, exact.depth, Role::exact);
  if (beside != nullptr) depth.steps("hand-over", beside->profile.edges, others.depth, Role::peer);
  depth.steps(fmt::format("{}, {} particles", flow.discretisation.scheme, means.depth.size()), frame.profile.edges,
              means.depth, Role::computed);
  auto& velocity = figure.panel({.x = "x [m]", .y = "velocity u [m/s]", .title = title});
  velocity.line("exact", exact.x, exact.velocity, Role::exact);
  if (beside != nullptr) velocity.points("hand-over", others.x, others.velocity, Role::peer);
  velocity.points(flow.discretisation.scheme, means.x, means.velocity, Role::computed);
  const ProfileCurve curve = computed_curve(frame.profile);
  exhibit.snapshot({.time = frame.time,
                    .x = curve.x,
                    .z = curve.depth,
                    .unit = "m",
                    .fields = {{"depth", "m", curve.depth}, {"velocity", "m/s", curve.velocity}}});
}

void draw_flow(const FlowRun& flow, evidence::Exhibit& exhibit, const std::string& title,
               const std::vector<std::string>& atlas, const FlowRun& literal) {
  const bool both = !literal.frames.empty();
  auto& figure = exhibit.figure(
      "profiles", title,
      "The exact solution, the particles as rectangles of their mean depth, and as dots at their velocity.", atlas);
  for (std::size_t k = 0; k < flow.frames.size(); ++k) {
    const FlowRun& drawn = both ? literal : flow;
    draw_frame(figure, exhibit, drawn, drawn.frames[k],
               fmt::format("t = {:g} s, step {}", drawn.frames[k].time, drawn.frames[k].steps),
               both ? &flow.frames[k] : nullptr);
  }
}

ParticleFigure compute_figure(const Run& run, const FlowProblem& problem, const Discretisation& discretisation,
                              const std::vector<double>& times, const Front& front,
                              const std::vector<std::string>& schemes) {
  return {.flow = compute_flow(problem, discretisation, times, [&](double done) { run.progress(0.5 * done); }),
          .as_written = compute_as_written(run, problem, discretisation, times),
          .front = front,
          .contestants = contest_all(problem, discretisation, schemes, times.back(), &front,
                                     [&](double done) { run.progress(0.5 + 0.5 * done); })};
}

void show_figure(const ParticleFigure& figure, evidence::Exhibit& exhibit, const std::string& title,
                 const std::vector<std::string>& atlas) {
  draw_flow(figure.flow, exhibit, title, atlas, figure.as_written);
  report_contest(exhibit, figure.flow.problem, figure.flow.time(), figure.contestants);
  exhibit.measure("max_courant", figure.flow.max_courant);
}

}  // namespace seiche::validation
