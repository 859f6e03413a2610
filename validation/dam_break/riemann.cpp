/*
Two uniform states meet at `jump` at $t = 0$ on a flat bed: the Riemann problem of the shallow-water equations,

$$h_t + (h u)_x = 0, \qquad (h u)_t + \left(h u^2 + g h^2/2\right)_x = 0.$$

Every pair of depths and velocities may be set, a dry side is depth 0. The exact solution consists of a wave to the
left, a uniform middle and a wave to the right; each wave is a fan or a jump.

This is the case for trying a scheme out, ours (`G1`, `M2`, `H2`: the conservative particle method of Bogomolov,
Zakharov and Zerkal at its three levels; `lax_friedrichs`, `maccormack`, `roe`, `muscl`) or your own (`seiche score
riemann`).

**What is compared.** Cell means, the method's own reconstruction, and the front, all with the exact solution at the
same time. What passes the ends is booked, so that mass and momentum must balance to round-off whatever the resolution.

**What to look at.** The bore: in level `H2` it lies inside a single particle. The corners of the fan are where every
scheme loses its order.
*/
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/riemann.hpp"
#include "validation/case/case.hpp"
#include "validation/case/score.hpp"
#include "validation/studies/shallow_water/flow_run.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;

exact::Riemann solution_of(const Values& values) {
  return {values.real("gravity"),
          {values.real("left_depth"), values.real("left_velocity")},
          {values.real("right_depth"), values.real("right_velocity")},
          values.real("jump")};
}

FlowProblem problem_from(const Values& values) {
  const double start = values.real("start");
  const double end = values.real("end");
  const double jump = values.real("jump");
  if (!(start < end))
    throw std::invalid_argument(fmt::format("end = {:g} is out of range: must exceed start = {:g}", end, start));
  if (!(jump > start && jump < end)) {
    throw std::invalid_argument(fmt::format("jump = {:g} is out of range: must be in ({:g}, {:g})", jump, start, end));
  }
  const auto end_kind = [&](const char* side) {
    return values.real(std::string(side) + "_depth") == 0 ? FlowProblem::End::dry : FlowProblem::End::stream;
  };
  const exact::Riemann solution = solution_of(values);
  return problem_of(solution, solution.gravity(), start, end, {jump}, end_kind("left"), end_kind("right"));
}

/// The front that is judged: the right wave if it is a jump, else the left one if it is, else the dry front or the head
/// of the right fan.
struct Judged {
  Front front;
  bool is_jump = false;
};

Judged judged_front(const exact::Riemann& solution, double time) {
  const double middle = solution.star().depth;
  const auto place = [&](double speed) { return solution.jump() + speed * time; };
  // Half way from the jump to the nearest other wave.
  const double reach = 0.5 * time * (solution.right_wave().slowest - solution.left_wave().fastest);
  using Kind = exact::Riemann::Kind;
  if (solution.right_wave().kind == Kind::jump) {
    return {{middle, solution.right().depth, place(solution.right_wave().fastest), reach}, true};
  }
  if (solution.left_wave().kind == Kind::jump) {
    return {{middle, solution.left().depth, place(solution.left_wave().slowest), reach}, true};
  }
  if (solution.left().depth == 0) return {{0, 0, solution.breakpoints(time).front(), 0}, false};
  return {{0, 0, solution.breakpoints(time).back(), 0}, false};
}

/// Where a computed profile has its front: the jump, or the end of the water at a dry front. Cells have no end of the
/// water; the outermost one deeper than a thousandth of the deepest counts.
double judged_position(const exact::Riemann& solution, const Judged& judged, const Profile& profile, bool particles) {
  if (judged.is_jump) return front_position(profile, judged.front);
  if (solution.left().depth > 0 && solution.right().depth > 0) return std::numeric_limits<double>::quiet_NaN();
  if (particles) return solution.left().depth == 0 ? profile.edges.front() : profile.edges.back();
  Largest deepest;
  for (const State& mean : profile.means) deepest.add(mean.depth);
  if (!(deepest.value() > 0)) return std::numeric_limits<double>::quiet_NaN();
  const auto is_wet = [&](const State& mean) { return mean.depth > 1e-3 * deepest.value(); };
  if (solution.left().depth == 0) {
    const auto first = std::find_if(profile.means.begin(), profile.means.end(), is_wet) - profile.means.begin();
    return profile.edges[static_cast<std::size_t>(first)];
  }
  const auto last = profile.means.rend() - std::find_if(profile.means.rbegin(), profile.means.rend(), is_wet);
  return profile.edges[static_cast<std::size_t>(last)];
}

