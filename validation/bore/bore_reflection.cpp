/*
A bore runs into still water and is reflected by a wall. Behind the reflected bore the water is at rest, of depth $h_2$,

$$u_1 = (h_2 - h_1)\sqrt{\frac{g}{2}\,\frac{h_2 + h_1}{h_1 h_2}}, \qquad a_- = -\frac{u_1 h_1}{h_2 - h_1}.$$

Bogomolov, Zakharov and Zerkal take $h_1 = 1$ m and $u_1 = 1.3$ m/s, ten particles, $\tau = 0.02$ s and a wall at $x =
10$ m (their figures 13 to 15). The still depth $h_0 = 0.6343$ m follows from $u_1$; they print 0.63. They do not state
the initial position of the bore; here it is 5 m. They report a computed wall depth of **1.36 m, compared with 1.45 m
from the jump conditions**.

**What is compared.** Wall depth and reconstructed profile after the reflection; the other variants of the method and
the comparison schemes; the paper's two printed depths, the computed one by the rearrangement as written.

**Your solver.** The profile at `time` is scored as in `riemann`; at the other end water enters in the state behind the
incident bore.

**What to look at.** With the hand-over of both incident and reflected bore, ten particles give 1.45167616 m to all
printed digits. By the rearrangement as written (see `moving_bore`) the wall depth fluctuates, and 1.36 m is one of its
values.
*/
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/scoring/score.hpp"
#include "validation/studies/shallow_water/bore_depths.hpp"
#include "validation/studies/shallow_water/judged_states.hpp"

namespace seiche::validation::cases::bore_reflection {

/// The reflection at a right wall, or its mirror image at a left one.
struct Mirrored {
  exact::BoreReflection reflection;
  double start, end;
  bool left_wall;

  [[nodiscard]] double mirrored(double x) const { return left_wall ? start + end - x : x; }
  [[nodiscard]] State at(double x, double t) const {
    State s = reflection.at(std::min(mirrored(x), end), t);
    if (left_wall) s.velocity = -s.velocity;
    return s;
  }
  [[nodiscard]] std::vector<double> breakpoints(double t) const { return {mirrored(reflection.position(t))}; }
  /// The two states of a time, and where and since when they are beside each other.
  [[nodiscard]] JudgedStates states(double t) const {
    const exact::Bore& incident = reflection.incident();
    const double meeting = reflection.reflection_time();
    const bool reflected = t > meeting;
    State before = incident.behind();
    const State after = reflected ? State{reflection.reflected_depth(), 0} : incident.ahead();
    const double place = mirrored(reflected ? end : incident.position(0));
    if (left_wall) before.velocity = -before.velocity;
    const exact::Riemann solution(incident.gravity(), left_wall ? after : before, left_wall ? before : after, place);
    return {.solution = solution, .since = reflected ? t - meeting : t, .start = start, .end = end};
  }
};

/// h0 of the paper, from its u1 = 1.3 m/s and h1 = 1 m with g = 9.81 m/s^2 by the jump conditions. All digits count:
/// with eight of them the velocity would be right to 3e-9 only.
constexpr double published_still_depth = 0.6343140641800991;

Mirrored solution_of(const Values& values) {
  const double gravity = values.real("gravity");
  const double start = values.real("start");
  const double end = values.real("end");
  const double jump = values.real("jump");
  if (!(start < jump && jump < end)) {
    throw std::invalid_argument(fmt::format("jump = {:g} is out of range: must be in ({:g}, {:g})", jump, start, end));
  }
  const bool left = values.text("wall") == "left";
  const double mirrored_jump = left ? start + end - jump : jump;
  require_bore(values, "front_depth", "still_depth");
  const exact::Bore incident(gravity, values.real("still_depth"), values.real("front_depth"), 0, mirrored_jump);
  return {exact::BoreReflection(incident, end), start, end, left};
}

/// What the parameters decide.
struct SetUp {
  Mirrored solution;
  FlowProblem problem;
  Discretisation discretisation;
  double time;
  Front front;

