/// Gravity on the free surface of water in three dimensions: the energy int z^2/2 dA over the bilinear patches between
/// rows of nodes, and minus its gradient.
#pragma once

#include <cstddef>
#include <span>

#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/mechanics/constrained_model.hpp"

namespace seiche::lattice {

class SurfacePatches {
 public:
  /// @param nodes  of the lattice, along each axis; the surface's are the last ones
  SurfacePatches(std::size_t columns, std::size_t rows, std::size_t nodes)
      : columns_(columns),
        rows_(rows),
        nodes_(nodes),
        first_(nodes - (columns + 1) * (rows + 1)),
        forces_(columns, rows, 12) {}

  /// push += weight times the forces at q = (x, y, z).
  void push(mechanics::Input q, double weight, mechanics::Output push);
  /// @param counted  marks the patches that count; empty: all
  [[nodiscard]] double moment(mechanics::Input q, std::span<const char> counted = {}) const;

 private:
  std::size_t columns_, rows_, nodes_, first_;
  linear::RowBlocks forces_;  // of a patch on its corners: number 3 corner + axis
};

}  // namespace seiche::lattice
