/// A flow of overlapping particles, stepped by Frank's one-step scheme.
///
///     Flow flow(staggered_disc(1, 0.1), [](Point r) { return Point{r.x, -r.y}; });
///     while (flow.time() < 1) flow.advance(0.02);
///
/// The first velocities are projected on constant masses of the control volumes, which takes some per cent of them next
/// to free surfaces. What a stabilisation takes from the energy is booked. Throws std::invalid_argument for bad input,
/// singular configurations among it, and Divergence, with time, step and place, when one comes up on the way, a
/// particle goes through a wall, or a value is not finite.
#pragma once

#include <memory>
#include <utility>

#include "seiche/mechanics/plane_flow.hpp"
#include "seiche/models/overlapping_particles/model.hpp"

// The integrators of the model, compiled once and not in every file that steps it.
extern template class seiche::mechanics::OneStep<seiche::overlapping_particles::Model>;
extern template class seiche::mechanics::Start<seiche::overlapping_particles::Model>;
extern template class seiche::mechanics::InvariantsWatch<seiche::overlapping_particles::Model>;

namespace seiche::overlapping_particles {

class Flow : public mechanics::OneStepFlow<Model> {
 public:
  explicit Flow(Particles particles, const VelocityAt& velocity = {}, Settings settings = {})
      : OneStepFlow(std::make_unique<Model>(std::move(particles), std::move(settings)), velocity) {}
};

}  // namespace seiche::overlapping_particles
