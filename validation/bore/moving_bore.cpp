/*
A bore of depth $h_1 = 2$ m runs into still water of depth $h_0 = 1$ m. The jump conditions

$$h_1 (u_1 - a) = h_0 (u_0 - a) = m, \qquad m (u_1 - u_0) = \tfrac{g}{2}\left(h_0^2 - h_1^2\right)$$

give the bore speed $a = \sqrt{g h_1 (h_1 + h_0)/(2 h_0)}$ and the velocity behind the bore, $u_1 = a (1 - h_0/h_1)$.
Bogomolov, Zakharov and Zerkal compute it with 120 particles and $\tau = 0.08$ s and print $a = 5.4$ and $u_1 = 2.7$ m/s
(their figures 9 to 12); both $g = 9.8$ and $9.81$ m/s² agree with those digits.

The left end is a piston moving at $u_1$.

**The rearrangement as written in the source.** Every rectangle moves with its velocity; pairs that overlap or separate
are rebuilt: in an overlap the particle of smaller density, at a gap the faster one; new depths give pressures, and
these give new velocities. If the rebuilt particle would become denser than the other, its position changes as well
(their figure 4): it takes the other's density, and its far side moves, until all pairs touch. The text leaves the
pressure at a shared side open ("the pressure scheme of [4]"); here it is the state of the rebuilt particle. Densities
within 1e-9 count as equal and sides within 1e-11 of the channel length as touching: without these tolerances a sweep
over the pairs does not end.

**What is compared.** The reconstructed profile with the exact one; the energy of the two-state reconstruction, which
must fall at the rate of the jump conditions, $D = g a (h_1 - h_0)^3/(4 h_1)$; the other variants of the method and the
comparison schemes.

**Your solver.** The channel is 120 m long, the bore starts at x = 40 m; at the left end water enters in the state
behind the bore. Depth and velocity at 8 s, `steps` times `time_step`, are scored as in `riemann`: the position of the
bore gives its speed.

**What to look at.** One particle holds the bore and hands it over to the next, by both rules. By the rearrangement as
written the depth behind the bore is not uniform: the velocity of a side combined with the pressure of one particle does
not satisfy the jump conditions. By the hand-over the depth behind is exact to all digits. Every comparison scheme
smears the bore over several cells.
*/
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/instruments/each.hpp"
#include "validation/scoring/score.hpp"
#include "validation/studies/shallow_water/bore_depths.hpp"
#include "validation/studies/shallow_water/judged_states.hpp"

namespace seiche::validation::cases::moving_bore {

namespace particles = shallow_water_particles;

constexpr double length = 120;
constexpr double start = 40;

/// What the parameters decide.
struct SetUp {
  exact::Bore bore;
  FlowProblem problem;
  Discretisation discretisation;
  long steps;
  double time;
  Front front;

  [[nodiscard]] JudgedStates states() const {
    return {.solution = {bore.gravity(), bore.behind(), bore.ahead(), start},
            .since = time,
            .end = length,
            .cells = discretisation.particles};
  }
};

SetUp set_up(const Values& values) {
  const double gravity = values.real("gravity");
  require_bore(values, "front_depth", "still_depth");
  const exact::Bore bore(gravity, values.real("still_depth"), values.real("front_depth"), 0, start);
  const Discretisation discretisation{
      .scheme = "H2", .particles = values.integer("particles"), .time_step = values.real("time_step"), .theta = 1.5};
  const long steps = values.integer("steps");
  const double time = static_cast<double>(steps) * discretisation.time_step;
  if (bore.position(time) >= length) {
    throw std::invalid_argument(
        fmt::format("steps = {} of time_step = {:g} are out of range: must end before t = {:g} s, when the bore of "
                    "front_depth = {:g} and still_depth = {:g} leaves the channel",
                    steps, discretisation.time_step, (length - start) / bore.speed(), values.real("front_depth"),
                    values.real("still_depth")));
  }
  return {bore,
          problem_of(bore, gravity, 0, length, {start}, FlowProblem::End::stream, FlowProblem::End::wall),
          discretisation,
          steps,
          time,
          {.behind = bore.behind().depth, .ahead = bore.ahead().depth, .position = bore.position(time), .reach = 30}};
}

/// Energy and particle edges step by step: D is exact, and the paths of edges show the jump as a kink.
struct History {
  std::vector<double> time;
  std::vector<double> energy;       ///< of the two-state reconstruction
  std::vector<double> mean_energy;  ///< of particle means
  std::vector<double> work;         ///< of the piston
  std::vector<std::vector<double>> edges;