/// The solution holds until a wave meets an end. The ends move with the water in the particle method, as pistons.
void require_before_ends(const exact::Riemann& solution, const FlowProblem& problem, double time, bool moving_ends) {
  Smallest meetings;
  const double left_end = moving_ends ? solution.left().velocity : 0;
  const double right_end = moving_ends ? solution.right().velocity : 0;
  if (solution.left().depth > 0 && solution.left_wave().slowest < left_end) {
    meetings.add((solution.jump() - problem.start) / (left_end - solution.left_wave().slowest));
  }
  if (solution.right().depth > 0 && solution.right_wave().fastest > right_end) {
    meetings.add((problem.end - solution.jump()) / (solution.right_wave().fastest - right_end));
  }
  if (time > meetings.value()) {
    throw std::invalid_argument(fmt::format(
        "time = {:g} is out of range: must be at most {:g}, when a wave meets an end", time, meetings.value()));
  }
}

std::vector<double> cell_centres(const Values& values) {
  const double start = values.real("start");
  const double end = values.real("end");
  const long n = values.integer("particles");
  std::vector<double> x;
  for (long i = 0; i < n; ++i)
    x.push_back(start + (end - start) * (static_cast<double>(i) + 0.5) / static_cast<double>(n));
  return x;
}

std::vector<WantedTable> tables_of(const Values& values) {
  const exact::Riemann solution = solution_of(values);
  const double time = values.real("time");
  const auto depth = [=](Place p) { return solution.at(p.abscissa, time).depth; };
  const auto velocity = [=](Place p) {  // dry bed has none
    const State state = solution.at(p.abscissa, time);
    return state.depth > 0 ? state.velocity : std::numeric_limits<double>::quiet_NaN();
  };
  return {{.name = "profile",
           .kind = WantedTable::Kind::profile,
           .abscissa = Column{"x", "m", "position, increasing"},
           .quantities = {{.column = {"h", "m", "depth"}, .reference = depth},
                          {.column = {"u", "m/s", "velocity"}, .reference = velocity}},
           .points = [x = cell_centres(values)](double) { return x; }}};
}

std::vector<WantedTable> wanted(const Values& values) {
  require_before_ends(solution_of(values), problem_from(values), values.real("time"), false);
  return tables_of(values);
}

/// Means at the centres: what somebody else would submit.
Submitted submitted_from(const Profile& profile) {
  SubmittedGroup group;
  for (std::size_t i = 0; i < profile.means.size(); ++i) {
    group.abscissa.push_back(0.5 * (profile.edges[i] + profile.edges[i + 1]));
    group.values["h"].push_back(profile.means[i].depth);
    group.values["u"].push_back(profile.means[i].velocity);
  }
  return {{"profile", {group}}};
}

/// Mean error of depth when each of two waves is a straight slope over so many cells instead of a jump.
/// @param share  width of a cell over that of the channel
evidence::Bound smeared_waves(const exact::Riemann& solution, double cells_wide, double share) {
  const auto [lowest, highest] = std::minmax({solution.left().depth, solution.right().depth, solution.star().depth});
  return {
      .limit = std::max(2 * cells_wide * share * (highest - lowest) / 4, 1e-12 * highest),
      .reason = fmt::format("a jump D smeared evenly over w cells of width dx leaves D w dx/4; two waves, each over at "
                            "most w = {:.3g} cells, D the range of depths",
                            cells_wide)};
}

/// What the parameters decide.
struct SetUp {
  exact::Riemann solution;
  FlowProblem problem;
  Discretisation discretisation;
  double time;
  Judged judged;

  [[nodiscard]] bool particles() const { return discretisation.scheme.size() == 2; }
  [[nodiscard]] bool dry() const { return solution.left().depth == 0 || solution.right().depth == 0; }
  [[nodiscard]] double judged_position(const Profile& profile) const {
    return cases::judged_position(solution, judged, profile, particles());
  }
};

