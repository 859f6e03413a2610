/*
A dam at $x = 10$ m holds water of depth $h_1 = 1$ m back from a dry bed and vanishes at $t = 0$. Ritter's solution is a
parabola between the wave running back into the reservoir and the dry front,

$$\sqrt{g h} = \tfrac13\left(2 c_1 - \frac{x - 10}{t}\right), \qquad -c_1 t < x - 10 < 2 c_1 t, \qquad c_1 = \sqrt{g
h_1}.$$

Bogomolov, Zakharov and Zerkal compute it with **ten particles**, $\tau = 0.08$ s, and show steps 0, 13, 26 and 39
(their figure 6); figures 5 and 7 are the set-up and the exact parabola. They do not print $h_1$ and $g$; the wave
positions fit their domain with $h_1 = 1$ m, and $g = 9.81$ m/s² is used here.

**What is compared.** The position of the dry front, the means over each particle (*cell*), the profile that the method
reconstructs within its particles (*reconstruction*; the front particle holds the tip of a parabola, not a rectangle),
and the rectangles as drawn. Comparison schemes run on cells of the initial particle width, over a channel long enough
for the front.

**What to look at.** The front: by the rearrangement as written in the paper the last particle is a rectangle, a tenth
of the water, and ends metres short of the front. MacCormack's scheme breaks down over a dry bed.
*/
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/instruments/exact/dam_break.hpp"
#include "validation/studies/shallow_water/flow_run.hpp"

namespace seiche::validation::cases::dry_dam_break {

constexpr double dam = 10;
/// Steps 13, 26, 39 of ten particles; the same times for any number of them.
const std::vector<double> times{0, 1.04, 2.08, 3.12};

/// What the parameters decide.
struct SetUp {
  exact::Ritter ritter;
  FlowProblem problem;
  Discretisation discretisation;
  FlowProblem channel;  ///< with its dry part, which peers need as cells
  Discretisation cells;
};

SetUp set_up(const Values& values) {
  const double gravity = values.real("gravity");
  const exact::Ritter ritter(gravity, values.real("depth"), dam);
  SetUp s{.ritter = ritter,
          .problem = problem_of(ritter, gravity, 0, dam, {}, FlowProblem::End::wall, FlowProblem::End::dry),
          .discretisation = {.scheme = "H2",
                             .particles = values.integer("particles"),
                             .time_step = values.real("time_step"),
                             .theta = 1.5}};
  s.channel = s.problem;
  s.channel.end = 40;
  s.channel.jumps = {dam};
  s.cells = s.discretisation;
  s.cells.particles = 4 * s.discretisation.particles;
  return s;
}

struct Results {
  FlowRun flow;
  FlowRun as_written;
  std::vector<Contestant> contestants;
};

/// The exact parabola at the paper's times with the particles' tip (figure 7).
void draw_parabola(evidence::Exhibit& exhibit, const FlowRun& flow, double front) {
  auto& panel =
      add_panel(exhibit, "parabola", "The dry dam-break parabola",
                "Ritter's profile and the reconstruction of the particles: parabola tip in the front particle.",
                {.x = "x [m]", .y = "depth h [m]"}, {"bzz-fig-7"});
  const ProfileCurve exact = exact_curve(flow.problem, 0, front * 1.02, flow.time());
  const ProfileCurve own = computed_curve(flow.profile());
  panel.line("exact", exact.x, exact.depth, Role::exact);
  panel.line("reconstruction of the particles", own.x, own.depth, Role::computed);
  panel.steps("particles", flow.profile().edges, means_of(flow.profile()).depth, Role::peer);
}

void claims(const Values& values, const Claims<Results>& claims) {
  const SetUp s = set_up(values);
  const double end = times.back();
  const double front = s.ritter.front(end);
  const auto here = claims.at(s.discretisation.text());
  here.check(
      "front", "The position of the dry front equals Ritter's solution exactly.", "front position [m]",
      [](const Results& r) { return r.flow.profile().edges.back(); },
      Roundoff{.operations = std::pow(end / s.discretisation.time_step / 4, 2),
               .scale = front,
               .reason = "two roundings per step, of the increment and of the position, each by at most half an "
                         "eps; the increment is the same in every step, so that roundings repeat and add up "
                         "linearly: eps per step, which the criterion's factor 4 makes of steps/4",
               .expected = front});
  claim_conservation(here.of(&Results::flow), s.problem, s.discretisation, end);
  claim_as_written(here.of(&Results::as_written), values, "bzz-fig-6", s.problem, s.discretisation, end,
                   values.real("depth"), nullptr);
  here.from("figure 24 uses the scheme over a wet bed only")
      .check(
          "maccormack", "MacCormack's scheme breaks down over a dry bed.", "finished",
          [](const Results& r) { return by_scheme(r.contestants, "maccormack").finished() ? 1.0 : 0.0; },
          Qualitative{.detector = "no negative or undefined depth until the end",
                      .reason = "the predictor gives negative depths at a dry front",
                      .expected = false});
}

Results compute(const Run& run) {
  const SetUp s = set_up(run);
  return {compute_flow(s.problem, s.discretisation, times, [&](double done) { run.progress(0.8 * done); }),
          compute_as_written(run, s.problem, s.discretisation, times),
          contest_all(s.channel, s.cells, all_schemes, times.back(), nullptr)};
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  const SetUp s = set_up(values);
  const double depth = values.real("depth");
  auto& panel = add_panel(exhibit, "setup", "Dam break over a dry bed: initial state", "Water behind the dam at t = 0.",
                          {.x = "x [m]", .y = "elevation [m]", .x_min = 0, .x_max = 20, .y_min = -0.1, .y_max = 1.3},
                          {"bzz-fig-5"});
  panel.fill("water", std::vector<double>{0, dam}, std::vector<double>{depth, depth}, Role::water);
  panel.line("dam", std::vector<double>{dam, dam}, std::vector<double>{0, 1.15 * depth}, Role::guide);
  panel.line("bed", std::vector<double>{0, 20}, std::vector<double>{0, 0}, Role::bed);
  draw_flow(r.flow, exhibit, "Dam break over a dry bed", {"bzz-fig-6"}, r.as_written);
  draw_parabola(exhibit, r.flow, s.ritter.front(r.flow.time()));
  report_contest(exhibit, s.channel, r.flow.time(), r.contestants);
  exhibit.measure("max_courant", r.flow.max_courant);
}

void dry_dam_break(Case& c) {
  c.title = "Dam break over a dry bed with ten particles";
  c.source = literature::bogomolov + ", figures 5 to 7";
  c.parameters = {
      integer("particles", {10, 640, 2560}, {4, 1e6}, "particles behind the dam"),
      real("time_step", {0.08, 0.00125, 0.0003}, "s", {1e-9, 1}, "time step"),
      real("depth", 1.0, "m", {1e-3, 1e3}, "depth behind the dam"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
      rearrangement(),
  };
  c.published = {
      {.tiles = {"bzz-fig-6", "bzz-fig-5", "bzz-fig-7"}, .stated = {"particles", "time_step", "rearrangement"}}};
  c.study = Study(claims, compute, show, "Ritter (1892)");
}

}  // namespace seiche::validation::cases::dry_dam_break
