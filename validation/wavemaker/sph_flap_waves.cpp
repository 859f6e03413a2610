#include "validation/wavemaker/sph_flap_waves.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/particles/sph_volume_fraction.hpp"
#include "validation/studies/wcsph/kept_flow.hpp"

namespace seiche::validation {

FlapDesign flap_design(const Values& values) {
  // Shorter, and the near field of the flap is measured; longer, and particles and theory take days.
  require_within("gauge/depth", values.real("gauge") / values.real("depth"), 0.5, 100);
  return {values.real("depth"), values.real("period"), values.real("stroke"), values.real("gauge")};
}

void exchange(Tape& tape, FlapWaves& w) {
  tape(w.scheme, w.neighbours, w.spacing, w.layers, w.particles, w.time, w.behind, w.breaks_down, w.extremes, w.steps);
  for (std::vector<double>& elevation : w.elevation) tape(elevation);
}

FlapWaves make_flap_waves(const Run& run, const FlapDesign& design, long layers, const FlapScheme& scheme,
                          bool may_break, Part part) {
  const double spacing = design.depth / static_cast<double>(layers);
  const double length = spacing * std::round(run.real("flume") * design.gauge / spacing);
  wcsph::Settings settings = sph_settings(run, flap_gravity, 1000, std::sqrt(flap_gravity * design.depth));
  scheme.change(settings);
  wcsph::Scene scene = wcsph::flume({.length = length,
                                     .depth = design.depth,
                                     .stroke = design.stroke,
                                     .frequency = 2 * std::numbers::pi / design.period,
                                     .spacing = spacing},
                                    settings);
  wcsph::Flow flow(std::move(scene.particles), scene.spacing, settings, scene.paddles);
  FlapWaves waves{.scheme = scheme.name,
                  .neighbours = std::numbers::pi * std::pow(wcsph::support * settings.smoothing, 2),
                  .spacing = spacing,
                  .layers = layers,
                  .particles = flow.particles().size()};
  const auto samples = std::lround(flap_periods * samples_per_period);
  wcsph::Box basin = wcsph::unbounded;
  basin.bottom = scene.bottom;
  basin.right = scene.far_wall;
  long n = 0;
  const auto state = [&](Tape& tape) { tape(n, waves, flow); };
  try {
    for (part.resume(state); n <= samples; ++n) {
      part.keep(state);
      march(flow, design.period * static_cast<double>(n) / samples_per_period);
      const wcsph::VolumeFraction fraction(flow.particles(), flow.smoothing_length(), basin, settings.kernel);
      waves.time.push_back(flow.time());
      for (std::size_t k = 0; k < places.size(); ++k) {
        waves.elevation[k].push_back(fraction.elevation(places[k] * design.gauge).value_or(nan) - scene.still_water);
      }
    }
  } catch (const Divergence& failure) {
    if (!may_break) throw;
    waves.breaks_down = failure.time();
    return waves;
  }
  waves.behind = flow.outside(scene.extents.left, scene.extents.right, scene.extents.bottom, 2 * scene.extents.top);
  waves.extremes = flow.extremes();
  waves.steps = flow.steps();
  return waves;
}

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

}  // namespace seiche::validation
