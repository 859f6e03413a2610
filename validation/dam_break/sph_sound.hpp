/// The sound speed of a collapsing column by the source's rule (sound_rule.hpp): the first run has ten times the speed
/// of a free fall through the column's height. What is fastest is the splash at the far wall.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "validation/case/case.hpp"
#include "validation/dam_break/sph_dam.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"

namespace seiche::validation {

/// sph_parameters, with a sound speed of the first run of ten times sqrt(2 g times the column's height), and the choice
/// between the rule and a sound speed that is given.
std::vector<Parameter> sph_dam_parameters(SphDefaults defaults);

struct SphCollapses {
  std::optional<SphCollapse> first;  ///< that told the largest speed; none with a given sound speed
  SphCollapse run;
};

void exchange(Tape& tape, SphCollapses& runs);

/// @param on_frame  is called in the last run only
SphCollapses collapse_by_rule(const SphDam& dam, const Values& values, const Watch& watch,
                              const std::vector<double>& frames = {},
                              const std::function<void(std::size_t, const wcsph::Flow&)>& on_frame = {},
                              const std::function<void(double)>& progress = {});

/// The rule holds; not claimed of a sound speed that is given.
void claim_sound(const Claims<SphCollapses>& claims, const Values& values);

/// The largest speed that the first run told, and Mach numbers.
void measure_sound(evidence::Exhibit& exhibit, const SphCollapses& runs);

}  // namespace seiche::validation
