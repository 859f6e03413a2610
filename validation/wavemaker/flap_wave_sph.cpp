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
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "seiche/exact/wavemaker_transient.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/models/wcsph/volume_fraction.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/studies/wcsph/spacing_ladder.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"

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

Design design_of(const Values& values) {
  return {values.real("depth"), values.real("period"), values.real("stroke"), values.real("gauge")};
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

  [[nodiscard]] std::string resolution() const {
    return fmt::format("{} layers, {}", layers, sph_resolution(spacing, particles));
  }
};

Waves make_waves(const Run& run, const Design& design, long layers, const Scheme& scheme) {
  const double spacing = design.depth / static_cast<double>(layers);
  const double length = spacing * std::round(run.real("flume") * design.gauge / spacing);
  wcsph::Settings settings = sph_settings(run, gravity, 1000, std::sqrt(gravity * design.depth));
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
    Smallest low;
    Largest high;
    for (std::size_t n = 0; n < time.size(); ++n) {
      const double phase = time[n] / period - static_cast<double>(k);
      if (phase < -1e-9 || phase > 1 + 1e-9) continue;
      low.add(elevation[n]);
      high.add(elevation[n]);
    }
    heights[k] = high.value() - low.value();
  }
  return heights;
}

/// Linear theory at the gauge, at the instants at which it is read.
struct Theory {
  std::vector<double> time, transient, settled;
  std::array<double, 3> heights{};  ///< of the transient
  double settled_height = 0;
  double wavenumber = 0;
};

Theory theory_of(const Design& design) {
  const exact::WavemakerTransient start =
      exact::WavemakerTransient::with_period(exact::Paddle::flap, gravity, design.depth, design.period, design.stroke);
  Theory linear;
  for (long n = 0; n <= std::lround(periods * samples_per_period); ++n) {
    const double t = design.period * static_cast<double>(n) / samples_per_period;
    linear.time.push_back(t);
    linear.transient.push_back(start.elevation(design.gauge, t));
    linear.settled.push_back(start.steady().elevation(design.gauge, t));
  }
  linear.heights = heights_of(linear.time, linear.transient, design.period);
  linear.settled_height = start.steady().wave_height();
  linear.wavenumber = 2 * std::numbers::pi / start.steady().wavelength();
  return linear;
}

struct Results {
  Design design;
  Theory linear;
  std::vector<Waves> runs;  ///< by the lattices of the ladder
  Waves wide;               ///< the finest with more neighbours

  [[nodiscard]] std::array<double, 3> heights(const Waves& waves) const {
    return heights_of(waves.time, waves.elevation, design.period);
  }
};

Results compute(const Run& run) {
  const Design design = design_of(run);
  const long finest = run.integer("layers");
  const std::vector<long> ladder = sph_ladder(run.tier(), finest);
  Results r{.design = design, .linear = theory_of(design), .runs = std::vector<Waves>(ladder.size()), .wide = {}};
  climb(run, ladder.size() + 1, [&](std::size_t k) {
    if (k == ladder.size()) {
      r.wide = make_waves(run, design, finest, Scheme::more_neighbours);
    } else {
      r.runs[k] = make_waves(run, design, ladder[k], Scheme::as_set);
    }
  });
  return r;
}

/// The height of the second wave with the scheme as it is set.
Measurement second_wave(const Results& r) {
  return {.value = r.heights(r.runs.back())[1], .resolution = r.runs.back().resolution()};
}

void claim_second_wave(const Claims<Results>& claims, const Theory& linear, const Values& values) {
  const auto near = [](const std::string& id, const std::string& scheme) {
    return evidence::Claim{.id = "second-transient" + id,
                           .text = fmt::format("The second wave is that of the exact transient ({}).", scheme),
                           .quantity = "height from crest to trough during the second period",
                           .unit = "m",
                           .source = theory};
  };
  const double steepness = 0.5 * linear.wavenumber * linear.heights[1];
  const Bound nonlinear{.limit = steepness,
                        .reason = "nonlinearity: k H/2 of this wave, a tenth for the published one",
                        .expected = linear.heights[1],
                        .relative = true};
  claims.check(
      near("-more", "Wendland kernel, h = 2 dx"),
      [](const Results& r) -> Measurement {
        return {.value = r.heights(r.wide)[1], .resolution = r.wide.resolution()};
      },
      nonlinear);
  const evidence::Claim settled{.id = "second-settled",
                                .text = "The second wave is within 8 per cent of the settled one.",
                                .quantity = "height from crest to trough during the second period",
                                .unit = "m",
                                .source = publication};
  const Bound eight{
      .limit = 0.08, .reason = "the publication's statement", .expected = linear.settled_height, .relative = true};
  if (at_defaults(values)) {
    // Lattices of 13 to 15 layers scatter by 0.012.
    const bool quick = values.tier() == Tier::quick;
    const evidence::KnownFailure low{.value = quick ? 0.715 : 0.69, .width = quick ? 0.02 : 0.025};
    claims.known_failure(near("", "as set"), second_wave, nonlinear,
                         {.value = low.value,
                          .width = low.width,
                          .reason = "with about 20 neighbours waves lose height on their way, 12 to 17 per cent of it "
                                    "here, which finer spacings do not give back"});
    claims.known_failure(settled, second_wave, eight,
                         {.value = low.value,
                          .width = low.width,
                          .reason = "the settled wave has not arrived: in exact linear theory the second wave is more "
                                    "than a fifth lower at this place"});
  } else {
    claims.check(near("", "as set"), second_wave, nonlinear);
    claims.check(settled, second_wave, eight);
  }
}

