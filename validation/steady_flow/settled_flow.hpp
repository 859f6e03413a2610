/// How far a flow of particles between open ends is from a steady state. Particles enter at their own rhythm, so that
/// no instant is like the next: errors are means over the last fifth of the time.
#pragma once

#include <vector>

#include "validation/studies/shallow_water/profile_measures.hpp"

namespace seiche::validation {

/// Numbers of particles from the coarsest to 8 times as many, by factors of sqrt 2.
inline constexpr int numbers_of_resolutions = 7;
std::vector<long> numbers_of_particles(long coarsest);

/// 32 instants of the last fifth of a time.
class SettledInstants {
 public:
  explicit SettledInstants(double time) : next_(0.8 * time), every_(0.2 * time / 32) {}
  /// Whether one of them has come since the last one was told.
  bool reached(double now) {
    if (now < next_) return false;
    next_ += every_;
    return true;
  }

 private:
  double next_, every_;
};

/// The particles that lie between two places; throws std::runtime_error where none does.
Profile part_of(const Profile& whole, double from, double to);

/// Mean of |q/discharge - 1| over the particles by their lengths.
double mean_discharge_error(const Profile& profile, double discharge);

}  // namespace seiche::validation
