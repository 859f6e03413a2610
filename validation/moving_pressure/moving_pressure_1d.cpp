/*
A patch of surface pressure, a hovercraft say, travels along a channel at the speed of long waves. Its waves cannot
outrun it linearly; the energy piles up until it leaves forward, as a train of solitons faster than the source. Lengths
are in depths, speeds in $\sqrt{gH}$, so that speed 1 is the critical one.

**Set-up.** $p = p_0 \cos^2(\pi z/2w)$ for $|z| < w$, $z = x - Ut$, grown from nothing during five units of time, on
still water between walls that no wave reaches back from. Pressure acts on every segment of the surface, normal to it.

**What is compared.** The leading soliton with Serre's solitary wave: its speed must be $\sqrt{1 + a}$ for its height
$a$. For a source whose numbers are known, its regime: how many solitons have left, how high they are, and the period of
the surface at the source. Try `--set p0=-0.1 --set half_width=6.5 --set time=800`: no soliton at all.

**What to look at.** The ridge plot, in the frame of the source: solitons lean to the right because they are faster.
*/
#include "validation/case/case.hpp"
#include "validation/moving_pressure/pressure_regimes.hpp"

namespace seiche::validation::cases {
namespace {

void run(Running& run) {
  const double threshold = run.real("threshold");
  const PressureWaves waves(
      {.pressure = run.real("p0"), .half_width = run.real("half_width"), .speed = run.real("speed")},
      {.time = run.real("time"), .spacing = run.real("h"), .tau = run.real("tau_over_h") * run.real("h")},
      [&](double part) { run.progress(part); });
  measure_pressure_waves(run.record, "", waves, threshold);
  claim_leading_soliton(run.record, "leader", waves, threshold);
  if (const auto regime = pressure_regime_of(waves.source(), waves.run())) {
    claim_pressure_regime(run.record, *regime, waves);
  }
  auto& figure = run.record.figure("waves", "Waves of the source",
                                   "Surfaces one above the other, time upwards, in the frame of the source; and the "
                                   "elevation at its centre.");
  waves.draw_ridges(figure);
  waves.draw_at_source(figure);
}

}  // namespace

Case moving_pressure_1d() {
  Case c;
  c.title = "A pressure patch at the critical speed sends solitons ahead";
  c.source =
      "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), section 3.3; T. Y. Wu, J. Fluid "
      "Mech. 184 (1987) 75";
  c.parameters = {
      real("p0", 0.1, "rho g H", {-0.5, 0.5}, "pressure at the centre of the source; negative for suction"),
      real("half_width", 4.0, "H", {0.25, 50}, "half of the width of the source"),
      real("speed", 1.0, "(g H)^(1/2)", {0.1, 2}, "speed of the source"),
      real("time", 150.0, "(H/g)^(1/2)", {20, 1e4}, "length of the run"),
      real("h", 0.25, "H", {0.02, 0.5}, "distance of markers at rest"),
      real("tau_over_h", 0.25, "(g H)^(-1/2)", {0.01, 0.7}, "time step over the distance of markers"),
      real("threshold", soliton_threshold, "H", {1e-4, 1}, "what is higher, ahead of the source, is a soliton"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
