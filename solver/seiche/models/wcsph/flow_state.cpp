#include "seiche/models/wcsph/flow_state.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/models/wcsph/engine.hpp"

namespace seiche::wcsph {

FlowState Flow::state() const {
  return engine_->state();
}

void Flow::resume(const FlowState& state) {
  engine_->resume(state);
}

FlowState Flow::Engine::state() const {
  return {.particles = particles_,
          .reference_x = reference_x_,
          .reference_z = reference_z_,
          .listed = {stage_.base().x, stage_.base().z, stage_.base().density, listed_reserve_},
          .half_travel = half_travel_,
          .time = time_,
          .steps = steps_,
          .extremes = extremes_};
}

void Flow::Engine::resume(const FlowState& state) {
  if (state.particles.size() != particles_.size()) {
    throw std::invalid_argument(fmt::format("state of {} particles: must be of {}, as the flow has",
                                            state.particles.size(), particles_.size()));
  }
  particles_ = state.particles;
  if (!paddles_.empty()) {
    reference_x_ = state.reference_x;
    reference_z_ = state.reference_z;
  }
  time_ = state.time;
  steps_ = state.steps;
  // Lists as they were, of the places then; what is in order stays in order.
  particles_.x = state.listed.x;
  particles_.z = state.listed.z;
  particles_.density = state.listed.density;
  sort(state.listed.reserve);
  if (!std::is_sorted(neighbours_.order().begin(), neighbours_.order().end())) {
    throw std::invalid_argument("state of a flow of other settings: its particles are in another order");
  }
  particles_.x = state.particles.x;
  particles_.z = state.particles.z;
  particles_.density = state.particles.density;
  half_travel_ = state.half_travel;
  extremes_ = state.extremes;
}

}  // namespace seiche::wcsph