SetUp set_up(const Values& values) {
  const exact::Riemann solution = solution_of(values);
  const double time = values.real("time");
  SetUp s{.solution = solution,
          .problem = problem_from(values),
          .discretisation = {.scheme = values.text("scheme"),
                             .particles = values.integer("particles"),
                             .equal_masses = values.text("spacing") == "masses",
                             .time_step = values.real("time_step"),
                             .theta = values.real("theta")},
          .time = time,
          .judged = judged_front(solution, time)};
  require_before_ends(s.solution, s.problem, time, s.particles());
  return s;
}

struct Results {
  SetUp set_up;
  FlowRun flow;
};

/// Steps of the size given, or by the Courant number of the fastest wave.
double steps_of(const SetUp& s) {
  if (s.discretisation.time_step > 0) return s.time / s.discretisation.time_step;
  const auto speed = [&](State state) {
    return std::abs(state.velocity) + shallow_water::celerity(s.solution.gravity(), state.depth);
  };
  const double fastest = std::max({speed(s.solution.left()), speed(s.solution.star()), speed(s.solution.right())});
  const double cell = s.problem.length() / static_cast<double>(s.discretisation.particles);
  return s.time * fastest / (s.discretisation.courant * cell);
}

void claims(const Values& values, const Claims<Results>& claims) {
  const SetUp s = set_up(values);
  const auto here = claims.at(s.discretisation.text());
  claim_conservation(here.of(&Results::flow), s.problem, s.discretisation, s.time);

  // A scheme that loses more than the fan's first cell, or smears a jump over the whole channel, is not one to use: the
  // error of a first-order scheme at a jump of size d is about its width times d times the cell width.
  const double cells_wide = s.discretisation.scheme == "lax_friedrichs" ? std::sqrt(steps_of(s)) : 8;
  here.check(
      {.id = "depth",
       .text = "The cell means of depth are those of the exact solution to within a few smeared cells.",
       .quantity = "cell L1(h)",
       .unit = "m",
       .source = "exact solution of the Riemann problem"},
      [](const Results& r) { return r.flow.errors.cell.depth.l1; },
      smeared_waves(s.solution, cells_wide, 1 / static_cast<double>(s.discretisation.particles)));
  here.only_if(s.discretisation.scheme == "H2" && s.dry(), "only H2 follows a dry front, where there is one")
      .check(
          {.id = "dry-front",
           .text = "The dry front is where the exact one is.",
           .quantity = "front position",
           .unit = "m",
           .source = "Ritter (1892)"},
          [](const Results& r) -> Measurement {
            return {.value = r.set_up.judged_position(r.flow.profile()),
                    .told = {.operations = std::pow(static_cast<double>(r.flow.steps()) / 4, 2)}};
          },
          evidence::Roundoff{
              .operations =
                  evidence::Amount::told_by_run(std::pow(most_steps(s.problem, s.discretisation, s.time) / 4, 2)),
              .scale = std::abs(s.judged.front.position) + s.problem.length(),
              .reason =
                  "two roundings per step, of the increment and of the position, each by at most half an eps; the "
                  "increment is the same in every step, so that they repeat and add up linearly: eps per step, "
                  "which the criterion's factor 4 makes of steps/4",
              .expected = s.judged.front.position});
}

Results compute(const Run& run) {
  Results r{.set_up = set_up(run)};
  const SetUp& s = r.set_up;
  r.flow = compute_flow(s.problem, s.discretisation, {s.time}, [&](double done) { run.progress(done); });
  return r;
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const SetUp& s = r.set_up;
  show_errors(r.flow.errors, exhibit);
  show_conservation(r.flow, exhibit);
  measure_own(tables_of(values), submitted_from(r.flow.profile()), exhibit);
  exhibit.measure("star_depth", s.solution.star().depth);
  exhibit.measure("star_velocity", s.solution.star().velocity);
  exhibit.measure("front_position", s.judged_position(r.flow.profile()));
  exhibit.measure("front_position_exact", s.judged.front.position);
  if (s.judged.is_jump) exhibit.measure("front_width", front_width(r.flow.profile(), s.judged.front));
  auto& figure = exhibit.figure("profile", "Depth and velocity",
                                fmt::format("At t = {:g} s: the exact solution, and the {} as rectangles of their mean "
                                            "depth and dots at their velocity.",
                                            s.time, s.particles() ? "particles" : "cells"));
  draw_frame(figure, exhibit, r.flow, r.flow.frames.back(), fmt::format("t = {:g} s", s.time));
}

