/// A flow of particles between open ends that settles: how it is computed, and how far it is from a steady state.
/// Particles enter at their own rhythm, so that no instant is like the next: errors are means over the last fifth of
/// the time.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "validation/case/study.hpp"
#include "validation/studies/shallow_water/profile_measures.hpp"

namespace seiche::validation {

/// Numbers of particles from the coarsest to 8 times as many, by factors of sqrt 2.
inline constexpr int numbers_of_resolutions = 7;
std::vector<long> numbers_of_particles(long coarsest);

/// Between a left end where the water enters and a right one where it leaves.
struct OpenReach {
  double length = 0;                            ///< [m]
  double discharge = 0;                         ///< of the inflow, and everywhere at t = 0 [m^2/s]
  std::optional<double> outflow_depth = {};     ///< none where it is supercritical [m]
  std::function<double(double x)> start_depth;  ///< at t = 0 [m]
  shallow_water_particles::Forcing forcing = {};
};

struct Settled {
  Profile profile;  ///< at the end
  double mass_defect = 0;
  double momentum_defect = 0;
};

/// @param look  called with the profiles of 32 instants of the last fifth of the time
Settled settle(const OpenReach& reach, long particles, double time, const Run::Progress& progress,
               const std::function<void(const Profile&)>& look);

/// The particles that lie between two places; throws std::runtime_error where none does.
Profile part_of(const Profile& whole, double from, double to);

/// Mean of |q/discharge - 1| over the particles by their lengths.
double mean_discharge_error(const Profile& profile, double discharge);

}  // namespace seiche::validation
