#include "validation/dam_break/wet_dam_break.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/dam_break.hpp"

namespace seiche::validation {

std::vector<Parameter> wet_dam_break_parameters(ByTier<long> particles, ByTier<double> time_step) {
  return {integer("particles", particles, {10, 1e6}, "particles over the whole channel, of equal widths"),
          real("time_step", time_step, "s", {1e-6, 10}, "time step"),
          real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity")};
}

void run_wet_dam_break(Running& run, const WetDamBreak& setup) {
  const double gravity = run.real("gravity");
  const double time = setup.times.back();
  const exact::Stoker stoker(gravity, 1, setup.ratio, setup.dam);
  const FlowProblem problem = problem_of(stoker, gravity, 0, setup.length, {setup.dam});
  const Discretisation particles{
      .scheme = "H2", .particles = run.integer("particles"), .time_step = run.real("time_step"), .theta = 1.5};
  const auto flow = run_and_draw(run.record, problem, particles, setup.times,
                                 fmt::format("Dam break over water, h0/h1 = {:g}", setup.ratio), setup.atlas,
                                 [&](double done) { run.progress(0.5 * done); });
  claim_conservation(run.record, *flow);

  const Profile profile = flow->profile();
  const ProfileErrors errors = profile_errors(profile, problem, time);
  measure_errors(run.record, errors);
  const Front front{.behind = stoker.plateau().depth,
                    .ahead = setup.ratio,
                    .position = stoker.bore_position(time),
                    .reach = 0.5 * (stoker.bore_position(time) - stoker.fan_end(time))};
  claim_single_particle(run.record, *flow, front);
  run.record.check(
      {.id = "range",
       .text = "No depth leaves the range of the exact solution.",
       .quantity = "largest depth outside the range",
       .unit = "m",
       .source = "maximum principle of the two fields"},
      {.value = excursion(profile, setup.ratio, 1), .resolution = particles.text()},
      evidence::Bound{.limit = 1e-5,
                      .reason = "the exact solution is monotone; a hand-over in a disturbed neighbourhood may "
                                "overshoot by the disturbance, of the size of the start-up error squared"});
  if (run.as_published()) {
    claim_reproduced(run.record, "cell_l1_h", "cell L1(h)", "The mean depths have the known error.",
                     errors.cell.depth.l1, setup.cell_l1_h, "m", particles.text());
  }

  report_contest(run.record, problem, time,
                 contest_all(problem, particles, setup.schemes, time, &front,
                             [&](double done) { run.progress(0.5 + 0.5 * done); }));
}

}  // namespace seiche::validation
