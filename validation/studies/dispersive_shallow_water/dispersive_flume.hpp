/// Laboratory flumes in the one-dimensional dispersive model: water between a wall and a wall or a shoreline, with
/// gauges.
///
/// Bores and irregular waves have the improved dispersion of Madsen and Sorensen (1992), gamma = 1/15 and alpha = 1/3 +
/// gamma, which is Airy's law to the fourth order of k h, waves over bars that of Bonneton et al. (2011), gamma =
/// 0.051, which stays by it up to k h = 4; solitary waves are those of Serre's equations, gamma = 0, for which they are
/// exact at the start. Over slopes the kinetic energy is that of Green and Naghdi. Lengths in metres, times in seconds.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "validation/case/parameter.hpp"
#include "validation/case/submission.hpp"

namespace seiche::validation::laboratory {

namespace dispersive = dispersive_shallow_water_1d;

struct Flume {
  std::vector<double> bed_x, bed_z;  ///< knots, z from the still-water level; water begins 1 after the first
  double spacing = 0.1;              ///< of the markers at rest
  double tau = 0.02;                 ///< longest step
  bool shoreline = false;            ///< at the right end, instead of a wall at the last knot
  double gravity = 9.81;
  double gamma = 0;
  dispersive::Friction friction = {};
  std::optional<dispersive::Breaking> breaking = {};

  [[nodiscard]] dispersive::Channel channel() const;
};

/// Regular waves that run to the right over a level bed, with the second harmonic bound to them; they fade within a
/// wavelength at both ends.
struct Train {
  double depth = 1, amplitude = 0.01, period = 1;  ///< amplitude of the water's surface
  double from = 0, to = 1;                         ///< [m]
};

/// Of the flumes with slopes and beaches; 0.010 s/m^(1/3) is the handbooks' value for glass (Chow 1959). Where water is
/// deep for its waves friction takes a per cent or less, and the flume has none.
inline constexpr dispersive::Friction glass{dispersive::FrictionLaw::manning, 0.01};

inline constexpr double improved = 1.0 / 15;  ///< gamma
/// gamma of the linear law of Bonneton, Chazel, Lannes, Marche and Tissier, J. Comput. Phys. 230 (2011) 1479, whose
/// alpha = 1.153 is 1 + 3 gamma: within 2 % of Airy's phase velocity up to k h = 4.
inline constexpr double one_parameter = 0.051;

/// "dispersion": improved, one-parameter, or Serre's with gamma = 0.
Parameter dispersion_parameter();
double gamma_of(const std::string& dispersion);

/// Wavenumber of linear waves.
double wavenumber(double depth, double period, double gravity, double gamma);

dispersive::Flow regular_waves(const Flume& flume, const Train& train);

/// Cnoidal waves of Serre's equations (exact/model_waves.hpp) of this height and period, without a mean discharge;
/// they fade like regular_waves.
struct Cnoidal {
  double depth = 1, height = 0.02, period = 1;
  double from = 0, to = 1;  ///< [m]
};
dispersive::Flow cnoidal_waves(const Flume& flume, const Cnoidal& train);

/// Solitary waves of Serre's equations, `direction` 1 or -1, far from each other.
struct Solitary {
  double depth = 1, amplitude = 0.1, crest = 0;
  int direction = 1;
};
dispersive::Flow solitary_waves(const Flume& flume, const std::vector<Solitary>& waves);

/// A smooth step of water from h0 (1 + jump) down to h0 at x = 0, whose velocity makes it a bore that runs to the
/// right.
dispersive::Flow smooth_bore(const Flume& flume, double depth, double jump, double width);

/// The water's surface (water_surface.hpp) at gauges, every `interval` from now to `end`; times less `origin`.
std::vector<SubmittedGroup> gauge_records(dispersive::Flow& flow, const Flume& flume, const std::vector<double>& groups,
                                          const std::vector<double>& places, double interval, double end,
                                          double origin = 0);

}  // namespace seiche::validation::laboratory
