/*
A piston, or a flap hinged at the bed, starts to oscillate in water at rest. Linear theory gives the exact transient: an
integral over wavenumbers that tends to the progressive wave of the wavemaker's transfer function, with a near field
that decays from the paddle.

**What is compared.** The case shows the elevation at a gauge and the settled wave. It accepts external results, the
elevation at the gauge: `seiche score wavemaker_start`.

**What to look at.** The first waves at a gauge one wavelength away differ from the settled wave: the front disperses,
the second crest is too low and the third too high. A comparison over a few periods must use the transient.
*/
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/wavemaker.hpp"
#include "seiche/require.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::wavemaker_start {

const std::string source = "Havelock (1929); Dean and Dalrymple (1991), ch. 6";

exact::WavemakerTransient start_of(const Values& values) {
  // Waves of 600 depths: the panels of the quadrature over the periods grow with the period.
  constexpr double longest = 600;
  require_within("period sqrt(gravity/depth)",
                 values.real("period") * std::sqrt(values.real("gravity") / values.real("depth")), 0, longest);
  return exact::WavemakerTransient(values.text("paddle") == "piston" ? exact::Paddle::piston : exact::Paddle::flap,
                                   {values.real("gravity"), values.real("depth")}, exact::Period{values.real("period")},
                                   values.real("stroke"));
}

double gauge_of(const Values& values) {
  const double gauge = values.real("gauge");
  return gauge > 0 ? gauge : start_of(values).steady().wavelength();
}

std::vector<double> times_of(const Values& values) {
  const double end = values.real("periods") * values.real("period");
  return evenly(0, end, 40 * static_cast<int>(values.real("periods")) + 1);
}

void show(const exact::WavemakerTransient& start, const Values& values, evidence::Exhibit& exhibit) {
  exhibit.measure("reference_uncertainty", start.uncertainty());
  exhibit.measure("wave_height", start.steady().wave_height());
  exhibit.measure("wavelength", start.steady().wavelength());
  const double gauge = gauge_of(values);
  auto& panel = add_panel(exhibit, "gauge", "Elevation at the gauge",
                          fmt::format("{:.4g} m from the paddle: the start from rest, and the settled wave.", gauge),
                          {.x = "t [s]", .y = "elevation [m]"});
  const std::vector<double> times = times_of(values);
  panel.line("start from rest", times, each(times, [&](double t) { return start.elevation(gauge, t); }), Role::exact);
  panel.line("settled", times, each(times, [&](double t) { return start.steady().elevation(gauge, t); }), Role::guide);
}

std::vector<WantedTable> wanted(const Values& values) {
  const auto start = std::make_shared<const exact::WavemakerTransient>(start_of(values));
  const double gauge = gauge_of(values);
  const std::vector<double> times = times_of(values);
  return {
      {.name = "gauge",
       .kind = WantedTable::Kind::series,
       .abscissa = Column{"t", "s", "time since the start from rest"},
       .quantities = {{.column = {"eta", "m", fmt::format("surface elevation at x = {:.6g} m", gauge)},
                       .reference = [start, gauge](Place p) { return start->elevation(gauge, p.abscissa); },
                       .requirements = {within_tolerance(
                           Measure::relative_l2, values,
                           "The elevation at the gauge agrees with the exact linear transient within the tolerance.",
                           source)}}},
       .points = [times](double) { return times; },
       .exact = {fmt::format("seiche exact wavemaker_start --set kind={},depth={},gravity={},period={},stroke={} "
                             "--grid x={},t=0:{}:{}",
                             values.text("paddle"), values.real("depth"), values.real("gravity"), values.real("period"),
                             values.real("stroke"), gauge, times.back(), times.size())}}};
}

void wavemaker_start(Case& c) {
  c.title = "Wavemaker started from rest";
  c.source =
      "T. H. Havelock, Phil. Mag. 8 (1929) 569; R. G. Dean, R. A. Dalrymple, Water Wave Mechanics for Engineers and "
      "Scientists, 1991, ch. 6";
  c.parameters = {
      choice("paddle", "flap", {"piston", "flap"}, "motion of the paddle"),
      real("depth", 4.0, "m", {1e-6, 1e6}, "depth"),
      real("period", 4.7, "s", {1e-6, 1e6}, "period of the paddle"),
      real("stroke", 0.1, "m", {1e-12, 1e6}, "stroke at the still-water level; small in linear theory"),
      real("gravity", 9.81, "m/s^2", {1e-6, 1e6}, "acceleration of gravity"),
      real("gauge", 0.0, "m", {0, 1e6}, "distance of the gauge from the paddle; 0 is one wavelength"),
      real("periods", 6.0, "1", {1, 1e3}, "length of the requested series in periods"),
      tolerance_parameter(),
  };
  c.study = exact_study<start_of, show>(source);
  c.submission = {.tables = wanted};
}

}  // namespace seiche::validation::cases::wavemaker_start
