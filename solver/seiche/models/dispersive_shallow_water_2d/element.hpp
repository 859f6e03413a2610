/// A cell of the plan model: the water of a column between the bilinear surface and the bottom.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "seiche/lattice/cell_rows.hpp"

namespace seiche::dispersive_shallow_water_2d {

/// Gradients are kept as they are, number 3 corner + axis.
struct Column {
  static constexpr std::size_t axes = 3, corners = 4, stored = 12, mobilities = 6, momenta = 2, turns = 1;

  template <std::size_t corner, std::size_t axis>
  SEICHE_INLINE static double gradient(const double* s, std::ptrdiff_t stride, std::ptrdiff_t i) {
    return s[static_cast<std::ptrdiff_t>(3 * corner + axis) * stride + i];
  }
  static void assemble_row(const lattice::Assembly<Column>& row);
  static void rates_of_row(const lattice::Rates<Column>& row);
  static void react_row(const lattice::Reaction<Column>& row);
  static void kick_row(const lattice::Kick<Column>& row);
};

/// Inverse masses W of the nodes, symmetric 3 x 3.
struct InverseMasses {
  explicit InverseMasses(std::size_t nodes) {
    for (auto* w : {&xx, &yy, &zz, &xy, &xz, &yz}) w->assign(nodes, 0.0);
  }
  void put(std::size_t k, const std::array<double, 6>& w) {
    xx[k] = w[0], yy[k] = w[1], zz[k] = w[2], xy[k] = w[3], xz[k] = w[4], yz[k] = w[5];
  }
  std::vector<double> xx, yy, zz, xy, xz, yz;
};

/// Smallest corner Jacobian of a row and the smallest depth of its nodes.
struct RowExtremes {
  double jacobian;
  double depth;
};

/// Gradients of the volumes of a row over the level z = bottom, times `weight`, added to what is there if `add`.
RowExtremes measure_row(std::size_t columns, const lattice::NodeVectors<Column>& r, double bottom, double weight,
                        bool add, linear::RowBlocks::Row gradients);

}  // namespace seiche::dispersive_shallow_water_2d
