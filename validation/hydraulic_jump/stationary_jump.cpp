/*
A bore of depth 2 m into 1 m is stationary in a frame moving at its speed $a$. In its mirror image, drawn by Bogomolov,
Zakharov and Zerkal, supercritical water of depth $h_0 = 1$ m enters from the left at 5.42 m/s and leaves to the right,
2 m deep, at 2.71 m/s. They compute it with 105 particles and $\tau = 0.08$ s, the jump at $x = 100$ m (their figures 16
to 18).

The particles move through the jump; both ends are pistons moving with the stream.

**What is compared.** The position and the profile of the jump after 100 steps, with the other variants of the method
and the comparison schemes.

**What to look at.** MacCormack's and Roe's schemes hold a jump on a cell edge exactly, because their grid is at rest.
For the particles the water moves 43 m and the jump stays: to all digits by the hand-over; by the rearrangement as
written in the paper within one particle, but a metre downstream.
*/
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/instruments/exact/dam_break.hpp"
#include "validation/studies/shallow_water/bore_depths.hpp"
#include "validation/studies/shallow_water/flow_run.hpp"

namespace seiche::validation::cases::stationary_jump {

using exact::StationaryJump;

constexpr double length = 105;
constexpr double place = 100;

/// What the parameters decide.
struct SetUp {
  StationaryJump jump;
  FlowProblem problem;
  Discretisation discretisation;
  double time;
  Front front;
};

SetUp set_up(const Values& values) {
  const double gravity = values.real("gravity");
  require_bore(values, "deep_depth", "shallow_depth");
  const StationaryJump jump(gravity, values.real("shallow_depth"), values.real("deep_depth"), place);
  const Discretisation discretisation{
      .scheme = "H2", .particles = values.integer("particles"), .time_step = values.real("time_step"), .theta = 1.5};
  return {jump,
          problem_of(jump, gravity, 0, length, {place}, FlowProblem::End::stream, FlowProblem::End::stream),
          discretisation,
          values.number("steps") * discretisation.time_step,
          {.behind = jump.upstream().depth, .ahead = jump.downstream().depth, .position = place, .reach = 30}};
}

void draw_sketches(evidence::Exhibit& exhibit, const FlowProblem& problem, const StationaryJump& jump) {
  const ProfileCurve curve = exact_curve(problem, 0, length, 0);
  const std::string title =
      fmt::format("u = {:.2f} m/s left, {:.2f} m/s right", jump.upstream().velocity, jump.downstream().velocity);
  evidence::Axes axes{.x = "x [m]", .y = "elevation [m]", .title = title, .x_min = 80, .x_max = length};
  axes.y_min = -0.1;
  axes.y_max = 3;
  auto& panel = add_panel(exhibit, "setup", "Stationary hydraulic jump: initial state",
                          "Water flows from left to right through a stationary jump.", axes, {"bzz-fig-16"});
  panel.fill("water", curve.x, curve.depth, Role::water);
  draw_exact(exhibit.figure("exact", "The exact jump", "Depth and velocity, the same at all times.", {"bzz-fig-17"}),
             problem, 0);
}

void claims(const Values& values, const Claims<ParticleFigure>& claims) {
  const SetUp s = set_up(values);
  const auto flow = claims.of(&ParticleFigure::flow);
  claim_conservation(flow, s.problem, s.discretisation, s.time);
  claim_exact_profile(flow, s.jump.downstream().depth, s.discretisation, s.time);
  claim_single_particle(flow, s.front);
  claim_as_written(claims.of(&ParticleFigure::as_written), values, "bzz-fig-18", s.problem, s.discretisation, s.time,
                   s.front.ahead - s.front.behind, &s.front, {{"cell_l1_h", 0.0304586}, {"front", 1.16668}});
}

ParticleFigure compute(const Run& run) {
  const SetUp s = set_up(run);
  return compute_figure(run, s.problem, s.discretisation, {0, 0.5 * s.time, s.time}, s.front);
}

void show(const ParticleFigure& figure, const Values& values, evidence::Exhibit& exhibit) {
  const SetUp s = set_up(values);
  draw_sketches(exhibit, s.problem, s.jump);
  show_figure(figure, exhibit, "Particles passing a stationary jump", {"bzz-fig-18"});
}

void stationary_jump(Case& c) {
  c.title = "Stationary hydraulic jump";
  c.source = literature::bogomolov + ", figures 16 to 18";
  c.tiers = {Tier::quick};
  c.parameters = {
      integer("particles", 105L, {12, 1e6}, "particles of equal widths over the channel"),
      real("time_step", 0.08, "s", {1e-9, 1}, "time step"),
      integer("steps", 100L, {1, 1e7}, "number of steps"),
      real("shallow_depth", 1.0, "m", {1e-3, 1e3}, "depth upstream"),
      real("deep_depth", 2.0, "m", {1e-3, 1e3}, "depth downstream"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
      rearrangement(),
  };
  c.published = {{.tiles = {"bzz-fig-18", "bzz-fig-16", "bzz-fig-17"},
                  .stated = {"particles", "time_step", "steps", "shallow_depth", "deep_depth", "rearrangement"}}};
  c.study = Study(claims, compute, show);
}

}  // namespace seiche::validation::cases::stationary_jump
