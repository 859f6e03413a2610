/*
Two bores, of depths 2 m and 1.5 m, run towards each other through still water 1 m deep. They meet at $t_c = 4.118$ s;
afterwards two weaker bores enclose water 2.697 m deep, the middle state of the Riemann problem between the two states
behind the bores.

Both ends are pistons; for your solver, inflow ends of a channel from 0 to 100 m. The bores start at 30 and 70 m.

**What is compared.** The profile 2 s after the collision, for several numbers of particles and the three variants of
the method. External profiles are scored as in `riemann`.

**What to look at.** During the collision two bores share a particle. A method that falls back to smeared bores there
leaves an error at the collision point that decays only as $1/N$; here the particle holds both incident bores, then both
outgoing ones.
*/
#include "seiche/exact/shallow_water/riemann.hpp"
#include "validation/case/case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/scoring/score.hpp"
#include "validation/studies/shallow_water/bore_depths.hpp"
#include "validation/studies/shallow_water/judged_states.hpp"

namespace seiche::validation::cases::colliding_bores {

/// What the parameters decide.
struct SetUp {
  exact::CollidingBores bores;
  FlowProblem problem;
  double time;
  std::vector<long> particles;

  [[nodiscard]] Discretisation level(const std::string& scheme, long count) const {
    return {.scheme = scheme, .particles = count, .theta = 1.5};
  }
  [[nodiscard]] Discretisation finest() const { return level("H2", particles.back()); }
  [[nodiscard]] JudgedStates states() const {
    return {.solution = {problem.gravity, bores.left(), bores.right(), bores.collision_place()},
            .since = time - bores.collision_time(),
            .start = problem.start,
            .end = problem.end,
            .cells = particles.back()};
  }
};

SetUp set_up(const Values& values) {
  const double gravity = values.real("gravity");
  require_bore(values, "left_depth", "still_depth");
  require_bore(values, "right_depth", "still_depth");
  const exact::CollidingBores bores(gravity, values.real("left_depth"), values.real("still_depth"),
                                    values.real("right_depth"), 30, 70);
  using End = FlowProblem::End;
  const long n = values.integer("particles");
  return {bores,
          problem_of(bores, gravity, 0, 100, {30, 70}, End::stream, End::stream),
          bores.collision_time() + values.real("after"),
          {n, 2 * n, 4 * n}};
}

struct Results {
  SetUp set_up;
  FlowRun flow;
  std::vector<std::vector<Contestant>> levels;  ///< by number of particles, then by level

  [[nodiscard]] const Contestant& finest() const { return levels.back().back(); }
};

void claims(const Values& values, const Claims<Results>& claims) {
  const SetUp s = set_up(values);
  const auto particles = static_cast<double>(s.finest().particles);
  claim_conservation(claims.of(&Results::flow), s.problem, s.finest(), s.time);
  const auto here = claims.at(s.finest().text());
  claim_states(here.of(&Results::flow), s.states(), s.problem.length() / particles);
  here.check(
      "reconstructed_l1_h", "The profile after the collision equals the exact solution to round-off.",
      "reconstructed L1(h) [m]",
      [particles](const Results& r) -> Measurement {
        return {.value = r.finest().errors.reconstructed.depth.l1,
                .told = {.operations = 8 * particles * static_cast<double>(r.finest().steps)}};
      },
      Roundoff{.operations = Amount::told_by_run(8 * particles * most_steps(s.problem, s.finest(), s.time)),
               .scale = s.bores.star().depth,
               .reason = "both bores are tracked through the particle they share: eight rounded operations per step, "
                         "and per particle that a bore has passed"});
}

Results compute(const Run& run) {
  Results r{.set_up = set_up(run)};
  const SetUp& s = r.set_up;
  r.flow = compute_flow(s.problem, s.finest(), {0.7 * s.bores.collision_time(), s.time},
                        [&](double done) { run.progress(0.5 * done); });
  for (const long particles : s.particles) {
    r.levels.push_back(contest_all(s.problem, s.level("", particles), particle_schemes, s.time, nullptr));
  }
  return r;
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  const SetUp& s = r.set_up;
  draw_flow(r.flow, exhibit, "Collision of two bores", {});
  evidence::Table& table = add_table(exhibit, "levels", "Error of the levels", "Cell L1(h) after the collision.",
                                     {"particles", "G1 [m]", "M2 [m]", "H2 [m]", "H2 reconstructed [m]"});
  for (std::size_t k = 0; k < r.levels.size(); ++k) {
    std::vector<Cell>& row = table.rows.emplace_back(1, static_cast<double>(s.particles[k]));
    for (const Contestant& level : r.levels[k]) row.emplace_back(level.errors.cell.depth.l1);
    row.emplace_back(r.levels[k].back().errors.reconstructed.depth.l1);
  }
  auto& panel =
      add_panel(exhibit, "convergence", "Error against the number of particles", "Cell L1(h) 2 s after the collision.",
                {.x = "particles", .y = "cell L1(h) [m]", .log_x = true, .log_y = true});
  const std::vector<double> counts(s.particles.begin(), s.particles.end());
  for (std::size_t level = 0; level < particle_schemes.size(); ++level) {
    panel.points(particle_schemes[level], counts,
                 each(r.levels, [&](const auto& one) { return one[level].errors.cell.depth.l1; }), Role::computed);
  }
  exhibit.measure("max_courant", r.flow.max_courant);
  measure_own(wanted_states(s.states()), submitted_profile(r.flow.profile()), exhibit);
  exhibit.measure("collision_time", s.bores.collision_time());
  exhibit.measure("collision_place", s.bores.collision_place());
  exhibit.measure("star_depth", s.bores.star().depth);
  exhibit.measure("star_velocity", s.bores.star().velocity);
}

void colliding_bores(Case& c) {
  c.title = "Collision of two bores";
  c.source =
      "J. J. Stoker, Water Waves, 1957, 10.7; E. F. Toro, Shock-capturing methods for free-surface shallow flows, 2001";
  c.parameters = {
      integer("particles", {50, 400, 1600}, {20, 1e6},
              "smallest number of particles; twice and four times as many run too"),
      real("left_depth", 2.0, "m", {1e-3, 1e3}, "depth behind the left bore"),
      real("still_depth", 1.0, "m", {1e-3, 1e3}, "depth of the still water between"),
      real("right_depth", 1.5, "m", {1e-3, 1e3}, "depth behind the right bore"),
      real("after", 2.0, "s", {0.01, 10}, "time after the collision"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
  };
  c.study = Study(claims, compute, show, "Riemann problem of the states behind the bores");
  c.submission = submission_of([](const Values& values) { return set_up(values).states(); });
}

}  // namespace seiche::validation::cases::colliding_bores
