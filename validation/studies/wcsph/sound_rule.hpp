/// The sound speed by the source's rule: ten times the largest speed of the whole run.
///
/// Nobody knows that speed before. A first run, with a sound speed that is given, tells it; a second one, with the
/// sound speed that follows, is the computation. Fastest are single particles of spray, so lattices and sound speeds
/// differ by a tenth or two: a quarter more than ten is taken.
///
/// Artificial viscosity is proportional to alpha c_0. That product stays what it is in the first run: with alpha itself
/// a faster sound would thicken the water.
///
/// Reference: Monaghan, Simulating free surface flows with SPH, J. Comput. Phys. 110 (1994) 399.
#pragma once

#include <string>

#include "seiche/models/wcsph/settings.hpp"
#include "validation/case/case.hpp"

namespace seiche::validation {

/// sound_from: largest_speed, by the rule, or `given`, by the parameter sound.
Parameter sound_rule(const std::string& given);
bool by_sound_rule(const Values& values);

/// @param largest_speed  of the water in a run with the settings [m/s]
wcsph::Settings with_sound_for(wcsph::Settings settings, double largest_speed);

}  // namespace seiche::validation
