/*
A solitary wave of height $a$ on water of depth $d$ climbs a plane beach of slope $1 : \cot\beta$. While the wave does
not break, the shallow-water equations have an exact solution: Carrier and Greenspan's transformation makes them linear,
and the extremes of its shoreline equal the extremes of linear theory,

$$R(\tau) = \int \Phi(k)\,\frac{2 e^{-ik\tau}}{J_0(2 k X_0) - i J_1(2 k X_0)}\,dk, \qquad X_0 = \cot\beta,$$

in units of $d$ and $\sqrt{d/g}$. For long beaches the maximum is Synolakis' run-up law $\mathcal R/d = 2.831
\sqrt{\cot\beta}\,(a/d)^{5/4}$.

**What is compared.** The case computes the integral and the residuals of its identities, and shows the shoreline. It
accepts external results: `seiche score carrier_greenspan_runup` takes the maximum run-up, and the shoreline elevation
as a function of time.

**What to look at.** Run-down is steeper than run-up: a wave that does not break on its way up may break on its way
back.
*/
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/solitary_runup.hpp"
#include "seiche/require.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::carrier_greenspan_runup {

exact::SolitaryRunup wave_of(const Values& values) {
  // Beaches so gentle that waves of this height break far out, and that the quadrature takes minutes.
  require_within("cot_slope sqrt(amplitude/depth)",
                 values.real("cot_slope") * std::sqrt(values.real("amplitude") / values.real("depth")), 0, 30);
  return {values.real("gravity"), values.real("depth"), values.real("amplitude"), values.real("cot_slope")};
}

/// From the crest's arrival at the toe until the wave has left the beach, or breaks.
std::vector<double> times_of(const Values& values, const exact::SolitaryRunup& wave) {
  const double beach =
      values.real("depth") * values.real("cot_slope") / std::sqrt(values.real("gravity") * values.real("depth"));
  return evenly(0, std::min(4 * beach, 0.999 * wave.breaking_time()), 201);
}

void show(const exact::SolitaryRunup& wave, const Values& values, evidence::Exhibit& exhibit) {
  exhibit.measure("runup_value", wave.highest().elevation);
  exhibit.measure("runup_time", wave.highest().time);
  exhibit.measure("law", wave.law());
  exhibit.measure("breaking_amplitude", wave.breaking_amplitude());
  exhibit.measure("reference_uncertainty", wave.uncertainty());
  auto& panel = add_panel(exhibit, "shoreline", "The shoreline",
                          "Shoreline elevation; the crest is at the toe of the beach at t = 0.",
                          {.x = "t [s]", .y = "elevation [m]"});
  const std::vector<double> times = times_of(values, wave);
  panel.line("exact", times, each(times, [&](double t) { return wave.shoreline(t).elevation; }), Role::exact);
  const std::vector<double> ends{times.front(), times.back()};
  panel.line("run-up law", ends, std::vector<double>(2, wave.law()), Role::guide);
}

std::vector<WantedTable> wanted(const Values& values) {
  const Lazy<exact::SolitaryRunup> wave([values] { return wave_of(values); });
  const std::string source = "Synolakis (1987)";
  const std::function<double()> highest = [wave] { return wave->highest().elevation; };
  return {
      {.name = "scalars",
       .quantities = {wanted_number({"runup", "m", "maximum shoreline elevation above still water"}, highest, values,
                                    "Maximum run-up agrees with the exact solution within the tolerance.", source)}},
      {.name = "shoreline",
       .kind = WantedTable::Kind::series,
       .abscissa = Column{"t", "s", "time since the crest was at the toe"},
       .quantities = {{.column = {"eta", "m", "elevation of the shoreline"},
                       .reference = [wave](Place p) { return wave->shoreline(p.abscissa).elevation; },
                       .requirements = {within_tolerance(
                           Measure::relative_l2, values,
                           "The shoreline elevation agrees with the exact solution at all times.", source)}}},
       .points = [wave, values](double) { return times_of(values, *wave); }}};
}

void carrier_greenspan_runup(Case& c) {
  c.title = "Run-up of a solitary wave on a plane beach: exact solution";
  c.source = literature::synolakis + "; G. F. Carrier, H. P. Greenspan, J. Fluid Mech. 4 (1958) 97";
  c.parameters = {
      real("amplitude", 0.019, "m", {1e-9, 1e6}, "crest height of the incident wave"),
      real("depth", 1.0, "m", {1e-6, 1e6}, "depth before the beach"),
      real("cot_slope", 19.85, "1", {0.1, 1e3}, "s of the beach slope 1:s"),
      real("gravity", 9.81, "m/s^2", {1e-6, 1e6}, "acceleration of gravity"),
      tolerance_parameter(),
  };
  c.study = exact_study<wave_of, show>("Synolakis (1987)");
  c.submission = {.tables = wanted};
}

}  // namespace seiche::validation::cases::carrier_greenspan_runup