  [[nodiscard]] const exact::BoreReflection& reflection() const { return solution.reflection; }
  /// Cells of a tenth of the particles' length: ten hold no profile that could be judged.
  [[nodiscard]] JudgedStates states() const {
    JudgedStates states = solution.states(time);
    states.cells = 10 * discretisation.particles;
    return states;
  }
  [[nodiscard]] bool reflected() const { return time > reflection().reflection_time(); }
  /// When the reflected jump has left the particle at the wall.
  [[nodiscard]] double since_the_wall_is_left() const {
    return reflection().reflection_time() +
           problem.length() / static_cast<double>(discretisation.particles) / -reflection().reflected_speed();
  }
};

SetUp set_up(const Values& values) {
  const Mirrored solution = solution_of(values);
  const exact::BoreReflection& reflection = solution.reflection;
  using End = FlowProblem::End;
  const FlowProblem problem =
      problem_of(solution, values.real("gravity"), solution.start, solution.end, {values.real("jump")},
                 solution.left_wall ? End::wall : End::stream, solution.left_wall ? End::stream : End::wall);
  const double time = values.real("time");
  const bool reflected = time > reflection.reflection_time();
  const State& incoming = reflection.incident().behind();
  return {.solution = solution,
          .problem = problem,
          .discretisation = {.scheme = "H2",
                             .particles = values.integer("particles"),
                             .time_step = values.real("time_step"),
                             .theta = 1.5},
          .time = time,
          .front = {.behind = reflected ? reflection.reflected_depth() : incoming.depth,
                    .ahead = reflected ? incoming.depth : reflection.incident().ahead().depth,
                    .position = problem.breakpoints(time)[0],
                    .reach = problem.length()}};
}

struct Results {
  SetUp set_up;
  ParticleFigure figure;
  std::vector<double> time, wall;  ///< of every step by the rearrangement as written, and the depth at the wall

