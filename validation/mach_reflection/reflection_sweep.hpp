/// Solitary waves of several amplitudes that meet a wall at many angles.
#pragma once

#include <string>
#include <vector>

#include "validation/case/study.hpp"
#include "validation/instruments/each.hpp"
#include "validation/mach_reflection/reflection_run.hpp"

namespace seiche::validation {

/// Frank's criterion: reflection is regular if the reflected wave has at least this part of the incident amplitude.
inline constexpr double regular_from = 0.95;
/// On lattices so coarse that no reflected wave has it: this part of the largest.
inline constexpr double regular_from_largest = 0.99;

/// One amplitude on one lattice, by ascending angles.
struct ReflectionSeries {
  double amplitude = 0.3;
  double spacing = 0.5;
  std::vector<double> angles;                ///< [deg]
  std::vector<Reflection> reflections = {};  ///< of the angles

  /// The one whose wall amplitude, over the incident, is highest at the end.
  /// Throws std::out_of_range without reflections.
  [[nodiscard]] const Reflection& highest() const;
  /// a_r/a_i from which on reflection counts as regular.
  [[nodiscard]] double regular_ratio() const;
  /// Angle [deg] at which a_r/a_i passes it, linearly between the neighbours; uncertainty: from those of the
  /// ratios there and half of their distance in angle where the ratios differ by less. NaN if it does not.
  [[nodiscard]] Measurement boundary() const;
};

/// Angle [deg] at which tan(psi)/cos(psi) = sqrt(3a): kappa = 1 for finite angles.
double resonant_angle(double amplitude);

/// C of a_r = C psi^2 by least squares over the angles up to `last` [deg].
struct AngleLaw {
  double factor = 0;
  double uncertainty = 0;       ///< twice its standard error
  double largest_residual = 0;  ///< relative
};
AngleLaw angle_law(const ReflectionSeries& series, double last);

/// Computes all reflections of the angles of the series, the costly ones first.
/// @param time  how long; 0 for ReflectionRun::settled_time()
void sweep(const Run& run, std::vector<ReflectionSeries>& series, double time);

}  // namespace seiche::validation
