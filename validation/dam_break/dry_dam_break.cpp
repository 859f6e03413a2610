/*
A dam at $x = 10$ m holds water of depth $h_1 = 1$ m back from a dry bed and vanishes at $t = 0$. Ritter's solution is a
parabola between the wave that runs back into the water and the dry front,

$$\sqrt{g h} = \tfrac13\left(2 c_1 - \frac{x - 10}{t}\right), \qquad -c_1 t < x - 10 < 2 c_1 t, \qquad c_1 = \sqrt{g
h_1}.$$

Bogomolov, Zakharov and Zerkal compute it with **ten particles**, $\tau = 0.08$ s, and show steps 0, 13, 26 and 39
(their figure 6); figures 5 and 7 are the set-up and the exact parabola. They do not print $h_1$ and $g$; the wave
positions fit their domain with $h_1 = 1$ m, and $g = 9.81$ m/s² is used here.

**What is compared.** The position of the dry front, the means over each particle (*cell*), the profile the method
itself takes within its particles (*reconstruction*; the front particle holds the tip of a parabola, not a rectangle),
and the rectangles as drawn. Peers run on cells as wide as the particles were at the start, over a channel long enough
for the front.

**What to look at.** The front: a rectangle of one tenth of the water would end metres short of it. MacCormack's scheme
has no answer over a dry bed.
*/
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/dam_break.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/shallow_water/flow_evidence.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;

constexpr double dam = 10;

void claim_front(evidence::Record& record, const Flow& flow, double expected) {
  record.measure("front_position", flow.profile().edges.back());
  record.check(
      {.id = "front",
       .text = "The dry front is exactly where Ritter's solution has it.",
       .quantity = "front position",
       .unit = "m",
       .source = "Ritter (1892)"},
      {.value = flow.profile().edges.back(), .resolution = flow.discretisation().text()},
      evidence::Roundoff{.operations = std::pow(static_cast<double>(flow.steps()), 2),
                         .scale = expected,
                         .reason = "one rounded update per step; the increment is the same in every step, so that "
                                   "its rounding repeats and adds up linearly",
                         .expected = expected});
}

void draw_setup(evidence::Record& record, double depth) {
  auto& panel =
      record.figure("setup", "Dam break over a dry bed: the problem", "Water behind the dam at t = 0.", {"bzz-fig-5"})
          .panel({.x = "x [m]", .y = "elevation [m]", .x_min = 0, .x_max = 20, .y_min = -0.1, .y_max = 1.3});
  panel.fill("water", std::vector<double>{0, dam}, std::vector<double>{depth, depth}, Role::water);
  panel.line("dam", std::vector<double>{dam, dam}, std::vector<double>{0, 1.15 * depth}, Role::guide);
  panel.line("bed", std::vector<double>{0, 20}, std::vector<double>{0, 0}, Role::bed);
}

/// The exact parabola at the paper's times with the particles' tip (figure 7).
void draw_parabola(evidence::Record& record, const FlowProblem& problem, const Flow& flow, double front) {
  auto& panel =
      record
          .figure("parabola", "The dry dam-break parabola",
                  "Ritter's profile and the particles' own curve: parabola tip in the front particle.", {"bzz-fig-7"})
          .panel({.x = "x [m]", .y = "depth h [m]"});
  const ExactCurve exact = exact_curve(problem, 0, front * 1.02, flow.time());
  const ExactCurve own = computed_curve(flow.profile());
  panel.line("exact", exact.x, exact.depth, Role::exact);
  panel.line("reconstruction of the particles", own.x, own.depth, Role::computed);
  panel.steps("particles", flow.profile().edges, means_of(flow.profile()).depth, Role::peer);
}

void run(Running& run) {
  const double gravity = run.real("gravity");
  const double depth = run.real("depth");
  const double tau = run.real("time_step");
  const long n = run.integer("particles");
  const exact::Ritter ritter(gravity, depth, dam);
  const FlowProblem problem = problem_of(ritter, gravity, 0, dam, {}, FlowProblem::End::wall, FlowProblem::End::dry);
  // Steps 13, 26, 39 of ten particles; the same times for any number of them.
  const std::vector<double> times{0, 1.04, 2.08, 3.12};
  const double end = times.back();

  draw_setup(run.record, depth);
  const Discretisation particles{.scheme = "H2", .particles = n, .time_step = tau, .theta = 1.5};
  const auto flow = run_and_draw(run.record, problem, particles, times, "Dam break over a dry bed", {"bzz-fig-6"},
                                 [&](double done) { run.progress(0.8 * done); });
  draw_parabola(run.record, problem, *flow, ritter.front(end));
  claim_front(run.record, *flow, ritter.front(end));
  claim_conservation(run.record, *flow);

  const ProfileErrors errors = profile_errors(flow->profile(), problem, end);
  measure_errors(run.record, errors);
  if (run.as_published()) {
    claim_reproduced(run.record, "reconstructed_l1_h", "reconstructed L1(h)",
                     "The reconstruction of ten particles is the known one.", errors.reconstructed.depth.l1, 4.1e-3,
                     "m", particles.text());
    claim_reproduced(run.record, "cell_l1_h", "cell L1(h)", "The mean depths of ten particles are the known ones.",
                     errors.cell.depth.l1, 3.9e-3, "m", particles.text());
  }

  // Peers need the dry part of the channel as cells.
  FlowProblem channel = problem;
  channel.end = 40;
  channel.jumps = {dam};
  std::vector<Contestant> contestants;
  for (const std::string& scheme : all_schemes) {
    contestants.push_back(
        contest(channel, {.scheme = scheme, .particles = 4 * n, .time_step = tau, .theta = 1.5}, end, nullptr));
    if (scheme == "maccormack") {
      run.record.known_failure(
          {.id = "maccormack",
           .text = "MacCormack's scheme finishes over a dry bed.",
           .quantity = "finished",
           .source = "figure 24 uses the scheme over a wet bed only"},
          {.value = contestants.back().failure.empty() ? 1.0 : 0.0, .resolution = particles.text()},
          evidence::Qualitative{.detector = "no negative or undefined depth until the end",
                                .reason = "a usable scheme must survive drying"},
          "its predictor makes negative depths at a dry front; a property of the scheme");
    }
  }
  report_contest(run.record, channel, end, contestants);
}

}  // namespace

Case dry_dam_break() {
  Case c;
  c.title = "Dam break over a dry bed with ten particles";
  c.source = "Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method, figures 5 to 7";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      integer("particles", {10, 640, 2560}, {4, 1e6}, "particles behind the dam"),
      real("time_step", {0.08, 0.00125, 0.0003}, "s", {1e-9, 1}, "time step"),
      real("depth", 1.0, "m", {1e-3, 1e3}, "depth behind the dam"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
