#include "validation/moving_pressure/pressure_regimes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {
namespace {

namespace model = dispersive_shallow_water_1d;

constexpr double behind = 250;     // length of the channel behind the start of the source
constexpr double room_ahead = 90;  // and beyond where the fastest soliton gets
constexpr double fastest_soliton = 1.25;
constexpr double sampling = 0.5;
constexpr double ridge_window = 200;  // the last part of the run that is drawn
constexpr int ridge_lines = 30;

/// Lagrange's cubic through the four markers nearest to the place: a polyline would have a kink at every marker that
/// passes the source.
double smooth_elevation(const model::Flow& flow, double place) {
  const auto x = flow.x();
  const auto y = flow.y();
  const auto above = static_cast<std::size_t>(std::upper_bound(x.begin() + 2, x.end() - 2, place) - x.begin());
  double sum = 0;
  for (std::size_t i = above - 2; i < above + 2; ++i) {
    double weight = 1;
    for (std::size_t j = above - 2; j < above + 2; ++j) {
      if (j != i) weight *= (place - x[j]) / (x[i] - x[j]);
    }
    sum += weight * y[i];
  }
  return sum;
}

PressureSurface surface_of(const model::Flow& flow, const PressureSource& source) {
  PressureSurface surface{.time = flow.time(), .elevation = {flow.y().begin(), flow.y().end()}};
  for (const double x : flow.x()) surface.place.push_back(x - source.speed * flow.time());
  return surface;
}

PressureSurface ridge_of(const model::Flow& flow, const PressureSource& source) {
  PressureSurface ridge{.time = flow.time(), .place = evenly(-70, 85, 311)};
  std::vector<double> x = each(ridge.place, [&](const double z) { return z + source.speed * flow.time(); });
  ridge.elevation = flow.elevation_at(x);
  return ridge;
}

double highest_beyond(std::span<const double> x, std::span<const double> elevation, double place) {
  const auto first = std::upper_bound(x.begin(), x.end(), place) - x.begin();
  return largest(elevation.subspan(static_cast<std::size_t>(first)));
}

}  // namespace

double PressureSource::at(double x, double time) const {
  const double z = x - speed * time;
  if (std::abs(z) >= half_width) return 0;
  const double cosine = std::cos(std::numbers::pi * z / (2 * half_width));
  const double growth = time < ramp ? 0.5 * (1 - std::cos(std::numbers::pi * time / ramp)) : 1;
  return pressure * growth * cosine * cosine;
}

PressureWaves::PressureWaves(PressureSource source, PressureRun run, const std::function<void(double)>& progress)
    : source_(source) {
  const double end = std::max(fastest_soliton, source.speed) * run.time + room_ahead;
  model::Channel channel{.bottom = std::make_shared<LevelBottom>(1.0)};
  const auto cells = static_cast<std::size_t>(std::lround((end + behind) / run.spacing));
  model::Flow flow(channel, model::still_markers(channel, model::equal_labels(channel, -behind, end, cells)), {},
                   {.surface_pressure = [source](double x, double time) { return source.at(x, time); }});
  const auto samples = static_cast<long>(std::ceil(run.time / sampling));
  const double first_ridge = std::max(0.0, run.time - ridge_window);
  const double between_ridges = (run.time - first_ridge) / ridge_lines;
  const auto sample = [&] {
    time_.push_back(flow.time());
    at_source_.push_back(smooth_elevation(flow, source.speed * flow.time()));
    ahead_ever_.add(highest_beyond(flow.x(), flow.y(), source.speed * flow.time() + source.half_width));
    at_wall_.add(flow.y().back());
    const double next_ridge = first_ridge + between_ridges * static_cast<double>(ridges_.size());
    if (flow.time() >= next_ridge) ridges_.push_back(ridge_of(flow, source));
    if (flow.time() <= run.time - leader_time) earlier_ = surface_of(flow, source);
  };
  sample();
  for (long k = 1; k <= samples; ++k) {
    march(flow, run.time * static_cast<double>(k) / static_cast<double>(samples), stable_steps(flow, run.tau));
    sample();
    progress(static_cast<double>(k) / static_cast<double>(samples));
  }
  last_ = surface_of(flow, source);
}

