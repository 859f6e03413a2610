/// What is measured of a solitary wave that meets a wall at an angle: wall, incident and reflected crest, stem.
///
/// From one surface, in depths, without knowledge of the model that made it:
///
///     a_w    top of the foremost crest on the wall that is higher than a/2
///     a_i    median height of the front crests of the rows 0.82 to 0.96 of the lattice's height; a line through their
///            places gives the incident angle
///     a_r    median height of the reflected crests: behind the front crest of their row by 8 to 22 times
///            sqrt(0.3/a), the highest such, below 1.05 of the front crest and of a, and not lower than half of the
///            highest of all rows: where the reflected crest is at another distance there are the ripples that coarse
///            lattices leave behind; psi_r from a line through their places
///     y_T    where the incident line reaches the x of the crest on the wall: the length of the stem
///
/// Uncertainties, as half-widths: of heights half the width of the central 68 % of the rows; of angles and lengths
/// twice the standard error of the line, widened by its curvature; of a_w the difference between the interpolations by
/// three and by five nodes (0.7 % of a stem as high as the depth on nodes half a depth apart, changing as it passes
/// them: for series in time five_node_height is smoother). They know nothing of the model's own error, nor of the
/// growth that is still to come (see wall_history.hpp).
///
/// When not to use it: before the stem's end and the reflected crest have parted from the front crest by the distances
/// above; near the upper end of the lattice, which the stem's end must not come nearer than 30 sqrt(0.3/a).
#pragma once

#include <optional>
#include <vector>

#include "reports/evidence/claim.hpp"
#include "validation/instruments/plan/row_crests.hpp"
#include "validation/instruments/straight_line.hpp"

namespace seiche::validation {

struct ReflectionBands {
  double incident_from = 0.82;  ///< of the lattice's height
  double incident_to = 0.96;
  double nearest = 8;  ///< of the reflected behind the front crest, times sqrt(0.3/a)
  double farthest = 22;
  double tallest = 1.05;    ///< of the reflected over the front crest, and over a
  double lowest = 0.5;      ///< of the reflected over the highest reflected of all rows
  double threshold = 0.01;  ///< of crests, over a
  double wall = 0.5;        ///< of the crest on the wall, over a
};

struct ReflectedCrest {
  evidence::Measurement amplitude;  ///< a_r
  evidence::Measurement angle;      ///< psi_r [rad]
  StraightLine line;                ///< x over y
  std::vector<Crest> crests;
};

struct ReflectionPattern {
  evidence::Measurement wall_amplitude;      ///< a_w
  Crest wall;                                ///< where
  evidence::Measurement incident_amplitude;  ///< a_i
  evidence::Measurement incident_angle;      ///< [rad]
  StraightLine incident_line;                ///< x over y
  std::vector<Crest> incident;
  evidence::Measurement stem_length;  ///< y_T
  /// None where fewer than 4 rows have a reflected crest at its distance.
  std::optional<ReflectedCrest> reflected;

  /// a_r/a_i; throws std::logic_error without a reflected crest.
  [[nodiscard]] evidence::Measurement reflected_ratio() const;
};

/// @param amplitude  nominal a of the incident wave, in depths: scales thresholds and distances, nothing else
/// Throws std::invalid_argument for an incomplete lattice, std::runtime_error if there is no crest on the wall or fewer
/// than 4 front crests in the band.
ReflectionPattern measured_reflection(const SurfaceLattice& surface, double amplitude);

}  // namespace seiche::validation
