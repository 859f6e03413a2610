/*
A bore of depth $h_1 = 2$ m runs into still water of depth $h_0 = 1$ m. The jump conditions

$$h_1 (u_1 - a) = h_0 (u_0 - a) = m, \qquad m (u_1 - u_0) = \tfrac{g}{2}\left(h_0^2 - h_1^2\right)$$

give its speed $a = \sqrt{g h_1 (h_1 + h_0)/(2 h_0)}$ and the velocity behind it, $u_1 = a (1 - h_0/h_1)$. Bogomolov,
Zakharov and Zerkal compute it with 120 particles and $\tau = 0.08$ s and print $a = 5.4$ and $u_1 = 2.7$ m/s (their
figures 9 to 12); both $g = 9.8$ and $9.81$ m/s² fit those digits.

The left end is a piston that moves with $u_1$.

**What is compared.** The method's own profile with the exact one; the energy of the two-state reconstruction, which
must fall at exactly the rate that the jump conditions give, $D = g a (h_1 - h_0)^3/(4 h_1)$; the other levels of the
method and the peers.

**What to look at.** One particle holds the jump and hands it on to the next; nothing else is disturbed, to the last
digit. Every peer smears it over several cells.
*/
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/bore.hpp"
#include "seiche/models/shallow_water_particles/initial.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/studies/shallow_water/flow_evidence.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;
namespace particles = shallow_water_particles;

constexpr double length = 120;
constexpr double start = 40;

void draw_setup(evidence::Record& record, const exact::Bore& bore) {
  const double h0 = bore.ahead().depth;
  const double h1 = bore.behind().depth;
  const double u1 = bore.behind_velocity();
  auto& piston =
      record
          .figure("setup-piston", "A piston drives a bore",
                  "The piston at the left moves at the velocity of the water behind the bore.", {"bzz-fig-9"})
          .panel({.x = "x [m]", .y = "elevation [m]", .x_min = 0, .x_max = length, .y_min = -0.1, .y_max = 1.5 * h1});
  const std::vector<double> x{start, start, start + 30, start + 30, length};
  piston.fill("water", x, std::vector<double>{0, h1, h1, h0, h0}, Role::water);
  piston.line("piston", std::vector<double>{start, start}, std::vector<double>{0, 1.3 * h1}, Role::guide);
  piston.line("bed", std::vector<double>{0, length}, std::vector<double>{0, 0}, Role::bed);

  auto& panel = record.figure("setup", "The bore: the problem", "Depths and velocities at t = 0.", {"bzz-fig-10"})
                    .panel({.x = "x [m]",
                            .y = "elevation [m]",
                            .title = fmt::format("behind u = {:.3f} m/s, ahead at rest", u1),
                            .x_min = 0,
                            .x_max = length,
                            .y_min = -0.1,
                            .y_max = 1.5 * h1});
  panel.fill("water", std::vector<double>{0, start, start, length}, std::vector<double>{h1, h1, h0, h0}, Role::water);
  panel.line("bed", std::vector<double>{0, length}, std::vector<double>{0, 0}, Role::bed);
}

void draw_exact(evidence::Record& record, const FlowProblem& problem, double time) {
  auto& figure =
      record.figure("exact", "The exact bore", fmt::format("Depth and velocity at t = {:g} s.", time), {"bzz-fig-11"});
  const ExactCurve curve = exact_curve(problem, 0, length, time);
  figure.panel({.x = "x [m]", .y = "depth h [m]"}).line("exact", curve.x, curve.depth, Role::exact);
  figure.panel({.x = "x [m]", .y = "velocity u [m/s]"}).line("exact", curve.x, curve.velocity, Role::exact);
}

/// Follows energy and edges step by step: D is exact, and the paths of edges show the jump as a kink.
void follow(Running& run, const exact::Bore& bore, long n, double tau, long steps) {
  const double u1 = bore.behind_velocity();
  const double gravity = bore.gravity();
  particles::ParticleFlow flow(
      particles::bore(gravity, 0, start, length, bore.behind().depth, bore.ahead().depth, static_cast<std::size_t>(n)),
      {.left = particles::Piston{[u1](double) { return u1; }}, .right = particles::Wall{}}, {.gravity = gravity});
  std::vector<double> times{0};
  std::vector<double> energy{flow.energy()};
  std::vector<double> mean_energy{flow.mean_energy()};
  std::vector<std::vector<double>> paths;
  const auto note_paths = [&] {
    const auto& edge = flow.particles().edge;
    paths.emplace_back(edge.begin(), edge.end());
  };
  note_paths();
  double worst = 0;
  for (long k = 1; k <= steps; ++k) {
    flow.advance(tau);
    times.push_back(flow.time());
    energy.push_back(flow.energy());
    mean_energy.push_back(flow.mean_energy());
    note_paths();
    // The piston works with the thrust of the water behind the bore.
    const double work = shallow_water::thrust(gravity, bore.behind().depth) * u1 * flow.time();
    worst = std::max(worst, std::abs(flow.energy() - energy[0] - work + bore.energy_loss_rate() * flow.time()));
  }
  run.record.measure("energy_deviation", worst);
  run.record.check(
      {.id = "energy",
       .text = "Energy falls at exactly the rate of the jump conditions.",
       .quantity = "largest deviation of the two-state energy",
       .unit = "m^4/s^3 s",
       .source = "D = g a (h1 - h0)^3/(4 h1), Stoker (1957), 10.6"},
      {.value = worst, .resolution = fmt::format("N = {}, tau = {:g} s", n, tau)},
      evidence::Roundoff{.operations = static_cast<double>(n + steps),
                         .scale = energy[0],
                         .reason = "energy is a sum over particles, of the size of its value; one rounding per step"});

  auto& history = run.record
                      .figure("energy", "Energy against time",
                              "Energy less the work of the piston. Of the two-state reconstruction it falls along the "
                              "straight line of the jump conditions; of particle means it wavers as the transition "
                              "particle fills.")
                      .panel({.x = "t [s]", .y = "energy - work - E(0) [m$^4$/s$^2$]"});
  std::vector<double> two_state;
  std::vector<double> means;
  std::vector<double> law;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double work = shallow_water::thrust(gravity, bore.behind().depth) * u1 * times[k];
    two_state.push_back(energy[k] - work - energy[0]);
    means.push_back(mean_energy[k] - work - mean_energy[0]);
    law.push_back(-bore.energy_loss_rate() * times[k]);
  }
  history.line("-D t", times, law, Role::exact);
  history.points("two-state reconstruction", times, two_state, Role::computed);
  history.line("particle means", times, means, Role::peer);

  auto& panel = run.record
                    .figure("paths", "Paths of particle edges",
                            "Each line is an edge in the (x, t) plane; the jump is the line along which they bend.")
                    .panel({.x = "x [m]", .y = "t [s]", .x_min = 30, .x_max = 90});
  const std::size_t edges = paths.front().size();
  for (std::size_t e = edges / 4; e < edges * 3 / 4; e += 2) {
    std::vector<double> x;
    for (const auto& row : paths) x.push_back(row[e]);
    panel.line(e == edges / 4 ? "edges" : "", x, times, Role::computed);
  }
  std::vector<double> front;
  for (const double t : times) front.push_back(bore.position(t));
  panel.line("exact bore", front, times, Role::exact);
}

