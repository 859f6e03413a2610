#include "validation/dam_break/wet_dam_break.hpp"

#include <fmt/format.h>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "validation/instruments/exact/dam_break.hpp"

namespace seiche::validation {

std::vector<Parameter> wet_dam_break_parameters(ByTier<long> particles, ByTier<double> time_step) {
  return {integer("particles", particles, {10, 1e6}, "particles over the whole channel, of equal widths"),
          real("time_step", time_step, "s", {1e-6, 10}, "time step"),
          real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"), rearrangement()};
}

namespace {

/// What the parameters decide.
struct SetUp {
  FlowProblem problem;
  Discretisation discretisation;
  double time;
  Front front;
};

SetUp set_up(const WetDamBreak& setup, const Values& values) {
  const double gravity = values.real("gravity");
  const double time = setup.times.back();
  const exact::Stoker stoker(gravity, 1, setup.ratio, setup.dam);
  return {.problem = problem_of(stoker, gravity, 0, setup.length, {setup.dam}),
          .discretisation = {.scheme = "H2",
                             .particles = values.integer("particles"),
                             .time_step = values.real("time_step"),
                             .theta = 1.5},
          .time = time,
          .front = {.behind = stoker.plateau().depth,
                    .ahead = setup.ratio,
                    .position = stoker.bore_position(time),
                    .reach = 0.5 * (stoker.bore_position(time) - stoker.fan_end(time))}};
}

}  // namespace

void claim_wet_dam_break(const WetDamBreak& setup, const Values& values, const Claims<ParticleFigure>& claims) {
  const SetUp s = set_up(setup, values);
  const auto flow = claims.of(&ParticleFigure::flow).at(s.discretisation.text());
  claim_conservation(flow, s.problem, s.discretisation, s.time);
  claim_single_particle(flow, s.front);
  claim_as_written(claims.of(&ParticleFigure::as_written), values, setup.atlas.front(), s.problem, s.discretisation,
                   s.time, 1 - setup.ratio, &s.front, setup.misses);
  claim_range(flow, setup.ratio, 1, s.discretisation, s.time, "maximum principle of the two fields");
  flow.only_if(values.as_published(setup.atlas.front()), "of the particles and steps of the figure")
      .from("Stoker, Water Waves (1957), 10.8")
      .check(
          "cell_l1_h",
          "The mean error of cell depths is below the error of the exact profile moved by one particle width.",
          "cell L1(h) [m]", [](const FlowRun& run) { return run.errors.cell.depth.l1; },
          Bound{.limit = (1 - setup.ratio) / static_cast<double>(s.discretisation.particles),
                .reason =
                    "the exact depth falls from 1 m to h0: moved by the width of one of N particles it differs by "
                    "(1 m - h0)/N in the mean"});
}

ParticleFigure compute_wet_dam_break(const WetDamBreak& setup, const Run& run) {
  const SetUp s = set_up(setup, run);
  return compute_figure(run, s.problem, s.discretisation, setup.times, s.front, setup.schemes);
}

}  // namespace seiche::validation
