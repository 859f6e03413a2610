/// The two-dimensional Lagrangian mesh against a manufactured motion of a free square (exact/double_shear.hpp).
#pragma once

#include <cstddef>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "validation/instruments/manufactured/double_shear.hpp"

namespace seiche::validation {

struct DoubleShearRun {
  std::size_t n = 16;  ///< cells along each side of the square of side 2
  double tau_over_h = 0.2;
  lagrangian_mesh_2d::Scheme scheme = {};
  /// Amplitude of a smooth displacement of the initial nodes within the square and along its sides.
  double distortion = 0;
  double time = 1;
  validation::DoubleShear motion = validation::DoubleShear();

  [[nodiscard]] double spacing() const { return 2 / static_cast<double>(n); }
};

/// Edges are judged on their middle three quarters: around the corners, where two edges' first-order errors meet, a few
/// cells are of first order in every respect.
constexpr double judged_edge = 0.75;

/// At the end, largest components of nodes and root-mean-square vectors over the mass.
struct DoubleShearErrors {
  double interior = 0;  ///< position in the middle half of the square, each way
  double rms_position = 0;
  double rms_lambda = 0;  ///< mean of the last two steps, in the middle of cells
  double slip = 0;        ///< largest displacement along the top edge
  double shape = 0;       ///< distance of the top edge's nodes from the exact curve, root mean square
};

lagrangian_mesh_2d::Flow double_shear_flow(const DoubleShearRun& run);
/// At the end, in equal steps of at most tau_over_h times the spacing.
DoubleShearErrors double_shear_errors(const DoubleShearRun& run);

}  // namespace seiche::validation