void claims(const Values& values, const Claims<Results>& claims) {
  claim_second_wave(claims, theory_of(design_of(values)), values);
  claims.check(
      {.id = "transient-below",
       .text = "In exact linear theory too the second wave at this place is lower than the settled one by "
               "more than 8 per cent.",
       .quantity = "it is lower",
       .source = theory},
      [](const Results& r) { return r.linear.heights[1] < 0.92 * r.linear.settled_height ? 1.0 : 0.0; },
      evidence::Qualitative{.detector = "height of the second wave below 0.92 of the settled one",
                            .reason = "the front of the wave train disperses"});
  claims.check(
      {.id = "contained",
       .text = "No particle gets behind the flap or through a wall.",
       .quantity = "particles outside at the end",
       .source = publication},
      [](const Results& r) -> Measurement {
        return {.value = static_cast<double>(r.runs.back().behind), .resolution = r.runs.back().resolution()};
      },
      Bound{.limit = 0, .reason = "walls are tight"});
}

void show_numbers(const Results& r, evidence::Exhibit& exhibit) {
  const Waves& finest = r.runs.back();
  const Theory& linear = r.linear;
  double difference = 0;
  double norm = 0;
  for (std::size_t n = 0; n < linear.time.size(); ++n) {
    difference += std::pow(finest.elevation[n] - linear.transient[n], 2);
    norm += linear.transient[n] * linear.transient[n];
  }
  exhibit.measure("settled_height", linear.settled_height);
  exhibit.measure("transient_over_settled", linear.heights[1] / linear.settled_height);
  exhibit.measure("relative_l2_from_transient", std::sqrt(difference / norm));
  exhibit.measure("second_wave_over_transient", r.heights(finest)[1] / linear.heights[1]);
  exhibit.measure("second_wave_over_transient_more_neighbours", r.heights(r.wide)[1] / linear.heights[1]);
  exhibit.measure("largest_mach_number", finest.extremes.mach);
  exhibit.measure("particles_lost_more_neighbours", static_cast<double>(r.wide.behind));
  exhibit.measure("steps", static_cast<double>(finest.steps));
  std::vector<double> sizes, second;
  for (const Waves& one : r.runs) {
    sizes.push_back(one.spacing);
    second.push_back(r.heights(one)[1]);
  }
  measure_convergence(exhibit, "second_wave", sizes, second);
}

void tabulate(const Results& r, evidence::Exhibit& exhibit) {
  evidence::Table table{.id = "heights",
                        .title = "Heights from crest to trough at the gauge",
                        .caption = "In the first and second period, and in the part of the third that was run [m].",
                        .columns = {{"", ""}, {"period 1", "m"}, {"period 2", "m"}, {"2 to 2.75", "m"}}};
  const auto row = [&](const std::string& label, const std::array<double, 3>& heights) {
    table.rows.push_back({label, heights[0], heights[1], heights[2]});
  };
  const double settled = r.linear.settled_height;
  row("settled, linear", {settled, settled, settled});
  row("transient, linear", r.linear.heights);
  for (const Waves& one : r.runs) row(fmt::format("SPH, {} layers", one.layers), r.heights(one));
  row(fmt::format("SPH, {} layers, h = 2 dx", r.wide.layers), r.heights(r.wide));
  exhibit.table(std::move(table));
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  show_numbers(r, exhibit);
  tabulate(r, exhibit);
  auto& panel =
      exhibit
          .figure("gauge", "Elevation at x = L from the flap wavemaker",
                  "SPH, the exact transient from rest, and the settled wave, which is not there yet.", {"sph-fig-5"})
          .panel({.x = "t/T", .y = "elevation [m]"});
  std::vector<double> phase;
  for (const double t : r.linear.time) phase.push_back(t / r.design.period);
  panel.line("transient, linear theory", phase, r.linear.transient, Role::exact);
  panel.line("settled, linear theory", phase, r.linear.settled, Role::guide);
  for (const Waves& one : r.runs) {
    panel.line(fmt::format("SPH, {} layers", one.layers), phase, one.elevation,
               &one == &r.runs.back() ? Role::computed : Role::peer);
  }
  panel.line(fmt::format("SPH, {} layers, h = 2 dx", r.wide.layers), phase, r.wide.elevation, Role::peer);
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
  c.published = {{.tiles = {"sph-fig-5"},
                  .tier = Tier::full,
                  .differs = "the publication states neither the spacing nor the length of the flume"}};
  c.study = Study(claims, compute, show);
  return c;
}

}  // namespace seiche::validation::cases
