/*
The dam break of ratio 0.1 in a channel of 200 m by difference schemes: Lax-Friedrichs, MacCormack and first-order
upwind,
$\Delta x = 1$ m, at $t = 25$ s (figure 24 of Bogomolov, Zakharov and Zerkal), and beside them what is used today: a
limited second-order scheme with the HLL flux.

**What is compared.** Mean depths and the position and width of the bore, at $\tau = 0.05$ s.

**What to look at.** Lax-Friedrichs smears the bore over forty cells; MacCormack oscillates behind it; the upwind scheme
rounds the corners of the fan. Compare with 200 and 22 particles in the next two cases.
*/
#include <fmt/format.h>

#include "seiche/exact/dam_break.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/shallow_water/flow_evidence.hpp"

namespace seiche::validation::cases {
namespace {

/// Errors and widths that an independent implementation of the schemes measured.
struct Known {
  const char* scheme;
  double cell_l1_h;
};
constexpr Known known[] = {{"lax_friedrichs", 4.5e-2}, {"maccormack", 6.0e-3}, {"roe", 8.2e-3}, {"muscl", 1.5e-3}};

void run(Running& run) {
  const double gravity = run.real("gravity");
  const double time = run.real("time");
  const exact::Stoker stoker(gravity, 1, 0.1, 100);
  const FlowProblem problem = problem_of(stoker, gravity, 0, 200, {100});
  const Front front{
      .behind = stoker.plateau().depth, .ahead = 0.1, .position = stoker.bore_position(time), .reach = 40};
  std::vector<Contestant> contestants;
  for (const Known& one : known) {
    const Discretisation d{
        .scheme = one.scheme, .particles = run.integer("cells"), .time_step = run.real("time_step"), .theta = 1.5};
    contestants.push_back(contest(problem, d, time, &front));
    run.progress(0.25 * static_cast<double>(contestants.size()));
    if (!run.as_published()) continue;
    claim_reproduced(run.record, fmt::format("cell_l1_h_{}", one.scheme), "cell L1(h)",
                     fmt::format("The error of {} is the known one.", one.scheme),
                     contestants.back().errors.cell.depth.l1, one.cell_l1_h, "m", d.text());
  }
  report_contest(run.record, problem, time, contestants, {"bzz-fig-24"});
  const auto flow =
      make_flow(problem, {.scheme = "roe", .particles = run.integer("cells"), .time_step = run.real("time_step")});
  flow->advance_to(time);
  claim_conservation(run.record, *flow, "_roe");
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
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
