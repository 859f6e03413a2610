/// A flow of the hexahedral Lagrangian mesh: a mesh of water, stepped by one of the schemes.
///
///     Flow flow(layer_mesh({.begin = 0, .end = 40, .south = 0, .north = 20, .columns = 80, .rows = 40, .layers = 2,
///                           .elevation = [](double x, double y) { return 0.1 * std::exp(-x * x - y * y); }}));
///     while (flow.time() < 20) flow.advance(0.2);
///
/// The first velocities are projected on constant volumes. Throws std::invalid_argument for bad input and Divergence,
/// with time, step and place, when a cell tangles, a solver fails or a value is not finite.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "seiche/models/lagrangian_mesh_3d/mesh.hpp"
#include "seiche/models/lagrangian_mesh_3d/model.hpp"
#include "seiche/plan_lattice/lattice_flow.hpp"

namespace seiche::lagrangian_mesh_3d {

// Meshes of layers of water and of free bodies of fluid.

/// Water over begin <= x <= end, south <= y <= north: equal cells in plan, vertical columns of layers of equal height.
struct Layer {
  double begin = 0;  ///< west side [m]
  double end = 1;    ///< east side [m]
  double south = 0;
  double north = 1;
  double depth = 1;  ///< of still water over a level bottom [m]
  std::size_t columns = 1;
  std::size_t rows = 1;
  std::size_t layers = 1;
  /// Surface elevation [m]; empty for still water.
  std::function<double(double x, double y)> elevation = {};
  Sides sides = {};
  /// Place of the south side, instead of `south`; rows then have equal widths on each line x = const. A wedge in a
  /// channel.
  std::function<double(double x)> south_wall = {};
  /// Uneven bottom, which `depth` then does not describe; null for none.
  std::shared_ptr<const PlanBottom> bottom = {};
};
/// Throws std::invalid_argument: ends out of order, no cells, depth not positive, a surface below the bottom (by
/// place). Throws Infeasible.
Mesh layer_mesh(const Layer& layer);

using mechanics::Scheme;
using mechanics::Stepping;
using mechanics::TimeComposition;
using plan_lattice::Window;

class Flow : public plan_lattice::LatticeFlow<Model> {
 public:
  /// @param velocity  at the beginning
  /// @param smooth_start  the first velocities of the one-step scheme get the part outside the constraints that keeps
  ///                      its multipliers from alternating (mechanics/start.hpp); not with driven sides or compositions
  explicit Flow(Mesh mesh, const Velocity& velocity = {}, Scheme scheme = {}, Settings settings = {},
                Window window = {}, bool smooth_start = true, Forcing forcing = {});

  /// The nodes of the free surface, numbered as in plan: node (i, j) at j (columns + 1) + i.
  [[nodiscard]] std::span<const double> surface_x() const { return x().last(shape().nodes()); }
  [[nodiscard]] std::span<const double> surface_y() const { return y().last(shape().nodes()); }
  [[nodiscard]] std::span<const double> surface_z() const { return z().last(shape().nodes()); }
};

}  // namespace seiche::lagrangian_mesh_3d

/// Compiled once, in flow.cpp.
extern template class seiche::plan_lattice::LatticeFlow<seiche::lagrangian_mesh_3d::Model>;
