/*
A patch of surface pressure, a hovercraft for example, travels along a channel at the long-wave celerity. Linear waves
cannot outrun it; energy accumulates until it leaves ahead, as a train of solitons faster than the source. Lengths are
over the depth, speeds over $\sqrt{gH}$, so that speed 1 is critical.

**Set-up.** $p = p_0 \cos^2(\pi z/2w)$ for $|z| < w$, $z = x - Ut$, ramped up over five time units, on still water
between walls too distant for reflections. Pressure acts on every segment of the surface, normal to it.

**What is compared.** The leading soliton with Serre's solitary wave: a speed of $\sqrt{1 + a}$ for its height $a$. For
sources with known results, the regime: number and height of the solitons, and the period of the surface at the source.
Try `--set p0=-0.1 --set half_width=6.5 --set time=800`: no soliton at all.

**What to look at.** The ridge plot, in the frame of the source: solitons lean to the right because they are faster.
*/
#include <limits>

#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/moving_pressure/pressure_regimes.hpp"

namespace seiche::validation::cases::moving_pressure_1d {

std::pair<PressureSource, PressureRun> set_up(const Values& values) {
  return {
      {.pressure = values.real("p0"), .half_width = values.real("half_width"), .speed = values.real("speed")},
      {.time = values.real("time"), .spacing = values.real("h"), .tau = values.real("tau_over_h") * values.real("h")}};
}

void claims(const Values& values, const Claims<PressureWaves>& claims) {
  const auto [source, run] = set_up(values);
  const auto regime = pressure_regime_of(source, run);
  const bool known = source.pressure >= 0.1 && source.speed >= 0.95 && source.speed <= 1 && source.half_width >= 1 &&
                     source.half_width <= 8 && run.time >= 100;
  claim_leading_soliton(
      claims.only_if(regime ? regime->solitons : known,
                     "the number of escaped solitons is known for pressure p0 >= 0.1 with half-widths from 1 to 8 at "
                     "speeds from 0.95 to 1 and t >= 100, and for the regimes of moving_pressure_regimes"),
      "leader", source, run);
  if (regime) claim_pressure_regime(claims, *regime, run);
  claims.at(run.text())
      .check("endless", "The elevation at the wall ahead stays below an ulp of the depth, 2.2e-16 H.",
             "largest elevation at the wall ahead, at any time [H]", &PressureWaves::largest_at_wall,
             Bound{.limit = std::numeric_limits<double>::epsilon(),
                   .reason = "an ulp of the depth: a smaller elevation is indistinguishable from zero"});
}

PressureWaves compute(const Run& run) {
  const auto [source, resolution] = set_up(run);
  return {source, resolution, [&](double part) { run.progress(part); }};
}

void show(const PressureWaves& waves, const Values& values, evidence::Exhibit& exhibit) {
  show_pressure_waves(exhibit, "", "leader", waves, values.real("threshold"));
  auto& figure = exhibit.figure(
      "waves", "Waves of the source",
      "Surfaces stacked with time upwards, in the frame of the source; and the elevation at its centre.");
  waves.draw_ridges(figure);
  waves.draw_at_source(figure);
}

void moving_pressure_1d(Case& c) {
  c.title = "Solitons ahead of a pressure patch at the critical speed";
  c.source = literature::frank + ", section 3.3; T. Y. Wu, J. Fluid Mech. 184 (1987) 75";
  c.parameters = {
      real("p0", 0.1, "rho g H", {-0.5, 0.5}, "pressure at the centre of the source; negative for suction"),
      real("half_width", 4.0, "H", {0.25, 50}, "half-width of the source"),
      real("speed", 1.0, "(g H)^(1/2)", {0.1, 2}, "speed of the source"),
      real("time", 150.0, "(H/g)^(1/2)", {20, 1e4}, "length of the run"),
      real("h", 0.25, "H", {0.02, 0.5}, "node spacing at rest"),
      real("tau_over_h", 0.25, "(g H)^(-1/2)", {0.01, 0.7}, "time step over the node spacing"),
      real("threshold", soliton_threshold, "H", {1e-4, 1},
           "an elevation above this, ahead of the source, is a soliton"),
  };
  c.study = Study(claims, compute, show, "set-up");
}

}  // namespace seiche::validation::cases::moving_pressure_1d
