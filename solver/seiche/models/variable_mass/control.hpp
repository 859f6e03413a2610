/// Control velocities: how nodes move relative to the water, so that cells keep their shape (Frank 1994, 5.3).
///
///     none       nodes are particles of the water
///     centroid   towards the centroid of the cell: c = sigma (centroid - r)
///     mapped     towards the node's own place at rest, lifted with the surface above it: c = sigma (target - r),
///                target = (X, Y + phi eta(x)), phi = 1 at the surface, 0 at the foot and below
///     fixed_x    c = -u + sigma (target - r) + (0, phi w), w the velocity of the surface above: nodes stay at their x
///
/// Nodes on walls keep to them, corners stay. The foot is the highest place that two walls hold: the bottom, or the
/// edge of a step; below it nodes return to where they were at rest.
///
/// Nodes of the surface slide along it (Surface) at the rate c_x = sigma_s (X - x), with fixed_x -u_x besides; with
/// sigma_s = 0 and another control than fixed_x they are particles. Rates are per time: at 1 a node is almost a
/// particle.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "seiche/free_lagrangian/cell_water.hpp"
#include "seiche/free_lagrangian/mesh.hpp"
#include "seiche/geometry/triangulation.hpp"
#include "seiche/ranges.hpp"

namespace seiche::variable_mass {

// The free surface between two walls, along which nodes slide without changing the volume or the potential energy of
// the water.
//
// A node moved along a chord of the surface keeps the area but not the energy: sliding at the rate c_x takes it along
// the slope of the surface and has two corrections for all nodes together,
//
// @f[ c_y = c_x y'(x) + |c_x| \left(\alpha + \beta (y - H)\right), \qquad
//     \nabla \Omega \cdot c = 0, \qquad \nabla (\Pi - \rho g H \Omega) \cdot c = 0, @f]
//
// with Omega the area within the outline and H the level at rest. Without them the energy of a solitary wave grows.

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

enum class ControlKind { none, centroid, mapped, fixed_x };
/// Throws std::invalid_argument listing the names there are.
ControlKind control_named(std::string_view name);

struct Control {
  ControlKind kind = ControlKind::mapped;
  double rate = 1;            ///< sigma [1/s]
  double surface_rate = 0.5;  ///< sigma_s [1/s]

  static constexpr auto ranges() {
    return std::array{Number{"rate", &Control::rate, Range::not_negative()},
                      Number{"surface_rate", &Control::surface_rate, Range::not_negative()}};
  }
};

class ControlVelocity {
 public:
  /// @param rest  the mesh under a flat surface: where nodes return to
  /// Throws std::invalid_argument: bad meshes (mesh.hpp), rates that are negative; mapped, fixed_x or a surface_rate
  /// without a surface between two walls.
  ControlVelocity(const free_lagrangian::Mesh& rest, Control control);

  /// The mesh under an elevated surface: every node lifted as `mapped` would have it. Throws std::invalid_argument
  /// for an elevation that is not finite.
  [[nodiscard]] free_lagrangian::Mesh raised(const std::function<double(double x)>& elevation) const;

  /// c of all nodes along x, then along y. @param mesh  at the places asked about
  void at(const MovingTriangulation& mesh, std::span<const double> u, std::span<double> c) const;

  [[nodiscard]] const Control& control() const { return control_; }
  [[nodiscard]] const Surface& surface() const { return surface_; }

 private:
  void slide(Places at, std::span<const double> u, std::span<double> c) const;
  [[nodiscard]] bool lifts() const {
    return control_.kind == ControlKind::mapped || control_.kind == ControlKind::fixed_x;
  }

  Control control_;
  free_lagrangian::Mesh rest_;
  Surface surface_;
  std::vector<free_lagrangian::Mobility> freedom_;
  std::vector<double> lift_;      // phi
  std::vector<bool> controlled_;  // neither on the surface nor on another free outline
};

}  // namespace seiche::variable_mass
