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
/// Nodes of the surface slide along it (surface.hpp) at the rate c_x = sigma_s (X - x), with fixed_x -u_x besides; with
/// sigma_s = 0 and another control than fixed_x they are particles. Rates are per time: at 1 a node is almost a
/// particle.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "seiche/free_lagrangian/cell_pressure.hpp"
#include "seiche/geometry/moving_triangulation.hpp"
#include "seiche/models/variable_mass/surface.hpp"

namespace seiche::variable_mass {

enum class ControlKind { none, centroid, mapped, fixed_x };
/// Throws std::invalid_argument listing the names there are.
ControlKind control_named(std::string_view name);

struct Control {
  ControlKind kind = ControlKind::mapped;
  double rate = 1;            ///< sigma [1/s]
  double surface_rate = 0.5;  ///< sigma_s [1/s]
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
