/// Reflections of solitary waves at a wall that are tabulated.
#pragma once

#include <optional>
#include <vector>

#include "validation/case/parameter.hpp"

namespace seiche::validation {

/// A row of reference_data/mach_reflection_model2; angles in degrees.
struct KnownReflection {
  double amplitude = 0;
  double angle = 0;
  double wall_ratio = 0, reflected_ratio = 0, reflected_angle = 0, stem_angle = 0;
  double growth = 0;  ///< of a_w in the last fifth
};

std::vector<KnownReflection> known_reflections(const Values& values);

}  // namespace seiche::validation