PressureWaves::Extremes PressureWaves::range_at_source() const {
  const auto half = std::span(at_source_).subspan(at_source_.size() / 2);
  return {smallest(half), largest(half)};
}

std::vector<CurveCrest> PressureWaves::source_peaks() const {
  const Extremes range = range_at_source();
  return crests_above(0.5 * (range.lowest + range.highest), time_, at_source_);
}

Period PressureWaves::period() const {
  const std::vector<CurveCrest> peaks = source_peaks();
  if (peaks.empty()) return {nan, nan};
  const auto first = std::lower_bound(time_.begin(), time_.end(), peaks.front().place) - time_.begin();
  return period_of(std::span(at_source_).subspan(static_cast<std::size_t>(first)), time_[1] - time_[0]);
}

std::vector<CurveCrest> PressureWaves::solitons(const PressureSurface& surface, double threshold) const {
  std::vector<CurveCrest> peaks = crests_above(threshold, surface.place, surface.elevation);
  std::erase_if(peaks, [&](const CurveCrest& peak) { return peak.place <= source_.half_width; });
  return peaks;
}

double PressureWaves::soliton_count(double threshold) const {
  return std::isnan(maximum_ahead()) ? nan : static_cast<double>(solitons(last_, threshold).size());
}

double PressureWaves::maximum_ahead() const {
  return highest_beyond(last_.place, last_.elevation, source_.half_width);
}

PressureWaves::Leader PressureWaves::leader(double threshold) const {
  const std::vector<CurveCrest> before = solitons(earlier_, threshold);
  const std::vector<CurveCrest> now = solitons(last_, threshold);
  if (before.empty() || now.empty()) return {};
  return {.speed = source_.speed + (now.back().place - before.back().place) / (last_.time - earlier_.time),
          .height = now.back().height};
}

void PressureWaves::draw_ridges(evidence::Figure& figure) const {
  Largest highest;
  highest.add(0.1);
  for (const PressureSurface& ridge : ridges_) highest.add(largest(ridge.elevation));
  // The highest wave is as high as four intervals between lines, rounded down to a number that can be read.
  const double interval = (ridges_.back().time - ridges_.front().time) / (ridge_lines - 1);
  const double scale = std::max(1.0, std::floor(4 * interval / highest.value() / 5) * 5);
  auto& panel = figure.panel({.x = "x - U t", .y = fmt::format("t + {:g} elevation", scale), .title = source_.text()});
  for (const PressureSurface& ridge : ridges_) {
    panel.line("surface", ridge.place,
               each(ridge.elevation, [&](const double elevation) { return ridge.time + scale * elevation; }));
  }
}

void PressureWaves::draw_at_source(evidence::Figure& figure) const {
  figure.panel({.x = "t", .y = "elevation at the source", .title = source_.text()}).line("surface", time_, at_source_);
}
namespace {

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 3.3";
constexpr double regular = 0.03;        // peaks of a periodic surface are equidistant to this fraction
constexpr double lowest_soliton = 0.1;  // what is lower may be a ripple

/// Without the first one, in which the start still shows.
std::vector<double> settled_distances(const PressureWaves& waves) {
  std::vector<double> result = distances(waves.source_peaks());
  if (!result.empty()) result.erase(result.begin());
  return result;
}

}  // namespace

std::vector<PressureRegime> pressure_regimes(bool all) {
  std::vector<PressureRegime> regimes{
      {"pressure", "pressure: solitons", {.pressure = 0.1, .half_width = 4}, 150},
      {"suction", "suction: solitons", {.pressure = -0.1, .half_width = 4}, 500, true, true},
      {"wide-suction", "wide suction: none", {.pressure = -0.1, .half_width = 6.5}, 800, false, true},
      {"pressure-1", "narrow pressure", {.pressure = 0.1, .half_width = 1}, 150},
      {"pressure-2", "pressure, w = 2", {.pressure = 0.1, .half_width = 2}, 150},
      {"pressure-7", "wide pressure", {.pressure = 0.1, .half_width = 7}, 800, true, true},
      {"suction-7", "suction, w = 7", {.pressure = -0.1, .half_width = 7}, 500, false, true},
      {"weak-suction", "weak suction", {.pressure = -0.05, .half_width = 4}, 500},
      {"weak-wide-suction", "weak wide suction", {.pressure = -0.05, .half_width = 8}, 500, false}};
  if (!all) regimes.resize(3);
  return regimes;
}

