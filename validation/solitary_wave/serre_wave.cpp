#include "validation/solitary_wave/serre_wave.hpp"

#include <cmath>
#include <memory>

#include "seiche/samples.hpp"

namespace seiche::validation {

using dispersive_shallow_water_1d::Channel;
using dispersive_shallow_water_1d::End;
using dispersive_shallow_water_1d::Flow;
using dispersive_shallow_water_1d::Scheme;
using dispersive_shallow_water_1d::Stepping;
using dispersive_shallow_water_1d::TimeComposition;

double SerreWave::spacing(long cells) const {
  const exact::SerreSolitary wave = exact();
  const double excess = wave.excess_up_to(end - crest) - wave.excess_up_to(begin - crest);
  return (length() + excess / depth) / static_cast<double>(cells);
}

Flow start(const SerreWave& wave, double spacing, Scheme scheme) {
  const Channel channel{.bottom = std::make_shared<LevelBottom>(wave.depth),
                        .left = End::wall,
                        .right = End::wall,
                        .period = wave.periodic ? wave.length() : 0,
                        .gravity = wave.gravity,
                        .alpha = wave.alpha};
  return {channel,
          solitary_markers(channel, wave.begin, wave.end, spacing,
                           {.amplitude = wave.amplitude, .crest = wave.crest, .depth = wave.depth}),
          scheme};
}

namespace {

/// Distance of a place from the exact crest, or from its image that is nearest.
double from_crest(const SerreWave& wave, double x, double time) {
  const double s = x - wave.crest - wave.exact().speed() * time;
  return wave.periodic ? std::remainder(s, wave.length()) : s;
}

}  // namespace

SerreErrors errors_of(const Flow& flow, const SerreWave& wave) {
  const exact::SerreSolitary exact = wave.exact();
  const std::vector<double> u = flow.u();
  SerreErrors errors;
  double elevations = 0;
  double velocities = 0;
  Worst largest;
  for (std::size_t i = 0; i < flow.x().size(); ++i) {
    const double s = from_crest(wave, flow.x()[i], flow.time());
    const double elevation = exact.elevation(s);
    const double velocity = exact.depth_averaged_velocity(s);
    const double error = flow.y()[i] - elevation;
    errors.l2 += error * error;
    elevations += elevation * elevation;
    errors.velocity += (u[i] - velocity) * (u[i] - velocity);
    velocities += velocity * velocity;
    largest.add(error / wave.amplitude);
  }
  errors.l2 = std::sqrt(errors.l2 / elevations);
  errors.velocity = std::sqrt(errors.velocity / velocities);
  errors.largest = largest.value();
  errors.phase = from_crest(wave, flow.crest().place, flow.time());
  errors.crest = flow.crest().elevation;
  return errors;
}

double largest_surface_error(const Flow& flow, const SerreWave& wave) {
  constexpr int parts = 8;  // of a cell
  const exact::SerreSolitary exact = wave.exact();
  Worst largest;
  for (std::size_t i = 0; i + 1 < flow.x().size(); ++i) {
    for (int k = 0; k <= parts; ++k) {
      const double w = static_cast<double>(k) / parts;
      const double s = from_crest(wave, (1 - w) * flow.x()[i] + w * flow.x()[i + 1], flow.time());
      const double y = (1 - w) * flow.y()[i] + w * flow.y()[i + 1];
      largest.add(y - exact.elevation(s));
    }
  }
  return largest.value() / wave.amplitude;
}

Flow followed(const SerreWave& wave, double spacing, double tau, Scheme scheme) {
  // Depths hardly change: tau alone decides, however long compared with the stable step of the one-step scheme.
  constexpr double no_courant_limit = 1e9;
  Flow flow = start(wave, spacing, scheme);
  flow.advance_to(wave.time, tau, {}, no_courant_limit);
  return flow;
}

std::string title(Scheme scheme) {
  std::string text = scheme.stepping == Stepping::one_step            ? "one-step"
                     : scheme.stepping == Stepping::one_step_feedback ? "one-step, feedback"
                                                                      : "conservative";
  if (scheme.fixed_sweeps > 0) text += ", " + std::to_string(scheme.fixed_sweeps) + " sweeps";
  if (scheme.composition == TimeComposition::triple_jump) text += ", triple jump";
  if (scheme.composition == TimeComposition::suzuki) text += ", Suzuki";
  return text;
}

}  // namespace seiche::validation