void run(Running& run) {
  const double gravity = run.real("gravity");
  const exact::Bore bore(gravity, run.real("still_depth"), run.real("front_depth"), 0, start);
  const FlowProblem problem =
      problem_of(bore, gravity, 0, length, {start}, FlowProblem::End::stream, FlowProblem::End::wall);
  const Discretisation discretisation{
      .scheme = "H2", .particles = run.integer("particles"), .time_step = run.real("time_step"), .theta = 1.5};
  const long steps = run.integer("steps");
  const double time = static_cast<double>(steps) * discretisation.time_step;
  if (bore.position(time) >= length) {
    throw std::invalid_argument(
        fmt::format("steps = {} is out of range: the bore would leave the channel at t = {:g} s", steps,
                    (length - start) / bore.speed()));
  }

  draw_setup(run.record, bore);
  draw_exact(run.record, problem, time);
  const auto flow =
      run_and_draw(run.record, problem, discretisation, {0, 0.5 * time, time}, "A bore runs into still water",
                   {"bzz-fig-12"}, [&](double done) { run.progress(0.3 * done); });
  claim_conservation(run.record, *flow);
  claim_exact_profile(run.record, *flow, problem, bore.behind().depth);
  const Front front{
      .behind = bore.behind().depth, .ahead = bore.ahead().depth, .position = bore.position(time), .reach = 30};
  claim_single_particle(run.record, *flow, front);
  run.record.check(
      {.id = "range",
       .text = "No depth leaves the range of the exact solution.",
       .quantity = "largest depth outside the range",
       .unit = "m",
       .source = "the bore is monotone"},
      {.value = excursion(flow->profile(), bore.ahead().depth, bore.behind().depth),
       .resolution = discretisation.text()},
      // Depth is mass over width: the rounding of two edges of the size of the channel counts N times.
      evidence::Roundoff{.operations = static_cast<double>(steps),
                         .scale = bore.behind().depth * static_cast<double>(discretisation.particles),
                         .reason = "edges as large as the channel are rounded once per step, and a width is "
                                   "their difference, N times smaller"});

  const io::Table printed = reference_table("bogomolov_zakharov_zerkal", run.record.reference_data);
  run.record.measure("speed", bore.speed());
  run.record.measure("velocity", bore.behind_velocity());
  if (run.as_published()) {
    run.record.check({.id = "printed-speed",
                      .text = "The speed that the paper prints follows from the jump conditions.",
                      .quantity = "bore speed",
                      .unit = "m/s",
                      .source = "section 4 of the paper"},
                     {.value = bore.speed()},
                     evidence::Bound{.limit = 0.05,
                                     .reason = "half a unit of the last printed digit",
                                     .expected = printed.column("bore_speed")[0]});
    run.record.check({.id = "printed-velocity",
                      .text = "So does the velocity behind the bore.",
                      .quantity = "velocity behind",
                      .unit = "m/s",
                      .source = "section 4 of the paper"},
                     {.value = bore.behind_velocity()},
                     evidence::Bound{.limit = 0.05,
                                     .reason = "half a unit of the last printed digit",
                                     .expected = printed.column("bore_velocity")[0]});
  }

  follow(run, bore, discretisation.particles, discretisation.time_step, steps);
  run.progress(0.5);
  report_contest(run.record, problem, time, contest_all(problem, discretisation, all_schemes, time, &front));
}

}  // namespace

Case moving_bore() {
  Case c;
  c.title = "A bore runs into still water";
  c.source = "Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method, figures 9 to 12";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      integer("particles", {120, 1200, 12000}, {12, 1e6}, "particles of equal widths over the channel"),
      real("time_step", {0.08, 0.008, 0.0008}, "s", {1e-9, 1}, "time step"),
      integer("steps", {100, 1000, 10000}, {1, 1e7}, "number of steps"),
      real("front_depth", 2.0, "m", {1e-3, 1e3}, "depth behind the bore"),
      real("still_depth", 1.0, "m", {1e-3, 1e3}, "depth of the still water ahead"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