  [[nodiscard]] double wall_depth(const Profile& profile) const {
    return set_up.solution.left_wall ? profile.means.front().depth : profile.means.back().depth;
  }
};

void draw_sketches(evidence::Exhibit& exhibit, const FlowProblem& problem, const Mirrored& solution) {
  const auto& bore = solution.reflection.incident();
  const double h1 = bore.behind().depth;
  auto& panel =
      add_panel(exhibit, "setup", "Reflection of a bore: initial state", "The bore before it reaches the wall.",
                {.x = "x [m]", .y = "elevation [m]", .y_min = -0.1, .y_max = 1.6 * h1}, {"bzz-fig-13"});
  const ProfileCurve before = exact_curve(problem, problem.start, problem.end, 0);
  panel.fill("water", before.x, before.depth, Role::water);
  const double wall = solution.left_wall ? problem.start : problem.end;
  panel.line("wall", std::vector<double>{wall, wall}, std::vector<double>{0, 1.5 * h1}, Role::bed);

  const double meeting = solution.reflection.reflection_time();
  auto& figure = exhibit.figure("exact", "Exact reflected bore",
                                "Depth and velocity before and after the bore reaches the wall.", {"bzz-fig-14"});
  for (const double t : {0.5 * meeting, 1.6 * meeting}) {
    draw_exact(figure, problem, t, fmt::format("t = {:.3g} s", t));
  }
}

void claims(const Values& values, const Claims<Results>& claims) {
  const SetUp s = set_up(values);
  const auto figure = claims.of(&Results::figure);
  const auto flow = figure.of(&ParticleFigure::flow);
  claim_conservation(flow, s.problem, s.discretisation, s.time);
  const double reflected_depth = s.reflection().reflected_depth();
  const auto here = claims.at(s.discretisation.text());
  here.only_if(s.reflected(), "the bore has not reached the wall")
      .from("jump conditions (11) of the paper")
      .check(
          "wall_depth", "The depth at the wall agrees with the jump conditions.", "depth at the wall [m]",
          [](const Results& r) { return r.wall_depth(r.figure.flow.profile()); },
          Roundoff{.operations = 8 * std::round(s.time / s.discretisation.time_step) *
                                 static_cast<double>(s.discretisation.particles),
                   .scale = reflected_depth,
                   .reason = "eight rounded operations per step, and per particle that the jump has passed",
                   .expected = reflected_depth});
  claim_exact_profile(flow, reflected_depth, s.discretisation, s.time);
  claim_as_written(figure.of(&ParticleFigure::as_written), values, "bzz-fig-15", s.problem, s.discretisation, s.time,
                   reflected_depth - s.reflection().incident().ahead().depth, &s.front, {{"width", 3}});
  claim_states(flow.at(s.discretisation.text()), s.states(),
               s.problem.length() / static_cast<double>(s.discretisation.particles));

  const io::Table printed = values.table("bogomolov_zakharov_zerkal");
  const auto published =
      claims.only_if(values.as_published("bzz-fig-15"), "the paper prints it for its own parameters");
  using Reflection = exact::BoreReflection;
  const auto follows = [&](const std::string& id, const std::string& quantity, const std::string& column, auto number) {
    const double value = printed.column(column)[0];
    published.check(
        id, fmt::format("The {} that the paper prints, {:g}, follows from the jump conditions.", quantity, value),
        quantity + " [" + printed.unit(column) + "]",
        [number](const Results& r) { return std::invoke(number, r.set_up.reflection()); },
        Bound{.limit = column == "incident_velocity" ? 0.05 : 0.005,
              .reason = "half a unit of the last printed digit",
              .expected = value});
  };
  follows("printed-exact", "reflected depth", "reflected_depth_exact", &Reflection::reflected_depth);
  follows("printed-speed", "reflected speed", "reflected_speed", &Reflection::reflected_speed);
  follows("printed-velocity", "velocity behind the incident bore", "incident_velocity",
          [](const Reflection& r) { return r.incident().behind_velocity(); });
  follows("printed-incident-speed", "speed of the incident bore", "incident_speed",
          [](const Reflection& r) { return r.incident().speed(); });
  follows("printed-still-depth", "depth of the still water", "incident_still_depth",
          [](const Reflection& r) { return r.incident().ahead().depth; });
  const double computed = printed.column("reflected_depth_computed")[0];
  published.check(
      "printed-computed",
      "The paper's computed wall depth of 1.36 m is a value of the rearrangement as written after the reflection.",
      "wall depth nearest to 1.36 m [m]",
      [computed, since = s.since_the_wall_is_left()](const Results& r) {
        Smallest nearest;
        for (std::size_t k = 0; k < r.time.size(); ++k) {
          if (r.time[k] > since) nearest.add(std::abs(r.wall[k] - computed), r.wall[k]);
        }
        return nearest.where();
      },
      Bound{.limit = 0.005, .reason = "half a unit of the last printed digit", .expected = computed});
}

Results compute(const Run& run) {
  Results r{.set_up = set_up(run)};
  const SetUp& s = r.set_up;
  const double meeting = s.reflection().reflection_time();
  const double tau = s.discretisation.time_step;
  const double before = tau * std::floor(0.9 * meeting / tau);
  const std::vector<double> times = s.reflected() ? std::vector{before, s.time} : std::vector{s.time};
  r.figure = compute_figure(run, s.problem, s.discretisation, times, s.front);
  std::vector<double> steps;
  for (long k = 0; tau * static_cast<double>(k) < s.time; ++k) steps.push_back(tau * static_cast<double>(k));
  steps.push_back(s.time);
  const FlowRun every = compute_as_written(run, s.problem, s.discretisation, steps);
  for (const FlowRun::Frame& frame : every.frames) {
    r.time.push_back(frame.time);
    r.wall.push_back(r.wall_depth(frame.profile));
  }
  return r;
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  const SetUp& s = r.set_up;
  draw_sketches(exhibit, s.problem, s.solution);
  show_figure(r.figure, exhibit, "Bore before and after the reflection", {"bzz-fig-15"});
  if (!r.time.empty()) {
    auto& panel = add_panel(exhibit, "wall", "Depth at the wall by the rearrangement as written", "After every step.",
                            {.x = "t [s]", .y = "depth h [m]"});
    panel.line("as written", r.time, r.wall, Role::computed);
    panel.line("jump conditions", std::vector<double>{s.since_the_wall_is_left(), r.time.back()},
               std::vector<double>(2, s.reflection().reflected_depth()), Role::exact);
  }
  measure_own(wanted_states(s.states()), submitted_profile(r.figure.flow.profile()), exhibit);
}

void bore_reflection(Case& c) {
  c.title = "Reflection of a bore by a wall";
  c.source = literature::bogomolov + ", figures 13 to 15";
  c.parameters = {
      real("front_depth", 1.0, "m", {1e-3, 1e3}, "depth behind the incident bore"),
      real("still_depth", published_still_depth, "m", {1e-3, 1e3}, "depth of the still water ahead of it"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
      real("start", 0.0, "m", {-1e6, 1e6}, "left end of the channel"),
      real("end", 10.0, "m", {-1e6, 1e6}, "right end of the channel"),
      real("jump", 5.0, "m", {-1e6, 1e6}, "position of the bore at t = 0"),
      choice("wall", "right", {"left", "right"}, "the end where the wall is"),
      integer("particles", {10, 100, 1000}, {4, 1e6}, "particles of equal widths"),
      real("time_step", {0.02, 0.002, 0.0002}, "s", {1e-9, 10}, "time step"),
      real("time", 2.6, "s", {1e-6, 1e6}, "end of the run"),
      rearrangement(),
  };
  c.published = {{.tiles = {"bzz-fig-15", "bzz-fig-13", "bzz-fig-14"},
                  .stated = {"front_depth", "still_depth", "end", "wall", "particles", "time_step", "rearrangement"}}};
  c.study = Study(claims, compute, show, "section 5 of the paper");
  c.submission = submission_of([](const Values& values) { return set_up(values).states(); });
}

}  // namespace seiche::validation::cases::bore_reflection