/// What the submitted points themselves resolve: errors of the linear interpolant, and the front.
void judge(const Values& values, const Submitted& submitted, evidence::Record& record) {
  const exact::Riemann solution = solution_of(values);
  const FlowProblem problem = problem_from(values);
  const double time = values.real("time");
  const SubmittedGroup& profile = submitted.at("profile").front();
  const std::vector<double>& x = profile.abscissa;
  const std::vector<double>& h = profile.values.at("h");
  const std::vector<double>& u = profile.values.at("u");
  if (x.front() < problem.start || x.back() > problem.end) {
    throw std::invalid_argument(fmt::format("column x: values in [{:g}, {:g}], must be in [{:g}, {:g}]", x.front(),
                                            x.back(), problem.start, problem.end));
  }
  double l1_h = 0;
  double l1_u = 0;
  constexpr int samples = 16;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double width = (x[i + 1] - x[i]) / samples;
    for (int k = 0; k < samples; ++k) {
      const double share = (k + 0.5) / samples;
      const State exact = solution.at(std::lerp(x[i], x[i + 1], share), time);
      l1_h += width * std::abs(std::lerp(h[i], h[i + 1], share) - exact.depth);
      if (exact.depth > 0) l1_u += width * std::abs(std::lerp(u[i], u[i + 1], share) - exact.velocity);
    }
  }
  const double covered = x.back() - x.front();
  record.measure("l1_h", l1_h / covered);
  record.measure("l1_u", l1_u / covered);
  record.measure("points", static_cast<double>(x.size()));

  Profile cells;
  cells.edges.push_back(x.front());
  for (std::size_t i = 0; i < x.size(); ++i) {
    cells.edges.push_back(i + 1 < x.size() ? 0.5 * (x[i] + x[i + 1]) : x.back());
    cells.means.push_back({h[i], u[i]});
  }
  const Judged judged = judged_front(solution, time);
  record.measure("front_position", judged_position(solution, judged, cells, false));
  record.measure("front_position_exact", judged.front.position);
  if (judged.is_jump) record.measure("front_width", front_width(cells, judged.front));

  const double spacing = covered / static_cast<double>(x.size() - 1);
  record.check({.id = "depth",
                .text = "The depth is that of the exact solution to within a few smeared cells.",
                .quantity = "L1(h) of the linear interpolant",
                .unit = "m",
                .source = "exact solution of the Riemann problem"},
               {.value = l1_h / covered, .resolution = fmt::format("{} points", x.size())},
               smeared_waves(solution, 8, spacing / covered));
}

}  // namespace

Case riemann() {
  Case c;
  c.title = "The Riemann problem, as you set it";
  c.source =
      "E. F. Toro, Shock-capturing methods for free-surface shallow flows, 2001; J. J. Stoker, Water Waves, 1957";
  c.parameters = {
      real("left_depth", 1.0, "m", {0, 1e6}, "depth left of the jump; 0 is dry"),
      real("left_velocity", 0.0, "m/s", {-1e6, 1e6}, "velocity left of the jump"),
      real("right_depth", 0.1, "m", {0, 1e6}, "depth right of the jump; 0 is dry"),
      real("right_velocity", 0.0, "m/s", {-1e6, 1e6}, "velocity right of the jump"),
      real("gravity", 9.81, "m/s^2", {1e-6, 1e6}, "acceleration of gravity"),
      real("start", 0.0, "m", {-1e9, 1e9}, "left end of the channel"),
      real("end", 50.0, "m", {-1e9, 1e9}, "right end of the channel"),
      real("jump", 20.0, "m", {-1e9, 1e9}, "position of the discontinuity at t = 0"),
      integer("particles", {50, 800, 6400}, {4, 1e7}, "particles or cells over the whole channel"),
      choice("spacing", std::string("widths"), {"widths", "masses"}, "particles of equal widths or of equal masses"),
      real("time_step", 0.0, "s", {0, 1e6}, "time step; 0 takes it from the Courant number 0.4"),
      real("time", 6.0, "s", {1e-9, 1e9}, "end of the run"),
      real("theta", 2.0, "1", {1, 2}, "limiter: 1 minmod, 2 monotonised central"),
      choice("scheme", std::string("H2"), all_schemes, "level of the particle method, or a peer"),
  };
  c.study = Study(claims, compute, show);
  c.submission = {.tables = wanted, .judge = judge};
  return c;
}

}  // namespace seiche::validation::cases
