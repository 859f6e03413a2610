/// What others found of the reflection of solitary waves at a wall.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/evidence/criterion.hpp"
#include "validation/case/parameter.hpp"
#include "validation/mach_reflection/reflection_run.hpp"

namespace seiche::validation {

/// The source of a claim that compares with a table of an earlier program.
inline std::string regression_of(const std::string& table) {
  return "regression: an earlier program for the same equations, table reference_data/" + table;
}
inline const std::string known_reflections_table = "mach_reflection_model2";

/// A number with its standard uncertainty.
struct Known {
  double value = 0;
  double uncertainty = 0;
  /// Nothing can be expected to agree with it: by how many expanded uncertainties on the table's lattices, and why.
  std::optional<evidence::KnownFailure> doubt = {};
};

/// A row of reference_data/mach_reflection_model2; angles in degrees.
struct KnownReflection {
  double amplitude = 0;
  double angle = 0;
  double end = 0;  ///< of the run
  Known wall_ratio, reflected_ratio, reflected_angle, stem_angle;
  double growth = 0;  ///< of a_w in the last fifth
};

std::vector<KnownReflection> known_reflections(const Values& values);
/// The one at this amplitude and angle [deg], if it is there.
std::optional<KnownReflection> known_reflection(const std::vector<KnownReflection>& all, double amplitude,
                                                double angle);

/// a_w/a_i at the time at which the known run ended, or at the end of this one if that is earlier.
evidence::Measurement wall_ratio_until(const Reflection& reflection, double time);

}  // namespace seiche::validation
