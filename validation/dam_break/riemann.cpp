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
#include "validation/dam_break/riemann_problem.hpp"
#include "validation/scoring/score.hpp"
#include "validation/studies/shallow_water/flow_run.hpp"

namespace seiche::validation::cases {
namespace {

const std::string source = "exact solution of the Riemann problem";

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
  const exact::Riemann solution = riemann_solution(values);
  const double time = values.real("time");
  const auto depth = [=](Place p) { return solution.at(p.abscissa, time).depth; };
  const auto velocity = [=](Place p) {  // dry bed has none
    const State state = solution.at(p.abscissa, time);
    return state.depth > 0 ? state.velocity : std::numeric_limits<double>::quiet_NaN();
  };
  const std::vector<double> centres = cell_centres(values);
  return {{.name = "profile",
           .kind = WantedTable::Kind::profile,
           .abscissa = Column{"x", "m", "position, increasing"},
           .quantities = {{.column = {"h", "m", "depth"}, .reference = depth},
                          {.column = {"u", "m/s", "velocity"}, .reference = velocity}},
           .points = [x = centres](double) { return x; },
           .exact = {
               fmt::format("seiche exact riemann --set left_depth={:.17g},left_velocity={:.17g},right_depth={:.17g},"
                           "right_velocity={:.17g},gravity={:.17g},jump={:.17g} --grid x={:.17g}:{:.17g}:{},t={:.17g}",
                           values.real("left_depth"), values.real("left_velocity"), values.real("right_depth"),
                           values.real("right_velocity"), values.real("gravity"), values.real("jump"), centres.front(),
                           centres.back(), centres.size(), time)}}};
}

std::vector<WantedTable> wanted(const Values& values) {
  require_before_ends(riemann_solution(values), riemann_channel(values), values.real("time"), false);
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

/// What the parameters decide.
struct SetUp {
  exact::Riemann solution;
  FlowProblem problem;
  Discretisation discretisation;
  double time;
  JudgedFront judged;

  [[nodiscard]] bool particles() const { return discretisation.scheme.size() == 2; }
  [[nodiscard]] bool dry() const { return solution.left().depth == 0 || solution.right().depth == 0; }
  [[nodiscard]] double judged_position(const Profile& profile) const {
    return validation::judged_position(solution, judged, profile, particles());
  }
};

SetUp set_up(const Values& values) {
  const exact::Riemann solution = riemann_solution(values);
  const double time = values.real("time");
  SetUp s{.solution = solution,
          .problem = riemann_channel(values),
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
  RiemannErrors errors;  ///< of the means at the centres, joined by straight lines: what others submit
};

/// The scheme of Lax and Friedrichs has the viscosity dx^2/(2 dt), and spreads a jump like anything else, over the root
/// of as many cells as there are steps.
Smearing smearing_of(const SetUp& s, double cell) {
  if (s.discretisation.scheme != "lax_friedrichs") return {};
  const auto speed = [&](State state) {
    return std::abs(state.velocity) + shallow_water::celerity(s.solution.gravity(), state.depth);
  };
  const double fastest = std::max({speed(s.solution.left()), speed(s.solution.star()), speed(s.solution.right())});
  const double step =
      s.discretisation.time_step > 0 ? s.discretisation.time_step : s.discretisation.courant * cell / fastest;
  return {.cells_wide = std::sqrt(s.time / step), .viscosity = cell / (fastest * step)};
}

void claims(const Values& values, const Claims<Results>& claims) {
  const SetUp s = set_up(values);
  const auto here = claims.at(s.discretisation.text());
  claim_conservation(here.of(&Results::flow), s.problem, s.discretisation, s.time);

  const double cell = s.problem.length() / static_cast<double>(s.discretisation.particles);
  for (const RiemannRequirement& one :
       riemann_requirements(s.solution, s.time, s.problem.length(), cell, smearing_of(s, cell))) {
    const evidence::Amount& limit = one.bound.limit;
    here.only_if(!(limit.value() > limit.cap()),
                 fmt::format("on cells of {:.3g} m a scheme of first order loses more than half of what water that "
                             "never moved would miss: nothing could be told",
                             cell))
        .check(
            {.id = one.id, .text = one.text, .quantity = one.quantity, .unit = one.unit, .source = source},
            [error = one.error](const Results& r) { return r.errors.*error; }, one.bound);
  }
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
  const SubmittedGroup own = submitted_from(r.flow.profile()).at("profile").front();
  r.errors = riemann_errors(s.solution, s.time, {own.abscissa, own.values.at("h"), own.values.at("u")});
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

/// Size of the cells that the limits are for: the solver's own, or as many over the channel as the case asks for.
double cell_of(const Values& values, const FlowProblem& problem, const SolverFacts& facts) {
  const double cell = facts.cell.value_or(problem.length() / static_cast<double>(values.integer("particles")));
  if (cell > problem.length() / 4) {
    throw std::invalid_argument(fmt::format("--dx {:g} is out of range: must be at most {:g}, a quarter of the channel",
                                            cell, problem.length() / 4));
  }
  return cell;
}

/// Points farther apart than two cells show less than the solver knows, and cannot be judged for it.
void require_points(const std::vector<double>& x, double cell) {
  Largest apart;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) apart.add(x[i + 1] - x[i]);
  if (!(apart.value() <= 2 * cell)) {
    throw std::invalid_argument(fmt::format(
        "column x: points up to {:.3g} m apart, must be at most two cells of {:.3g} m: print more points, or "
        "say how large your cells are by --dx",
        apart.value(), cell));
  }
}

void judge(const Values& values, const Submitted& submitted, const SolverFacts& facts, evidence::Record& record) {
  const exact::Riemann solution = riemann_solution(values);
  const FlowProblem problem = riemann_channel(values);
  const double time = values.real("time");
  const SubmittedGroup& group = submitted.at("profile").front();
  const RiemannProfile profile{group.abscissa, group.values.at("h"), group.values.at("u")};
  if (profile.x.front() < problem.start || profile.x.back() > problem.end) {
    throw std::invalid_argument(fmt::format("column x: values in [{:g}, {:g}], must be in [{:g}, {:g}]",
                                            profile.x.front(), profile.x.back(), problem.start, problem.end));
  }
  const double cell = cell_of(values, problem, facts);
  require_points(profile.x, cell);
  const RiemannErrors errors = riemann_errors(solution, time, profile);
  record.measure("l1_h", errors.depth);
  record.measure("l1_u", errors.velocity);
  record.measure("points", static_cast<double>(profile.x.size()));
  const JudgedFront judged = judged_front(solution, time);
  record.measure("front_position", judged_position(solution, judged, profile.cells(), false));
  record.measure("front_position_exact", judged.front.position);
  if (judged.is_jump) record.measure("front_width", front_width(profile.cells(), judged.front));

  const std::string resolution = fmt::format("cells of {:.4g} m, {} points", cell, profile.x.size());
  for (const RiemannRequirement& one : riemann_requirements(solution, time, problem.length(), cell)) {
    record.check({.id = one.id, .text = one.text, .quantity = one.quantity, .unit = one.unit, .source = source},
                 {.value = errors.*one.error, .resolution = resolution}, one.bound);
  }
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