double solitons_ahead(const PressureWaves& waves) {
  const double count = waves.soliton_count(soliton_threshold);
  return count > 0 ? 1 : count;
}

bool usual_resolution(const PressureRun& run) {
  const PressureRun usual;
  return run.spacing == usual.spacing && run.tau == usual.tau;
}

std::optional<PressureRegime> pressure_regime_of(const PressureSource& source, const PressureRun& run) {
  if (!usual_resolution(run)) return std::nullopt;
  for (const PressureRegime& regime : pressure_regimes()) {
    if (regime.source == source && regime.time == run.time) return regime;
  }
  return std::nullopt;
}

void claim_leading_soliton(const Claims<PressureWaves>& claims, const std::string& id, const PressureSource& of,
                           const PressureRun& run) {
  claims.at(run.text())
      .from("Serre, La Houille Blanche 8 (1953) 374")
      .check(
          id,
          fmt::format("The speed of the leading soliton agrees with Serre's solitary wave of its height ({}).",
                      of.text()),
          "speed of its crest / (1 + height)^(1/2)",
          [](const PressureWaves& waves) {
            const PressureWaves::Leader leader = waves.leader(lowest_soliton);
            return leader.speed / std::sqrt(1 + leader.height);
          },
          Bound{.limit = run.spacing * run.spacing / 36 + std::exp(-8.0),
                .reason =
                    "k^4 h^2/36, the error of the discrete dispersion relation at k = 1, the length of such a wave; "
                    "and exp(-8), the remaining elevation over the source of a wave four of its lengths ahead",
                .expected = 1});
}

void claim_pressure_regime(const Claims<PressureWaves>& all, const PressureRegime& regime, const PressureRun& run) {
  const Claims<PressureWaves> claims = all.at(run.text()).from(source);
  claims.check(
      regime.id + (regime.solitons ? "-solitons" : "-none-ahead"),
      fmt::format("The number of solitons ahead of the source is {} ({}).", regime.solitons ? "positive" : "zero",
                  regime.source.text()),
      "forward solitons present", solitons_ahead,
      Qualitative{
          .detector = fmt::format("a peak above {:g} beyond the front of the source at the end", soliton_threshold),
          .reason = "water escapes ahead only as solitons; lower elevations are the transient of the start",
          .expected = regime.solitons});
  if (!regime.periodic) return;
  claims.check(
      regime.id + "-regular",
      fmt::format("The intervals between surface peaks at the source deviate from their mean by at most 3 % ({}).",
                  regime.source.text()),
      "largest relative deviation of a peak interval from the mean",
      [](const PressureWaves& waves) { return relative_spread(settled_distances(waves)); },
      Bound{regular, "periodic, not chaotic; the first interval, affected by the start, is excluded"});
}

void show_pressure_waves(evidence::Exhibit& exhibit, const std::string& prefix, const std::string& leader,
                         const PressureWaves& waves, double threshold) {
  const auto keep = [&](const std::string& name, double value) {
    if (std::isfinite(value)) exhibit.measure(name, value);
  };
  const PressureWaves::Extremes range = waves.range_at_source();
  const Period period = waves.period();
  keep(prefix + "forward_solitons", waves.soliton_count(threshold));
  keep(prefix + "maximum_ahead", waves.maximum_ahead());
  keep(prefix + "maximum_ahead_ever", waves.maximum_ahead_ever());
  keep(prefix + "lowest_at_source", range.lowest);
  keep(prefix + "highest_at_source", range.highest);
  keep(prefix + "period", period.length);
  keep(prefix + "autocorrelation", period.correlation);
  keep(prefix + "spread_of_peaks", relative_spread(settled_distances(waves)));
  keep(leader + "_speed", waves.leader(lowest_soliton).speed);
  keep(leader + "_height", waves.leader(lowest_soliton).height);
}

}  // namespace seiche::validation
