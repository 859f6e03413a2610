/// A flow of the Dirichlet mesh: water in cells, stepped by Frank's one-step scheme.
///
///     Flow flow(free_lagrangian::layer_mesh({.begin = 0, .end = 3, .columns = 24, .rows = 8}),
///               [](Point r) { return Point{0.01 * std::sin(r.x), 0}; });
///     while (flow.time() < 20) flow.advance(0.05);
///
/// The first velocities are projected on constant areas. What the stabilisation and the feedback of the drift do to the
/// energy is booked: energy() + stabilisation_loss() - drift_work() is kept to round-off without gravity, and to
/// O(tau^2) with it. Throws std::invalid_argument for bad input, a singular mesh without stabilisation among it, and
/// Divergence, with time, step and place, when the mesh tangles or a value is not finite.
#pragma once

#include <memory>

#include "seiche/free_lagrangian/cell_water.hpp"
#include "seiche/mechanics/plane_flow.hpp"
#include "seiche/models/dirichlet_mesh/model.hpp"

namespace seiche::dirichlet_mesh {

class Flow : public mechanics::OneStepFlow<Model> {
 public:
  /// @param drift_feedback  share of the drift of the areas that a step takes back, in [0, 1]; 0.2 is enough
  explicit Flow(const Mesh& mesh, const VelocityAt& velocity = {}, Settings settings = {}, double drift_feedback = 0)
      : OneStepFlow(std::make_unique<Model>(mesh, settings), velocity, drift_feedback) {}

  /// A warning when the smallest angle falls below a few degrees.
  [[nodiscard]] MeshQuality quality() const { return model_->quality(state_.q); }
  [[nodiscard]] long flips() const { return model_->triangulation().flips(); }
};

}  // namespace seiche::dirichlet_mesh
