/*
A flap hinged at the bottom of a flume starts from rest and makes a regular wave: weakly compressible SPH (figure 5 of
the publication). Design: depth $d = 4$ m, wavelength $L = 27.3$ m, height 1.02 m, stroke 2.11 m, period 4.7 s.

**Set-up.** The flap turns rigidly, $X_w = \tfrac12 S\sin\omega t$ at the still-water level. $\alpha = 0.01$, density
filter every 30 steps, $c_0 = 10\sqrt{gd}$. The flume is so long that nothing comes back from its end. Elevations at
$x = L$: where the share of water on the vertical falls to one half.

**What is compared.** Heights from crest to trough in each period with two references: the settled wave of linear
theory, which the publication takes and from which it reports a difference of 8 per cent for the second wave; and the
exact linear transient from rest, `wavemaker_start`. The second is the right one. After two periods the settled wave has
not yet arrived at $x = L$.

**What to look at.** In linear theory itself the first wave at $x = L$ is almost absent, the second more than 20 per
cent too low, the third too high. Agreement of the second wave with the settled one within 8 per cent would be an error.
With the cubic spline and $h = 1.3\,dx$ of the publication waves lose height on their way, however fine the spacing;
with more neighbours (Wendland kernel, $h = 2\,dx$) they do not, but a particle or two get past the flap. Note that
period and wavelength of the design do not fit each other: with $T = 4.7$ s linear waves are 25.9 m long and, for this
stroke, 1.08 m high.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "seiche/exact/wavemaker_transient.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/models/wcsph/volume_fraction.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"
#include "validation/studies/wcsph/spacing_ladder.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Bound;
using evidence::Role;

const std::string publication = "Plunging breaking waves by weakly compressible smoothed particles, figure 5";
const std::string theory = "Kennard (1949); Dean and Dalrymple (1991), chapter 6";
constexpr double gravity = 9.81;
constexpr double periods = 2.75;
constexpr long samples_per_period = 60;

struct Design {
  double depth, period, stroke, gauge;
};

Design design_of(const Run& run) {
  return {run.real("depth"), run.real("period"), run.real("stroke"), run.real("gauge")};
}

/// As the parameters say, or with the Wendland kernel and h = 2 dx, 44 neighbours.
enum class Scheme { as_set, more_neighbours };

struct Waves {
  double spacing = 0;
  long layers = 0;
  std::size_t particles = 0;
  std::vector<double> time, elevation;
  long behind = 0;  ///< particles outside the flume at the end
  wcsph::Extremes extremes;
  long steps = 0;
};

Waves make_waves(const Run& run, const Design& design, long layers, const Scheme& scheme) {
  const double spacing = design.depth / static_cast<double>(layers);
  const double length = spacing * std::round(run.real("flume") * design.gauge / spacing);
  wcsph::Settings settings = sph_settings(run.values(), gravity, 1000, std::sqrt(gravity * design.depth));
  if (scheme == Scheme::more_neighbours) {
    settings.kernel = wcsph::KernelName::wendland_c2;
    settings.smoothing = 2;
  }
  const wcsph::Scene scene = wcsph::flume({.length = length,
                                           .depth = design.depth,
                                           .stroke = design.stroke,
                                           .frequency = 2 * std::numbers::pi / design.period,
                                           .spacing = spacing},
                                          settings);
  wcsph::Flow flow(scene.particles, scene.spacing, settings, scene.paddles);
  Waves waves{.spacing = spacing, .layers = layers, .particles = scene.particles.size()};
  const auto samples = std::lround(periods * samples_per_period);
  wcsph::Box basin = wcsph::unbounded;
  basin.bottom = scene.bottom;
  basin.right = scene.far_wall;
  for (long n = 0; n <= samples; ++n) {
    flow.advance_to(design.period * static_cast<double>(n) / samples_per_period);
    const wcsph::VolumeFraction fraction(flow.particles(), flow.smoothing_length(), basin, settings.kernel);
    waves.time.push_back(flow.time());
    waves.elevation.push_back(fraction.elevation(design.gauge).value_or(std::numeric_limits<double>::quiet_NaN()) -
                              scene.still_water);
  }
  waves.behind = flow.outside(scene.extents.left, scene.extents.right, scene.extents.bottom, 2 * scene.extents.top);
  waves.extremes = flow.extremes();
  waves.steps = flow.steps();
  return waves;
}

/// Crest to trough in each period, the last one as far as it goes.
std::array<double, 3> heights_of(const std::vector<double>& time, const std::vector<double>& elevation, double period) {
  std::array<double, 3> heights{};
  for (std::size_t k = 0; k < heights.size(); ++k) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t n = 0; n < time.size(); ++n) {
      const double phase = time[n] / period - static_cast<double>(k);
      if (phase < -1e-9 || phase > 1 + 1e-9) continue;
      low = std::min(low, elevation[n]);
      high = std::max(high, elevation[n]);
    }
    heights[k] = high - low;
  }
  return heights;
}

void claim(Running& run, const std::vector<Waves>& runs, const Waves& wide, const Design& design,
           const std::array<double, 3>& transient, double settled) {
  std::vector<double> sizes, second;
  for (const Waves& one : runs) {
    sizes.push_back(one.spacing);
    second.push_back(heights_of(one.time, one.elevation, design.period)[1]);
  }
  measure_convergence(run.record, "second_wave", sizes, second);
  const Waves& finest = runs.back();
  const evidence::Measurement height{
      .value = second.back(),
      .resolution = fmt::format("{} layers, {}", finest.layers, sph_resolution(finest.spacing, finest.particles))};
  run.record.measure("second_wave_over_transient", second.back() / transient[1]);
  const double wider = heights_of(wide.time, wide.elevation, design.period)[1];
  run.record.measure("second_wave_over_transient_more_neighbours", wider / transient[1]);
  const auto near = [](const std::string& id, const std::string& scheme) {
    return evidence::Claim{.id = "second-transient" + id,
                           .text = fmt::format("The second wave is that of the exact transient ({}).", scheme),
                           .quantity = "height from crest to trough during the second period",
                           .unit = "m",
                           .source = theory};
  };
  const Bound twelve{.limit = 0.12,
                     .reason = "12 %: nonlinearity, about k H/2 = 0.12 for waves as steep as these",
                     .expected = transient[1],
                     .relative = true};
  run.record.check(near("-more", "Wendland kernel, h = 2 dx"), {.value = wider, .resolution = height.resolution},
                   twelve);
  if (run.real("smoothing") < 1.5) {
    run.record.known_failure(near("", "as set"), height, twelve,
                             "with about 20 neighbours waves lose height on their way, 13 to 18 per cent of it here, "
                             "which finer spacings do not give back");
  } else {
    run.record.check(near("", "as set"), height, twelve);
  }
  run.record.known_failure(
      {.id = "second-settled",
       .text = "The second wave is within 8 per cent of the settled one.",
       .quantity = "height from crest to trough during the second period",
       .unit = "m",
       .source = publication},
      height, Bound{.limit = 0.08, .reason = "the publication's statement", .expected = settled, .relative = true},
      "the settled wave has not arrived: in exact linear theory the second wave is more than a "
      "fifth lower at this place");
  run.record.measure("transient_over_settled", transient[1] / settled);
  run.record.check({.id = "transient-below",
                    .text = "In exact linear theory too the second wave at this place is lower than the settled one by "
                            "more than 8 per cent.",
                    .quantity = "it is lower",
                    .source = theory},
                   {.value = transient[1] < 0.92 * settled ? 1.0 : 0.0},
                   evidence::Qualitative{.detector = "height of the second wave below 0.92 of the settled one",
                                         .reason = "the front of the wave train disperses"});
  run.record.check({.id = "contained",
                    .text = "No particle gets behind the flap or through a wall.",
                    .quantity = "particles outside at the end",
                    .source = publication},
                   {.value = static_cast<double>(finest.behind)}, Bound{.limit = 0, .reason = "walls are tight"});
}

void run(Running& run) {
  const Design design = design_of(run);
  const exact::WavemakerTransient start =
      exact::WavemakerTransient::with_period(exact::Paddle::flap, gravity, design.depth, design.period, design.stroke);
  const long finest = run.integer("layers");
  const std::vector<long> ladder = sph_ladder(run.tier(), finest);
  std::vector<Waves> runs(ladder.size());
  Waves wide;
  climb(run, ladder.size() + 1, [&](std::size_t k) {
    if (k == ladder.size()) {
      wide = make_waves(run, design, finest, Scheme::more_neighbours);
    } else {
      runs[k] = make_waves(run, design, ladder[k], Scheme::as_set);
    }
  });

  const std::vector<double>& time = runs.back().time;
  std::vector<double> transient, settled;
  double difference = 0;
  double norm = 0;
  for (std::size_t n = 0; n < time.size(); ++n) {
    transient.push_back(start.elevation(design.gauge, time[n]));
    settled.push_back(start.steady().elevation(design.gauge, time[n]));
    difference += std::pow(runs.back().elevation[n] - transient.back(), 2);
    norm += transient.back() * transient.back();
  }
  const auto theory_heights = heights_of(time, transient, design.period);
  run.record.measure("settled_height", start.steady().wave_height());
  run.record.measure("relative_l2_from_transient", std::sqrt(difference / norm));
  run.record.measure("largest_mach_number", runs.back().extremes.mach);
  run.record.measure("particles_lost_more_neighbours", static_cast<double>(wide.behind));
  run.record.measure("steps", static_cast<double>(runs.back().steps));
  evidence::Table table{.id = "heights",
                        .title = "Heights from crest to trough at the gauge",
                        .caption = "In the first and second period, and in the part of the third that was run [m].",
                        .columns = {{"", ""}, {"period 1", "m"}, {"period 2", "m"}, {"2 to 2.75", "m"}}};
  const auto row = [&](const std::string& label, const std::array<double, 3>& heights) {
    table.rows.push_back({label, heights[0], heights[1], heights[2]});
  };
  const double settled_height = start.steady().wave_height();
  row("settled, linear", {settled_height, settled_height, settled_height});
  row("transient, linear", theory_heights);
  for (const Waves& one : runs) {
    row(fmt::format("SPH, {} layers", one.layers), heights_of(one.time, one.elevation, design.period));
  }
  row(fmt::format("SPH, {} layers, h = 2 dx", wide.layers), heights_of(wide.time, wide.elevation, design.period));
  run.record.table(std::move(table));
  claim(run, runs, wide, design, theory_heights, settled_height);

  auto& panel =
      run.record
          .figure("gauge", "Elevation at x = L from the flap wavemaker",
                  "SPH, the exact transient from rest, and the settled wave, which is not there yet.", {"sph-fig-5"})
          .panel({.x = "t/T", .y = "elevation [m]"});
  std::vector<double> phase;
  for (const double t : time) phase.push_back(t / design.period);
  panel.line("transient, linear theory", phase, transient, Role::exact);
  panel.line("settled, linear theory", phase, settled, Role::guide);
  for (const Waves& one : runs) {
    panel.line(fmt::format("SPH, {} layers", one.layers), phase, one.elevation,
               &one == &runs.back() ? Role::computed : Role::peer);
  }
  panel.line(fmt::format("SPH, {} layers, h = 2 dx", wide.layers), phase, wide.elevation, Role::peer);
}

}  // namespace

Case flap_wave_sph() {
  Case c;
  c.title = "A flap makes a regular wave: weakly compressible SPH";
  c.source =
      "Plunging breaking waves by weakly compressible smoothed particles, figure 5; E. H. Kennard, Quart. Appl. "
      "Math. 7 (1949) 303; R. G. Dean, R. A. Dalrymple, Water wave mechanics (1991), chapter 6";
  c.tiers = {Tier::quick, Tier::full, Tier::paper};
  c.parameters = with({real("depth", 4.0, "m", {1e-3, 1e3}, "still-water depth"),
                       real("period", 4.7, "s", {1e-3, 1e3}, "period of the flap"),
                       real("stroke", 2.11, "m", {1e-6, 1e3}, "stroke at the still-water level"),
                       real("gauge", 27.3, "m", {1e-3, 1e4}, "distance of the gauge from the flap at rest"),
                       real("flume", 2.25, "gauge", {1.1, 20}, "length of the flume"),
                       integer("layers", {14, 40, 80}, {4, 400}, "particle spacings in the depth")},
                      sph_parameters({.alpha = 0.01, .filter = 30}, "sqrt(g d)"));
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
