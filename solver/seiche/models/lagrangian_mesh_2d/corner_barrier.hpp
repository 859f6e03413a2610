/// A potential that keeps the corners of cells from folding.
///
///     Pi_c = stiffness sum over corners with s < s_0 of V_0^(3/2) (s_0/s - 1)^2,   s_0 = 0.3
///
/// s is the shape of a corner (mesh.hpp): twice the triangle at it over the cell's first area V_0. Nothing is felt by
/// corners above s_0; momenta are kept; energy is not kept to round-off by any scheme while a corner is below, for the
/// potential is not a polynomial.
#pragma once

#include <span>

#include "seiche/models/lagrangian_mesh_2d/mesh.hpp"

namespace seiche::lagrangian_mesh_2d {

class CornerBarrier {
 public:
  /// @param stiffness  [N/m^3], not negative
  explicit CornerBarrier(double stiffness) : stiffness_(stiffness) {}

  [[nodiscard]] bool active() const { return stiffness_ > 0; }
  /// Infinite where a corner has folded.
  [[nodiscard]] double energy(const Mesh& mesh, std::span<const double> first_areas, const double* x,
                              const double* y) const;
  /// Adds weight times its forces.
  void push(const Mesh& mesh, std::span<const double> first_areas, const double* x, const double* y, double weight,
            std::span<double> push_x, std::span<double> push_y) const;

 private:
  double stiffness_;
};

}  // namespace seiche::lagrangian_mesh_2d
