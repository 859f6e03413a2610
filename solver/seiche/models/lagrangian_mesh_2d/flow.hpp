/// A flow of the two-dimensional Lagrangian mesh: a mesh of water, stepped by one of the schemes.
///
///     const exact::SolitaryWave wave(0.3);
///     Flow flow(layer_mesh({.begin = -15, .end = 45, .columns = 240, .rows = 8,
///                           .elevation = [&](double x) { return wave.elevation(x); }}),
///               [&](Point r) { const auto v = wave.velocity(r.x, r.y); return Point{v.u, v.v}; });
///     while (flow.time() < 20) flow.advance(0.05);
///
/// The first velocities are projected on constant areas. Throws std::invalid_argument for bad input and Divergence,
/// with time, step and place, when a cell tangles, a node leaves its curve, a solver fails or a value is not finite.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "seiche/lattice/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/mesh.hpp"
#include "seiche/models/lagrangian_mesh_2d/model.hpp"
#include "seiche/models/lagrangian_mesh_2d/rezone.hpp"

namespace seiche::lagrangian_mesh_2d {

using mechanics::Scheme;
using mechanics::Stepping;
using mechanics::TimeComposition;

class Flow : public lattice::Flow<Model> {
 public:
  using Velocity = InitialVelocity;

  /// @param velocity  at the beginning; project_to_smooth (mechanics/start.hpp) for waves that are to run long
  /// @param smooth_start  the first velocities of the one-step scheme get the part outside the constraints that keeps
  ///                      its multipliers from alternating (mechanics/start.hpp); not for driven nodes and compositions
  explicit Flow(Mesh mesh, const Velocity& velocity = {}, Scheme scheme = {}, Settings settings = {},
                Forcing forcing = {}, bool smooth_start = true);

  /// From now on the mesh is rezoned (rezone.hpp) as soon as a node is farther from its place than `drift` of its
  /// cells, and what it carries remapped (rezone.hpp); where that is not possible the mesh goes on as it is. The ledger
  /// counts from the last rezoning on. Throws std::invalid_argument: a drift outside (0, 2], a mesh that is no layer
  /// between straight walls (rezone.hpp), a body force, whose labels would be lost.
  void keep_upright(double drift = 0.2);
  struct Rezoning {
    long done = 0;
    long refused = 0;
    double lost = 0;  ///< energy that it took in all [J/m]
  };
  [[nodiscard]] const Rezoning& rezoning() const { return rezoning_; }

  /// One step of length tau > 0. A throw leaves the state as it was, or as it was rezoned.
  void advance(double tau) override;

  /// Row `rows` of the nodes.
  [[nodiscard]] std::span<const double> surface_x() const { return top(x()); }
  [[nodiscard]] std::span<const double> surface_y() const { return top(y()); }

 private:
  [[nodiscard]] std::span<const double> top(std::span<const double> values) const {
    return values.last(model_->mesh().columns + 1);
  }
  void rezone(const UprightColumns::Places& places);
  void rezone_where_due();

  std::unique_ptr<const UprightColumns> upright_;  // or none
  double drift_ = 0;
  Rezoning rezoning_;
};

}  // namespace seiche::lagrangian_mesh_2d

/// Compiled once, in flow.cpp.
extern template class seiche::lattice::Flow<seiche::lagrangian_mesh_2d::Model>;
