/*
The dam break of ratio 0.1 in a channel of 200 m by difference schemes: Lax-Friedrichs, MacCormack and first-order
upwind,
$\Delta x = 1$ m, at $t = 25$ s (figure 24 of Bogomolov, Zakharov and Zerkal), and beside them what is used today: a
limited second-order scheme with the HLL flux.

**What is compared.** Mean depths and the position and width of the bore, at $\tau = 0.05$ s.

**What to look at.** Lax-Friedrichs smears the bore over forty cells; MacCormack oscillates behind it; the upwind scheme
rounds the corners of the fan. Compare with 200 and 22 particles in the next two cases.
*/
#include <algorithm>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/shallow_water/flow_run.hpp"

namespace seiche::validation::cases::long_dam_break_schemes {
namespace {

/// What the parameters decide.
struct SetUp {
  FlowProblem problem;
  double time;
  Front front;
  Discretisation discretisation;

  [[nodiscard]] Discretisation by(const std::string& scheme) const {
    Discretisation d = discretisation;
    d.scheme = scheme;
    return d;
  }
  [[nodiscard]] Discretisation roe() const {
    Discretisation d = by("roe");
    d.theta = Discretisation{}.theta;
    return d;
  }
};

SetUp set_up(const Values& values) {
  const double gravity = values.real("gravity");
  const double time = values.real("time");
  const exact::Stoker stoker(gravity, 1, 0.1, 100);
  return {
      .problem = problem_of(stoker, gravity, 0, 200, {100}),
      .time = time,
      .front = {.behind = stoker.plateau().depth, .ahead = 0.1, .position = stoker.bore_position(time), .reach = 40},
      .discretisation = {.particles = values.integer("cells"), .time_step = values.real("time_step"), .theta = 1.5}};
}

struct Results {
  SetUp set_up;
  std::vector<Contestant> contestants;
  FlowRun roe;
};

void claims(const Values& values, const Claims<Results>& claims) {
  const SetUp s = set_up(values);
  const auto muscl = std::ranges::find(peer_schemes, "muscl") - peer_schemes.begin();
  claims.only_if(values.as_published("bzz-fig-24"), "of the cells and steps of the figure")
      .at(s.by("muscl").text())
      .from("Stoker, Water Waves (1957), 10.8")
      .check(
          "cell_l1_h_muscl", "Mean depths of the limited second-order scheme are within a cell of the exact profile.",
          "cell L1(h) [m]",
          [muscl](const Results& r) { return r.contestants.at(static_cast<std::size_t>(muscl)).errors.cell.depth.l1; },
          Bound{.limit = 0.9 / static_cast<double>(s.discretisation.particles),
                .reason = "the exact depth falls from 1 m to 0.1 m: moved by the width of one of N cells it differs by "
                          "0.9 m/N in the mean"});
  claim_conservation(claims.of(&Results::roe), s.problem, s.roe(), s.time, "_roe");
}

Results compute(const Run& run) {
  Results r{.set_up = set_up(run)};
  const SetUp& s = r.set_up;
  r.contestants = contest_all(s.problem, s.discretisation, peer_schemes, s.time, &s.front,
                              [&](double done) { run.progress(done); });
  r.roe = compute_flow(s.problem, s.roe(), {s.time}, [](double) {});
  return r;
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  report_contest(exhibit, r.set_up.problem, r.set_up.time, r.contestants, {"bzz-fig-24"});
  show_conservation(r.roe, exhibit, "_roe");
}

}  // namespace

Case long_dam_break_schemes() {
  Case c;
  c.title = "Dam break in a long channel by difference schemes";
  c.source = "Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method, figure 24";
  c.parameters = {
      integer("cells", 200L, {20, 1e6}, "cells over the channel"),
      real("time_step", 0.05, "s", {1e-9, 1}, "time step"),
      real("time", 25.0, "s", {0.1, 30}, "end of the run"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
  };
  c.published = {{.tiles = {"bzz-fig-24"}, .differs = "the paper does not state the depth behind the dam: 1 m"}};
  c.study = Study(claims, compute, show);
  return c;
}

}  // namespace seiche::validation::cases::long_dam_break_schemes
