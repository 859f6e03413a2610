/// The first moments after an initial discontinuity: edge averages of the exact centred waves.
///
/// A dam break starts inside one edge; until its waves span several particles no reconstruction can see them, and the
/// error of these first steps travels along the corners of the fan for ever. The discontinuity of two uniform states
/// has a self-similar solution, a function of mass/time in mass coordinates, so edge velocity and thrust averaged over
/// a step are known in closed form. They are used until the fan spans the given number of particles or a wave reaches
/// water that is not uniform; then the method goes on by itself.
///
/// When not to use it: with bed, friction or body force, where no centred solution exists (ParticleFlow ignores it).
/// Source: Stoker, Water Waves (1957), ch. 10, written in mass coordinates: h c = |mass|/time inside a fan.
#pragma once

#include <cstddef>
#include <optional>

#include "seiche/models/shallow_water_particles/edge_riemann.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::shallow_water_particles {

class SelfSimilarStart {
 public:
  /// @param left, right  uniform states; one of them missing is a dry bed
  /// @param edge         edge of the discontinuity
  /// @param first, last  edges between which the two states are uniform
  SelfSimilarStart(double gravity, std::optional<shallow_water::State> left, std::optional<shallow_water::State> right,
                   std::size_t edge, std::size_t first, std::size_t last);

  /// True when the discontinuity is a jump already: hand-over is exact from the first step.
  [[nodiscard]] bool lone_jump() const;

  /// True when at `time` (since the start) the fans span `particles`, or a wave nears the end of the uniform water.
  [[nodiscard]] bool over(const Array& mass, double time, int particles) const;

  /// Writes the exact averages over [time, time + tau] to all edges that waves have reached by the end of it.
  void replace(const Array& mass, double time, double tau, Array& velocity, Array& thrust) const;

 private:
  // One of the two waves, with velocities counted away from it: mass fluxes of its head and tail (equal for a jump).
  struct Wave {
    bool present;
    bool fan;
    double head, tail;
    shallow_water::State outer, inner;
  };
  [[nodiscard]] EdgeState average(const Wave& wave, double mass, double from, double to) const;

  double gravity_;
  std::size_t edge_;
  std::size_t first_;
  std::size_t last_;
  Wave left_{};  // mirrored
  Wave right_{};
  shallow_water::State star_{};
};

}  // namespace seiche::shallow_water_particles
