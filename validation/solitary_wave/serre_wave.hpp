/// Serre's solitary wave over a level bottom, followed with the discrete dispersive model and compared with itself.
#pragma once

#include <string>
#include <vector>

#include "seiche/exact/solitary_asymptotic.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"

namespace seiche::validation {

/// A channel of constant depth with the wave in it.
struct SerreWave {
  double amplitude = 0.2;  ///< [m]
  double depth = 1;        ///< [m]
  double gravity = 1;      ///< [m/s^2]
  double alpha = 1.0 / 3;  ///< factor of the vertical kinetic energy
  double begin = 0;        ///< ends of the channel [m]
  double end = 60;
  double crest = 20;  ///< at the beginning [m]
  double time = 20;   ///< how long it is followed [s]
  bool periodic = true;

  [[nodiscard]] exact::SerreSolitary exact() const { return exact::SerreSolitary(amplitude, depth, gravity, alpha); }
  [[nodiscard]] double length() const { return end - begin; }
  /// Width at rest of so many cells of equal volume [m]: the channel's length and what the wave adds to it.
  [[nodiscard]] double spacing(long cells) const;
};

/// The wave on markers `spacing` apart when at rest.
dispersive_shallow_water_1d::Flow start(const SerreWave& wave, double spacing,
                                        dispersive_shallow_water_1d::Scheme scheme);

/// Distance of a flow from the exact wave, over its markers. All but the crest are relative to the exact wave.
struct SerreErrors {
  double l2 = 0;        ///< of the elevation
  double largest = 0;   ///< of the elevation, over the amplitude
  double velocity = 0;  ///< L2 of the horizontal velocity
  double phase = 0;     ///< crest less the exact crest [m]
  double crest = 0;     ///< its elevation [m]
};
SerreErrors errors_of(const dispersive_shallow_water_1d::Flow& flow, const SerreWave& wave);

/// Largest error of the surface over the amplitude, also between the markers, where it is straight.
double largest_surface_error(const dispersive_shallow_water_1d::Flow& flow, const SerreWave& wave);

/// The flow at wave.time, by equal steps of at most tau.
dispersive_shallow_water_1d::Flow followed(const SerreWave& wave, double spacing, double tau,
                                           dispersive_shallow_water_1d::Scheme scheme);

/// "one-step", "conservative, Suzuki", ...: how figures call a scheme.
std::string title(dispersive_shallow_water_1d::Scheme scheme);

}  // namespace seiche::validation
