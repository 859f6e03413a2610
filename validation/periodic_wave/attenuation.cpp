#include "validation/periodic_wave/attenuation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "validation/case/reference_case.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/straight_line.hpp"

namespace seiche::validation {

using evidence::Bound;
using exact::StokesWave;

namespace {

constexpr int asked = 129;       ///< points of a surface
constexpr int seen_periods = 4;  ///< at a gauge

using Wave = Lazy<StokesWave>;

std::string exact_command(const StokesWave& wave, const std::string& grid) {
  return fmt::format("seiche exact stokes --set amplitude={:.17g},wavelength={:.17g},depth=1,gravity=1 --grid {}",
                     wave.amplitude(), wave.wavelength(), grid);
}

/// Gauges along a flume.
WantedTable wanted_gauges(const Wave& wave, const Values& values) {
  const std::vector<double> places =
      each(ways(values.integer("periods")), [&](const double way) { return way * wave->wavelength(); });
  const double last = seen_periods * period_of(*wave);
  return {
      .name = "gauges",
      .kind = WantedTable::Kind::series,
      .group = Column{"x", "m", "position of the gauge, from a crest at t = 0"},
      .abscissa = Column{"t", "s", "time, once the waves are settled at every gauge; for gravity 1 m/s^2, depth 1 m"},
      .quantities = {{.column = {"eta", "m", "surface elevation above the mean level"},
                      .reference = [wave](Place p) { return wave->elevation(p.group, p.abscissa); },
                      .requirements = {within_tolerance(
                          Measure::amplitude_ratio, values,
                          "The wave height agrees with the exact wave within the tolerance, by default 3.5 %.",
                          attenuation_source, 1)}}},
      .groups = places,
      .points = [last](double) { return evenly(0, last, seen_periods * (asked - 1) / 4 + 1); },
      .exact = {exact_command(*wave, fmt::format("x={:.17g}:{:.17g}:{},t=0:{:.17g}:{}", places.front(), places.back(),
                                                 places.size(), last, seen_periods * (asked - 1) / 4 + 1))}};
}

/// The submitted surface at as many points of a wavelength, through its period where it ends at centres of cells.
std::vector<Point> surface_of(const SubmittedGroup& group, double length) {
  const std::vector<double>& eta = group.values.at("eta");
  std::vector<double> x, y;
  if (group.abscissa.back() - length < group.abscissa.front()) {
    x.push_back(group.abscissa.back() - length);
    y.push_back(eta.back());
  }
  x.insert(x.end(), group.abscissa.begin(), group.abscissa.end());
  y.insert(y.end(), eta.begin(), eta.end());
  if (group.abscissa.front() + length > x.back()) {
    x.push_back(group.abscissa.front() + length);
    y.push_back(eta.front());
  }
  std::vector<Point> surface;
  for (int k = 0; k < asked - 1; ++k) {
    const double at = length * k / (asked - 1);
    surface.push_back({at, linear_at({x, y}, at)});
  }
  return surface;
}

/// The fundamental at a gauge: all its periods laid over each other, in time.
Fundamental at_gauge(const StokesWave& wave, const SubmittedGroup& group) {
  const double period = period_of(wave);
  std::vector<Point> folded;
  for (std::size_t k = 0; k < group.abscissa.size(); ++k) {
    if (group.abscissa[k] < 0 || group.abscissa[k] >= seen_periods * period * (1 - 1e-9)) continue;
    folded.push_back({std::fmod(group.abscissa[k], period), group.values.at("eta")[k]});
  }
  std::ranges::sort(folded, {}, &Point::x);
  const Elevation in_time = [&](double t) { return wave.elevation(wave.phase_speed() * t); };
  const Fundamental late = surface_fundamental(in_time, period, folded, group.value / wave.phase_speed());
  return {late.height, -late.lead};
}

Fundamental at_instant(const StokesWave& wave, const SubmittedGroup& group) {
  return surface_fundamental([&](double x) { return wave.elevation(x); }, wave.wavelength(),
                             surface_of(group, wave.wavelength()), wave.phase_speed() * group.value);
}

}  // namespace

std::vector<double> ways(long periods) {
  std::vector<double> all;
  for (long n = 1; apart * static_cast<double>(n) <= static_cast<double>(periods); ++n) {
    all.push_back(apart * static_cast<double>(n));
  }
  return all;
}

StokesWave wave_of(double height, double length) {
  return {height / 2, length, 1, 1};
}

double period_of(const StokesWave& wave) {
  return wave.wavelength() / wave.phase_speed();
}

Rates rates_of(const std::vector<double>& way, const std::vector<Fundamental>& found) {
  std::vector<double> logs, leads;
  for (const Fundamental& one : found) {
    logs.push_back(std::log(one.height));
    leads.push_back(leads.empty() ? one.lead : leads.back() + std::remainder(one.lead - leads.back(), 1.0));
  }
  return {-straight_line(way, logs).slope, straight_line(way, leads).slope};
}

std::vector<WantedTable> wanted_waves(const Values& values) {
  const Wave wave([values] { return wave_of(values.real("height"), values.real("length")); });
  if (values.text("tank") == "flume") return {wanted_gauges(wave, values)};
  const Lazy<std::vector<double>> times([wave, values] {
    return each(ways(values.integer("periods")), [&](const double way) { return way * period_of(*wave); });
  });
  return {
      {.name = "surface",
       .kind = WantedTable::Kind::profile,
       .group = Column{"t", "s", "time since a crest was at x = 0, for gravity 1 m/s^2 and depth 1 m"},
       .abscissa = Column{"x", "m", "position, over one wavelength"},
       .quantities =
           {{.column = {"eta", "m", "surface elevation above the mean level"},
             .reference = [wave](Place p) { return wave->elevation(p.abscissa, p.group); },
             .requirements =
                 {within_tolerance(Measure::amplitude_ratio, values,
                                   "The wave height agrees with the exact wave within the tolerance, by default 3.5 %.",
                                   attenuation_source, 1),
                  {.measure = Measure::shift,
                   .criterion = Bound{.limit = per_wavelength * values.real("length") * values.number("periods"),
                                      .reason = per_wavelength_reason + ", over all of them"},
                   .text = "The phase of the wave agrees with the exact wave at every instant within 0.5 % of the "
                           "distance travelled.",
                   .source = attenuation_source}}}},
       .groups = times,
       .points = [wave](double) { return evenly(0, wave->wavelength(), asked); },
       .exact =
           [wave, times] {
             return std::vector{
                 exact_command(*wave, fmt::format("x=0:{:.17g}:{},t={:.17g}:{:.17g}:{}", wave->wavelength(), asked,
                                                  times->front(), times->back(), times->size()))};
           }}};
}

void judge_waves(const Values& values, const Submitted& submitted, const SolverFacts& facts, evidence::Record& record) {
  const bool flume = values.text("tank") == "flume";
  const auto found = submitted.find(flume ? "gauges" : "surface");
  if (found == submitted.end()) return;
  const StokesWave wave = wave_of(values.real("height"), values.real("length"));
  std::vector<double> way;
  std::vector<Fundamental> stations;
  for (const SubmittedGroup& group : found->second) {
    way.push_back(group.value / (flume ? wave.wavelength() : period_of(wave)));
    stations.push_back(flume ? at_gauge(wave, group) : at_instant(wave, group));
  }
  const evidence::Claim decay{"decay", "The decay of the wave height is at most 0.5 % per wavelength.",
                              "decay of the fundamental per wavelength", "1", attenuation_source};
  const evidence::Claim phase{"phase", "The celerity agrees with the exact wave within 0.5 %.",
                              "phase lead per wavelength", "wavelengths", attenuation_source};
  if (way.size() < 2) {
    for (const evidence::Claim& claim : {decay, phase}) {
      record.leave_out({claim, flume ? "a rate needs two gauges" : "a rate needs two instants"});
    }
    return;
  }
  const Rates rates = rates_of(way, stations);
  record.measure("decay_per_wavelength", rates.decay);
  record.measure("lead_per_wavelength", rates.lead);
  std::string resolution =
      fmt::format("{} {} over {:g} wavelengths", way.size(), flume ? "gauges" : "instants", way.back());
  if (facts.cell) {
    record.measure("cells_per_height", values.real("height") / *facts.cell);
    resolution += fmt::format(", {:.3g} cells over the height", values.real("height") / *facts.cell);
  }
  if (facts.seconds) record.measure("seconds_per_wavelength", *facts.seconds / way.back());
  const Bound slight{.limit = per_wavelength, .reason = per_wavelength_reason};
  record.check(decay, {.value = rates.decay, .resolution = resolution}, slight);
  record.check(phase, {.value = rates.lead, .resolution = resolution}, slight);
}

}  // namespace seiche::validation