  /// Largest deviation of the energy from the law of the jump conditions, with its time.
  [[nodiscard]] Worst energy_deviation(const exact::Bore& bore) const {
    Worst deviation;
    for (std::size_t k = 1; k < time.size(); ++k) {
      deviation.add(energy[k] - energy[0] - work[k] + bore.energy_loss_rate() * time[k], time[k]);
    }
    return deviation;
  }
};

struct Results {
  SetUp set_up;
  ParticleFigure figure;
  History history;
};

void draw_setup(evidence::Exhibit& exhibit, const exact::Bore& bore) {
  const double h0 = bore.ahead().depth;
  const double h1 = bore.behind().depth;
  evidence::Axes axes{
      .x = "x [m]", .y = "elevation [m]", .x_min = 0, .x_max = length, .y_min = -0.1, .y_max = 1.5 * h1};
  auto& piston =
      add_panel(exhibit, "setup-piston", "Bore driven by a piston",
                "The piston at the left moves at the velocity of the water behind the bore.", axes, {"bzz-fig-9"});
  const std::vector<double> x{start, start, start + 30, start + 30, length};
  piston.fill("water", x, std::vector<double>{0, h1, h1, h0, h0}, Role::water);
  piston.line("piston", std::vector<double>{start, start}, std::vector<double>{0, 1.3 * h1}, Role::guide);
  piston.line("bed", std::vector<double>{0, length}, std::vector<double>{0, 0}, Role::bed);

  axes.title = fmt::format("behind u = {:.3f} m/s, ahead at rest", bore.behind_velocity());
  auto& panel =
      add_panel(exhibit, "setup", "Bore: initial state", "Depths and velocities at t = 0.", axes, {"bzz-fig-10"});
  panel.fill("water", std::vector<double>{0, start, start, length}, std::vector<double>{h1, h1, h0, h0}, Role::water);
  panel.line("bed", std::vector<double>{0, length}, std::vector<double>{0, 0}, Role::bed);
}

particles::ParticleFlow initial_flow(const SetUp& s) {
  const exact::Bore& bore = s.bore;
  return {particles::bore(bore.gravity(), 0, start, length, bore.behind().depth, bore.ahead().depth,
                          static_cast<std::size_t>(s.discretisation.particles)),
          {.left = particles::Piston{[u1 = bore.behind_velocity()](double) { return u1; }}, .right = particles::Wall{}},
          {.gravity = bore.gravity()}};
}

History follow(const SetUp& s) {
  particles::ParticleFlow flow = initial_flow(s);
  // The piston works with the thrust of the water behind the bore.
  const double power = shallow_water::thrust(s.bore.gravity(), s.bore.behind().depth) * s.bore.behind_velocity();
  History history;
  const auto note = [&] {
    history.time.push_back(flow.time());
    history.energy.push_back(flow.energy());
    history.mean_energy.push_back(flow.mean_energy());
    history.work.push_back(power * flow.time());
    const auto& edge = flow.particles().edge;
    history.edges.emplace_back(edge.begin(), edge.end());
  };
  note();
  for (long k = 1; k <= s.steps; ++k) {
    flow.advance(s.discretisation.time_step);
    note();
  }
  return history;
}

void draw_history(evidence::Exhibit& exhibit, const History& history, const exact::Bore& bore) {
  auto& energy = add_panel(
      exhibit, "energy", "Energy against time",
      "Energy minus the work of the piston. The energy of the two-state reconstruction falls along the straight line "
      "of the jump conditions; the energy of particle means fluctuates as the transition particle fills.",
      {.x = "t [s]", .y = "energy - work - E(0) [m$^4$/s$^2$]"});
  const auto less_work = [&](std::vector<double> values) {
    const double first = values.front();
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = values[k] - history.work[k] - first;
    return values;
  };
  energy.line("-D t", history.time, each(history.time, [&](double t) { return -bore.energy_loss_rate() * t; }),
              Role::exact);
  energy.points("two-state reconstruction", history.time, less_work(history.energy), Role::computed);
  energy.line("particle means", history.time, less_work(history.mean_energy), Role::peer);

  auto& paths = add_panel(exhibit, "paths", "Paths of particle edges",
                          "Each line is an edge in the (x, t) plane; the bore is the line along which the edges bend.",
                          {.x = "x [m]", .y = "t [s]", .x_min = 30, .x_max = 90});
  const std::size_t edges = history.edges.front().size();
  for (std::size_t e = edges / 4; e < edges * 3 / 4; e += 2) {
    paths.line(e == edges / 4 ? "edges" : "", each(history.edges, [&](const auto& row) { return row[e]; }),
               history.time, Role::computed);
  }
  paths.line("exact bore", each(history.time, [&](double t) { return bore.position(t); }), history.time, Role::exact);
}

void claims(const Values& values, const Claims<Results>& claims) {
  const SetUp s = set_up(values);
  const auto steps = static_cast<double>(s.steps);
  const auto figure = claims.of(&Results::figure);
  const auto flow = figure.of(&ParticleFigure::flow);
  claim_conservation(flow, s.problem, s.discretisation, s.time);
  claim_exact_profile(flow, s.bore.behind().depth, s.discretisation, s.time);
  claim_single_particle(flow, s.front);
  claim_as_written(figure.of(&ParticleFigure::as_written), values, "bzz-fig-12", s.problem, s.discretisation, s.time,
                   s.front.behind - s.front.ahead, &s.front);
  claim_range(flow, s.front.ahead, s.front.behind, s.discretisation, s.time, "the bore is monotone");
  const std::string resolution =
      fmt::format("N = {}, tau = {:g} s", s.discretisation.particles, s.discretisation.time_step);
  claim_states(flow.at(resolution), s.states(), length / static_cast<double>(s.discretisation.particles));
  claims.at(resolution)
      .where("t = {:g} s")
      .from("D = g a (h1 - h0)^3/(4 h1), Stoker (1957), 10.6")
      .check(
          "energy", "The energy decay equals the rate of the jump conditions to round-off.",
          "largest deviation of the two-state energy [m^4/s^3 s]",
          [s](const Results& r) { return r.history.energy_deviation(s.bore); },
          Roundoff{.operations = static_cast<double>(s.discretisation.particles) + steps,
                   .scale = initial_flow(s).energy(),
                   .reason = "energy is a sum over particles, of the size of its value; one rounding per step"});

  const io::Table printed = values.table("bogomolov_zakharov_zerkal");
  const auto published =
      claims.only_if(values.as_published("bzz-fig-12"), "the paper prints it for its own parameters");
  const auto follows = [&](const std::string& id, const std::string& name, const std::string& quantity,
                           const std::string& column, double (exact::Bore::*number)() const) {
    published.check(
        id,
        fmt::format("The {} from the jump conditions agrees with the printed one within half a unit of its last digit, "
                    "0.05 m/s.",
                    name),
        quantity + " [m/s]", [number](const Results& r) { return (r.set_up.bore.*number)(); },
        Bound{.limit = 0.05, .reason = "half a unit of the last printed digit", .expected = printed.column(column)[0]});
  };
  follows("printed-speed", "bore speed", "bore speed", "bore_speed", &exact::Bore::speed);
  follows("printed-velocity", "velocity behind the bore", "velocity behind", "bore_velocity",
          &exact::Bore::behind_velocity);
}

Results compute(const Run& run) {
  const SetUp s = set_up(run);
  return {s, compute_figure(run, s.problem, s.discretisation, {0, 0.5 * s.time, s.time}, s.front), follow(s)};
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  const SetUp& s = r.set_up;
  draw_setup(exhibit, s.bore);
  draw_exact(exhibit.figure("exact", "The exact bore", fmt::format("Depth and velocity at t = {:g} s.", s.time),
                            {"bzz-fig-11"}),
             s.problem, s.time);
  show_figure(r.figure, exhibit, "Bore into still water", {"bzz-fig-12"});
  draw_history(exhibit, r.history, s.bore);
  measure_own(wanted_states(s.states()), submitted_profile(r.figure.flow.profile()), exhibit);
}

void moving_bore(Case& c) {
  c.title = "Bore into still water";
  c.source = literature::bogomolov + ", figures 9 to 12";
  c.parameters = {
      integer("particles", {120, 1200, 12000}, {12, 1e6}, "particles of equal widths over the channel"),
      real("time_step", {0.08, 0.008, 0.0008}, "s", {1e-9, 1}, "time step"),
      integer("steps", {100, 1000, 10000}, {1, 1e7}, "number of steps"),
      real("front_depth", 2.0, "m", {1e-3, 1e3}, "depth behind the bore"),
      real("still_depth", 1.0, "m", {1e-3, 1e3}, "depth of the still water ahead"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
      rearrangement(),
  };
  c.published = {{.tiles = {"bzz-fig-12", "bzz-fig-9", "bzz-fig-10", "bzz-fig-11"},
                  .stated = {"particles", "time_step", "steps", "front_depth", "still_depth", "rearrangement"}}};
  c.study = Study(claims, compute, show, "section 4 of the paper");
  c.former_names = {"rearrangement_literal"};
  c.submission = submission_of([](const Values& values) { return set_up(values).states(); });
}

}  // namespace seiche::validation::cases::moving_bore
