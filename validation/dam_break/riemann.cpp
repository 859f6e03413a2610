/*
Two uniform states meet at `jump` at $t = 0$ on a flat bed: the Riemann problem of the shallow-water equations,

$$h_t + (h u)_x = 0, \qquad (h u)_t + \left(h u^2 + g h^2/2\right)_x = 0.$$

Any pair of depths and velocities may be set; depth 0 is a dry side. The exact solution consists of a left wave, a
uniform middle state and a right wave; each wave is a rarefaction or a bore.

The case serves to try a scheme, one of the suite (`G1`, `M2`, `H2`: the conservative particle method of Bogomolov,
Zakharov and Zerkal in its three variants; `lax_friedrichs`, `maccormack`, `roe`, `muscl`) or your own (`seiche score
riemann`).

**What is compared.** Cell means, the reconstructed profile, and the front, all with the exact solution at the same
time. Fluxes through the ends are booked, so that mass and momentum balance to round-off at any resolution.

**What to look at.** The bore: in variant `H2` it lies inside a single particle. At the corners of the rarefaction every
scheme loses its order.
*/
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/parameter.hpp"
#include "validation/scoring/score.hpp"
#include "validation/studies/shallow_water/flow.hpp"
#include "validation/studies/shallow_water/judged_states.hpp"

namespace seiche::validation::cases::riemann {

// The Riemann problem that the parameters of the case `riemann` set.

exact::Riemann riemann_solution(const Values& values) {
  return {values.real("gravity"),
          {values.real("left_depth"), values.real("left_velocity")},
          {values.real("right_depth"), values.real("right_velocity")},
          values.real("jump")};
}

/// @throws std::invalid_argument where the jump is not within the channel
FlowProblem riemann_channel(const Values& values) {
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
  const exact::Riemann solution = riemann_solution(values);
  return problem_of(solution, solution.gravity(), start, end, {jump}, end_kind("left"), end_kind("right"));
}

/// The solution holds until a wave meets an end. The ends move with the water in the particle method, as pistons.
/// @throws std::invalid_argument for a later time
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

JudgedStates states_of(const Values& values) {
  const FlowProblem channel = riemann_channel(values);
  JudgedStates states{.solution = riemann_solution(values),
                      .since = values.real("time"),
                      .start = channel.start,
                      .end = channel.end,
                      .cells = values.integer("particles")};
  require_before_ends(states.solution, channel, states.since, false);
  return states;
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

/// Over that of Rusanov's flux: the scheme of Lax and Friedrichs has dx^2/(2 dt) everywhere.
double viscosity_of(const SetUp& s) {
  if (s.discretisation.scheme != "lax_friedrichs") return 1;
  if (s.discretisation.time_step == 0) return 1 / s.discretisation.courant;
  const auto speed = [&](State state) {
    return std::abs(state.velocity) + shallow_water::celerity(s.solution.gravity(), state.depth);
  };
  const double fastest = std::max({speed(s.solution.left()), speed(s.solution.star()), speed(s.solution.right())});
  const double cell = s.problem.length() / static_cast<double>(s.discretisation.particles);
  return cell / (fastest * s.discretisation.time_step);
}

void claims(const Values& values, const Claims<FlowRun>& claims) {
  const SetUp s = set_up(values);
  const auto here = claims.at(s.discretisation.text());
  claim_conservation(here, s.problem, s.discretisation, s.time);

  // A particle keeps its water, and of first order it is as coarse as it is long.
  const double deepest = std::max(s.solution.left().depth, s.solution.right().depth);
  const double stretched = s.discretisation.scheme == "G1" && !s.dry() ? deepest / s.solution.star().depth : 1;
  const double cell = std::max(1.0, stretched) * s.problem.length() / static_cast<double>(s.discretisation.particles);
  claim_states(here, states_of(values), cell, viscosity_of(s));
  here.only_if(s.discretisation.scheme == "H2" && s.dry(), "only H2 tracks a dry front")
      .check(
          "dry-front", "The position of the dry front equals the exact solution to round-off.", "front position [m]",
          [s](const FlowRun& flow) -> Measurement {
            return {.value = s.judged_position(flow.profile()),
                    .told = {.operations = std::pow(static_cast<double>(flow.steps()) / 4, 2)}};
          },
          Roundoff{.operations = Amount::told_by_run(std::pow(most_steps(s.problem, s.discretisation, s.time) / 4, 2)),
                   .scale = std::abs(s.judged.front.position) + s.problem.length(),
                   .reason = "two roundings per step, of the increment and of the position, each by at most half an "
                             "eps; the increment is the same in every step, so that roundings repeat and add up "
                             "linearly: eps per step, which the criterion's factor 4 makes of steps/4",
                   .expected = s.judged.front.position});
}

FlowRun compute(const Run& run) {
  const SetUp s = set_up(run);
  return compute_flow(s.problem, s.discretisation, {s.time}, [&](double done) { run.progress(done); });
}

void show(const FlowRun& flow, const Values& values, evidence::Exhibit& exhibit) {
  const SetUp s = set_up(values);
  exhibit.measure("cell_l1_h", flow.errors.cell.depth.l1);
  exhibit.measure("reconstructed_l1_h", flow.errors.reconstructed.depth.l1);
  exhibit.measure("max_courant", flow.max_courant);
  measure_own(wanted_states(states_of(values)), submitted_profile(flow.profile()), exhibit);
  exhibit.measure("star_depth", s.solution.star().depth);
  exhibit.measure("star_velocity", s.solution.star().velocity);
  exhibit.measure("front_position", s.judged_position(flow.profile()));
  exhibit.measure("front_position_exact", s.judged.front.position);
  if (s.judged.is_jump) exhibit.measure("front_width", front_width(flow.profile(), s.judged.front));
  auto& figure = exhibit.figure(
      "profile", "Depth and velocity",
      fmt::format(
          "At t = {:g} s: the exact solution, and the {} as rectangles of their mean depth and dots at their velocity.",
          s.time, s.particles() ? "particles" : "cells"));
  draw_frame(figure, exhibit, flow, flow.frames.back(), fmt::format("t = {:g} s", s.time));
}

void riemann(Case& c) {
  c.title = "Riemann problem with given states";
  c.source =
      "E. F. Toro, Shock-capturing methods for free-surface shallow flows, 2001; J. J. Stoker, Water Waves, 1957";
  c.tiers = {Tier::quick};
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
      choice("spacing", "widths", {"widths", "masses"}, "particles of equal widths or of equal masses"),
      real("time_step", 0.0, "s", {0, 1e6}, "time step; 0 takes it from the Courant number 0.4"),
      real("time", 6.0, "s", {1e-9, 1e9}, "end of the run"),
      real("theta", 2.0, "1", {1, 2}, "limiter: 1 minmod, 2 monotonised central"),
      choice("scheme", "H2", all_schemes, "level of the particle method, or a comparison scheme"),
  };
  c.study = Study(claims, compute, show, "Ritter (1892)");
  c.submission = submission_of(states_of);
}

}  // namespace seiche::validation::cases::riemann
