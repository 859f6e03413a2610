/// Run-up of a solitary wave on a plane slope behind a level bottom: fully nonlinear potential flow.
///
/// A solitary wave of the Euler equations starts so far before the toe that less than 1e-8 of it is there, and is moved
/// by Cauchy's integral in a plane where bottom and slope are one straight line (slope_climb.hpp). Nodes are
/// those of Chebyshev, dense at the shore, whose node climbs the slope. Run-up R is its highest level above still
/// water.
///
/// When not to use it: waves that break on the way up; the surface then gets vertical, and the computation ends with a
/// Divergence. Cotangents above 3, where the tongue of water gets thinner than the nodes resolve. The way down after
/// the largest run-up. Friction and surface tension.
///
/// References: Grilli, Svendsen & Subramanya, Breaking criterion and characteristics for solitary waves on slopes, J.
/// Waterway, Port, Coastal, Ocean Eng. 123 (1997) 102 (boundary elements; run-up on steep slopes, and which waves
/// break); Hall & Watts, Laboratory investigation of the vertical rise of solitary waves on impermeable slopes, Beach
/// Erosion Board Tech. Memo. 33 (1953).
#pragma once

#include <cmath>
#include <vector>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class SlopeRunup {
 public:
  /// @param amplitude  of the incident wave [m], amplitude/depth in [0.02, 0.5]
  /// @param cotangent  of the slope, in [0, 3]; 0: a vertical wall
  /// @param depth      undisturbed [m]
  /// @param markers    intervals of the surface, even, at least 160;  @param tolerance  of a time step, in depths
  /// Throws std::invalid_argument, and Divergence if the water overturns or is not resolved.
  explicit SlopeRunup(double amplitude, double cotangent, double depth = 1, std::size_t markers = 200,
                      double tolerance = 1e-8);

  [[nodiscard]] double runup() const { return runup_; }  ///< R [m]
  /// From when the crest would pass the toe if there were no slope to the largest run-up, times sqrt(g/depth).
  [[nodiscard]] double runup_time() const { return runup_time_; }
  [[nodiscard]] double wave_amplitude() const { return amplitude_; }  ///< [m]
  [[nodiscard]] double cotangent() const { return cotangent_; }

  /// The shore in time, until the largest run-up.
  struct Shore {
    double time = 0;   ///< as in runup_time()
    double level = 0;  ///< above still water [m]
    double rise = 0;   ///< of the level, over sqrt(g depth)
  };
  [[nodiscard]] const std::vector<Shore>& history() const { return history_; }
  /// Level [m] at a time, by a cubic between the steps; throws std::out_of_range outside the motion.
  [[nodiscard]] double level(double time) const;

  /// Difference of R from a second computation with a fifth less of the markers, or a quarter more where those would be
  /// too few, and ten times the tolerance, relative to R. Takes about as long as this one.
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;
  /// What self_test() tells of a wave of an amplitude over the depth, before it is measured: no defects yet.
  static SelfTest identities(double ratio, double tolerance = 1e-8);

 private:
  double amplitude_, cotangent_, depth_;
  std::size_t markers_;
  double tolerance_;
  double runup_ = 0;
  double runup_time_ = 0;
  double energy_change_ = 0;
  double volume_change_ = 0;
  std::vector<Shore> history_;
};

}  // namespace seiche::exact
