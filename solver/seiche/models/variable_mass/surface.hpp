/// The free surface between two walls, along which nodes slide without changing the volume or the potential energy of
/// the water.
///
/// A node moved along a chord of the surface keeps the area but not the energy: sliding at the rate c_x takes it along
/// the slope of the surface and has two corrections for all nodes together,
///
/// @f[ c_y = c_x y'(x) + |c_x| \left(\alpha + \beta (y - H)\right), \qquad
///     \nabla \Omega \cdot c = 0, \qquad \nabla (\Pi - \rho g H \Omega) \cdot c = 0, @f]
///
/// with Omega the area within the outline and H the level at rest. Without them the energy of a solitary wave grows.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seiche/free_lagrangian/mesh.hpp"

namespace seiche::variable_mass {

inline std::size_t index(int k) {
  return static_cast<std::size_t>(k);
}

class Surface {
 public:
  /// The nodes of the outline between two of its nodes that walls hold, both included. None where nothing or all is
  /// free. Throws std::invalid_argument where there are two such stretches or one that goes back in x.
  explicit Surface(const free_lagrangian::Mesh& mesh);

  /// In ascending x.
  [[nodiscard]] std::span<const int> nodes() const { return nodes_; }
  [[nodiscard]] bool exists() const { return !nodes_.empty(); }
  /// Mean height at rest, H.
  [[nodiscard]] double level() const { return level_; }

  /// Throws mechanics::Infeasible naming the node where the surface goes back in x.
  void require_single_valued(Places at) const;
  /// Of a quantity given at all nodes of the mesh, along the surface at x: linear between nodes.
  [[nodiscard]] double along(Places at, std::span<const double> quantity, double x) const;
  /// From c_x of all nodes their c_y.
  void slide(Places at, std::span<const double> cx, std::span<double> cy) const;
  /// What the surface nodes' cells gain per time because the outline goes with c, handed on from node to node: the gain
  /// of node s of nodes() from node s + 1, [m^2/s].
  [[nodiscard]] std::vector<double> handed_on(Places at, std::span<const double> cx, std::span<const double> cy) const;

 private:
  void correct(Places at, std::span<const double> cx, std::span<double> cy) const;

  std::vector<int> nodes_;
  std::vector<int> outline_;
  double level_ = 0;
};

}  // namespace seiche::variable_mass
